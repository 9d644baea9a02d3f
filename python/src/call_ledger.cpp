// SPDX-License-Identifier: MIT
// The ledger of one call.
#include "call_ledger.h"

#include <pybind11/stl.h>

#include "moivre/numeric/fingerprint.h"
#include "moivre/report/version.h"

#if MOIVRE_WITH_LANES
#include "moivre/tracker_lanes/lane_tracker.h"
#endif

namespace moivre::python {
namespace {

std::string instruction_set() {
#if MOIVRE_WITH_LANES
  return lane_target();
#else
  return "none";
#endif
}

/// A call of Python asks one thing of its run.
Fingerprint the_question() {
  FingerprintMaker maker;
  maker.add(std::string("Python"));
  return maker.fingerprint();
}

}  // namespace

CallLedger::CallLedger(const std::string& path, RunIdentity identity) {
  identity.insert(identity.begin() + 1,
                  {{"version", std::string(version())}, {"instruction set", instruction_set()}});
  book_ = std::make_unique<RunLedger>(path, identity, [this] { is_broken_ = true; });
}

std::string CallLedger::end(const std::string& text, bool is_complete) {
  book_->close_observations();
  if (!is_stopped_ && !is_broken_) {
    constexpr int kUndecided = 2;
    book_->add_to_answer(the_question(), "text", text);
    book_->add_to_answer(the_question(), "unfinished", "");
    book_->end_answer(the_question(), is_complete ? 0 : kUndecided);
  }
  return book_->failure();
}

void bind_ledgers(pybind11::module_& module) {
  pybind11::class_<CallLedger>(module, "CallLedger")
      .def(pybind11::init<const std::string&, RunIdentity>())
      .def("end", &CallLedger::end);
}

}  // namespace moivre::python
