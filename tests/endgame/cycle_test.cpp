// SPDX-License-Identifier: MIT
// Do the power sums of a cycle tell where its sheets end, whatever lies inside the circle?
#include "cycle.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>

#include "moivre/numeric/random.h"

namespace moivre {
namespace {

constexpr int kSamplesOfATurn = 16;
constexpr double kRadius = 1e-4;
constexpr double kRounding = 1e-13;

/// z at the samples of m turns, z a function of u = s^{1/m} on |s| = kRadius.
std::vector<Complex> cycle_of(int m, const std::function<Complex(Complex)>& z) {
  std::vector<Complex> samples;
  const int count = m * kSamplesOfATurn;
  for (int k = 1; k <= count; ++k) {
    const double angle = 2 * std::numbers::pi * k / count;
    samples.push_back(z(std::polar(std::pow(kRadius, 1.0 / m), angle)));
  }
  return samples;
}

/// The two sheets of z^2 = s + limit^2, followed around both branch points.
std::vector<Complex> two_sheets(double limit) {
  return cycle_of(2, [limit](Complex u) { return u * std::sqrt(1.0 + limit * limit / (u * u)); });
}

TEST(Cycle, SheetsOfAPowerSeriesWithoutAConstantTermVanishTogether) {
  for (const int m : {1, 2, 3, 5, 8, 12}) {
    const auto z = cycle_of(m, [](Complex u) { return u * (2.0 + u * Complex(0.3, -1)); });
    EXPECT_TRUE(vanish_together(z, m, EndParameters())) << m;
    EXPECT_FALSE(meet_together(z, Complex(0.5, 0), m, EndParameters()) && m > 1) << m;
    EXPECT_TRUE(meet_together(z, 0.0, m, EndParameters())) << m;
  }
}

// The circle is wide beside their distance: the sum of squares is lost in the errors that samples
// may have, not in those they have.
TEST(Cycle, SheetsThatEndBesideEachOtherAreToldApartByTheErrorsThatTheSamplesHave) {
  const EndParameters ends;
  const auto beside = two_sheets(1e-7);
  EXPECT_TRUE(meet_together(beside, 0.0, 2, ends));
  EXPECT_GT(sums_and_errors(beside, 2, 0, ends).sum, ends.shrink);
  EXPECT_LE(sums_and_errors(two_sheets(0), 2, 0, ends).sum, ends.shrink);
}

TEST(Cycle, ALimitThatIsNotZeroIsSeenWhereverTheOthersEnd) {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    const int m = 1 + static_cast<int>(seed % 6);
    const Complex limit = 1e-6 * random_phase(seed, RandomStream::slice, 0);
    const auto z = cycle_of(m, [&](Complex u) { return u + limit; });
    EXPECT_FALSE(vanish_together(z, m, EndParameters())) << seed;
    EXPECT_TRUE(meet_together(z, limit, m, EndParameters())) << seed;
  }
}

/// Samples of m sheets that end at 0 or, the first power sum being `limit`, beside it; each off by
/// up to `error` of itself.
std::vector<Complex> blurred_cycle(int m, const Complex& limit, double error, std::uint64_t seed) {
  std::vector<Complex> z = cycle_of(m, [&](Complex u) { return u + limit; });
  for (std::size_t k = 0; k < z.size(); ++k) {
    z[k] *= 1.0 + error * random_phase(seed, RandomStream::test, k);
  }
  return z;
}

// Far below what a tolerance for all samples would have to be.
TEST(Cycle, WhatHasToVanishBesideASumTellsALimitFromErrors) {
  const EndParameters ends;
  for (std::uint64_t seed = 1; seed <= 50; ++seed) {
    const int m = 1 + static_cast<int>(seed % 5);
    for (const double error : {1e-16, 1e-12, 1e-8}) {
      const Complex limit = 300 * error * random_phase(seed, RandomStream::slice, 0);
      const auto z = blurred_cycle(m, limit, error, seed);
      EXPECT_GT(sums_and_errors(z, m, 0, ends).sum, ends.shrink) << seed << ' ' << error;
      EXPECT_LE(sums_and_errors(z, m, 1e7 * error, ends).sum, 1) << seed << ' ' << error;
    }
  }
}

// By chance it may not; then the next circle is asked.
TEST(Cycle, AnEndAtZeroIsNearlyAlwaysToldByItsErrors) {
  const EndParameters ends;
  int told = 0;
  for (std::uint64_t seed = 1; seed <= 1000; ++seed) {
    const int m = 1 + static_cast<int>(seed % 5);
    const SumsAndErrors beside = sums_and_errors(blurred_cycle(m, 0, 1e-12, seed), m, 0, ends);
    EXPECT_LE(beside.error, 1e-12) << seed;
    told += beside.sum <= ends.shrink ? 1 : 0;
  }
  EXPECT_GE(told, 980);
}

// A path that hardly moves: what its samples differ by is their rounding.
TEST(Cycle, SheetsMeetWhereNothingButRoundingKeepsThemApart) {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    const Complex common = random_phase(seed, RandomStream::test, 0);
    std::uint64_t k = 0;
    const auto z = cycle_of(2, [&](Complex u) {
      const Complex noise = 1e-16 * random_phase(seed, RandomStream::test, ++k);
      return common + 1e-12 * u + noise;
    });
    EXPECT_TRUE(meet_together(z, common, 2, EndParameters())) << seed;
    EXPECT_FALSE(meet_together(z, common + Complex(1e-9, 0), 2, EndParameters())) << seed;
  }
}

