// SPDX-License-Identifier: MIT
// Are roots told apart that are distinct, and known again that are one; however near, in whatever
// order?
#include "moivre/certify/distinct.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <random>

#include "moivre/certify/bounds.h"
#include "moivre/numeric/rational.h"
#include "planted.h"

namespace moivre::test {
namespace {

Certificate ball(const Point& midpoint, double radius, double error) {
  Certificate c;
  c.verdict = Verdict::certified;
  c.bits = kDoubleBits;
  c.midpoint = midpoint;
  c.sizes = BallSizes(std::vector(midpoint.size(), radius), std::vector(midpoint.size(), error));
  return c;
}

TEST(Distinct, RelationsFollowFromErrorsAndRadii) {
  const Certificate a = ball({0, 0}, 1, 0.1);
  EXPECT_EQ(relation(a, ball({0, 5}, 1, 0.1)), Relation::distinct);
  EXPECT_EQ(relation(a, ball({0, 0.2}, 1, 0.05)), Relation::distinct);
  EXPECT_EQ(relation(a, ball({0.05, 0}, 1, 0.1)), Relation::same);
  // Overlapping balls alone prove nothing.
  EXPECT_EQ(relation(ball({0, 0}, 0.1, 0.09), ball({0.12, 0}, 0.1, 0.09)), Relation::doubtful);
  // One image inside the other's ball is enough, whichever it is.
  EXPECT_EQ(relation(ball({0, 0}, 0.02, 0.01), ball({0.05, 0}, 1, 0.9)), Relation::same);
  EXPECT_EQ(relation(ball({0.05, 0}, 1, 0.9), ball({0, 0}, 0.02, 0.01)), Relation::same);
}

TEST(Distinct, RelationsAreExactAtTheEdge) {
  const double e = 0x1p-54;
  EXPECT_EQ(relation(ball({1}, 0x1p-53, e), ball({1 + 0x1p-52}, 0x1p-53, e)), Relation::distinct);
  // They touch at a point.
  EXPECT_EQ(relation(ball({0}, 2, 1), ball({2}, 1.5, 1)), Relation::doubtful);
  Certificate finer = ball({1}, 1e-30, 1e-31);
  finer.finer = {{1e-29}};
  EXPECT_EQ(relation(finer, ball({1}, 1e-30, 1e-31)), Relation::distinct);
}

/// |m_a - m_b|^2 of one coordinate against (error_a + error_b)^2 and (radius_b - error_a)^2.
Relation by_definition(const Certificate& a, const Certificate& b) {
  Rational re = Rational(a.midpoint[0].real()) - Rational(b.midpoint[0].real());
  const Rational im = Rational(a.midpoint[0].imag()) - Rational(b.midpoint[0].imag());
  for (const Point& part : a.finer) re += Rational(part[0].real());
  const Rational norm = re * re + im * im;
  const auto is_beyond = [&](const Rational& reach) { return norm > reach * reach; };
  if (is_beyond(Rational(a.error(0)) + Rational(b.error(0)))) return Relation::distinct;
  for (const auto& [inner, outer] : {std::pair{&a, &b}, std::pair{&b, &a}}) {
    const Rational room = Rational(outer->radius(0)) - Rational(inner->error(0));
    if (room >= 0 && !is_beyond(room)) return Relation::same;
  }
  return Relation::doubtful;
}

// Distances within some units of the last place of what they are compared with. No pair is both
// distinct and the same: errors are more than half of what radii leave.
TEST(Distinct, RelationsThatDoubleTellsAreTheExactOnes) {
  std::mt19937_64 random(1);
  std::uniform_real_distribution<double> unit(0.8, 0.99);
  std::uniform_int_distribution<int> some(-4, 4);
  std::map<Relation, int> seen;
  for (int k = 0; k < 30'000; ++k) {
    const double scale = std::ldexp(1, 10 * some(random));
    const double angle = k % 2 == 0 ? 0 : unit(random);
    Certificate a =
        ball({std::polar(scale * unit(random), angle)}, 2 * scale, scale * unit(random));
    if (k % 5 == 0) a.finer = {{scale * 0x1p-54 * some(random)}};
    Certificate b = ball({0}, 2 * scale, scale * unit(random));
    const double reach = k % 3 == 0 ? a.error(0) + b.error(0) : b.radius(0) - a.error(0);
    b.midpoint[0] = a.midpoint[0] + std::polar(reach * (1 + some(random) * 0x1p-52), angle);
    ASSERT_EQ(relation(a, b), by_definition(a, b)) << k;
    ASSERT_EQ(relation(b, a), by_definition(a, b)) << k;
    ++seen[relation(a, b)];
  }
  EXPECT_GT(seen[Relation::distinct], 1000);
  EXPECT_GT(seen[Relation::same], 1000);
  EXPECT_GT(seen[Relation::doubtful], 1000);
}

TEST(Distinct, RootsOfPlantedSystemsAreAllDistinct) {
  const Planted p = planted(7, 3, Factors::conjugate_pairs);
  ASSERT_EQ(p.roots.size(), 27U);
  std::vector<Point> points;
  for (const ExactPoint& root : p.roots) points.push_back(to_double(root));
  const std::vector<Certificate> certificates = certify(p.f, points);
  for (std::uint64_t seed = 1; seed <= 3; ++seed) {
    const Distinctness d = compare(certificates, seed);
    EXPECT_EQ(d.holding, 27U);
    EXPECT_EQ(d.distinct_roots, 27U);
    EXPECT_TRUE(d.doubtful.empty());
    // As many as Bezout's number: these are all the roots.
    EXPECT_EQ(bezout_bound(p.f), 27U);
  }
}

TEST(Distinct, TheSameRootFromTwoPointsIsOne) {
  const System f = problem("katsura-5.phc");
  const Certificate root = certify(f, {{1, 0, 0, 0, 0, 0}})[0];
  ASSERT_EQ(root.verdict, Verdict::certified);
  std::vector<Point> points;
  for (const double off : {0.0, 1e-9, -1e-8, 1e-13})
    points.push_back({1 + off, off, -off, off, 0, 0});
  std::vector<Certificate> certificates = certify(f, points);
  certificates.push_back(Certificate());
  Certifier certifier(make_certify_program(f));
  const Distinctness d = tell_apart(certifier, certificates);
  EXPECT_EQ(d.distinct_roots, 1U);
  EXPECT_EQ(d.holding, 4U);
  EXPECT_EQ(d.first_of, (std::vector<std::size_t>{0, 0, 0, 0, 4}));
}

TEST(Distinct, NeighboursOfAnyDistanceAreToldApart) {
  for (const char* squared : {"1e-20", "1e-30", "1e-40", "1e-100"}) {
    const System f = system_of(std::string("2\nx^2 - 2*x + 1 - ") + squared + ";\ny - x;\n");
    std::vector<Certificate> certificates =
        certify(f, {{1 + 1e-7, 1 + 1e-7}, {1 - 1e-7, 1 - 1e-7}, {1 + 2e-7, 1 + 2e-7}});
    for (const Certificate& c : certificates) ASSERT_EQ(c.verdict, Verdict::certified) << squared;
    Certifier certifier(make_certify_program(f));
    const Distinctness d = tell_apart(certifier, certificates);
    EXPECT_EQ(d.distinct_roots, 2U) << squared;
    EXPECT_EQ(d.same, (std::vector<IndexPair>{{0, 2}})) << squared;
    EXPECT_TRUE(d.doubtful.empty()) << squared;
  }
}

TEST(Distinct, DoubtsAreTakenAwayByMoreDigits) {
  const System f = system_of("1\nx^2 - 2;\n");
  Certifier certifier(make_certify_program(f));
  // True, but made so wide that they cannot be compared: -sqrt(2) and sqrt(2), and sqrt(2) off its
  // middle.
  const double root = std::sqrt(2.0);
  std::vector<Certificate> certificates = {ball({root}, 1.42, 1.415), ball({-root}, 1.42, 1.415),
                                           ball({root + 1.4}, 1.42, 1.415)};
  const Distinctness before = compare(certificates);
  EXPECT_FALSE(before.doubtful.empty());
  EXPECT_LT(before.distinct_roots, 2U);
  const Distinctness after = tell_apart(certifier, certificates);
  EXPECT_TRUE(after.doubtful.empty());
  EXPECT_EQ(after.distinct_roots, 2U);
  EXPECT_EQ(after.same, (std::vector<IndexPair>{{0, 2}}));
}

TEST(Distinct, TheSweepFindsEveryPairThatMeets) {
  // A grid of balls, each of which meets its neighbours; all pairs compared one by one give the
  // same.
  std::vector<Certificate> certificates;
  for (int a = 0; a < 12; ++a) {
    for (int b = 0; b < 12; ++b) {
      certificates.push_back(ball({Complex(a, b), 1e6}, 0.61, 0.6));
    }
  }
  std::vector<IndexPair> expected;
  for (std::size_t i = 0; i < certificates.size(); ++i) {
    for (std::size_t j = i + 1; j < certificates.size(); ++j) {
      if (relation(certificates[i], certificates[j]) == Relation::doubtful)
        expected.emplace_back(i, j);
    }
  }
  ASSERT_GT(expected.size(), 100U);
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    EXPECT_EQ(compare(certificates, seed).doubtful, expected);
  }
}

TEST(Distinct, BezoutsNumberBoundsTheRoots) {
  EXPECT_EQ(bezout_bound(problem("katsura-10.phc")), 1024U);
  EXPECT_EQ(bezout_bound(system_of("2\nx*y - 1;\n3;\n")), 0U);
  EXPECT_THROW(bezout_bound(system_of("1 2\nx*y - 1;\n")), std::invalid_argument);
}

}  // namespace
}  // namespace moivre::test
