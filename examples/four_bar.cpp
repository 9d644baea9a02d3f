// SPDX-License-Identifier: MIT
// In which ways can this four-bar be assembled? A mechanism built by names.
#include <iostream>

#include "moivre/moivre.h"

int main() {
  moivre::MechanismBuilder four_bar("Norton, example 4-1");
  four_bar.units("mm", "deg");
  four_bar.ground({{"A", {0, 0}}, {"D", {100, 0}}});
  four_bar.body("crank", {{"A", {0, 0}}, {"B", {40, 0}}});
  four_bar.body("coupler", {{"B", {0, 0}}, {"C", {120, 0}}});
  four_bar.body("rocker", {{"D", {0, 0}}, {"C", {80, 0}}});
  four_bar.joint("revolute", {"ground.A", "crank.A"});
  four_bar.joint("revolute", {"crank.B", "coupler.B"});
  four_bar.joint("revolute", {"coupler.C", "rocker.C"});
  four_bar.joint("revolute", {"ground.D", "rocker.D"});
  four_bar.driver("angle", "crank", {{"start", 40}, {"velocity", 360}});

  const moivre::Mechanism mechanism = four_bar.build();
  const auto tracker = moivre::make_cvode_tracker();
  const moivre::ClosureResult result = moivre::find_closures(mechanism, *tracker);
  std::cout << result.closures.size() << " closures, " << to_string(*result.completeness) << '\n';
  for (const moivre::Closure& closure : result.closures) {
    const Eigen::Vector3d c = moivre::point_position(mechanism, "coupler.C", closure.q);
    std::cout << closure.id << ": C = (" << c.x() << ", " << c.y() << ")\n";
  }
}
