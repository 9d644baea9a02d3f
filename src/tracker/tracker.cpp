// SPDX-License-Identifier: MIT
// The trackers' shared vocabulary: names of journeys' ends, sums of counts, a single journey.
#include "moivre/tracker/tracker.h"

namespace moivre {

std::string to_string(Journey journey) {
  switch (journey) {
    case Journey::arrived:
      return "arrived";
    case Journey::stopped:
      return "stopped";
    case Journey::bad_start:
      return "bad start";
    case Journey::step_limit:
      return "step limit";
    case Journey::step_too_small:
      return "step too small";
    case Journey::off_path:
      return "off the path";
    case Journey::cancelled:
      return "cancelled";
  }
  return "";
}

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
