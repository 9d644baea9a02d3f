// SPDX-License-Identifier: MIT
// The options that commands share, in CLI11's terms.
#include "common_options.h"

#include <cerrno>
#include <cstdlib>
#include <stdexcept>

#include "choices.h"
#include "moivre/expression/words.h"
#include "moivre/polynomial/read.h"
#include "moivre/solver/solve.h"

namespace moivre {
void add_file(CLI::App& command, std::string& file) {
  command
      .add_option("FILE", file,
                  "polynomial system: equations, or another program's text form; - is standard "
                  "input")
      ->required();
}

void add_mechanism_file(CLI::App& command, std::string& file) {
  command
      .add_option("FILE", file,
                  "mechanism: bodies and joints, or typed equations (.toml); - is standard input")
      ->required();
}

void add_any_file(CLI::App& command, std::string& file) {
  command
      .add_option("FILE", file,
                  "mechanism or typed equations (.toml), else a polynomial system: equations, or "
                  "another program's text form")
      ->required();
}

System read_polynomial_file(const std::string& file) {
  const Source source = read_source(file);
  if (file.ends_with(".toml")) {
    throw std::invalid_argument(file +
                                ": this command takes polynomial systems; mechanisms (.toml) are "
                                "for closures, motion, sweep, newton, mobility, guesses, study and "
                                "family learn");
  }
  return read_system(source);
}

void add_start_options(CLI::App& command, StartChoice& choice) {
  CLI::Option* const start =
      command
          .add_option("--start", choice.kind,
                      "start system: auto, total-degree, multihomogeneous or polyhedral")
          ->capture_default_str();
  offer(*start, {"auto", "total-degree", "multihomogeneous", "polyhedral"});
  command.add_option("--seed", choice.seed, "seed of the random numbers in the start system")
      ->check(CLI::Validator(not_64_bits, ""))
      ->capture_default_str();
}

void require_known(const StartChoice& choice) {
  if (start_kind(choice.kind)) return;
  throw std::invalid_argument("--start " + choice.kind +
                              ": the start systems are auto, total-degree, multihomogeneous and "
                              "polyhedral");
}

StartKind kind_of(const StartChoice& choice) { return start_kind(choice.kind).value(); }

void add_json_option(CLI::App& command, std::string& path) {
  command.add_option("--json", path, "write JSON here; - is standard output")->type_name("PATH");
}

void add_threads_option(CLI::App& command, int& threads) {
  command.add_option("--threads", threads, "number of threads; 0: as many as the machine has")
      ->capture_default_str();
}

void add_time_option(CLI::App& command, double& at) {
  command.add_option("--at", at, "time of the drivers, in seconds")->capture_default_str();
}

void add_quiet_flag(CLI::App& command, bool& quiet) {
  command.add_flag("--quiet", quiet, "print no text and no progress line");
}

namespace {

/// CLI11's own check names the range: up to the 309 digits of the largest double.
std::string not_above_zero(const std::string& seconds) {
  const std::optional<double> limit = to_number(seconds);
  if (limit && *limit > 0) return "";
  return "a number of seconds above 0 is needed, not '" + seconds + "'";
}

}  // namespace

void add_time_limit_option(CLI::App& command, std::optional<double>& seconds) {
  command
      .add_option("--time-limit", seconds,
                  "stop after so many seconds with what is finished; exit code 2 then")
      ->check(CLI::Validator(not_above_zero, ""))
      ->type_name("SECONDS");
}

std::string not_64_bits(const std::string& number) {
  if (number.find('-') != std::string::npos) return number + " is negative";
  errno = 0;
  std::strtoull(number.c_str(), nullptr, 0);
  return errno == ERANGE ? number + " is beyond 64 bits" : "";
}

void require_all(const std::vector<std::function<void()>>& checks) {
  std::string refusals;
  for (const auto& check : checks) {
    try {
      check();
    } catch (const std::invalid_argument& refusal) {
      refusals += (refusals.empty() ? "" : "\nmoivre: ") + std::string(refusal.what());
    }
  }
  if (!refusals.empty()) throw std::invalid_argument(refusals);
}

void require_threads(int threads) {
  SolveOptions options;
  options.threads = threads;
  for (const std::string& sentence : validate(options)) throw std::invalid_argument(sentence);
}

void add_examples(CLI::App& command, const std::vector<std::string>& examples) {
  std::string text = "Examples:\n";
  for (const std::string& example : examples) text += "  " + example + '\n';
  command.footer(text);
}

}  // namespace moivre
