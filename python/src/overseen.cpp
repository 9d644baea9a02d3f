// SPDX-License-Identifier: MIT
// The watch over a thread that works.
#include "overseen.h"

#include <cmath>

#include "moivre/numeric/stopwatch.h"

namespace moivre::python {
namespace {

// Ctrl-C is answered, and progress is told, within this time.
constexpr std::chrono::milliseconds kGlance{50};

/// True where Ctrl-C was pressed and nothing else. Throws what another signal's handler raised.
bool is_interrupted() {
  if (PyErr_CheckSignals() == 0) return false;
  pybind11::error_already_set raised;
  if (!raised.matches(PyExc_KeyboardInterrupt)) throw std::move(raised);
  return true;
}

/// Shorter than a glance where the time ends before.
std::chrono::milliseconds until_look(const Terms& terms, const Stopwatch& stopwatch) {
  const double left = terms.time_limit.value_or(HUGE_VAL) - stopwatch.total();
  if (left <= 0 || left >= std::chrono::duration<double>(kGlance).count()) return kGlance;
  return std::chrono::milliseconds(static_cast<int>(left * 1000) + 1);
}

void show(Oversight& oversight, const pybind11::object& progress) {
  if (progress.is_none()) return;
  if (const std::optional<Advance> news = oversight.news()) progress(news->done, news->total);
}

}  // namespace

void Oversight::tell(std::uint64_t done, std::uint64_t total) {
  const std::lock_guard lock(mutex_);
  news_ = Advance{done, total};
}

void Oversight::finish() {
  const std::lock_guard lock(mutex_);
  is_finished_ = true;
  changed_.notify_all();
}

bool Oversight::wait(std::chrono::milliseconds longest) {
  std::unique_lock lock(mutex_);
  return changed_.wait_for(lock, longest, [this] { return is_finished_; });
}

std::optional<Advance> Oversight::news() {
  const std::lock_guard lock(mutex_);
  return std::exchange(news_, std::nullopt);
}

std::exception_ptr watch(Oversight& oversight, const Terms& terms) {
  const Stopwatch stopwatch;
  const pybind11::object& progress = terms.progress;
  std::exception_ptr raised;
  bool is_second = false;
  const auto wait = [&] {
    const pybind11::gil_scoped_release free;
    return oversight.wait(until_look(terms, stopwatch));
  };
  while (!wait()) {
    try {
      if (terms.ledger != nullptr && terms.ledger->is_broken()) oversight.request_stop();
      if (terms.time_limit && stopwatch.total() >= *terms.time_limit) oversight.request_stop();
      if (is_interrupted()) {
        if (is_second) {
          PyErr_SetNone(PyExc_KeyboardInterrupt);
          throw pybind11::error_already_set();
        }
        is_second = true;
        oversight.request_stop();
      }
      if (!raised) show(oversight, progress);
    } catch (...) {
      raised = std::current_exception();
      oversight.request_stop();
    }
  }
  try {
    if (!raised) show(oversight, progress);
  } catch (...) {
    raised = std::current_exception();
  }
  return raised;
}

}  // namespace moivre::python
