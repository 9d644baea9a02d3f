// SPDX-License-Identifier: MIT
// A shared lock, tried and let go.
#include "ledger_reading.h"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <stdexcept>
#include <string>

#include "file_lock.h"

namespace moivre {

LedgerReading::LedgerReading(const std::string& path)
    : file_(::open(path.c_str(), O_RDONLY | O_NONBLOCK | O_CLOEXEC)) {
  if (file_ < 0) {
    throw std::invalid_argument("cannot read the ledger " + path + ": " + std::strerror(errno));
  }
  const std::string why = no_ledger(path, file_);
  if (!why.empty()) {
    ::close(file_);
    throw std::invalid_argument(why);
  }
  is_running = ::flock(file_, LOCK_SH | LOCK_NB) != 0;
  ::flock(file_, LOCK_UN);
}

LedgerReading::~LedgerReading() { ::close(file_); }

}  // namespace moivre
