// SPDX-License-Identifier: MIT
// The command line as a whole: its commands, its errors, its exit codes.
#include <algorithm>
#include <cstdio>
#include <iterator>
#include <new>
#include <set>
#include <sstream>

#include "command.h"
#include "moivre/expression/joined.h"
#include "moivre/expression/source.h"
#include "option_words.h"
#include "output.h"
#include "process_role.h"
#include "suggest.h"
#include "version_text.h"

namespace moivre {
namespace {

std::vector<std::string> command_names(const CLI::App& moivre) {
  std::vector<std::string> names;
  for (const CLI::App* command : moivre.get_subcommands({})) names.push_back(command->get_name());
  return names;
}

std::vector<std::string> option_names(const CLI::App& app) {
  std::vector<std::string> names;
  for (const CLI::Option* option : app.get_options()) {
    for (const std::string& name : option->get_lnames()) names.push_back("--" + name);
    for (const std::string& name : option->get_snames()) names.push_back("-" + name);
  }
  return names;
}

const CLI::App* find_command(const CLI::App& moivre, const std::string& name) {
  for (const CLI::App* command : moivre.get_subcommands({})) {
    if (command->get_name() == name) return command;
  }
  return nullptr;
}

std::string did_you_mean(const std::string& word, const std::vector<std::string>& known) {
  const auto suggestion = nearest(word, known);
  return suggestion ? "; did you mean " + *suggestion + "?" : "";
}

std::string unknown_command(const CLI::App& group, const std::string& word) {
  return "moivre: unknown command " + word + did_you_mean(word, command_names(group)) +
         "\nThe commands are " + joined(command_names(group), ", ") + ".\n";
}

/// A sentence for each word that is neither a command nor an option; empty when all are known.
std::string unknown_words(const CLI::App& moivre, const std::vector<std::string>& words) {
  const CLI::App* command = nullptr;
  std::string text;
  for (const std::string& word : words) {
    if (word == "--") break;
    if (word.size() > 1 && word.front() == '-') {
      const std::string name = word.substr(0, word.find('='));
      const bool is_number = name.find_first_not_of("-+.0123456789eE") == std::string::npos;
      const auto known = option_names(command != nullptr ? *command : moivre);
      if (is_number || std::find(known.begin(), known.end(), name) != known.end()) continue;
      text += "moivre: unknown option " + name + did_you_mean(name, known) + '\n';
    } else if (command == nullptr) {
      command = find_command(moivre, word);
      if (command == nullptr) return unknown_command(moivre, word);
    } else if (!command->get_subcommands({}).empty()) {
      const CLI::App* const group = command;
      command = find_command(*group, word);
      if (command == nullptr) return unknown_command(*group, word);
    }
  }
  return text;
}

/// A sentence where a word is empty, as a shell writes a variable without a value; else empty.
std::string empty_words(const std::vector<std::string>& words) {
  for (std::size_t k = 0; k < words.size(); ++k) {
    const std::string& word = words[k];
    const bool has_empty_value = word.starts_with("--") && word.find('=') + 1 == word.size();
    if (!word.empty() && !has_empty_value) continue;
    const std::string behind = k > 0 ? " behind " + words[k - 1] : "";
    return "moivre: " + (word.empty() ? "an argument" + behind : word) + " is empty\n";
  }
  return "";
}

/// A sentence where an option is the last word and wants another; else empty.
std::string no_value(const std::string& what) {
  const std::size_t colon = what.find(": 1 required ");
  if (colon == std::string::npos || !what.ends_with(" missing")) return "";
  return "moivre: " + what.substr(0, colon) + " needs a value behind it\n";
}

/// A sentence where an option's number is none, or goes on with letters or a comma; else empty.
std::string not_a_number(const std::string& what, const std::vector<std::string>& words) {
  for (std::size_t k = 0; k < words.size(); ++k) {
    const std::size_t equals = words[k].find('=');
    const bool has_value = words[k].starts_with("--") && equals != std::string::npos;
    const std::string option = words[k].substr(0, equals);
    if (!option.starts_with("--") || what.find(option + " ") == std::string::npos) continue;
    const std::string value =
        has_value ? words[k].substr(equals + 1) : (k + 1 < words.size() ? words[k + 1] : "");
    const std::size_t end = value.find_first_not_of("+-.0123456789eE");
    if (end == std::string::npos) continue;
    if (end == 0) {
      if (!what.starts_with("Could not convert")) continue;
      return "moivre: " + option + " takes a number, not " + value + '\n';
    }
    const bool is_comma = value[end] == ',';
    return "moivre: " + option + " takes a number, not " + value +
           (is_comma ? ": decimals have a point"
                     : ": write " + value.substr(0, end) + ", without a unit") +
           '\n';
  }
  return "";
}

int refuse(const std::string& text) {
  std::fputs(text.c_str(), stderr);
  return kUsage;
}

/// Whether several processes do the command's work together.
bool is_shared(const CLI::App& moivre) {
  static const std::set<std::string> kShared{"solve", "closures", "motion", "family", "sweep"};
  for (const CLI::App* command : moivre.get_subcommands()) {
    if (kShared.count(command->get_name()) > 0) return true;
  }
  return false;
}

struct Command {
  const char* name;
  void (*add)(CLI::App& moivre, Chosen& chosen);
};

constexpr Command kCommands[]{
    {"solve", add_solve_command},         {"track", add_track_command},
    {"info", add_info_command},           {"closures", add_closures_command},
    {"motion", add_motion_command},       {"newton", add_newton_command},
    {"mobility", add_mobility_command},   {"guesses", add_guesses_command},
    {"mechanism", add_mechanism_command}, {"study", add_study_command},
    {"check", add_check_command},         {"family", add_family_command},
    {"sweep", add_sweep_command},         {"ledger", add_ledger_command}};

/// Only the one that is called, where the first word names it: the options of all the others take
/// half a millisecond.
void add_commands(CLI::App& moivre, Chosen& chosen, const std::string& first_word) {
  const bool is_named = std::any_of(std::begin(kCommands), std::end(kCommands),
                                    [&](const Command& c) { return c.name == first_word; });
  for (const Command& command : kCommands) {
    if (!is_named || command.name == first_word) command.add(moivre, chosen);
  }
}

int parse_and_run(int argc, char** argv) {
  const std::vector<std::string> words(argv + std::min(argc, 1), argv + argc);
  CLI::App moivre;
  Chosen chosen;
  describe_program(moivre, chosen, words);
  const std::string empty = empty_words(words);
  if (!empty.empty()) return refuse(empty);
  try {
    moivre.parse(argc, argv);
  } catch (const CLI::Success& asked_for_text) {
    std::ostringstream text;
    const int code = moivre.exit(asked_for_text, text, text);
    write_to_stdout(text.str());
    return code;
  } catch (const CLI::ParseError& error) {
    std::string unknown = unknown_words(moivre, words);
    if (unknown.empty()) unknown = no_value(error.what());
    if (unknown.empty()) unknown = not_a_number(error.what(), words);
    return refuse(!unknown.empty() ? unknown
                                   : std::string("moivre: ") + error.what() +
                                         "\nmoivre --help shows how to call it.\n");
  }
  if (!process_role().tells && !is_shared(moivre)) return kDecided;
  return chosen();
}

}  // namespace

void describe_program(CLI::App& moivre, Chosen& chosen, const std::vector<std::string>& words) {
  moivre.name("moivre");
  moivre.description(
      "Finds every root of a polynomial system, and every way a mechanism can be assembled, by "
      "homotopy continuation.");
  const bool verbose = std::find(words.begin(), words.end(), "--verbose") != words.end();
  moivre.set_version_flag("--version", [verbose] { return version_text(verbose); });
  moivre.add_flag("--verbose")->description("with --version: also list what is built in");
  moivre.require_subcommand(1);
  moivre.footer("moivre COMMAND --help explains a command and shows examples.\n");
  add_commands(moivre, chosen, words.empty() ? "" : words.front());
}

int run_command_line(int argc, char** argv) noexcept {
  try {
    return parse_and_run(argc, argv);
  } catch (const ParseError& error) {
    return refuse(error.what());
  } catch (const std::invalid_argument& error) {
    return refuse("moivre: " + in_option_words(error.what()) + '\n');
  } catch (const std::overflow_error& error) {
    return refuse(std::string("moivre: ") + error.what() + '\n');
  } catch (const std::bad_alloc&) {
    return refuse("moivre: there is not enough memory\n");
  } catch (const std::exception& error) {
    std::fprintf(stderr, "moivre: internal error: %s\n", error.what());
  } catch (...) {
    std::fputs("moivre: internal error\n", stderr);
  }
  return kInternal;
}

}  // namespace moivre
