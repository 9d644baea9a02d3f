// SPDX-License-Identifier: MIT
// What does the program do when it is called like this? Runs `moivre` in a folder of its own and
// catches all it says.
#pragma once

#include <functional>
#include <string>
#include <vector>

namespace moivre::test {

struct Outcome {
  int exit_code = -1;  ///< -1 when a signal ended the program
  std::string out;
  std::string err;
  double after_signal = 0;  ///< seconds from the signal of run_until() to the end
};

/// A folder for one test, with the files that it writes.
class Scene {
 public:
  /// The file that the program reads as standard input, where it was written; else the tests' own.
  static constexpr const char* kInput = ".in";

  Scene();
  ~Scene();
  Scene(const Scene&) = delete;
  Scene& operator=(const Scene&) = delete;

  void write(const std::string& name, const std::string& text) const;
  std::string read(const std::string& name) const;
  bool has(const std::string& name) const;
  std::string path(const std::string& name) const;
  /// The names of all files, each on a line.
  std::string listing() const;

  /// Runs `moivre` with these arguments in the folder.
  Outcome run(const std::vector<std::string>& arguments) const;
  /// The same, with a terminal as stderr where `terminal`, and `meanwhile` called with the process
  /// id while it runs.
  Outcome run(const std::vector<std::string>& arguments, bool terminal,
              const std::function<void(int)>& meanwhile) const;

  /// The same of another program.
  Outcome run_program(const std::string& program, const std::vector<std::string>& arguments,
                      const std::function<void(int)>& meanwhile) const;

  /// The same with a terminal as stderr; the signal is sent when `wanted` was seen on it.
  Outcome run_until(const std::vector<std::string>& arguments, const std::string& wanted,
                    int signal) const;

 private:
  Outcome run_in(const std::string& program, const std::vector<std::string>& arguments,
                 bool terminal, const std::function<void(int)>& meanwhile,
                 const std::function<void(int, const std::string&)>& seen) const;

  std::string folder_;
};

/// Is this one of the lines of the text, from its first character to its last?
inline bool has_line(const std::string& text, const std::string& line) {
  return ('\n' + text).find('\n' + line + '\n') != std::string::npos;
}

inline bool contains(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

/// Waits until the process catches SIGINT. False when it does not within ten seconds.
bool catches_interrupt(int process);

/// Waits until the process, all its threads together, has taken so many seconds of processor time:
/// its work has come as far on a busy machine as on an idle one. False when it ended before, or
/// does not get there within two minutes.
bool has_worked(int process, double seconds);

/// For Scene::run(): sends the signal to a process that catches it and has worked so long.
std::function<void(int)> send_after(double seconds, int signal);

}  // namespace moivre::test
