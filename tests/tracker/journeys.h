// SPDX-License-Identifier: MIT
// What do tests of trackers follow? Square roots whose paths are known in closed form, and many
// departures at once.
//
// Homogeneous points of one unknown are (x_1, x_0).
#pragma once

#include <map>
#include <vector>

#include "moivre/polynomial/read.h"
#include "moivre/tracker/tracker.h"

namespace moivre::test {

/// x^2 = 1 becomes `target`.
inline Homotopy from_square_roots_of_one(const std::string& target) {
  return {read_system({"f", "1\n" + target + ";\n"}), read_system({"g", "1\nx^2 - 1;\n"})};
}

inline Complex affine(const Point& x) { return x[0] / x[1]; }

inline Departure from(const Point& x, const Contour& contour = Contour::segment(0, 1)) {
  Departure departure;
  departure.contour = contour;
  departure.x = x;
  return departure;
}

/// Hands out departures in their order, and keeps what arrives by path number.
class Journeys : public DepartureSource {
 public:
  explicit Journeys(std::vector<Departure> departures) : departures_(std::move(departures)) {}
  std::optional<Departure> next() override {
    if (next_ == departures_.size()) return std::nullopt;
    return departures_[next_++];
  }
  void arrived(const Departure& departure, Arrival&& arrival) override {
    arrivals[departure.path] = std::move(arrival);
  }

  std::map<std::uint64_t, Arrival> arrivals;

 private:
  std::vector<Departure> departures_;
  std::size_t next_ = 0;
};

}  // namespace moivre::test
