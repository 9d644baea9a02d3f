// SPDX-License-Identifier: MIT
// What does the command line tell of itself? The options and examples of every command, as man
// pages and completion show them.
//
// Everything is read off the objects that parse the command line and print --help: an option cannot
// be in one and not in the other.
#pragma once

#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace moivre {

struct ManualOption {
  std::vector<std::string> names;    ///< "--output", "-o"; of an argument by its place: "FILE"
  std::string value;                 ///< what stands behind it: "PATH"; empty: nothing does
  std::string standard;              ///< its default; empty where there is none
  std::vector<std::string> choices;  ///< the words that it takes; empty: any
  std::string sentence;
  std::string group;
  std::vector<std::string> excludes;
  std::vector<std::string> needs;
  bool required = false;
  bool repeated = false;
};

struct ManualCommand {
  std::string name;  ///< "moivre", "moivre solve", "moivre family learn", "moivre-mpi"
  std::string call;  ///< what is typed, where that is more than the name
  std::string sentence;
  std::vector<ManualOption> arguments;  ///< by their place
  std::vector<ManualOption> options;
  std::vector<std::string> examples;
  std::vector<ManualCommand> commands;
};

/// Of the whole program, where `app` is `moivre` with all its commands.
ManualCommand manual_of(CLI::App& app);

/// moivre-mpi, whose commands are those of `moivre` (here: `program`).
ManualCommand manual_of_ranks(const ManualCommand& program);

/// The name behind "moivre ": "", "solve", "family learn"; of another program its whole name.
std::string words_of(const ManualCommand& command);

/// Calls visit(command) for this one and all below it.
template <class Visit>
void for_each_command(const ManualCommand& command, Visit visit) {
  visit(command);
  for (const ManualCommand& below : command.commands) for_each_command(below, visit);
}

}  // namespace moivre
