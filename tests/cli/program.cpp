// SPDX-License-Identifier: MIT
// Calls of the program by fork and exec; its output goes to files, or stderr to a pseudo-terminal.
#include "program.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <pty.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <optional>
#include <sstream>
#include <stdexcept>
#include <thread>

namespace moivre::test {
namespace {

namespace fs = std::filesystem;

std::string content(const fs::path& file) {
  std::ifstream stream(file, std::ios::binary);
  std::ostringstream text;
  text << stream.rdbuf();
  return text.str();
}

[[noreturn]] void become(const std::string& program, const std::vector<std::string>& arguments,
                         const std::string& folder, int terminal) {
  const fs::path here = folder;
  const int out = ::open((here / ".out").c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
  const int err = terminal >= 0
                      ? terminal
                      : ::open((here / ".err").c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
  const int in = ::open((here / Scene::kInput).c_str(), O_RDONLY);
  if (in >= 0) ::dup2(in, STDIN_FILENO);
  ::dup2(out, STDOUT_FILENO);
  ::dup2(err, STDERR_FILENO);
  if (::chdir(folder.c_str()) != 0) ::_exit(127);
  std::vector<char*> words;
  std::string name = "moivre";
  words.push_back(name.data());
  std::vector<std::string> copies = arguments;
  for (std::string& copy : copies) words.push_back(copy.data());
  words.push_back(nullptr);
  ::execv(program.c_str(), words.data());
  ::_exit(127);
}

/// `seen` is called with all that came so far.
std::string drained(int descriptor, const std::function<void(const std::string&)>& seen) {
  std::string text;
  char buffer[4096];
  for (ssize_t got = 0; (got = ::read(descriptor, buffer, sizeof buffer)) > 0;) {
    text.append(buffer, static_cast<std::size_t>(got));
    seen(text);
  }
  return text;
}

}  // namespace

Scene::Scene() {
  std::string pattern = (fs::temp_directory_path() / "moivre-cli-XXXXXX").string();
  if (::mkdtemp(pattern.data()) == nullptr) throw std::runtime_error("no temporary folder");
  folder_ = pattern;
}

Scene::~Scene() {
  std::error_code ignored;
  fs::remove_all(folder_, ignored);
}

void Scene::write(const std::string& name, const std::string& text) const {
  std::ofstream(fs::path(folder_) / name, std::ios::binary) << text;
}

std::string Scene::read(const std::string& name) const { return content(fs::path(folder_) / name); }

bool Scene::has(const std::string& name) const { return fs::exists(fs::path(folder_) / name); }

std::string Scene::path(const std::string& name) const {
  return (fs::path(folder_) / name).string();
}

std::string Scene::listing() const {
  std::string names;
  for (const auto& entry : fs::directory_iterator(folder_)) {
    names += entry.path().filename().string() + '\n';
  }
  return names;
}

Outcome Scene::run(const std::vector<std::string>& arguments) const {
  return run(arguments, false, [](int) {});
}

Outcome Scene::run(const std::vector<std::string>& arguments, bool terminal,
                   const std::function<void(int)>& meanwhile) const {
  return run_in(MOIVRE_PROGRAM, arguments, terminal, meanwhile, [](int, const std::string&) {});
}

Outcome Scene::run_until(const std::vector<std::string>& arguments, const std::string& wanted,
                         int signal) const {
  using Clock = std::chrono::steady_clock;
  std::optional<Clock::time_point> sent;
  Outcome outcome = run_in(
      MOIVRE_PROGRAM, arguments, true, [](int) {},
      [&](int process, const std::string& text) {
        if (sent || !contains(text, wanted)) return;
        ::kill(process, signal);
        sent = Clock::now();
      });
  if (sent) outcome.after_signal = std::chrono::duration<double>(Clock::now() - *sent).count();
  return outcome;
}

Outcome Scene::run_program(const std::string& program, const std::vector<std::string>& arguments,
                           const std::function<void(int)>& meanwhile) const {
  return run_in(program, arguments, false, meanwhile, [](int, const std::string&) {});
}

Outcome Scene::run_in(const std::string& program, const std::vector<std::string>& arguments,
                      bool terminal, const std::function<void(int)>& meanwhile,
                      const std::function<void(int, const std::string&)>& seen) const {
  int master = -1;
  int slave = -1;
  if (terminal && ::openpty(&master, &slave, nullptr, nullptr, nullptr) != 0) {
    throw std::runtime_error("no pseudo-terminal");
  }
  const pid_t process = ::fork();
  if (process == 0) become(program, arguments, folder_, slave);
  if (terminal) ::close(slave);
  meanwhile(process);
  Outcome outcome;
  if (terminal) {
    outcome.err = drained(master, [&](const std::string& text) { seen(process, text); });
  }
  int status = 0;
  ::waitpid(process, &status, 0);
  if (terminal) ::close(master);
  outcome.exit_code = WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  outcome.out = read(".out");
  if (!terminal) outcome.err = read(".err");
  return outcome;
}

bool catches_interrupt(int process) {
  const std::string file = "/proc/" + std::to_string(process) + "/status";
  const auto give_up = std::chrono::steady_clock::now() + std::chrono::seconds(10);
  while (std::chrono::steady_clock::now() < give_up) {
    std::ifstream stream(file);
    for (std::string line; std::getline(stream, line);) {
      if (line.rfind("SigCgt:", 0) != 0) continue;
      const unsigned long long caught = std::strtoull(line.c_str() + 7, nullptr, 16);
      if ((caught >> (SIGINT - 1)) & 1U) return true;
    }
    std::this_thread::sleep_for(std::chrono::milliseconds(2));
  }
  return false;
}

bool has_worked(int process, double seconds) {
  const std::string file = "/proc/" + std::to_string(process) + "/stat";
  const double ticks = seconds * static_cast<double>(::sysconf(_SC_CLK_TCK));
  const auto give_up = std::chrono::steady_clock::now() + std::chrono::minutes(2);
  while (std::chrono::steady_clock::now() < give_up) {
    // Behind the name in parentheses: the state, ten numbers, and what user and system took.
    const std::string text = content(file);
    std::istringstream fields(text.substr(text.rfind(')') + 1));
    std::string state;
    fields >> state;
    if (!fields || state == "Z") return false;
    for (int k = 0; k < 10; ++k) fields >> state;
    double user = 0, system = 0;
    if (fields >> user >> system && user + system >= ticks) return true;
    std::this_thread::sleep_for(std::chrono::milliseconds(2));
  }
  return false;
}

std::function<void(int)> send_after(double seconds, int signal) {
  return [seconds, signal](int process) {
    EXPECT_TRUE(catches_interrupt(process));
    EXPECT_TRUE(has_worked(process, seconds)) << "it ended, or stood still";
    ::kill(process, signal);
  };
}

}  // namespace moivre::test
