// SPDX-License-Identifier: MIT
// A lock by flock(), and what is found behind the name.
#include "file_lock.h"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <cstring>
#include <stdexcept>
#include <string_view>
#include <thread>

namespace moivre {
namespace {

/// One who only looks holds the lock for an instant.
bool has_locked(int file) {
  if (::flock(file, LOCK_EX | LOCK_NB) == 0) return true;
  std::this_thread::sleep_for(std::chrono::milliseconds(100));
  return ::flock(file, LOCK_EX | LOCK_NB) == 0;
}

bool is_database(int file) {
  constexpr std::string_view kSqlite = "SQLite format 3";
  char head[kSqlite.size()] = {};
  const bool is_read = ::pread(file, head, sizeof head, 0) == static_cast<ssize_t>(sizeof head);
  return is_read && std::string_view(head, sizeof head) == kSqlite;
}

}  // namespace

std::string no_ledger(const std::string& path, int file) {
  struct stat status = {};
  if (::fstat(file, &status) != 0 || !S_ISREG(status.st_mode))
    return "cannot use " + path + " as a ledger: it is no regular file";
  return status.st_size > 0 && !is_database(file) ? path + " is no ledger of a run" : "";
}

FileLock::FileLock(const std::string& path)
    : path_(path), file_(::open(path.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0666)) {
  struct stat status = {};
  if (file_ < 0 || ::fstat(file_, &status) != 0) {
    throw std::invalid_argument("cannot write the ledger " + path + ": " + std::strerror(errno));
  }
  device_ = status.st_dev;
  node_ = status.st_ino;
  std::string why = no_ledger(path, file_);
  if (why.empty() && !has_locked(file_)) why = "another process is writing the ledger " + path;
  if (why.empty()) return;
  ::close(file_);
  throw std::invalid_argument(why);
}

FileLock::~FileLock() { ::close(file_); }

bool FileLock::is_in_place() const {
  struct stat status = {};
  return ::stat(path_.c_str(), &status) == 0 && status.st_dev == device_ && status.st_ino == node_;
}

}  // namespace moivre
