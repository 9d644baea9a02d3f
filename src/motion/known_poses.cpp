// SPDX-License-Identifier: MIT
// Poses sorted by their numbers; those within reach are compared.
#include "known_poses.h"

#include <algorithm>
#include <cmath>

#include "moivre/closures/same_pose.h"

namespace moivre {

KnownPoses::KnownPoses(const Phi& phi, const std::vector<Closure>& closures)
    : weights_(Eigen::VectorXd::Zero(phi.dimension())) {
  for (Eigen::Index k = 0; k < weights_.size(); ++k) {
    if (is_length(phi, k)) weights_[k] = std::cos(static_cast<double>(k * k + 1));
  }
  for (const Closure& closure : closures) {
    numbers_.emplace_back(number_of(closure.q), numbers_.size());
    size_ = std::max(size_, size_of(phi, closure.q));
  }
  std::sort(numbers_.begin(), numbers_.end());
}

std::optional<std::size_t> KnownPoses::nearest(const Phi& phi, const std::vector<Closure>& closures,
                                               const Eigen::VectorXd& q) const {
  const double number = number_of(q);
  const double reach = static_cast<double>(q.size()) * kSamePose * std::max(size_, size_of(phi, q));
  std::optional<std::size_t> nearest;
  double least = kSamePose;
  auto next =
      std::lower_bound(numbers_.begin(), numbers_.end(), std::pair(number - reach, std::size_t{0}));
  for (; next != numbers_.end() && next->first <= number + reach; ++next) {
    const double gap = distance(phi, q, closures[next->second].q);
    if (!(gap <= least)) continue;
    least = gap;
    nearest = next->second;
  }
  return nearest;
}

}  // namespace moivre
