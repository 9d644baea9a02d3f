// SPDX-License-Identifier: MIT
// Pairs by their images, and a parabola in Newton's form.
#include "near_real.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "stages.h"

namespace moivre {
namespace {

// A vertex no lower than this part of what was seen already says that s turns back above zero.
constexpr double kWellBelow = 0.5;

double distance(const Point& a, const Point& b) {
  double largest = 0;
  for (std::size_t v = 0; v < a.size(); ++v) largest = std::max(largest, std::abs(a[v] - b[v]));
  return largest;
}

double distance(const ComplexPair& pair, const Point& x) {
  return std::min(distance(pair.x, x), distance(pair.image, x));
}

}  // namespace

std::vector<ComplexPair> complex_pairs(const Formulation& formulation,
                                       const std::vector<Solution>& closures) {
  std::vector<ComplexPair> pairs;
  for (const Solution& closure : closures) {
    if (closure.real || closure.singular) continue;
    const double same = kHolds * std::max(1.0, max_norm(closure.x));
    const bool is_known = std::any_of(pairs.begin(), pairs.end(), [&](const ComplexPair& pair) {
      return distance(pair, closure.x) <= same;
    });
    if (is_known) continue;
    ComplexPair pair{closure.x, mirrored(formulation, closure.x), 0};
    for (std::size_t v = 0; v < pair.x.size(); ++v) {
      pair.square += std::norm(pair.x[v] - pair.image[v]);
    }
    pairs.push_back(std::move(pair));
  }
  return pairs;
}

const ComplexPair* nearest_pair(const std::vector<ComplexPair>& pairs, const Point& x) {
  const ComplexPair* nearest = nullptr;
  double least = std::numeric_limits<double>::infinity();
  for (const ComplexPair& pair : pairs) {
    const double gap = distance(pair, x);
    if (gap >= least) continue;
    least = gap;
    nearest = &pair;
  }
  return nearest;
}

std::optional<double> time_near_real(const std::array<DistanceFromReal, 3>& points) {
  const auto& [a, b, c] = points;
  const double slope = (b.square - a.square) / (b.time - a.time);
  const double curvature = ((c.square - b.square) / (c.time - b.time) - slope) / (c.time - a.time);
  if (!(curvature > 0)) return std::nullopt;
  const double vertex = (a.time + b.time - slope / curvature) / 2;
  if (!(vertex > a.time && vertex < c.time)) return std::nullopt;
  const double value = a.square + (vertex - a.time) * (slope + curvature * (vertex - b.time));
  const double least = std::min({a.square, b.square, c.square});
  return value < kWellBelow * least ? std::optional<double>(vertex) : std::nullopt;
}

}  // namespace moivre
