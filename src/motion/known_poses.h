// SPDX-License-Identifier: MIT
// Which of many poses is this one? Found by one number of each pose, not by a look at all of them.
//
// The number is a sum of a pose's lengths with weights between -1 and 1, in which no two poses agree by chance. Poses that are the same
// (same_pose.h) differ by no more than kSamePose times their size in each of n coordinates, and so by no more than n times that in their
// numbers.
// Edges: without lengths all numbers are equal, and every pose is looked at.
#pragma once

#include <optional>
#include <utility>
#include <vector>

#include "moivre/closures/closures.h"
#include "moivre/mechanism/phi.h"

namespace moivre {

class KnownPoses {
 public:
  KnownPoses() = default;
  KnownPoses(const Phi& phi, const std::vector<Closure>& closures);

  /// Index of the nearest closure that is the same pose as q. `phi` and `closures` as they were given.
  std::optional<std::size_t> nearest(const Phi& phi, const std::vector<Closure>& closures,
                                     const Eigen::VectorXd& q) const;

 private:
  double number_of(const Eigen::VectorXd& q) const { return weights_.dot(q); }

  Eigen::VectorXd weights_;
  std::vector<std::pair<double, std::size_t>>
      numbers_;      ///< ascending, each with the closure's index
  double size_ = 1;  ///< of the largest pose
};

}  // namespace moivre