// They change places on every circle wider than limit^2: the mean is 0, and no sum but the second
// tells.
TEST(Cycle, OppositeLimitsWhoseMeanIsZeroAreTold) {
  for (const double limit : {5e-3, 1e-3, 1e-5, 3e-7}) {
    EXPECT_FALSE(vanish_together(two_sheets(limit), 2, EndParameters())) << limit;
    EXPECT_FALSE(meet_together(two_sheets(limit), 0.0, 2, EndParameters())) << limit;
  }
  EXPECT_TRUE(vanish_together(two_sheets(0), 2, EndParameters()));
}

TEST(Cycle, TheBoundHoldsForEveryLimit) {
  for (const double limit : {5e-3, 1e-4, 1e-6}) {
    const double bound = limit_bound(two_sheets(limit), 2);
    EXPECT_GE(bound, limit);
    EXPECT_LE(bound, 4 * limit);
  }
}

TEST(Cycle, WhatEndsBeyondABoundIsMuchNearerToZeroThanTheCircle) {
  EXPECT_TRUE(end_beyond(1e-6, two_sheets(1e-7), 2));
  EXPECT_FALSE(end_beyond(1e-8, two_sheets(1e-7), 2));
  // A constant as small as that is no end that is approached.
  EXPECT_FALSE(end_beyond(1e-6, std::vector<Complex>(kSamplesOfATurn, 1e-7), 1));
}

TEST(Cycle, ValuationsAreTurnsAroundZeroOverTheWindingNumber) {
  constexpr int kWinding = 6;
  std::vector<Point> samples;
  const auto powers = {-3, 0, 2};
  std::vector<std::vector<Complex>> coordinates;
  for (const int power : powers) {
    coordinates.push_back(
        cycle_of(kWinding, [power](Complex u) { return 7.0 * std::pow(u, power); }));
  }
  const auto x0 = cycle_of(kWinding, [](Complex u) { return u * (1.0 + 0.1 * u); });
  for (std::size_t k = 0; k < x0.size(); ++k) {
    samples.push_back({coordinates[0][k], coordinates[1][k], coordinates[2][k], x0[k]});
  }
  const std::vector<double> expected{-4.0 / 6, -1.0 / 6, 1.0 / 6};
  const std::vector<double> found = valuations(samples, 3, kWinding);
  ASSERT_EQ(found.size(), expected.size());
  for (std::size_t j = 0; j < found.size(); ++j) EXPECT_NEAR(found[j], expected[j], kRounding);
}

}  // namespace
}  // namespace moivre
