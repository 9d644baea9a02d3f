// SPDX-License-Identifier: MIT
// gnuplot as a process of its own, found on the PATH.
#include "gnuplot.h"

#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>

namespace moivre {

GnuplotOutcome run_gnuplot(const std::string& folder, const std::string& script) {
  std::string program = "gnuplot";
  std::string argument = script;
  char* arguments[]{program.data(), argument.data(), nullptr};
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_addchdir_np(&actions, folder.c_str());
  pid_t process = 0;
  const int error = posix_spawnp(&process, program.c_str(), &actions, nullptr, arguments, environ);
  posix_spawn_file_actions_destroy(&actions);
  if (error != 0) return error == ENOENT ? GnuplotOutcome::no_gnuplot : GnuplotOutcome::failed;
  int status = 0;
  while (waitpid(process, &status, 0) < 0) {
    if (errno != EINTR) return GnuplotOutcome::failed;
  }
  return WIFEXITED(status) && WEXITSTATUS(status) == 0 ? GnuplotOutcome::drawn
                                                       : GnuplotOutcome::failed;
}

}  // namespace moivre
