// SPDX-License-Identifier: MIT
// Does a root meet a condition where the exact sign says so? Filter and check against Q(sqrt(d)).
//
//   x^2 = d,  (y - c - e x) (y - g - h x) = 0:    roots in Q(sqrt(d))^2, where a sign is exact
//
// Conditions pass by a root at distances from 1e-3 down to 1e-18, and through it.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "moivre/check/check.h"
#include "moivre/report/solve_report.h"
#include "moivre/solver/filter.h"
#include "moivre/tracker_lanes/lane_tracker.h"
#include "random_values.h"

namespace moivre {
namespace {

using test::RandomValues;

constexpr std::uint64_t kSystems = 300;
/// Of the size of the terms: beyond this no digit of a root is in doubt.
constexpr double kTold = 1e-12;

/// a + b sqrt(d)
struct Surd {
  Rational a, b;
};

int sign_of(const Rational& x) { return x < Rational(0) ? -1 : (x.is_zero() ? 0 : 1); }

int sign_of(const Surd& z, const Rational& d) {
  const int a = sign_of(z.a);
  const int b = sign_of(z.b);
  if (a * b >= 0) return a != 0 ? a : b;
  return a * sign_of(z.a * z.a - d * z.b * z.b);
}

Surd product(const Surd& u, const Surd& v, const Rational& d) {
  return {u.a * v.a + d * u.b * v.b, u.a * v.b + u.b * v.a};
}

double rounded(const Surd& z, const Rational& d) {
  return to_double(z.a) + to_double(z.b) * std::sqrt(to_double(d));
}

struct SurdRoot {
  Surd x[2];
};

Surd value(const Polynomial& p, const SurdRoot& root, const Rational& d) {
  Surd sum;
  for (const Term& term : p.terms) {
    Surd z{term.coefficient.re, Rational(0)};
    for (const Power& factor : term.monomial) {
      for (std::uint32_t k = 0; k < factor.exponent; ++k)
        z = product(z, root.x[factor.variable], d);
    }
    sum = {sum.a + z.a, sum.b + z.b};
  }
  return sum;
}

/// The sum of the terms' sizes, 1 at least.
double size_of(const Polynomial& p, const SurdRoot& root, const Rational& d) {
  double sum = 1;
  for (const Term& term : p.terms) {
    double z = std::abs(to_double(term.coefficient.re));
    for (const Power& factor : term.monomial) {
      z *= std::pow(std::abs(rounded(root.x[factor.variable], d)), factor.exponent);
    }
    sum += z;
  }
  return sum;
}

struct SurdSystem {
  Rational d;
  bool is_rational = false;  ///< d is a square
  System f;
  std::vector<SurdRoot> roots;
};

Rational fraction(RandomValues& random) {
  const auto numerator = static_cast<std::int64_t>(random.below(41)) - 20;
  return {numerator, static_cast<std::int64_t>(random.below(9)) + 1};
}

SurdSystem random_surds(RandomValues& random) {
  const Rational no_squares[] = {{2, 1}, {3, 1}, {5, 1}, {7, 3}, {1, 2}};
  const Rational squares[] = {{4, 1}, {9, 16}, {1, 9}};
  const auto [x, y] = unknowns<2>();
  SurdSystem s;
  s.is_rational = random.below(3) == 0;
  s.d = s.is_rational ? squares[random.below(3)] : no_squares[random.below(5)];
  const Rational c = fraction(random);
  const Rational e = fraction(random);
  const Rational g = c + Rational(1 + static_cast<int>(random.below(5)), 3);
  const Rational h = e;  // the two lines are parallel: four roots, none of them double
  s.f = make_system({"x", "y"}, {x * x - s.d, (y - c - e * x) * (y - g - h * x)});
  for (const int sign : {1, -1}) {
    s.roots.push_back({{{Rational(0), Rational(sign)}, {c, Rational(sign) * e}}});
    s.roots.push_back({{{Rational(0), Rational(sign)}, {g, Rational(sign) * h}}});
  }
  return s;
}

/// A random cubic; two of three pass a root closely, or go through it.
Condition random_condition(const SurdSystem& s, RandomValues& random) {
  const std::vector<Polynomial> x = unknowns(2);
  Polynomial p = constant(static_cast<int>(random.below(9)) - 4);
  for (int terms = 0; terms < 4; ++terms) {
    p += (static_cast<int>(random.below(11)) - 5) * pow(x[0], static_cast<int>(random.below(3))) *
         pow(x[1], static_cast<int>(random.below(3)));
  }
  if (random.below(3) > 0) {
    const Surd v = value(p, s.roots[random.below(s.roots.size())], s.d);
    const double beside[] = {1e-3, -1e-6, 1e-9, -1e-12, 1e-15, -1e-18, 0};
    const Rational middle = v.b.is_zero() ? v.a : Rational(rounded(v, s.d));
    p -= middle + Rational(beside[random.below(std::size(beside))]);
  }
  return {p, random.below(2) == 0, "the condition"};
}

/// Which exact root a point is.
std::size_t root_of(const SurdSystem& s, const Point& x) {
  const auto is_near = [&](const SurdRoot& root) {
    return std::abs(x[0] - rounded(root.x[0], s.d)) + std::abs(x[1] - rounded(root.x[1], s.d)) <
           1e-6;
  };
  const auto found = std::find_if(s.roots.begin(), s.roots.end(), is_near);
  if (found == s.roots.end()) throw std::logic_error("no root of this system");
  return static_cast<std::size_t>(found - s.roots.begin());
}

struct Trial {
  SurdSystem system;
  Condition condition;
  SolveResult all;

