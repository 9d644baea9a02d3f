// SPDX-License-Identifier: MIT
// How many closures has each spatial mechanism of problems/mechanisms, as it is typed and with
// every dimension a little off?
//
// Disturbed: every coordinate of every point, every axis in both bodies, every rod's length and
// every weld's turn, so that nothing is parallel, meets, or is equal any more, but what goes
// through one named point of a body still does. Then an arm is a general one (16), a platform a
// general one (40), double joints split, and what closes by its special dimensions alone closes no
// more.
#pragma once

#include <Eigen/Geometry>
#include <algorithm>
#include <cstdint>
#include <string>
#include <vector>

#include "moivre/mechanism/mechanism.h"
#include "moivre/mechanism/phi.h"
#include "moivre/numeric/random.h"

namespace moivre {

struct SpatialCount {
  std::string file;
  std::uint64_t complex = 0;
  std::uint64_t real = 0;
  std::uint64_t most_paths = 0;  ///< over all stages
  std::uint64_t disturbed = 0;   ///< complex closures of the general class
  std::uint64_t dimension = 0;   ///< of its motion; then no closure is isolated
};

inline const std::vector<SpatialCount>& spatial_counts() {
  static const std::vector<SpatialCount> counts{
      {"rssr", 2, 2, 2, 2, 0},
      {"rccc", 2, 2, 4, 2, 0},
      {"bennett", 1, 1, 2, 0, 0},
      {"spherical-four-bar", 2, 2, 2, 2, 0},
      {"spherical-3-rrr", 8, 4, 16, 8, 0},
      {"3-rps", 16, 8, 16, 16, 0},
      {"general-6r", 16, 4, 24, 16, 0},
      {"manseur-doty", 16, 16, 24, 16, 0},
      {"puma-560", 8, 8, 24, 16, 0},
      {"ur5", 8, 8, 16, 16, 0},
      {"7r-loop", 16, 6, 24, 16, 0},
      {"bricard", 0, 0, 24, 16, 1},
      {"bricard-driven", 4, 2, 8, 0, 0},
      {"delta-reduced", 2, 2, 2, 2, 0},
      {"delta-inverse", 8, 8, 6, 0, 0},
      {"delta", 40, 12, 40, 40, 0},
      {"3-upu", 16, 16, 31, 0, 0},
      {"dietmaier", 40, 40, 40, 40, 0},
      {"planar-platform", 40, 12, 40, 40, 0},
      {"platform-6-4", 32, 4, 40, 40, 0},
      {"platform-6-3", 16, 6, 40, 40, 0},
      {"octahedral-3-3", 16, 4, 40, 40, 0},
      {"griffis-duffy", 0, 0, 40, 40, 1},
  };
  return counts;
}

inline double largest_coordinate(const Mechanism& mechanism) {
  double largest = 0;
  for (const Body& body : mechanism.bodies) {
    for (const BodyPoint& point : body.points) {
      largest = std::max(largest, point.at.cwiseAbs().maxCoeff());
    }
  }
  return largest > 0 ? largest : 1;
}

/// The mechanism with its lengths off by up to `share` of its size, its axes and turns by up to
/// `share` radians. Axes that are typed alike in both bodies stay alike: angles count from them.
inline Mechanism disturbed(Mechanism mechanism, double share, std::uint64_t seed = 1) {
  std::uint64_t count = 0;
  const double size = largest_coordinate(mechanism);
  const auto wander = [&] {
    return share * (2 * random_unit(seed, RandomStream::test, count++) - 1);
  };
  const auto wander_by_three = [&] {
    const double x = wander();
    const double y = wander();
    return Eigen::Vector3d(x, y, wander());
  };
  for (Body& body : mechanism.bodies) {
    for (BodyPoint& point : body.points) point.at += size * wander_by_three();
  }
  for (Joint& joint : mechanism.joints) {
    const bool are_equal = joint.axis[0] == joint.axis[1];
    joint.axis[0] = (joint.axis[0] + wander_by_three()).normalized();
    joint.axis[1] = are_equal ? joint.axis[0] : (joint.axis[1] + wander_by_three()).normalized();
    if (joint.type == JointType::rod) joint.length += size * wander();
    if (joint.type == JointType::weld) joint.turn_rad += wander();
  }
  return mechanism;
}

/// The same mechanism with the frames of all bodies turned alike at random, so that every number is
/// a rounded one. Not for drivers of angles, which count from other zeros then.
inline Mechanism turned(Mechanism mechanism, std::uint64_t seed = 1) {
  const auto number = [&](std::uint64_t k) {
    return 2 * random_unit(seed, RandomStream::test, k) - 1;
  };
  const Eigen::Quaterniond turn(number(0), number(1), number(2), number(3));
  const Eigen::Matrix3d R = turn.normalized().toRotationMatrix();
  for (Body& body : mechanism.bodies) {
    for (BodyPoint& point : body.points) point.at = R * point.at;
  }
  for (Joint& joint : mechanism.joints) {
    for (Eigen::Vector3d& axis : joint.axis) axis = (R * axis).normalized();
  }
  return mechanism;
}

}  // namespace moivre
