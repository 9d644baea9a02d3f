// SPDX-License-Identifier: MIT
// Two tables, made of the options, and a function that looks into them.
#include <algorithm>

#include "completion.h"
#include "moivre/expression/joined.h"

namespace moivre {
namespace {

// readline cuts --option=value at the "=", into three words.
constexpr const char* kFunction = R"bash(_moivre() {
  local word=${COMP_WORDS[COMP_CWORD]} before=${COMP_WORDS[COMP_CWORD-1]} command='' k
  if [[ $word == = ]]; then
    word=''
  elif [[ $before == = ]] && ((COMP_CWORD > 2)); then
    before=${COMP_WORDS[COMP_CWORD-2]}
  fi
  for ((k = 1; k < COMP_CWORD; ++k)); do
    _moivre_is_command "${command:+$command }${COMP_WORDS[k]}" || break
    command=${command:+$command }${COMP_WORDS[k]}
  done

  local taken=''
  [[ $before != -* ]] || taken=$(_moivre_taken "$command" "$before")
  if [[ -z $taken && $word == -* ]]; then
    taken="words $(_moivre_options "$command")"
  elif [[ -z $taken ]]; then
    taken=$(_moivre_taken "$command" '')
  fi
  COMPREPLY=()
  case $taken in
    words*) mapfile -t COMPREPLY < <(compgen -W "${taken#words}" -- "$word") ;;
    file) mapfile -t COMPREPLY < <(compgen -f -- "$word") ;;
    folder) mapfile -t COMPREPLY < <(compgen -d -- "$word") ;;
    either*) mapfile -t COMPREPLY < <(compgen -W "${taken#either}" -- "$word"; compgen -f -- "$word") ;;
  esac
  case $taken in
    file | folder | either*) compopt -o filenames 2>/dev/null ;;
  esac
  return 0
}
complete -F _moivre moivre
)bash";

std::string taken(const ManualOption& option) {
  switch (taken_by(option)) {
    case ValueKind::words:
      return "words " + joined(option.choices, " ");
    case ValueKind::file:
      return "file";
    case ValueKind::folder:
      return "folder";
    case ValueKind::other:
      return "other";
    case ValueKind::nothing:
      break;
  }
  return "";
}

/// The names of commands, or what the first argument by its place takes.
std::string taken_by_place(const ManualCommand& command) {
  if (command.commands.empty()) return command.arguments.empty() ? "" : taken(command.arguments[0]);
  std::vector<std::string> names;
  for (const ManualCommand& below : command.commands) {
    names.push_back(below.name.substr(command.name.size() + 1));
  }
  return (command.arguments.empty() ? "words " : "either ") + joined(names, " ");
}

std::string is_command(const ManualCommand& program) {
  std::vector<std::string> names;
  for_each_command(program, [&](const ManualCommand& command) {
    if (!words_of(command).empty()) names.push_back("'" + words_of(command) + "'");
  });
  return "_moivre_is_command() {\n  case $1 in\n    " + joined(names, " | ") +
         ") return 0 ;;\n  esac\n  return 1\n}\n";
}

std::string options(const ManualCommand& program) {
  std::string text = "_moivre_options() {\n  case $1 in\n";
  for_each_command(program, [&](const ManualCommand& command) {
    std::vector<std::string> names;
    for (const ManualOption& option : command.options) {
      names.insert(names.end(), option.names.begin(), option.names.end());
    }
    text += "    '" + words_of(command) + "') echo '" + joined(names, " ") + "' ;;\n";
  });
  return text + "  esac\n}\n";
}

/// $1: the command, $2: the option; empty: an argument by its place.
std::string all_taken(const ManualCommand& program) {
  std::string text = "_moivre_taken() {\n  case \"$1:$2\" in\n";
  for_each_command(program, [&](const ManualCommand& command) {
    const std::string begin = "    '" + words_of(command) + ":";
    for (const ManualOption& option : command.options) {
      if (taken_by(option) == ValueKind::nothing) continue;
      std::vector<std::string> patterns;
      for (const std::string& name : option.names) {
        patterns.push_back("'" + words_of(command) + ':' + name + "'");
      }
      text += "    " + joined(patterns, " | ") + ") echo '" + taken(option) + "' ;;\n";
    }
    text += begin + "') echo '" + taken_by_place(command) + "' ;;\n";
  });
  return text + "  esac\n}\n";
}

}  // namespace

ValueKind taken_by(const ManualOption& option) {
  if (option.value.empty()) return ValueKind::nothing;
  if (!option.choices.empty()) return ValueKind::words;
  if (option.value == "FOLDER") return ValueKind::folder;
  const bool is_argument = option.names.front().front() != '-';
  const bool is_file = is_argument || option.value == "PATH" || option.value == "FILE";
  return is_file ? ValueKind::file : ValueKind::other;
}

std::string bash_completion(const ManualCommand& program) {
  return "# shellcheck shell=bash\n# Completion of moivre in bash; made by the build from the "
         "options of the program.\n" +
         is_command(program) + options(program) + all_taken(program) + kFunction;
}

}  // namespace moivre
