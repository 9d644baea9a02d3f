// SPDX-License-Identifier: MIT
// How does a call of Python survive its process? What it observes is kept in a ledger, and the same
// call goes on where it ended.
#pragma once

#include <pybind11/pybind11.h>

#include <atomic>
#include <memory>
#include <string>

#include "moivre/run_ledger/run_ledger.h"

namespace moivre::python {

class CallLedger {
 public:
  /// identity: what makes the call this one; the version and the instruction set are added. Throws
  /// std::invalid_argument where the file cannot be used, or is another run's.
  CallLedger(const std::string& path, RunIdentity identity);

  RunLedger& book() { return *book_; }
  /// Whether nothing more can be kept: the call is to stop.
  const std::atomic<bool>& is_broken() const { return is_broken_; }
  void note_stop() { is_stopped_ = true; }

  /// The call has ended: keeps its text, where it came to its end. Why not all was kept, or empty.
  std::string end(const std::string& text, bool is_complete);

 private:
  std::atomic<bool> is_broken_{false};
  bool is_stopped_ = false;
  std::unique_ptr<RunLedger> book_;  // last: it tells is_broken_ until it is gone
};

void bind_ledgers(pybind11::module_& module);

}  // namespace moivre::python
