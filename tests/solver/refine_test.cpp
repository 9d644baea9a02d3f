// SPDX-License-Identifier: MIT
// Is a proved root known to the last digit, and an end without a proof kept as it was?
#include "refine.h"

#include <gtest/gtest.h>

#include <cmath>

#include "certificates.h"
#include "moivre/certify/certifier.h"
#include "moivre/polynomial/read.h"
#include "problem_set.h"

namespace moivre {
namespace {

/// What a tracker leaves for the refinement to do.
constexpr double kTrackerError = 1e-8;
constexpr double kUnit = 0x1p-52;

using test::read;

Refiner refiner_of(const System& f) {
  return Refiner(make_refiner_program(f, std::vector<double>(f.variables.size(), 1.0)));
}

/// The root that is proved near x; not simple where there is none.
Refined proved(const std::string& text, const Point& x) {
  const System f = read(text);
  const auto certificate = Prover(make_certify_program(f)).prove(x);
  return certificate ? refiner_of(f).take(*certificate) : Refined{};
}

std::string wilkinson(int degree) {
  std::string text = "1\n ";
  for (int k = 1; k <= degree; ++k) {
    if (k > 1) text += "*";
    text += "(x - ";
    text += std::to_string(k);
    text += ")";
  }
  return text + ";\n";
}

TEST(Refine, KnowsAProvedRootToTheLastDigit) {
  for (int turn = 0; turn < 8; ++turn) {
    const Complex off = std::polar(kTrackerError, static_cast<double>(turn));
    const Refined root = proved("2\n x^2 + y^2 - 5;\n x*y - 2;\n", {1.0 + off, 2.0 - off});
    EXPECT_TRUE(root.simple);
    EXPECT_LE(std::abs(root.x[0] - 1.0), kUnit);
    EXPECT_LE(std::abs(root.x[1] - 2.0), 2 * kUnit);
    EXPECT_LE(root.residual, kUnit);
    EXPECT_LE(root.accuracy, 4 * kUnit);
  }
}

TEST(Refine, StatesAnAccuracyThatHoldsForAnIrrationalRoot) {
  const Refined root = proved("1\n x^2 - 2;\n", {1.41421356});
  EXPECT_TRUE(root.simple);
  EXPECT_LE(std::abs(root.x[0] - std::sqrt(2.0)), root.accuracy * std::sqrt(2.0) + kUnit);
}

TEST(Refine, KnowsRootsOfWilkinsonsPolynomialThatDoubleDoesNotProve) {
  if (!proves_beyond_double()) GTEST_SKIP() << "needs more digits";
  const System f = read(wilkinson(30));
  Prover prover(make_certify_program(f));
  int beyond_double = 0;
  for (int k = 1; k <= 30; ++k) {
    SCOPED_TRACE(k);
    const Point x{k * (1 + 1e-9)};
    const auto certificate = prover.prove(x);
    ASSERT_NE(certificate, nullptr);
    const Refined root = refiner_of(f).take(*certificate);
    EXPECT_TRUE(root.simple);
    // The exact coefficients count: rounding them to double would move these roots by 1e-5.
    EXPECT_LE(std::abs(root.x[0] - static_cast<double>(k)), root.accuracy * k);
    EXPECT_LT(root.accuracy, 4 * kUnit);
    if (!prover.prove_in_double(x)) ++beyond_double;
  }
  EXPECT_GT(beyond_double, 5);
}

TEST(Refine, ProvesNothingOfAMultipleRoot) {
  for (int m = 2; m <= 8; ++m) {
    const std::string power = "(x - 1)^" + std::to_string(m);
    for (const double off : {0.0, 1e-15, 1e-9, 1e-6, 1e-4}) {
      SCOPED_TRACE("multiplicity " + std::to_string(m) + ", off by " + std::to_string(off));
      for (int turn = 0; turn < 4; ++turn) {
        const Complex x = 1.0 + std::polar(off, static_cast<double>(turn));
        EXPECT_FALSE(proved("1\n " + power + ";\n", {x}).simple);
      }
      EXPECT_FALSE(proved("2\n " + power + " + y - 1;\n y - 1;\n", {1 + off, 1}).simple);
    }
  }
}

TEST(Refine, KnowsTwoNearRootsToBeTwo) {
  for (const double root : {1 - 1e-5, 1 + 1e-5}) {
    const double start = root + 1e-9;
    const Refined refined = proved("2\n x^2 - 2*x + 1 - 1e-10;\n y - x;\n", {start, start});
    EXPECT_TRUE(refined.simple);
    EXPECT_LE(std::abs(refined.x[0] - root), 1e-15);
  }
}

TEST(Refine, DoesNotRunAwayToAnotherRoot) {
  EXPECT_FALSE(proved("1\n x^2 - 1;\n", {2}).simple);
  Refiner refiner = refiner_of(read("1\n x^2 - 1;\n"));
  EXPECT_FALSE(refiner.is_within_reach({1 + 1e-4}, 1e-12, {1}));
  EXPECT_TRUE(refiner.is_within_reach({1 + 1e-9}, 1e-12, {1}));
}

TEST(Refine, SetsVanishingPartsToZero) {
  const Complex off(kTrackerError, -kTrackerError);
  const Refined root =
      proved("3\n x^2 - 4;\n y*x;\n z^2 + 1;\n", {2.0 + off, off, Complex(0, 1) + off});
  EXPECT_TRUE(root.simple);
  EXPECT_EQ(root.x, (Point{2, 0, Complex(0, 1)}));
}

TEST(Refine, KeepsSmallPartsThatAreNotZero) {
  EXPECT_NEAR(proved("1\n 1000000000000*x - 1;\n", {1e-12}).x[0].real(), 1e-12, 1e-27);
}

TEST(Refine, OfASingularEndStatesTheRootOfItsResidual) {
  const Point x{Complex(1 + 1e-3, 1e-6)};
  Refiner refiner = refiner_of(read("1\n (x - 1)^4;\n"));
  const Refined kept = refiner.keep(x, 1e-15, 4);
  EXPECT_FALSE(kept.simple);
  EXPECT_EQ(kept.x, x);
  EXPECT_GE(kept.accuracy, 1e-4);
}

}  // namespace
}  // namespace moivre
