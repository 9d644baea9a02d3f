// SPDX-License-Identifier: MIT
// Is the file read while a run may be writing it? Whether one is, is asked by the lock that it
// holds; asking takes it for an instant only.
//
// Private to the module.
#pragma once

#include <string>

namespace moivre {

/// Held together by all who read.
class LedgerReading {
 public:
  /// Throws std::invalid_argument where the file cannot be read.
  explicit LedgerReading(const std::string& path);
  // Not before SQLite has closed the file: it would lose its locks.
  ~LedgerReading();
  LedgerReading(const LedgerReading&) = delete;
  LedgerReading& operator=(const LedgerReading&) = delete;

  bool is_running = false;

 private:
  int file_;
};

}  // namespace moivre
