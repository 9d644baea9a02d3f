// SPDX-License-Identifier: MIT
// Coordinate by coordinate: sorted by its value, cut where neighbours differ, each piece by the next coordinate.
#include "moivre/closures/canonical_order.h"

#include <algorithm>
#include <numbers>
#include <numeric>

namespace moivre {
namespace {

using Positions = std::vector<std::size_t>::iterator;

class Order {
 public:
  Order(const std::vector<Eigen::VectorXd>& poses, const std::vector<Coordinate>& coordinates,
        double length)
      : poses_(poses), coordinates_(coordinates), largest_length_(length) {
    for (const Eigen::VectorXd& q : poses) {
      for (std::size_t k = 0; k < coordinates.size(); ++k) {
        const double size = std::abs(q[static_cast<Eigen::Index>(k)]);
        if (!is_angle(k)) largest_length_ = std::max(largest_length_, size);
      }
    }
  }

  /// Sorts [first, last), whose poses tie in every coordinate before k.
  void sort_from(std::size_t k, Positions first, Positions last) const {
    if (k == coordinates_.size() || last - first < 2) return;
    std::stable_sort(first, last,
                     [&](std::size_t a, std::size_t b) { return value(a, k) > value(b, k); });
    for (Positions piece = first; piece != last;) {
      Positions end = piece + 1;
      while (end != last && value(*(end - 1), k) - value(*end, k) <= tolerance(k)) ++end;
      std::sort(piece, end);
      sort_from(k + 1, piece, end);
      piece = end;
    }
  }

 private:
  bool is_angle(std::size_t k) const { return coordinates_[k].kind != CoordinateKind::length; }
  double tolerance(std::size_t k) const {
    return kSameCoordinate * (is_angle(k) ? 1.0 : largest_length_);
  }
  double value(std::size_t pose, std::size_t k) const {
    const double v = poses_[pose][static_cast<Eigen::Index>(k)];
    const bool is_half_turn = is_angle(k) && v <= -std::numbers::pi + kSameCoordinate;
    return is_half_turn ? v + 2 * std::numbers::pi : v;
  }

  const std::vector<Eigen::VectorXd>& poses_;
  const std::vector<Coordinate>& coordinates_;
  double largest_length_;
};

/// Half a turn about v is half a turn about -v: of the two, the one whose first coordinate that is not zero is positive.
Eigen::VectorXd with_named_half_turns(Eigen::VectorXd q,
                                      const std::vector<Coordinate>& coordinates) {
  constexpr Eigen::Index kSize = 3;
  for (Eigen::Index k = 0; k < q.size(); ++k) {
    if (coordinates[static_cast<std::size_t>(k)].kind != CoordinateKind::rotation_vector) continue;
    auto v = q.segment<kSize>(k);
    k += kSize - 1;
    if (v.norm() < std::numbers::pi - kSameCoordinate) continue;
    Eigen::Index first = 0;
    while (first < kSize - 1 && std::abs(v[first]) <= kSameCoordinate) ++first;
    if (v[first] < 0) v *= -1;
  }
  return q;
}

}  // namespace

std::vector<std::size_t> canonical_order(const std::vector<Eigen::VectorXd>& poses,
                                         const std::vector<Coordinate>& coordinates,
                                         double length) {
  std::vector<std::size_t> order(poses.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::vector<Eigen::VectorXd> named;
  named.reserve(poses.size());
  for (const Eigen::VectorXd& q : poses) named.push_back(with_named_half_turns(q, coordinates));
  Order(named, coordinates, length).sort_from(0, order.begin(), order.end());
  return order;
}

}  // namespace moivre
