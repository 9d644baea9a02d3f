// SPDX-License-Identifier: MIT
// Signs and least sizes of the miss along a set, and secants there.
#include "near_closures.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace moivre {
namespace {

/// By how much the tip misses the pose there: along the direction in which it can move least, which
/// turns little from place to place.
struct Miss {
  double s = 0;  ///< of the place, between two others
  Eigen::VectorXd values;
  Velocity6<double> least;  ///< unit, on the side of the last one's
  double size = 0;
};

Miss miss_along(const SetPlace& place, const Velocity6<double>& least, double s = 0) {
  return {s, place.values, least, least.dot(place.at.error)};
}

Miss miss_at(const SetPlace& place, const Velocity6<double>& least_before, double s = 0) {
  const Velocity6<double> least = least_moved(place, least_before);
  return miss_along(place, least.dot(least_before) < 0 ? Velocity6<double>(-least) : least, s);
}

/// Where the parabola through three misses is 0, or else nearest to 0.
double least_of_parabola(const std::array<Miss, 3>& at) {
  const auto& [a, b, c] = at;
  const double ab = (b.size - a.size) / (b.s - a.s);
  const double bc = (c.size - b.size) / (c.s - b.s);
  const double bend = (bc - ab) / (c.s - a.s);
  const double slope = ab + bend * (b.s - a.s);  // at b
  if (bend == 0) return b.s - b.size / slope;
  const double under_root = slope * slope - 4 * bend * b.size;
  if (under_root <= 0) return b.s - slope / (2 * bend);
  return b.s - 2 * b.size / (slope + std::copysign(std::sqrt(under_root), slope));
}

/// Between two places of the set, where the tip misses the pose least: by secants of second order
/// along the set. Newton's method alone leaves a set that is curved.
Eigen::VectorXd nearest_to_pose(const Arm& arm, const Eigen::Isometry3d& pose, const Miss& from,
                                const Miss& to, double accuracy) {
  constexpr int kMost = 10;
  constexpr double kNothing = 1e-15;
  const Eigen::VectorXd chord = to.values - from.values;
  const Eigen::VectorXd direction = in_arms_lengths(arm, chord).normalized();
  const auto missed = [&](double s) {
    return miss_at(settled(arm, pose, from.values + s * chord, direction, accuracy), from.least, s);
  };
  std::array<Miss, 3> at{from, missed(0.5), to};
  at[2].s = 1;
  const auto by_size = [](const Miss& a, const Miss& b) {
    return std::abs(a.size) < std::abs(b.size);
  };
  for (int k = 0; k < kMost; ++k) {
    std::sort(at.begin(), at.end(), by_size);
    if (std::abs(at[0].size) < kNothing) break;
    const double s = least_of_parabola({at[1], at[0], at[2]});
    if (!(s >= 0 && s <= 1) || s == at[0].s || s == at[1].s) break;
    at[2] = missed(s);
  }
  return std::min_element(at.begin(), at.end(), by_size)->values;
}

/// Where the tip misses the pose by no more than rounding, one place of many in a row is left.
std::vector<Miss> told_apart(const std::vector<Miss>& all) {
  const auto is_told = [](const Miss& miss) { return std::abs(miss.size) > kLeastError; };
  std::vector<Miss> apart;
  for (const Miss& miss : all) {
    const bool goes_on = !apart.empty() && !is_told(apart.back()) && !is_told(miss);
    if (!goes_on) {
      apart.push_back(miss);
    } else if (std::abs(miss.size) < std::abs(apart.back().size)) {
      apart.back() = miss;
    }
  }
  return apart;
}

}  // namespace

std::vector<Eigen::VectorXd> near_closures(const Arm& arm, const Eigen::Isometry3d& pose,
                                           const SetPlaces& places, double accuracy) {
  std::vector<Eigen::VectorXd> closures;
  std::vector<Miss> miss;
  miss.reserve(places.size());
  for (const SetPlace& place : places) {
    miss.push_back(miss.empty() ? miss_along(place, least_moved(place))
                                : miss_at(place, miss.back().least));
  }
  miss = told_apart(miss);
  const auto size = [&](std::size_t k) { return std::abs(miss[k].size); };
  for (std::size_t k = 1; k < miss.size(); ++k) {
    if (miss[k - 1].size * miss[k].size <= 0) {
      closures.push_back(nearest_to_pose(arm, pose, miss[k - 1], miss[k], accuracy));
    } else if (k + 1 < miss.size() && size(k) < size(k - 1) && size(k) < size(k + 1)) {
      closures.push_back(nearest_to_pose(arm, pose, miss[k - 1], miss[k + 1], accuracy));
    }
  }
  return closures;
}

}  // namespace moivre
