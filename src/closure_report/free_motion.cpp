// SPDX-License-Identifier: MIT
// The shortest direction of Phi_q, angles and lengths made comparable.
#include "free_motion.h"

#include <cmath>

#include "moivre/expression/joined.h"
#include "moivre/kinematics/null_space.h"
#include "moivre/report/number_text.h"

namespace moivre {

Eigen::VectorXd free_motion(const Phi& phi, const Eigen::VectorXd& q, double t) {
  const auto& all = phi.coordinates();
  Eigen::VectorXd scale(phi.dimension());
  for (Eigen::Index k = 0; k < scale.size(); ++k) {
    const bool is_length = all[static_cast<std::size_t>(k)].kind == CoordinateKind::length;
    scale[k] = is_length ? phi.length() : 1;
  }
  return shortest_direction(phi.jacobian(q, t) * scale.asDiagonal()).cwiseProduct(scale);
}

std::string direction_text(const Eigen::VectorXd& direction, const Mechanism& mechanism) {
  constexpr double kNoise = 1e-12;
  const std::vector<Coordinate> names = coordinates(mechanism);
  std::vector<std::string> parts;
  for (Eigen::Index k = 0; k < direction.size(); ++k) {
    if (std::abs(direction[k]) <= kNoise) continue;
    parts.push_back(names[static_cast<std::size_t>(k)].name + " " +
                    known_digits(direction[k], 1e-6));
  }
  return joined(parts, ", ");
}

}  // namespace moivre
