// SPDX-License-Identifier: MIT
// The points and liftings of every stage of the search for mixed cells.
#include "cell_stages.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <span>

#include "random_lifting.h"

namespace moivre {

namespace {

using SparsePoint = std::vector<PointExponent>;
using Points = std::vector<SparsePoint>;

/// The support moved so that every variable has an exponent 0 in some term: cells are the same, the
/// degree is least.
Points moved_to_the_planes(const Support& support, std::size_t n) {
  Exponents least = support.terms.front();
  for (const Exponents& term : support.terms) {
    for (std::size_t j = 0; j < n; ++j) least[j] = std::min(least[j], term[j]);
  }
  Points points;
  for (const Exponents& term : support.terms) {
    SparsePoint& point = points.emplace_back();
    for (std::uint32_t j = 0; j < n; ++j) {
      if (term[j] != least[j]) point.push_back({j, std::int64_t{term[j]} - least[j]});
    }
  }
  return points;
}

std::int64_t degree_of(const Points& points) {
  std::int64_t degree = 0;
  for (const SparsePoint& point : points) {
    std::int64_t sum = 0;
    for (const auto& [variable, exponent] : point) sum += exponent;
    degree = std::max(degree, sum);
  }
  return degree;
}

/// Two liftings of the corners of the simplices: corner 0..n-1 is e_j, corner n is 0.
struct CornerLifting {
  Lifting first;
  Lifting tie;
};

CornerLifting corner_lifting(std::size_t n, std::uint64_t seed) {
  const std::vector<std::size_t> sizes(n, n + 1);
  CornerLifting corners{random_lifting(sizes, seed, LiftingPurpose::corners),
                        random_lifting(sizes, seed, LiftingPurpose::corner_ties)};
  // alpha_s = omega(0) - omega(e_s) lies within the range of the lifting, so that slack of the
  // others > 0.
  const std::int64_t out_of_the_way = 3 * (std::int64_t{1} << kLiftingBits);
  for (std::size_t s = 0; s < n; ++s) {
    for (std::size_t j = 0; j < n; ++j) corners.first[s][j] += j == s ? 0 : out_of_the_way;
  }
  return corners;
}

struct Ingredients {
  std::vector<Points> points;
  Lifting lifting;
  Lifting tie;
  CornerLifting corners;
};

void add_point(CellStage& stage, std::size_t block, std::span<const PointExponent> point,
               Int128 lifting, Int128 tie) {
  double sum = 0;
  for (const PointExponent& coordinate : point) {
    stage.coordinates.push_back(coordinate);
    sum += static_cast<double>(coordinate.exponent);
  }
  stage.coordinate_begin.push_back(static_cast<std::uint32_t>(stage.coordinates.size()));
  stage.block_of.push_back(static_cast<std::uint32_t>(block));
  stage.lifting.push_back(lifting);
  stage.tie_lifting.push_back(tie);
  stage.largest_exponent_sum = std::max(stage.largest_exponent_sum, sum);
  stage.largest_lifting = std::max(stage.largest_lifting, std::abs(approximate(lifting)));
}

CellStage make_stage(const Ingredients& in, std::size_t s, std::int64_t degree) {
  const std::size_t n = in.points.size();
  CellStage stage;
  stage.coordinate_begin.push_back(0);
  for (std::size_t b = 0; b < n; ++b) {
    stage.block_begin.push_back(static_cast<std::uint32_t>(stage.points()));
    for (std::size_t k = 0; b <= s && k < in.points[b].size(); ++k) {
      add_point(stage, b, in.points[b][k], in.lifting[b][k], in.tie[b][k]);
    }
    const std::int64_t d = b == s ? degree : 1;
    for (std::size_t corner = 0; b >= s && corner <= n; ++corner) {
      const PointExponent point{static_cast<std::uint32_t>(corner), d};
      add_point(stage, b, {&point, corner < n ? std::size_t{1} : 0},
                Int128{d} * in.corners.first[b][corner], Int128{d} * in.corners.tie[b][corner]);
    }
  }
  stage.block_begin.push_back(static_cast<std::uint32_t>(stage.points()));
  return stage;
}

}  // namespace

std::uint64_t points_of_stages(const std::vector<Support>& supports) {
  const std::uint64_t n = supports.size();
  std::uint64_t terms = 0;
  for (const Support& support : supports) terms += support.terms.size();
  return n * terms + n * (n + 1) / 2 * (n + 1);
}

std::optional<CellStages> make_stages(const std::vector<Support>& supports, const Lifting& lifting,
                                      std::uint64_t seed, const std::atomic<bool>* stop) {
  const std::size_t n = supports.size();
  std::vector<Points> moved;
  std::vector<std::size_t> sizes;
  for (const Support& support : supports) {
    moved.push_back(moved_to_the_planes(support, n));
    sizes.push_back(support.terms.size());
  }
  const Lifting tie = random_lifting(sizes, seed, LiftingPurpose::ties);

  CellStages stages;
  stages.n = n;
  stages.order.resize(n);
  std::iota(stages.order.begin(), stages.order.end(), std::size_t{0});
  // Least degree first: the number of cells grows late. Cyclic-10 takes 60 000 steps so, 150 000
  // the other way round.
  std::stable_sort(stages.order.begin(), stages.order.end(), [&](std::size_t a, std::size_t b) {
    return degree_of(moved[a]) < degree_of(moved[b]);
  });
  Ingredients in;
  for (const std::size_t support : stages.order) {
    stages.degrees.push_back(degree_of(moved[support]));
    in.points.push_back(moved[support]);
    in.lifting.push_back(lifting[support]);
    in.tie.push_back(tie[support]);
  }
  in.corners = corner_lifting(n, seed);
  for (std::size_t s = 0; s < n; ++s) {
    if (stop != nullptr && *stop) return std::nullopt;
    stages.stages.push_back(make_stage(in, s, stages.degrees[s]));
  }
  return stages;
}

}  // namespace moivre
