// SPDX-License-Identifier: MIT
// The trackers' shared vocabulary: sums of counts, a single journey, and what a source throws.
#include "moivre/tracker/tracker.h"

#include <exception>

namespace moivre {

StepCount& StepCount::operator+=(const StepCount& other) {
  accepted += other.accepted;
  rejected += other.rejected;
  work += other.work;
  return *this;
}

namespace {

class SingleDeparture : public DepartureSource {
 public:
  explicit SingleDeparture(Departure&& departure) : departure_(std::move(departure)) {}

  std::optional<Departure> next() override {
    std::optional<Departure> result;
    result.swap(departure_);
    return result;
  }
  void arrived(const Departure&, Arrival&& arrival) override { arrival_ = std::move(arrival); }
  Arrival take() { return std::move(arrival_); }

 private:
  std::optional<Departure> departure_;
  Arrival arrival_;
};

/// Hands on what another source does, until that throws.
class CaughtSource : public DepartureSource {
 public:
  explicit CaughtSource(DepartureSource& source) : source_(source) {}

  std::optional<Departure> next() override {
    if (thrown_) return std::nullopt;
    try {
      return source_.next();
    } catch (...) {
      thrown_ = std::current_exception();
      return std::nullopt;
    }
  }
  void arrived(const Departure& departure, Arrival&& arrival) override {
    if (thrown_) return;
    try {
      source_.arrived(departure, std::move(arrival));
    } catch (...) {
      thrown_ = std::current_exception();
    }
  }
  void rethrow() const {
    if (thrown_) std::rethrow_exception(thrown_);
  }

 private:
  DepartureSource& source_;
  std::exception_ptr thrown_;
};

}  // namespace

void run_session(TrackerSession& session, DepartureSource& source, const std::atomic<bool>& stop) {
  CaughtSource caught(source);
  session.run(caught, stop);
  caught.rethrow();
}

Arrival follow(TrackerSession& session, Departure departure, const std::atomic<bool>& stop) {
  SingleDeparture source(std::move(departure));
  run_session(session, source, stop);
  return source.take();
}

}  // namespace moivre
