// SPDX-License-Identifier: MIT
// For which radii do a circle and a hyperbola meet in real points? One family, learned once, and a
// table of its members' roots.
#include <iostream>
#include <vector>

#include "moivre/moivre.h"

int main() {
  const auto [x, y, r] = moivre::unknowns<3>();
  const moivre::System f = moivre::make_system({"x", "y", "r"}, {x * x + y * y - r * r, x * y - 1});
  const auto tracker = moivre::make_lane_tracker();
  const moivre::Family family = moivre::learn(moivre::unlearned_family(f, {{"r", 1}}), *tracker);

  const std::vector<moivre::Complex> radii{1.0, 1.4, 1.5, 2.0};
  const moivre::MemberTable table = moivre::solve_member_table(family, radii, *tracker);
  for (std::size_t k = 0; k < table.members(); ++k) {
    int real = 0;
    for (std::size_t row = table.first[k]; row < table.first[k + 1]; ++row) real += table.real[row];
    std::cout << "r = " << radii[k].real() << ": " << table.first[k + 1] - table.first[k]
              << " roots, " << real << " real\n";
  }
}
