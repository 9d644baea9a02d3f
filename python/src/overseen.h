// SPDX-License-Identifier: MIT
// How does Python stay in charge while the library works? The work has a thread of its own, without
// Python's lock; the caller's thread looks for Ctrl-C and tells of progress.
//
// The first Ctrl-C asks the work to stop, and what is finished is the result; a second one is
// Python's KeyboardInterrupt, raised as soon as the work has stopped. An exception of the progress
// function likewise ends the work, and is passed on. Both are looked for every kGlance, so that no
// path waits for Python. A limit of time asks as the first Ctrl-C does, and so does a ledger that
// cannot be written.
#pragma once

#include <pybind11/pybind11.h>

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <cstdint>
#include <exception>
#include <mutex>
#include <optional>
#include <thread>
#include <type_traits>

#include "call_ledger.h"

namespace moivre::python {

/// How far the work is: a number of paths, poses, samples, ...
struct Advance {
  std::uint64_t done = 0;
  std::uint64_t total = 0;
};

class Oversight {
 public:
  explicit Oversight(CallLedger* ledger) : ledger_(ledger) {}

  /// nullptr: the call is not kept.
  CallLedger* ledger() const { return ledger_; }
  const std::atomic<bool>& stop() const { return stop_; }
  void request_stop() { stop_ = true; }

  /// From any thread.
  void tell(std::uint64_t done, std::uint64_t total);
  void finish();
  /// True when the work has finished; false when it was waited for so long.
  bool wait(std::chrono::milliseconds longest);
  /// What was told since this was last asked.
  std::optional<Advance> news();

 private:
  CallLedger* ledger_;
  std::atomic<bool> stop_{false};
  std::mutex mutex_;
  std::condition_variable changed_;
  bool is_finished_ = false;
  std::optional<Advance> news_;
};

/// Whom a call tells, and how long it may take.
struct Terms {
  pybind11::object progress;         ///< None, or called with (done, total)
  std::optional<double> time_limit;  ///< seconds
  CallLedger* ledger = nullptr;      ///< not owned
};

/// Until the work has finished. Returns what Python raised meanwhile.
std::exception_ptr watch(Oversight& oversight, const Terms& terms);

/// work(Oversight&) in a thread of its own.
template <class Work>
auto overseen(const Terms& terms, Work work) {
  std::optional<std::invoke_result_t<Work, Oversight&>> result;
  std::exception_ptr fault;
  Oversight oversight(terms.ledger);
  std::thread worker([&] {
    try {
      result.emplace(work(oversight));
    } catch (...) {
      fault = std::current_exception();
    }
    oversight.finish();
  });
  const std::exception_ptr raised = watch(oversight, terms);
  worker.join();
  if (terms.ledger != nullptr && oversight.stop()) terms.ledger->note_stop();
  if (raised) std::rethrow_exception(raised);
  if (fault) std::rethrow_exception(fault);
  return std::move(*result);
}

}  // namespace moivre::python
