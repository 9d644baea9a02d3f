// SPDX-License-Identifier: MIT
// Do random numbers depend on seed, stream and index alone, on all of each, and fill their range
// evenly?
#include "moivre/numeric/random.h"

#include <gtest/gtest.h>

#include <bit>
#include <limits>
#include <set>

namespace moivre {
namespace {

constexpr auto kStart = RandomStream::start_system;
constexpr auto kTest = RandomStream::test;
constexpr int kCount = 10000;

TEST(RandomBits, AreTheSameForTheSameSeedStreamAndIndexInAnyOrder) {
  std::vector<std::uint64_t> forwards;
  for (std::uint64_t i = 0; i < 100; ++i) forwards.push_back(random_bits(7, kTest, i));
  for (std::uint64_t i = 100; i-- > 0;) EXPECT_EQ(random_bits(7, kTest, i), forwards[i]);
}

TEST(RandomBits, OfTheDefaultSeedAreTheseOnEveryMachine) {
  EXPECT_EQ(random_bits(1, RandomStream::start_system, 0), 8614008028692990056u);
  EXPECT_EQ(random_bits(1, RandomStream::start_system, 1), 12017601128915079454u);
  EXPECT_EQ(random_bits(1, RandomStream::slice, 0), 1685891443961195628u);
}

TEST(RandomBits, AreSharedByNoTwoSeedsStreamsOrIndices) {
  std::set<std::uint64_t> seen;
  std::size_t count = 0;
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    for (const RandomStream stream : {kStart, RandomStream::slice, kTest}) {
      for (std::uint64_t index = 0; index < 50; ++index, ++count) {
        seen.insert(random_bits(seed, stream, index));
      }
    }
  }
  EXPECT_EQ(seen.size(), count);
}

TEST(RandomBits, SeeTheHighHalfOfSeedAndIndex) {
  const std::uint64_t high = std::uint64_t{1} << 63;
  EXPECT_NE(random_bits(1, kTest, 0), random_bits(1, kTest, high));
  EXPECT_NE(random_bits(1, kTest, 0), random_bits(1 + high, kTest, 0));
}

TEST(RandomBits, AnswerEachFlippedBitOfTheIndexByFlippingHalfOfTheirs) {
  double flipped = 0;
  for (std::uint64_t i = 0; i < kCount; ++i) {
    const std::uint64_t change = std::uint64_t{1} << (i % 64);
    flipped += std::popcount(random_bits(1, kTest, i) ^ random_bits(1, kTest, i ^ change));
  }
  // 64 fair coins: mean 32, standard deviation 4 / sqrt(count); five of them.
  EXPECT_NEAR(flipped / kCount, 32, 5 * 4 / std::sqrt(double{kCount}));
}

TEST(RandomUnit, FillsTheIntervalEvenly) {
  double sum = 0;
  double squares = 0;
  for (std::uint64_t i = 0; i < kCount; ++i) {
    const double u = random_unit(3, kTest, i);
    ASSERT_GE(u, 0);
    ASSERT_LT(u, 1);
    sum += u;
    squares += u * u;
  }
  // Variances of u and u^2: 1/12 and 4/45; five standard deviations.
  EXPECT_NEAR(sum / kCount, 1.0 / 2, 5 * std::sqrt(1.0 / 12 / kCount));
  EXPECT_NEAR(squares / kCount, 1.0 / 3, 5 * std::sqrt(4.0 / 45 / kCount));
}

TEST(RandomPhase, LiesOnTheUnitCircleAllAround) {
  Complex sum = 0;
  for (std::uint64_t i = 0; i < kCount; ++i) {
    const Complex phase = random_phase(3, kTest, i);
    ASSERT_NEAR(std::abs(phase), 1, 2 * std::numeric_limits<double>::epsilon());
    sum += phase;
  }
  // Each part has variance 1/2, the modulus of the mean 1/count; five of that.
  EXPECT_LT(std::abs(sum) / kCount, 5 / std::sqrt(double{kCount}));
}

}  // namespace
}  // namespace moivre
