// SPDX-License-Identifier: MIT
// How does the run stand whose ledger this is? Read beside the run, or after it.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <string_view>

#include "moivre/run_ledger/run_ledger.h"

namespace moivre {

struct RunStanding {
  RunIdentity identity;
  bool is_running = false;   ///< a process is writing it
  bool is_finished = false;  ///< there is an answer
  int exit_code = 0;         ///< of the last answer
  std::uint64_t done = 0;
  std::uint64_t total = 0;  ///< 0: not told yet
  std::uint64_t roots = 0;
  double seconds = 0;  ///< of work, all processes together
  // Outcomes that were observed, paths that were followed again among them.
  std::uint64_t outcomes = 0, to_roots = 0, at_infinity = 0, failed = 0;

  /// Seconds, at the rate so far; below 0: not known. Paths that wait to be taken up are done in
  /// part:
  /// they count once, as observed.
  double seconds_left() const;
};

/// Throws std::invalid_argument where the file is no ledger, or damaged, or of another format.
RunStanding read_standing(const std::string& path);

/// What the run has written last into this slot, piece by piece; false where it wrote none.
bool read_last_answer(const std::string& path, const std::string& slot,
                      const std::function<void(std::string_view)>& sink);

}  // namespace moivre
