// SPDX-License-Identifier: MIT
// A line of `complete` for each command and option, on a condition that tells the command from the
// words typed so far.
#include "completion.h"
#include "moivre/expression/joined.h"

namespace moivre {
namespace {

// The words behind `moivre` up to the first option, as far as they are commands.
constexpr const char* kFunction = R"(function __moivre_command
    set -l command
    set -l words (commandline -opc)
    set -e words[1]
    for word in $words
        set -l longer $command $word
        contains -- "$longer" $__moivre_commands; or break
        set command $longer
    end
    test "$command" = "$argv"
end
complete -c moivre -f
)";

std::string quoted(const std::string& text) {
  std::string result = "'";
  for (const char c : text) {
    if (c == '\'' || c == '\\') result += '\\';
    result += c;
  }
  return result + "'";
}

std::string taken(const ManualOption& option) {
  switch (taken_by(option)) {
    case ValueKind::words:
      return " -x -a " + quoted(joined(option.choices, " "));
    case ValueKind::file:
      return " -r -F";
    case ValueKind::folder:
      return " -x -a '(__fish_complete_directories)'";
    case ValueKind::other:
      return " -x";
    case ValueKind::nothing:
      break;
  }
  return "";
}

}  // namespace

std::string fish_completion(const ManualCommand& program) {
  std::string names;
  std::string lines;
  for_each_command(program, [&](const ManualCommand& command) {
    const std::string words = words_of(command);
    if (!words.empty()) names += ' ' + quoted(words);
    const std::string begin = "complete -c moivre -n " + quoted("__moivre_command " + words);
    for (const ManualCommand& below : command.commands) {
      lines += begin + " -a " + below.name.substr(command.name.size() + 1) + " -d " +
               quoted(below.sentence) + '\n';
    }
    if (!command.arguments.empty()) lines += begin + " -F\n";
    for (const ManualOption& option : command.options) {
      lines += begin;
      for (const std::string& name : option.names) {
        lines += name.size() == 2 ? " -s " + name.substr(1) : " -l " + name.substr(2);
      }
      lines += taken(option) + " -d " + quoted(option.sentence) + '\n';
    }
  });
  return "# Completion of moivre in fish; made by the build from the options of the program.\nset "
         "-g __moivre_commands" +
         names + '\n' + kFunction + lines;
}

}  // namespace moivre
