// SPDX-License-Identifier: MIT
// Output files by POSIX descriptors: opened early, cut to length and written late.
#include "output.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <stdexcept>

namespace moivre {
namespace {

[[noreturn]] void refuse(const std::string& path) {
  throw std::invalid_argument("cannot write " + path + ": " + std::strerror(errno));
}

void write_all(int descriptor, std::string_view text, const std::string& name) {
  while (!text.empty()) {
    const ssize_t written = ::write(descriptor, text.data(), text.size());
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) refuse(name);
    text.remove_prefix(static_cast<std::size_t>(written));
  }
}

bool is_regular(int descriptor) {
  struct stat status;
  return ::fstat(descriptor, &status) == 0 && S_ISREG(status.st_mode);
}

}  // namespace

Output::Output(const std::string& path) : path_(path) {
  if (!is_wanted() || is_stdout()) return;
  constexpr mode_t kReadWriteForAll = 0666;  // less what the umask takes away
  descriptor_ = ::open(path.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, kReadWriteForAll);
  is_new_ = descriptor_ >= 0;
  if (!is_new_ && errno == EEXIST)
    descriptor_ = ::open(path.c_str(), O_WRONLY | O_CREAT | O_CLOEXEC, kReadWriteForAll);
  if (descriptor_ < 0) refuse(path);
}

Output::~Output() {
  if (descriptor_ < 0) return;
  ::close(descriptor_);
  if (is_new_) ::unlink(path_.c_str());
}

void Output::write(std::string_view text) {
  if (is_stdout()) return write_to_stdout(text);
  if (is_regular(descriptor_) && ::ftruncate(descriptor_, 0) != 0) refuse(path_);
  is_new_ = false;
  write_all(descriptor_, text, path_);
  const int descriptor = descriptor_;
  descriptor_ = -1;
  if (::close(descriptor) != 0) refuse(path_);
}

void write_to_stdout(std::string_view text) { write_all(STDOUT_FILENO, text, "standard output"); }

void require_distinct(const std::vector<std::string>& outputs, const std::string& input) {
  std::error_code ignored;
  for (std::size_t i = 0; i < outputs.size(); ++i) {
    if (outputs[i].empty()) continue;
    for (std::size_t j = 0; j < i; ++j) {
      if (outputs[i] != outputs[j]) continue;
      throw std::invalid_argument(outputs[i] == "-" ? "only one result can go to standard output"
                                                    : "two results would go to " + outputs[i]);
    }
    if (outputs[i] != "-" && std::filesystem::is_regular_file(input, ignored) &&
        std::filesystem::equivalent(outputs[i], input, ignored)) {
      throw std::invalid_argument("the result would overwrite the problem file " + input);
    }
  }
}

}  // namespace moivre
