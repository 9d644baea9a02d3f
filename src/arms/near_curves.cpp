// SPDX-License-Identifier: MIT
// Crossings along a curve, and circles round them.
#include "near_curves.h"

#include <cmath>
#include <numbers>

namespace moivre {
namespace {

/// Samples where the tip can move so little along a second direction, and less than beside them.
std::vector<SetPlace> crossings(const Arm& arm, const Eigen::Isometry3d& pose,
                                const std::vector<Eigen::VectorXd>& samples) {
  constexpr double kHardlyMoves = 1e-6;
  std::vector<SetPlace> places;
  std::vector<double> second;
  for (const Eigen::VectorXd& sample : samples) {
    places.push_back(place_at(arm, pose, sample));
    const Eigen::VectorXd sigma = stretch_of(places.back()).sigma;
    second.push_back(sigma.size() < 2 ? HUGE_VAL : sigma[sigma.size() - 2]);
  }
  std::vector<SetPlace> least;
  for (std::size_t k = 0; k < places.size(); ++k) {
    const double before = k == 0 ? HUGE_VAL : second[k - 1];
    const double behind = k + 1 == places.size() ? HUGE_VAL : second[k + 1];
    if (second[k] <= kHardlyMoves && second[k] <= before && second[k] < behind) {
      least.push_back(places[k]);
    }
  }
  return least;
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
                                         const std::vector<Eigen::VectorXd>& samples,
                                         double accuracy) {
  std::vector<Eigen::VectorXd> starts;
  for (const SetPlace& crossing : crossings(arm, pose, samples)) {
    const std::vector<SetPlace> circle = circle_around(arm, pose, crossing, accuracy);
    const std::size_t count = circle.size();
    for (std::size_t k = 0; k < count; ++k) {
      const bool is_least = circle[k].residual <= circle[(k + count - 1) % count].residual &&
                            circle[k].residual < circle[(k + 1) % count].residual;
      if (is_least) starts.push_back(circle[k].values);
    }
  }
  return starts;
}

}  // namespace moivre
