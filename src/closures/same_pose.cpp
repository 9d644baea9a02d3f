// SPDX-License-Identifier: MIT
// Poses side by side: angles modulo whole turns, in radians, lengths beside the larger pose.
#include "moivre/closures/same_pose.h"

#include <algorithm>
#include <cmath>

namespace moivre {
namespace {

/// Of the larger pose.
double size_of(const Phi& phi, const Eigen::VectorXd& a, const Eigen::VectorXd& b) {
  return std::max(size_of(phi, a), size_of(phi, b));
}

}  // namespace

double distance(const Phi& phi, const Eigen::VectorXd& a, const Eigen::VectorXd& b) {
  const Eigen::VectorXd gap = phi.canonical(phi.canonical(a) - phi.canonical(b));
  const double size = size_of(phi, a, b);
  double largest = 0;
  for (Eigen::Index k = 0; k < gap.size(); ++k) {
    largest = std::max(largest, std::abs(gap[k]) / (is_length(phi, k) ? size : 1));
  }
  return largest;
}

bool is_same_pose(const Phi& phi, const Eigen::VectorXd& a, const Eigen::VectorXd& b) {
  const double most = kSamePose * size_of(phi, a, b);
  for (Eigen::Index k = 0; k < a.size(); ++k) {
    if (is_length(phi, k) && std::abs(a[k] - b[k]) > most) return false;
  }
  return distance(phi, a, b) <= kSamePose;
}

}  // namespace moivre
