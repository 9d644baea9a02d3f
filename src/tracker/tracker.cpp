// SPDX-License-Identifier: MIT
// The trackers' shared vocabulary: sums of counts, a single journey.
#include "moivre/tracker/tracker.h"

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

}  // namespace

Arrival follow(TrackerSession& session, Departure departure, const std::atomic<bool>& stop) {
  SingleDeparture source(std::move(departure));
  session.run(source, stop);
  return source.take();
}

}  // namespace moivre
