// SPDX-License-Identifier: MIT
// How far is the run? One line on a terminal's stderr, from the first second on, erased at the end.
//
// Its seconds go on where nothing new is told: long work between two reports is seen to go on. How
// many are left is what the share of the work that is done foretold; nothing when these are over.
#pragma once

#include <chrono>
#include <condition_variable>
#include <mutex>
#include <string>
#include <thread>

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
  void show(const Progress& progress);
  /// The same with a text of one's own; seconds are added, and how many are left by the share of
  /// the work that is done.
  void show(const std::string& text, double done = 0);
  /// Erases it for good: before results are told. So does the destructor.
  void end();

 private:
  using Clock = std::chrono::steady_clock;

  /// Whether it is time for another line, in which case its text is worth making.
  bool is_due();
  void draw(Clock::time_point now);
  void go_on_by_itself();

  bool active_;
  Clock::time_point begin_ = Clock::now();
  std::mutex mutex_;  ///< of all that follows
  bool shown_ = false;
  bool is_over_ = false;
  Clock::time_point next_;
  std::string text_;
  double done_ = 0;
  Clock::time_point done_since_ = begin_;
  std::condition_variable wake_;
  std::thread seconds_;
};

}  // namespace moivre
