// SPDX-License-Identifier: MIT
// Does exact algebra count the roots that the literature counts, and say so where it cannot?
#include "moivre/algebra/quotient_ring.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>

#include "moivre/polynomial/read.h"

namespace moivre::test {
namespace {

using Verdict = QuotientRing::Verdict;

constexpr std::uint64_t kTerms = 20'000'000;

System system_of(const std::string& text) { return read_system({"test", text}); }

QuotientRing ring_of(const std::string& text) {
  return quotient_ring(system_of(text), {0, kTerms});
}

std::uint64_t roots_of(const std::string& text) {
  const QuotientRing ring = ring_of(text);
  EXPECT_EQ(ring.verdict, Verdict::finite) << text;
  return ring.dimension;
}

struct Published {
  const char* problem;
  std::uint64_t roots;
};
void PrintTo(const Published& published, std::ostream* out) { *out << published.problem; }

class QuotientRingOfProblems : public testing::TestWithParam<Published> {};

TEST_P(QuotientRingOfProblems, HasThePublishedNumberOfRootsAsDimension) {
  const System f = read_system(read_source(std::string(MOIVRE_SOURCE_DIR) +
                                           "/problems/polynomials/" + GetParam().problem + ".phc"));
  const QuotientRing ring = quotient_ring(f, {0, kTerms});
  EXPECT_EQ(ring.verdict, Verdict::finite);
  EXPECT_EQ(ring.dimension, GetParam().roots);
}

INSTANTIATE_TEST_SUITE_P(Literature, QuotientRingOfProblems,
                         testing::Values(Published{"cyclic-5", 70}, Published{"cyclic-6", 156},
                                         Published{"cassou", 16}, Published{"katsura-5", 32},
                                         Published{"noon-3", 21}, Published{"puma", 16},
                                         Published{"kin1", 48}, Published{"reimer-5", 144}),
                         [](const auto& given) {
                           std::string name = given.param.problem;
                           std::replace(name.begin(), name.end(), '-', '_');
                           return name;
                         });

TEST(QuotientRing, CountsEachRootWithItsMultiplicity) {
  EXPECT_EQ(roots_of("2\n(x - 1)^3*(x + 2);\ny^2 - x - 3;\n"), 8U);
  EXPECT_EQ(roots_of("2\nx^3 - 2*y^4;\ny^2 - 5*x^3;\n"), 12U);
  EXPECT_EQ(roots_of("1\n(x^2 - 2)^5;\n"), 10U);
}

TEST(QuotientRing, CountsDifferentRootsWhereAskedTo) {
  const auto points_of = [](const std::string& text) {
    return quotient_ring(system_of(text), {0, kTerms, nullptr, true}).points;
  };
  EXPECT_EQ(points_of("2\n(x - 1)^3*(x + 2);\ny^2 - x - 3;\n"), 4U);
  EXPECT_EQ(points_of("2\nx^3 - 2*y^4;\ny^2 - 5*x^3;\n"), 7U);  // 6 roots, and the origin six times
  EXPECT_EQ(points_of("1\n(x^2 - 2)^5;\n"), 2U);
  EXPECT_EQ(points_of("1\n(x - 1)^2 - 1e-60;\n"), 2U);
  EXPECT_EQ(points_of("2\nx^2 + y^2 - 1;\nx^2 + y^2 - 4;\n"), 0U);
  EXPECT_EQ(points_of("2\nx*y - x;\nx^2 - 3*x;\n"), std::nullopt);
  EXPECT_FALSE(ring_of("1\nx^2 - 2;\n").points);
}

TEST(QuotientRing, DoesNotCountRootsAtInfinity) {
  EXPECT_EQ(roots_of("2\nx^2 + y^2 - 1;\nx^2 + y^2 - x;\n"), 2U);
  EXPECT_EQ(roots_of("2\nx*y - 1;\nx^2*y - 2*x + 3;\n"), 1U);
}

TEST(QuotientRing, IsZeroWhereTheEquationsContradictEachOther) {
  EXPECT_EQ(roots_of("2\nx*y - 1;\nx*y - 2;\n"), 0U);
}

TEST(QuotientRing, IsInfiniteWhereRootsLieOnCurves) {
  EXPECT_EQ(ring_of("2\nx*y - x;\nx^2 - 3*x;\n").verdict, Verdict::infinite);
  EXPECT_EQ(ring_of("2\nx*y - 1;\n2*x*y - 2;\n").verdict, Verdict::infinite);
}

TEST(QuotientRing, CountsTheSimpleRootsBesideCurves) {
  const std::string circle = "(x^2 + y^2 - 3)";
  const auto simple_of = [](const std::string& text) { return ring_of(text).simple; };
  EXPECT_EQ(simple_of("2\n(x - 1)*" + circle + ";\n(y - 2)*" + circle + ";\n"), 1U);
  EXPECT_EQ(simple_of("2\n(x - 1)^2*" + circle + ";\n(y - 2)*" + circle + ";\n"), 0U);
  EXPECT_EQ(simple_of("2\n(x^2 - 2)*" + circle + ";\n(x*y - i)*" + circle + ";\n"), 2U);
  // Nearer to the circle than any path can tell, and on it.
  EXPECT_EQ(simple_of("2\n(x - 1 - 1e-60)*" + circle + ";\n(y^2 - 2)*" + circle + ";\n"), 2U);
  EXPECT_EQ(simple_of("2\n(x - 1)*" + circle + ";\n(y^2 - 2)*" + circle + ";\n"), 0U);
  // Of two points one lies on the plane that all equations share.
  EXPECT_EQ(simple_of("3\n(x - 1)*(z + 1);\n(y - 2)*(z + 1);\n(z^2 - x)*(z + 1);\n"), 1U);
  EXPECT_EQ(simple_of("2\nx*y - x;\nx^2 - x;\n"), 1U);
  EXPECT_EQ(simple_of("2\nx*y - 1;\n2*x*y - 2;\n"), 0U);
  EXPECT_FALSE(simple_of("2\nx^2 - 1;\ny^2 - 1;\n"));
  EXPECT_FALSE(simple_of("3 2\nx*y;\nx^2;\nx;\n"));
}

TEST(QuotientRing, OfAnyNumberOfEquationsCountsTheirCommonRoots) {
  EXPECT_EQ(roots_of("3 2\nx^2 - 1;\ny^2 - 1;\nx*y - 1;\n"), 2U);
}

TEST(QuotientRing, TakesComplexAndDecimalCoefficientsAsTheyStand) {
  EXPECT_EQ(roots_of("2\nx^2 + (1 + 2*i)*y - 3;\ny^2 - i*x*y + 0.1;\n"), 4U);
  // Two roots beside each other are no double root.
  EXPECT_EQ(roots_of("1\n(x - 1)^2 - 1e-60;\n"), 2U);
}

TEST(QuotientRing, IsGivenUpWithTheTermsAllowedAndWhenItIsStopped) {
  const System f = system_of("2\nx^2*y + y^3 - 3*x + 1;\nx^3 - y^2*x + 7*y;\n");
  EXPECT_EQ(quotient_ring(f, {0, 10}).verdict, Verdict::not_found);
  const std::atomic<bool> stop = true;
  EXPECT_EQ(quotient_ring(f, {0, kTerms, &stop}).verdict, Verdict::not_found);
  EXPECT_EQ(quotient_ring(f, {0, kTerms}).dimension, 9U);
}

TEST(QuotientRing, IsNotFoundBeyondItsDegreesAndUnknowns) {
  EXPECT_EQ(ring_of("1\nx^300 - 2;\n").verdict, Verdict::not_found);
  std::string many = "16\n";
  for (int k = 0; k < 16; ++k) many += "x" + std::to_string(k) + "^2 - 2;\n";
  EXPECT_EQ(ring_of(many).verdict, Verdict::not_found);
  // The last one is in no equation.
  System one_more = system_of("1\nx^2 - 2;\n");
  one_more.variables.resize(16, "y");
  EXPECT_EQ(quotient_ring(one_more, {0, kTerms}).verdict, Verdict::not_found);
  EXPECT_EQ(quotient_ring(System{}, {0, kTerms}).verdict, Verdict::not_found);
}

// p = 2^61 - 31 is prime. Modulo p the last one has no root: p x^2 = 2.
TEST(QuotientRing, LosesNoRootByAPrimeThatASystemWasMadeFor) {
  EXPECT_EQ(roots_of("1\n2305843009213693921*x^2 - x - 1;\n"), 2U);
  EXPECT_EQ(roots_of("1\nx^2/2305843009213693921 - x - 1;\n"), 2U);
  EXPECT_EQ(roots_of("2\n2305843009213693922*x^2 + y^2 - 3;\nx^2 + y^2 - 1;\n"), 4U);
}

// Two roots 2e-9 apart on a line on which the linear form that was the same for every system is
// constant.
TEST(QuotientRing, TellsRootsApartThatALinearFormKnownBeforehandDoesNot) {
  const std::string line =
      "(18012415595241892124*x + 2715516322141056654*y - 67614828396430959642/11)";
  const System f = system_of("2\n" + line + "*(x - 2*y + 3);\n(x - 2/7)^2 - 1e-18 + " + line +
                             "*(y + x + 1)/18012415595241892124;\n");
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    const QuotientRing ring = quotient_ring(f, {.counts_points = true, .seed = seed});
    EXPECT_EQ(ring.dimension, 4U);
    EXPECT_EQ(ring.points, 4U) << seed;
  }
}

// Beside the line x - y = 5 the first two equations have four simple roots, and the third vanishes
// at none of them, or at all.
TEST(QuotientRing, CountsTheSimpleRootsOfCombinationsAtWhichAllEquationsVanish) {
  const std::string two = "3 2\n(x - y - 5)*(x^2 - 2);\n(x - y - 5)*(y^2 - 3);\n";
  const System square = system_of("2\n(x - y - 5)*(x^2 - 2);\n(x - y - 5)*(y^2 - 3);\n");
  const auto simple_of = [&](const std::string& third) {
    return quotient_ring(system_of(two + third), {.counts_simple = true, .square = &square}).simple;
  };
  EXPECT_EQ(simple_of("(x - y - 5)*((x^2 - 2)*(y - 11) - 1e-30);\n"), 0U);
  EXPECT_EQ(simple_of("(x - y - 5)*(x^2 - 2)*(y - 11);\n"), 4U);
}

// Whatever is known, at least as many: where all are, the search may end.
TEST(QuotientRing, NeverCountsFewerThanThereAre) {
  const System f = system_of("2\nx^2*y + y^3 - 3*x + 1;\nx^3 - y^2*x + 7*y;\n");
  for (std::uint64_t known = 0; known <= 9; ++known) {
    EXPECT_EQ(quotient_ring(f, {known, kTerms}).dimension, 9U) << known;
  }
}

}  // namespace
}  // namespace moivre::test
