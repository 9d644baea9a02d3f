// SPDX-License-Identifier: MIT
// Reads the objects of CLI11 as plain structs.
#include "manual.h"

#include <CLI/CLI.hpp>
#include <sstream>

#include "choices.h"

namespace moivre {
namespace {

/// The type's name without what its checks say of themselves: "SECONDS" of "SECONDS:POSITIVE".
std::string type_name(CLI::Option& option) {
  std::string name = option.get_type_name();
  for (const std::string& check : checks_of(option)) {
    if (name.ends_with(':' + check)) name.resize(name.size() - check.size() - 1);
  }
  return name;
}

/// CLI11's words for types, in those that a reader of the manual knows.
std::string value_name(CLI::Option& option) {
  if (option.get_items_expected_max() == 0) return "";
  const std::string name = type_name(option);
  if (name == "UINT" || name == "INT" || name == "FLOAT") return "NUMBER";
  return name == "TEXT" ? "WORD" : name;
}

template <class Options>
std::vector<std::string> names_in(const Options& options) {
  std::vector<std::string> names;
  for (const CLI::Option* option : options) names.push_back(option->get_name());
  return names;
}

ManualOption option_of(CLI::Option& option) {
  ManualOption told;
  for (const std::string& name : option.get_lnames()) told.names.push_back("--" + name);
  for (const std::string& name : option.get_snames()) told.names.push_back("-" + name);
  if (option.get_positional()) told.names = {option.get_name()};
  told.value = option.get_positional() ? option.get_name() : value_name(option);
  told.standard = option.get_default_str();
  told.choices = offered(option);
  told.sentence = option.get_description();
  told.group = option.get_group();
  told.excludes = names_in(option.get_excludes());
  told.needs = names_in(option.get_needs());
  told.required = option.get_required();
  told.repeated = option.get_items_expected_max() > 1;
  return told;
}

/// The lines below "Examples:" of what stands at the end of --help.
std::vector<std::string> examples_of(const CLI::App& app) {
  std::vector<std::string> examples;
  std::istringstream footer(app.get_footer());
  for (std::string line; std::getline(footer, line);) {
    if (line.rfind("  ", 0) == 0) examples.push_back(line.substr(2));
  }
  return examples;
}

ManualCommand command_of(CLI::App& app, const std::string& before) {
  ManualCommand command;
  command.name = before + app.get_name();
  command.sentence = app.get_description();
  for (CLI::Option* option : app.get_options()) {
    auto& place = option->get_positional() ? command.arguments : command.options;
    place.push_back(option_of(*option));
  }
  command.examples = examples_of(app);
  for (CLI::App* below : app.get_subcommands({})) {
    command.commands.push_back(command_of(*below, command.name + ' '));
  }
  return command;
}

}  // namespace

ManualCommand manual_of(CLI::App& app) { return command_of(app, ""); }

ManualCommand manual_of_ranks(const ManualCommand& program) {
  ManualCommand command;
  command.name = program.name + "-mpi";
  command.call = "mpirun -n RANKS " + command.name;
  command.sentence = "The commands of " + program.name + ", whose paths many processes follow";
  command.options = program.options;
  command.examples = {"mpirun -n 4 moivre-mpi solve cyclic.phc --threads 1 --json roots.json",
                      "mpirun -n 4 moivre-mpi solve cyclic.phc --threads 1 --ledger run.db",
                      "srun moivre-mpi solve cyclic.phc --threads 1 --json roots.json"};
  for (const ManualCommand& below : program.commands) {
    ManualCommand& same = command.commands.emplace_back();
    same.name = command.name + ' ' + words_of(below);
    same.sentence = below.sentence;
  }
  return command;
}

std::string words_of(const ManualCommand& command) {
  const std::string program = command.name.substr(0, command.name.find(' '));
  if (program == command.name) return program == "moivre" ? "" : program;
  return command.name.substr(program.size() + 1);
}

}  // namespace moivre
