// SPDX-License-Identifier: MIT
// A call of _arguments for each command, and of _describe for each list of commands.
#include <algorithm>

#include "completion.h"

namespace moivre {
namespace {

/// In a specification of _arguments, within single quotes.
std::string escaped(const std::string& text) {
  std::string result;
  for (const char c : text) {
    if (c == '\'') {
      result += "'\\''";
    } else {
      if (c == '[' || c == ']' || c == ':' || c == '\\') result += '\\';
      result += c;
    }
  }
  return result;
}

std::string action(const ManualOption& option) {
  std::string words;
  switch (taken_by(option)) {
    case ValueKind::words:
      for (const std::string& word : option.choices) words += (words.empty() ? "" : " ") + word;
      return ":" + option.value + ":(" + words + ")";
    case ValueKind::file:
      return ":" + option.value + ":_files";
    case ValueKind::folder:
      return ":" + option.value + ":_files -/";
    case ValueKind::other:
      return ":" + escaped(option.value) + ": ";
    case ValueKind::nothing:
      break;
  }
  return "";
}

std::string function_of(const ManualCommand& command) {
  std::string name = "_" + command.name;
  std::replace(name.begin(), name.end(), ' ', '_');
  return name;
}

/// "'(-o --output)'{-o,--output}'[write here]:PATH:_files'"; one that may be repeated excludes
/// nothing.
std::string option_line(const ManualOption& option) {
  std::string all, cases;
  for (const std::string& name : option.names) {
    all += (all.empty() ? "" : " ") + name;
    cases += (cases.empty() ? "" : ",") + name;
  }
  const std::string excluded = option.repeated ? "*" : "(" + all + ")";
  if (option.names.size() > 1) cases = "'{" + cases + "}'";
  return "    '" + excluded + cases + "[" + escaped(option.sentence) + "]" + action(option) + "'";
}

std::string arguments_call(const ManualCommand& command) {
  std::string text = "  _arguments -s -S";
  for (const ManualOption& option : command.options) text += " \\\n" + option_line(option);
  if (!command.commands.empty()) return text + " \\\n    '1: :->command' '*:: :->rest'\n";
  for (const ManualOption& argument : command.arguments) {
    text += std::string(" \\\n    '") + (argument.repeated ? "*" : "") + action(argument) + "'";
  }
  return text + '\n';
}

std::string function(const ManualCommand& command) {
  std::string text = function_of(command) + "() {\n";
  if (command.commands.empty()) return text + arguments_call(command) + "}\n";
  text += "  local context state line\n  typeset -A opt_args\n" + arguments_call(command) +
          "  case $state in\n    command)\n      local -a commands=(\n";
  std::string calls;
  for (const ManualCommand& below : command.commands) {
    const std::string name = below.name.substr(command.name.size() + 1);
    text += "        '" + name + ':' + escaped(below.sentence) + "'\n";
    calls += "        " + name + ") " + function_of(below) + " ;;\n";
  }
  const std::string or_file = command.arguments.empty() ? "" : "; _files";
  return text + "      )\n      _describe command commands" + or_file +
         " ;;\n    rest)\n      case $line[1] in\n" + calls + "      esac ;;\n  esac\n}\n";
}

}  // namespace

std::string zsh_completion(const ManualCommand& program) {
  std::string text =
      "#compdef moivre\n# Completion of moivre in zsh; made by the build from the options of the "
      "program.\n";
  for_each_command(program, [&](const ManualCommand& command) { text += function(command); });
  return text + "_moivre \"$@\"\n";
}

}  // namespace moivre
