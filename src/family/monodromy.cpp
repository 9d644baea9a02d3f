// SPDX-License-Identifier: MIT
// A family from one pair: to a generic member, round loops, and the verdict of the trace test.
#include "moivre/family/monodromy.h"

#include <Eigen/Dense>
#include <algorithm>
#include <stdexcept>

#include "loops.h"
#include "moivre/family/learn.h"
#include "moivre/numeric/random.h"

namespace moivre {
namespace {

constexpr std::uint64_t kPairNumber = 1'000'000'000;

/// F(x; p) at a point, for a system in unknowns and parameters, all of them given.
Complex value_at(const Polynomial& p, const Point& all) {
  Complex sum = 0;
  for (const Term& term : p.terms) {
    Complex value = to_complex(term.coefficient);
    for (const Power& power : term.monomial) {
      for (std::uint32_t e = 0; e < power.exponent; ++e) value *= all[power.variable];
    }
    sum += value;
  }
  return sum;
}

/// Column j: F(x; e_j) - F(x; 0); the last one F(x; 0). Of parameters that are linear.
Eigen::MatrixXcd in_parameters(const Family& family, const Point& x) {
  const std::size_t n = family.unknowns();
  const std::size_t k = family.parameters();
  Eigen::MatrixXcd a(static_cast<Eigen::Index>(n), static_cast<Eigen::Index>(k + 1));
  Point all = x;
  all.resize(n + k);
  for (std::size_t column = 0; column <= k; ++column) {
    if (column < k) all[n + column] = 1;
    for (std::size_t i = 0; i < n; ++i) {
      a(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(column)) =
          value_at(family.system.polynomials[i], all);
    }
    if (column < k) all[n + column] = 0;
  }
  for (Eigen::Index column = 0; column < a.cols() - 1; ++column) a.col(column) -= a.rightCols(1);
  return a;
}

void require_pair(const Family& family, const KnownPair& pair) {
  if (pair.x.size() == family.unknowns() && pair.p.size() == family.parameters()) return;
  throw std::invalid_argument("a pair has a number for each of the " +
                              std::to_string(family.unknowns()) + " unknowns and " +
                              std::to_string(family.parameters()) + " parameters");
}

std::string standing_of(const TraceTest& test, int loops) {
  if (!test.was_made) {
    return std::to_string(loops) + " loops, the last ones without a new root; no trace test";
  }
  const std::string points = std::to_string(test.points) + " points of the curve";
  return test.holds ? "shown: the trace test holds (" + points +
                          "): no root of the components that were met is missing"
                    : "the trace test fails (" + points + "): roots are missing";
}

}  // namespace

std::optional<KnownPair> random_pair(const Family& family, std::uint64_t seed) {
  if (!is_linear_in_parameters(family)) return std::nullopt;
  KnownPair pair;
  for (std::size_t j = 0; j < family.unknowns(); ++j) {
    const std::uint64_t index = (kPairNumber << 8) + 2 * j;
    pair.x.push_back((0.5 + random_unit(seed, RandomStream::family, index)) *
                     random_phase(seed, RandomStream::family, index + 1));
  }
  const Point p = generic_member(family, ~seed);
  const Eigen::MatrixXcd a = in_parameters(family, pair.x);
  const Eigen::Index k = a.cols() - 1;
  const Eigen::Map<const Eigen::VectorXcd> at(p.data(), k);
  const Eigen::VectorXcd rest = a.leftCols(k) * at + a.col(k);
  const Eigen::VectorXcd step = a.leftCols(k).completeOrthogonalDecomposition().solve(-rest);
  constexpr double kSolved = 1e-10;
  if (!((a.leftCols(k) * step + rest).norm() <= kSolved * std::max(1.0, rest.norm()))) {
    return std::nullopt;
  }
  for (Eigen::Index j = 0; j < k; ++j) {
    pair.p.push_back(p[static_cast<std::size_t>(j)] + step[j]);
  }
  return pair;
}

Family learn_by_monodromy(Family unlearned, const KnownPair& pair, const Tracker& tracker,
                          const MonodromyOptions& options, const std::atomic<bool>& stop) {
  require_pair(unlearned, pair);
  Family family = std::move(unlearned);
  family.seed = options.seed;
  family.generic = generic_member(family, options.seed);
  const auto first =
      follow_roots(family.system, pair.p, family.generic, {pair.x}, tracker, stop).front();
  if (!first && !stop) {
    throw std::invalid_argument("the pair is no regular root of a member of the family");
  }
  family.roots.clear();
  if (first) family.roots.push_back(*first);
  const int loops = go_round_loops(family.system, family.generic, family.sizes, tracker, options, 1,
                                   stop, family.roots);
  Learning& learning = family.learning;
  learning.start = "monodromy";
  learning.paths = static_cast<std::uint64_t>(loops) * family.roots.size();
  TraceTest test;
  if (options.test && family.roots.size() <= options.most_tested) {
    test = trace_test(family, tracker, options, stop);
  }
  learning.complete = test.holds && !stop;
  learning.standing = standing_of(test, loops);
  return family;
}

}  // namespace moivre
