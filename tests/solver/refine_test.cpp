// SPDX-License-Identifier: MIT
// Is a simple root proved simple and known to the last digit, and a multiple one refused?
#include "refine.h"

#include <gtest/gtest.h>

#include <cmath>

#include "moivre/polynomial/read.h"
#include "problem_set.h"

namespace moivre {
namespace {

/// What a tracker leaves for the refinement to do.
constexpr double kTrackerError = 1e-8;
constexpr double kUnit = 0x1p-52;

using test::read;

Refiner refiner_of(const std::string& text) {
  const System f = read(text);
  return Refiner(make_refiner_program(f, std::vector<double>(f.variables.size(), 1.0)));
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

TEST(Refine, ProvesASimpleRootAndKnowsItToTheLastDigit) {
  Refiner refiner = refiner_of("2\n x^2 + y^2 - 5;\n x*y - 2;\n");
  for (int turn = 0; turn < 8; ++turn) {
    const Complex off = std::polar(kTrackerError, static_cast<double>(turn));
    const Refined root = refiner.refine({1.0 + off, 2.0 - off}, kTrackerError);
    EXPECT_TRUE(root.simple);
    EXPECT_LE(std::abs(root.x[0] - 1.0), kUnit);
    EXPECT_LE(std::abs(root.x[1] - 2.0), 2 * kUnit);
    EXPECT_LE(root.residual, kUnit);
    EXPECT_LE(root.accuracy, 4 * kUnit);
  }
}

TEST(Refine, StatesAnAccuracyThatHoldsForAnIrrationalRoot) {
  Refiner refiner = refiner_of("1\n x^2 - 2;\n");
  const Refined root = refiner.refine({1.41421356}, kTrackerError);
  EXPECT_TRUE(root.simple);
  EXPECT_LE(std::abs(root.x[0] - std::sqrt(2.0)), root.accuracy * std::sqrt(2.0) + kUnit);
}

TEST(Refine, ProvesEveryRootOfWilkinsonsPolynomialOfDegreeFifteen) {
  Refiner refiner = refiner_of(wilkinson(15));
  for (int k = 1; k <= 15; ++k) {
    for (const double side : {1.0, -1.0}) {
      SCOPED_TRACE(k);
      const Refined root = refiner.refine({k * (1 + side * kTrackerError)}, kTrackerError);
      EXPECT_TRUE(root.simple);
      // The exact coefficients count: rounding them to double would move these roots by 1e-5.
      EXPECT_LE(std::abs(root.x[0] - static_cast<double>(k)), k * kUnit);
    }
  }
}

TEST(Refine, RefusesAMultipleRootOfOneUnknown) {
  for (int m = 2; m <= 8; ++m) {
    Refiner refiner = refiner_of("1\n (x - 1)^" + std::to_string(m) + ";\n");
    for (const double off : {0.0, 1e-15, 1e-9, 1e-6, 1e-4}) {
      for (int turn = 0; turn < 4; ++turn) {
        SCOPED_TRACE("multiplicity " + std::to_string(m) + ", off by " + std::to_string(off));
        const Point x{1.0 + std::polar(off, static_cast<double>(turn))};
        EXPECT_FALSE(refiner.refine(x, std::max(off, kUnit)).simple);
      }
    }
  }
}

TEST(RefineFine, ProvesEveryRootOfWilkinsonsPolynomialOfDegreeThirty) {
  Refiner refiner = refiner_of(wilkinson(30));
  int beyond_double = 0;
  for (int k = 1; k <= 30; ++k) {
    SCOPED_TRACE(k);
    const Refined root = refiner.refine_fine({k * (1 + 1e-9)});
    EXPECT_TRUE(root.simple);
    EXPECT_LE(std::abs(root.x[0] - static_cast<double>(k)), root.accuracy * k);
    EXPECT_LT(root.accuracy, 1e-8);
    if (!refiner.refine({k * (1 + 1e-9)}, 1e-9).simple) ++beyond_double;
  }
  EXPECT_GT(beyond_double, 5);
}

TEST(RefineFine, RefusesAMultipleRoot) {
  for (int m = 2; m <= 8; ++m) {
    Refiner one = refiner_of("1\n (x - 1)^" + std::to_string(m) + ";\n");
    Refiner two = refiner_of("2\n (x - 1)^" + std::to_string(m) + " + y - 1;\n y - 1;\n");
    for (const double off : {0.0, 1e-15, 1e-9, 1e-6, 1e-4}) {
      SCOPED_TRACE("multiplicity " + std::to_string(m) + ", off by " + std::to_string(off));
      EXPECT_FALSE(one.refine_fine({1 + off}).simple);
      EXPECT_FALSE(two.refine_fine({1 + off, 1}).simple);
    }
  }
}

TEST(Refine, RefusesAMultipleRootOfSeveralUnknowns) {
  for (int m = 2; m <= 8; ++m) {
    SCOPED_TRACE("multiplicity " + std::to_string(m));
    Refiner refiner = refiner_of("2\n (x - 1)^" + std::to_string(m) + " + y - 1;\n y - 1;\n");
    EXPECT_FALSE(refiner.refine({1 + 1e-7, 1}, 1e-7).simple);
    EXPECT_FALSE(refiner.refine({1, 1}, 1e-12).simple);
  }
}

TEST(Refine, LeavesTheEndOfAMultipleRootWhereItWas) {
  Refiner refiner = refiner_of("1\n (x - 1)^3;\n");
  const Point x{Complex(1 + 1e-6, 1e-6)};
  EXPECT_EQ(refiner.refine(x, 1e-12).x, x);
}

TEST(Refine, ProvesTwoNearRootsToBeTwoSimpleOnes) {
  Refiner refiner = refiner_of("2\n x^2 - 2*x + 1 - 1e-10;\n y - x;\n");
  for (const double root : {1 - 1e-5, 1 + 1e-5}) {
    const double start = root + 1e-9;
    const Refined refined = refiner.refine({start, start}, 1e-9);
    EXPECT_TRUE(refined.simple);
    EXPECT_LE(std::abs(refined.x[0] - root), 1e-15);
  }
}

TEST(Refine, DoesNotRunAwayToAnotherRoot) {
  Refiner refiner = refiner_of("1\n x^2 - 1;\n");
  const Refined far = refiner.refine({2}, 1e-12);
  EXPECT_FALSE(far.simple);
  EXPECT_EQ(far.x, Point{2});
}

TEST(Refine, SetsVanishingPartsToZero) {
  Refiner refiner = refiner_of("3\n x^2 - 4;\n y*x;\n z^2 + 1;\n");
  const Complex off(kTrackerError, -kTrackerError);
  const Refined root = refiner.refine({2.0 + off, off, Complex(0, 1) + off}, kTrackerError);
  EXPECT_TRUE(root.simple);
  EXPECT_EQ(root.x, (Point{2, 0, Complex(0, 1)}));
}

TEST(Refine, KeepsSmallPartsThatAreNotZero) {
  Refiner refiner = refiner_of("1\n 1000000000000*x - 1;\n");
  EXPECT_NEAR(refiner.refine({1e-12}, 1e-15).x[0].real(), 1e-12, 1e-27);
}

TEST(Refine, OfASingularEndStatesTheRootOfItsResidual) {
  Refiner refiner = refiner_of("1\n (x - 1)^4;\n");
  const Refined kept = refiner.keep({1 + 1e-3}, 1e-15, 4);
  EXPECT_FALSE(kept.simple);
  EXPECT_GE(kept.accuracy, 1e-4);
}

}  // namespace
}  // namespace moivre
