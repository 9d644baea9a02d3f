// SPDX-License-Identifier: MIT
// moivre_pages FOLDER: the man pages and the completion of the shells, written below FOLDER as they
// are installed below share.
#include <cstdio>
#include <exception>
#include <filesystem>
#include <fstream>

#include "command.h"
#include "completion.h"
#include "man_page.h"
#include "moivre/version.h"

namespace {

namespace fs = std::filesystem;

void write(const fs::path& path, const std::string& text) {
  fs::create_directories(path.parent_path());
  std::ofstream file(path, std::ios::binary);
  file << text;
  file.close();
  if (!file) throw std::runtime_error(path.string() + " cannot be written");
}

void write_all(const fs::path& folder) {
  CLI::App app;
  moivre::Chosen chosen;
  moivre::describe_program(app, chosen);
  const moivre::ManualCommand program = moivre::manual_of(app);
  moivre::for_each_command(program, [&](const moivre::ManualCommand& command) {
    write(folder / "man" / "man1" / (moivre::page_name(command) + ".1"),
          moivre::man_page(command, program, MOIVRE_VERSION_STRING));
  });
#if MOIVRE_WITH_MPI
  const moivre::ManualCommand ranks = moivre::manual_of_ranks(program);
  write(folder / "man" / "man1" / (moivre::page_name(ranks) + ".1"),
        moivre::man_page(ranks, program, MOIVRE_VERSION_STRING));
#endif
  write(folder / "bash-completion" / "completions" / "moivre", moivre::bash_completion(program));
  write(folder / "zsh" / "site-functions" / "_moivre", moivre::zsh_completion(program));
  write(folder / "fish" / "vendor_completions.d" / "moivre.fish", moivre::fish_completion(program));
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2) {
    std::fputs("usage: moivre_pages FOLDER\n", stderr);
    return 1;
  }
  try {
    write_all(argv[1]);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "moivre_pages: %s\n", error.what());
    return 1;
  }
  return 0;
}
