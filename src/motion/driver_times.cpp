// SPDX-License-Identifier: MIT
// Where do the drivers stand at a time, and how long does it take until they have shown the whole motion?
#include <cmath>
#include <numbers>
#include <optional>

#include "moivre/motion/motion.h"

namespace moivre {
namespace {

/// Seconds from `from` until the angle has gone one turn on; nullopt where it comes to a halt before.
std::optional<double> time_of_a_turn(const Parabola& angle, double from) {
  constexpr double kTurn = 2 * std::numbers::pi;
  const double velocity = angle.velocity + angle.acceleration * from;
  const double acceleration = angle.acceleration * (velocity < 0 ? -1 : 1);
  // |velocity| d + acceleration d^2 / 2 = a turn, in the form that does not cancel.
  const double square = velocity * velocity + 2 * acceleration * kTurn;
  if (square < 0) return std::nullopt;
  const double sum = std::abs(velocity) + std::sqrt(square);
  if (!(sum > 0)) return std::nullopt;
  return 2 * kTurn / sum;
}

}  // namespace

std::vector<double> driver_values(const Mechanism& mechanism, double time) {
  std::vector<double> values;
  for (const Driver& driver : mechanism.drivers) {
    values.push_back(driver_state(driver.law, time).value);
  }
  return values;
}

double natural_duration(const Mechanism& mechanism, double from) {
  for (const Driver& driver : mechanism.drivers) {
    if (const auto* spline = std::get_if<Spline>(&driver.law)) {
      if (spline->t.back() > from) return spline->t.back() - from;
    }
    const auto* parabola = std::get_if<Parabola>(&driver.law);
    if (parabola == nullptr || kind_of(mechanism, driver) != CoordinateKind::angle) continue;
    if (const auto duration = time_of_a_turn(*parabola, from)) return *duration;
  }
  return 1;
}

}  // namespace moivre
