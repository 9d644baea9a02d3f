// SPDX-License-Identifier: MIT
// Where may joints stand that nobody has placed? Turns anywhere, slides within the arm's length to
// both sides.
#pragma once

#include "moivre/arms/arm.h"
#include "moivre/numeric/random.h"

namespace moivre {

/// The `number`-th of the seed.
inline Eigen::VectorXd random_joint_values(const Arm& arm, std::uint64_t seed,
                                           std::uint64_t number) {
  // Joints' zeros and the weights of combinations come before these in the stream.
  constexpr std::uint64_t kBehindOthers = 2000;
  const auto n = static_cast<Eigen::Index>(arm.joints.size());
  Eigen::VectorXd values(n);
  for (Eigen::Index k = 0; k < n; ++k) {
    const auto index = kBehindOthers + number * arm.joints.size() + static_cast<std::uint64_t>(k);
    const double unit = 2 * random_unit(seed, RandomStream::arm, index) - 1;
    const bool is_slide = arm.joints[static_cast<std::size_t>(k)].is_slide;
    values[k] = unit * (is_slide ? arm.length : std::numbers::pi);
  }
  return values;
}

}  // namespace moivre
