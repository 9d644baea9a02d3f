// SPDX-License-Identifier: MIT
// Where curves cross this one, and circles round there.
#include "near_curves.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

namespace moivre {
namespace {

/// Along which the tip can move least but for the curve's own direction.
double second_least(const SetPlace& place) {
  const Eigen::VectorXd sigma = stretch_of(place).sigma;
  return sigma.size() < 2 ? HUGE_VAL : sigma[sigma.size() - 2];
}

/// Of second_least().
constexpr double kHardlyMoves = 1e-6;

/// Between two places of the curve the one where that is least: by the golden section, since it is
/// |s - s0| beside a crossing. Nothing where it is nowhere so little: a singular value changes by
/// no more than the screws do.
std::optional<SetPlace> crossing_between(const Arm& arm, const Eigen::Isometry3d& pose,
                                         const Eigen::VectorXd& from, const Eigen::VectorXd& to,
                                         double accuracy) {
  constexpr int kSteps = 40;
  constexpr double kSteepest = 4;  // of a singular value, a radian
  const double share = (std::sqrt(5.0) - 1) / 2;
  const Eigen::VectorXd chord = way_between(arm, from, to);
  const auto place = [&](double s) {
    return settled(arm, pose, from + in_joints<double>(arm, s * chord), chord.normalized(),
                   accuracy);
  };
  double begin = 0, end = 1;
  SetPlace left = place(1 - share), right = place(share);
  double at_left = second_least(left), at_right = second_least(right);
  for (int k = 0; k < kSteps; ++k) {
    const double least = std::min(at_left, at_right);
    if (least <= kHardlyMoves) return at_left < at_right ? left : right;
    if (least > kSteepest * (end - begin) * chord.norm()) return std::nullopt;
    if (at_left < at_right) {
      end = begin + share * (end - begin);
      right = std::move(left);
      at_right = at_left;
      left = place(end - share * (end - begin));
      at_left = second_least(left);
    } else {
      begin = end - share * (end - begin);
      left = std::move(right);
      at_left = at_right;
      right = place(begin + share * (end - begin));
      at_right = second_least(right);
    }
  }
  return std::nullopt;
}

/// Places of the curve where the tip can move so little along a second direction.
std::vector<SetPlace> crossings(const Arm& arm, const Eigen::Isometry3d& pose,
                                const std::vector<Eigen::VectorXd>& samples, double accuracy) {
  constexpr double kMayCross = 0.1;
  std::vector<double> second;
  for (const Eigen::VectorXd& sample : samples) {
    second.push_back(second_least(place_at(arm, pose, sample)));
  }
  std::vector<SetPlace> places;
  const std::size_t count = samples.size();
  for (std::size_t k = 0; k < count; ++k) {
    const std::size_t before = (k + count - 1) % count, behind = (k + 1) % count;
    const bool is_least = second[k] <= second[before] && second[k] < second[behind];
    if (!is_least || second[k] > kMayCross) continue;
    auto place = crossing_between(arm, pose, samples[before], samples[behind], accuracy);
    if (place) places.push_back(std::move(*place));
  }
  return places;
}

std::vector<SetPlace> circle_around(const Arm& arm, const Eigen::Isometry3d& pose,
                                    const SetPlace& place, double accuracy) {
  constexpr int kPlaces = 48;
  constexpr double kRadius = 0.3;
  const Eigen::MatrixXd plane = stretch_of(place).V.rightCols(2);
  std::vector<SetPlace> circle;
  for (int k = 0; k < kPlaces; ++k) {
    const double angle = 2 * std::numbers::pi * k / kPlaces;
    const Eigen::Vector2d unit(std::cos(angle), std::sin(angle));
    const Eigen::VectorXd along = kRadius * (plane * unit);
    circle.push_back(
        settled(arm, pose, place.values + in_joints<double>(arm, along), plane, accuracy));
  }
  return circle;
}

}  // namespace

std::vector<Eigen::VectorXd> near_curves(const Arm& arm, const Eigen::Isometry3d& pose,
                                         const SetPlace& place, double accuracy) {
  std::vector<Eigen::VectorXd> starts;
  if (second_least(place) > kHardlyMoves) return starts;
  const std::vector<SetPlace> circle = circle_around(arm, pose, place, accuracy);
  const std::size_t count = circle.size();
  for (std::size_t k = 0; k < count; ++k) {
    const bool is_least = circle[k].residual <= circle[(k + count - 1) % count].residual &&
                          circle[k].residual < circle[(k + 1) % count].residual;
    if (is_least) starts.push_back(circle[k].values);
  }
  return starts;
}

std::vector<Eigen::VectorXd> near_curves(const Arm& arm, const Eigen::Isometry3d& pose,
                                         const std::vector<Eigen::VectorXd>& samples,
                                         double accuracy) {
  std::vector<Eigen::VectorXd> starts;
  for (const SetPlace& crossing : crossings(arm, pose, samples, accuracy)) {
    const auto around = near_curves(arm, pose, crossing, accuracy);
    starts.insert(starts.end(), around.begin(), around.end());
  }
  return starts;
}

}  // namespace moivre
