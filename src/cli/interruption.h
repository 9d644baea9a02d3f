// SPDX-License-Identifier: MIT
// How does Ctrl-C end a run? The first one asks it to stop with what is finished, the second ends the program at once.
#pragma once

#include <atomic>

namespace moivre {

/// Catches SIGINT and SIGTERM while it lives; one at a time.
class Interruption {
 public:
  Interruption();
  ~Interruption();
  Interruption(const Interruption&) = delete;
  Interruption& operator=(const Interruption&) = delete;

  const std::atomic<bool>& stop() const;
};

}  // namespace moivre
