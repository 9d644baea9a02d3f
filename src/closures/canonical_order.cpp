// SPDX-License-Identifier: MIT
// Coordinate by coordinate: sorted by its value, cut where neighbours differ, each piece by the
// next coordinate.
#include "moivre/closures/canonical_order.h"

#include <algorithm>
#include <numbers>
#include <numeric>

namespace moivre {
namespace {

using Eigen::Index;
using Eigen::VectorXd;
using Positions = std::vector<std::size_t>::iterator;

/// Sorts [first, last), whose poses tie in every coordinate before k. Values: lengths beside the
/// largest, half a turn as it is named.
void sort_from(Index k, Positions first, Positions last, const std::vector<VectorXd>& values) {
  if (last - first < 2 || k == values.front().size()) return;
  std::stable_sort(first, last,
                   [&](std::size_t a, std::size_t b) { return values[a][k] > values[b][k]; });
  for (Positions piece = first; piece != last;) {
    Positions end = piece + 1;
    while (end != last && values[*(end - 1)][k] - values[*end][k] <= kSameCoordinate) ++end;
    std::sort(piece, end);
    sort_from(k + 1, piece, end, values);
    piece = end;
  }
}

/// Half a turn about v is half a turn about -v: of the two, the one whose first coordinate that is
/// not zero is positive.
void name_half_turns(const std::vector<Coordinate>& coordinates, VectorXd& q) {
  constexpr Index kSize = 3;
  for (Index k = 0; k < q.size(); ++k) {
    const CoordinateKind kind = coordinates[static_cast<std::size_t>(k)].kind;
    if (kind == CoordinateKind::angle && q[k] <= -std::numbers::pi + kSameCoordinate) {
      q[k] += 2 * std::numbers::pi;
    }
    if (kind != CoordinateKind::rotation_vector) continue;
    auto v = q.segment<kSize>(k);
    k += kSize - 1;
    if (v.norm() < std::numbers::pi - kSameCoordinate) continue;
    Index first = 0;
    while (first < kSize - 1 && std::abs(v[first]) <= kSameCoordinate) ++first;
    if (v[first] < 0) v *= -1;
  }
}

}  // namespace

std::vector<std::size_t> canonical_order(const std::vector<VectorXd>& poses,
                                         const std::vector<Coordinate>& coordinates,
                                         double length) {
  const auto is_length = [&](Index k) {
    return coordinates[static_cast<std::size_t>(k)].kind == CoordinateKind::length;
  };
  for (const VectorXd& q : poses) {
    for (Index k = 0; k < q.size(); ++k) {
      if (is_length(k)) length = std::max(length, std::abs(q[k]));
    }
  }
  std::vector<VectorXd> values = poses;
  for (VectorXd& q : values) {
    name_half_turns(coordinates, q);
    for (Index k = 0; k < q.size(); ++k) q[k] /= is_length(k) ? length : 1;
  }
  std::vector<std::size_t> order(poses.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  sort_from(0, order.begin(), order.end(), values);
  return order;
}

}  // namespace moivre
