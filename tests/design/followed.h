// SPDX-License-Identifier: MIT
// What do the tests of a designer's quantities ask? A mechanism's motion from its guess, and a
// quantity of it by name.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

#include "../mechanism/files.h"
#include "moivre/design/readings.h"

namespace moivre::test {

inline constexpr double kPi = std::numbers::pi;

/// A motion of the pose that the file's guess leads to, and its readings.
struct Followed {
  Mechanism mechanism;
  MotionResult motion;
  Readings readings;

  const std::vector<BranchSample>& samples() const { return motion.branches.front().samples; }

  std::size_t index(const std::string& name) const {
    const auto& all = readings.quantities;
    const auto found =
        std::find_if(all.begin(), all.end(), [&](const Quantity& one) { return one.name == name; });
    if (found == all.end()) throw std::out_of_range("no quantity " + name);
    return static_cast<std::size_t>(found - all.begin());
  }
  bool has(const std::string& name) const {
    return std::any_of(readings.quantities.begin(), readings.quantities.end(),
                       [&](const Quantity& one) { return one.name == name; });
  }
  double value(const std::string& name, std::size_t sample) const {
    return readings.branches.front().values[sample][index(name)];
  }
  const Extremes& extremes(const std::string& name) const {
    return readings.branches.front().extremes[index(name)];
  }
};

inline Followed followed(const Mechanism& mechanism, const QuantityChoice& choice, int steps = 90,
                         double seconds = 0) {
  MotionOptions options;
  options.to = seconds > 0 ? seconds : natural_duration(mechanism);
  options.steps = steps;
  Followed all{mechanism, follow_guesses(mechanism, {initial_guess(mechanism)}, options), {}};
  const QuantityReader reader(all.mechanism, choice);
  all.readings = read_motion(all.motion, all.mechanism, reader);
  return all;
}

inline QuantityChoice groups(std::vector<QuantityGroup> wanted) { return {std::move(wanted), {}}; }

/// Crank, coupler and rocker on pivots `ground` apart, the crank turning by a degree a second from
/// `start` degrees.
inline std::string four_bar_text(double crank, double coupler, double rocker, double ground,
                                 const std::string& start = "30",
                                 const std::string& velocity = "1") {
  const auto text = [](double x) { return std::to_string(x); };
  return "[units]\nlength = \"mm\"\nangle = \"deg\"\n[ground.points]\nO = [0, 0]\nP = [" +
         text(ground) + ", 0]\n[body.crank.points]\nO = [0, 0]\nA = [" + text(crank) +
         ", 0]\n[body.coupler.points]\nA = [0, 0]\nB = [" + text(coupler) +
         ", 0]\n[body.rocker.points]\nP = [0, 0]\nB = [" + text(rocker) + R"toml(, 0]
[[joint]]
type = "revolute"
at = ["ground.O", "crank.O"]
[[joint]]
type = "revolute"
at = ["crank.A", "coupler.A"]
[[joint]]
type = "revolute"
at = ["coupler.B", "rocker.B"]
[[joint]]
type = "revolute"
at = ["ground.P", "rocker.P"]
[[driver]]
angle = "crank"
start = )toml" +
         start + "\nvelocity = " + velocity +
         "\n[guess]\n\"coupler.phi\" = 20\n\"rocker.phi\" = 80\n";
}

/// The slider-crank, its crank turning by a degree a second from 30 degrees, or by `velocity`.
inline std::string slider_crank_text(double crank, double rod, double offset,
                                     const std::string& velocity = "1") {
  return "[units]\nlength = \"mm\"\nangle = \"deg\"\n" + slider_crank_links(crank, rod, offset) +
         "[[driver]]\nangle = \"crank\"\nstart = 30\nvelocity = " + velocity +
         "\n[guess]\n\"rod.phi\" = -10\n\"slider.x\" = " + std::to_string(rod) + "\n";
}

}  // namespace moivre::test
