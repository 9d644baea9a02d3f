// SPDX-License-Identifier: MIT
// How is noise taken off a pose? One largest size for the lengths, one for the angles; at the
// origin, where a pose is all noise, those of the mechanism.
#include "noise.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace moivre {

using Eigen::Index;
using Eigen::VectorXd;

VectorXd without_noise(const Phi& phi, const VectorXd& q, const std::vector<Index>& held) {
  constexpr double kNoise = 8 * std::numeric_limits<double>::epsilon();
  const double largest_length = size_of(phi, q);
  double largest_angle = 1;
  for (Index k = 0; k < q.size(); ++k) {
    if (!is_length(phi, k)) largest_angle = std::max(largest_angle, std::abs(q[k]));
  }
  VectorXd clean = q;
  for (Index k = 0; k < q.size(); ++k) {
    const double noise = kNoise * (is_length(phi, k) ? largest_length : largest_angle);
    const bool is_held = std::find(held.begin(), held.end(), k) != held.end();
    if (!is_held && std::abs(q[k]) <= noise) clean[k] = 0;
  }
  return clean;
}

}  // namespace moivre
