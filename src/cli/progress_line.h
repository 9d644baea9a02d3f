// SPDX-License-Identifier: MIT
// How far is the run? One line on a terminal's stderr, from the first second on, erased at the end.
#pragma once

#include <chrono>
#include <string>

#include "moivre/solver/solve.h"

namespace moivre {

class ProgressLine {
 public:
  /// Shows nothing where stderr is no terminal, or when it is not `wanted`.
  explicit ProgressLine(bool wanted);
  ~ProgressLine();
  ProgressLine(const ProgressLine&) = delete;
  ProgressLine& operator=(const ProgressLine&) = delete;

  bool is_active() const { return active_; }
  /// Not thread-safe; the solver calls it one call at a time.
  void show(const Progress& progress);
  /// The same with a text of one's own; seconds are added, and how many are left by the share of
  /// the work that is done.
  void show(const std::string& text, double done = 0);

 private:
  using Clock = std::chrono::steady_clock;
  bool active_;
  bool shown_ = false;
  Clock::time_point begin_ = Clock::now();
  Clock::time_point next_;
};

}  // namespace moivre
