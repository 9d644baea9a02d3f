// SPDX-License-Identifier: MIT
// Who writes this file? One process at a time: it holds a lock that the kernel lets go when the
// process ends, however it ends.
//
// Private to the module. SQLite's own locks are of another kind, and lost where any descriptor of
// the file is closed: this one stays open as long as the database.
#pragma once

#include <sys/types.h>

#include <string>

namespace moivre {

/// Why this open file can be no ledger; empty where it may be one, as an empty file may.
std::string no_ledger(const std::string& path, int file);

class FileLock {
 public:
  /// Makes an empty file where there is none. Throws std::invalid_argument where the file is no
  /// database, cannot be written, or is locked.
  explicit FileLock(const std::string& path);
  ~FileLock();
  FileLock(const FileLock&) = delete;
  FileLock& operator=(const FileLock&) = delete;

  /// Whether the file still has its name.
  bool is_in_place() const;

 private:
  std::string path_;
  int file_;
  dev_t device_ = 0;
  ino_t node_ = 0;
};

}  // namespace moivre