  Surd value_at(std::size_t k) const { return value(condition.p, root(k), system.d); }
  bool is_met(std::size_t k) const {
    const int sign = sign_of(value_at(k), system.d);
    return sign > 0 || (sign == 0 && !condition.is_strict);
  }
  bool is_close(std::size_t k) const {
    return std::abs(rounded(value_at(k), system.d)) <=
           kTold * size_of(condition.p, root(k), system.d);
  }
  const SurdRoot& root(std::size_t k) const {
    return system.roots[root_of(system, all.solutions[k].x)];
  }
};

/// Calls for each trial: three conditions of each of the systems.
template <class Judge>
void for_each_trial(const Judge& judge) {
  const std::unique_ptr<Tracker> tracker = make_lane_tracker();
  for (std::uint64_t seed = 1; seed <= kSystems; ++seed) {
    RandomValues random(seed);
    Trial trial{random_surds(random), {}, {}};
    trial.all = solve(trial.system.f, *tracker);
    ASSERT_EQ(trial.all.solutions.size(), 4U) << seed;
    for (int k = 0; k < 3; ++k) {
      SCOPED_TRACE(std::to_string(seed) + ", condition " + std::to_string(k));
      trial.condition = random_condition(trial.system, random);
      judge(trial);
    }
  }
}

TEST(Conditions, AreMetWhereTheExactSignSaysSo) {
  std::size_t decided = 0;
  std::size_t on_boundary = 0;
  for_each_trial([&](const Trial& trial) {
    SolveResult kept = trial.all;
    keep_wanted({.conditions = {trial.condition}}, kept);
    for (std::size_t k = 0; k < trial.all.solutions.size(); ++k) {
      const Solution& root = trial.all.solutions[k];
      const auto found =
          std::find_if(kept.solutions.begin(), kept.solutions.end(),
                       [&](const Solution& other) { return other.path == root.path; });
      const bool is_kept = found != kept.solutions.end();
      const bool is_said = is_kept && !found->on_boundary.empty();
      if (is_kept == trial.is_met(k) && !is_said) {
        ++decided;
        continue;
      }
      ++on_boundary;
      EXPECT_TRUE(trial.is_close(k)) << k;
      EXPECT_NE(is_kept, trial.condition.is_strict) << "the boundary belongs to >= alone";
      EXPECT_EQ(is_said, is_kept);
      const std::string& why = kept.left_out.back().why;
      EXPECT_NE(is_kept, why.find("on its boundary") != std::string::npos) << why;
    }
  });
  EXPECT_GT(decided, 10 * on_boundary);
  EXPECT_GT(on_boundary, 50U);
  RecordProperty("decided", std::to_string(decided));
  RecordProperty("on_boundary", std::to_string(on_boundary));
}

/// The finding of the kind on root k, from 0.
const Finding* inequality_of(const std::vector<Finding>& findings, std::size_t k) {
  const auto found = std::find_if(findings.begin(), findings.end(), [&](const Finding& finding) {
    return finding.claim == ClaimKind::inequality && finding.root == k + 1;
  });
  return found == findings.end() ? nullptr : &*found;
}

TEST(Conditions, AreRefutedByCheckWhereTheExactSignSaysSo) {
  std::size_t refuted = 0;
  std::size_t open = 0;
  for_each_trial([&](const Trial& trial) {
    System f = trial.system.f;
    const Claims claims = read_claims({"result", solve_json(trial.all, "f")}, f.variables);
    f.conditions = {trial.condition};
    const Judgement judgement = check(f, claims);
    for (std::size_t k = 0; k < trial.all.solutions.size(); ++k) {
      const bool is_open = inequality_of(judgement.open, k) != nullptr;
      const bool is_refuted = inequality_of(judgement.refuted, k) != nullptr;
      refuted += is_refuted ? 1 : 0;
      open += is_open ? 1 : 0;
      if (is_open) {
        EXPECT_TRUE(trial.is_close(k)) << k;
        EXPECT_FALSE(trial.system.is_rational) << "such a root is known exactly";
      } else {
        EXPECT_EQ(is_refuted, !trial.is_met(k)) << k;
      }
    }
  });
  EXPECT_GT(refuted, 1000U);
  EXPECT_LT(open, refuted / 5);
  RecordProperty("refuted", std::to_string(refuted));
  RecordProperty("open", std::to_string(open));
}

}  // namespace
}  // namespace moivre
