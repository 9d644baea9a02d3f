// SPDX-License-Identifier: MIT
// How does a slider-crank move through a turn of its crank? Every branch, sample by sample, as CSV.
#include <iostream>

#include "moivre/moivre.h"

int main() {
  moivre::MechanismBuilder engine("Slider-crank");
  engine.units("mm", "deg");
  engine.ground({{"O", {0, 0}}});
  engine.body("crank", {{"O", {0, 0}}, {"P", {50, 0}}});
  engine.body("rod", {{"P", {0, 0}}, {"Q", {150, 0}}});
  engine.body("piston", {{"Q", {0, 0}}});
  engine.joint("revolute", {"ground.O", "crank.O"});
  engine.joint("revolute", {"crank.P", "rod.P"});
  engine.joint("revolute", {"rod.Q", "piston.Q"});
  engine.joint("prismatic", {"ground.O", "piston.Q"}, {{"along", {1, 0}}});
  engine.driver("angle", "crank", {{"start", 30}, {"velocity", 360}});

  const moivre::Mechanism mechanism = engine.build();
  const auto tracker = moivre::make_cvode_tracker();
  moivre::MotionOptions options;
  options.steps = 12;
  const moivre::MotionResult motion = moivre::find_motion(mechanism, *tracker, options);
  std::cout << moivre::motion_csv(motion, mechanism);
  return motion.complete ? 0 : 2;
}
