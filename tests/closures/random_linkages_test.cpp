// SPDX-License-Identifier: MIT
// Are the closures of linkages that nobody tuned the program to right? The bench random_linkages
// has them by the hundred.
#include <gtest/gtest.h>

#include "linkage_judge.h"
#include "mechanisms.h"
#include "moivre/tracker_lanes/lane_tracker.h"

namespace moivre {
namespace {

struct Drawn {
  const char* name;
  Space space;
  std::uint64_t seed;
  std::uint64_t first;
  std::uint64_t count;
};

class RandomLinkages : public testing::TestWithParam<Drawn> {};

ClosureResult by_lanes(const Mechanism& mechanism, std::uint64_t seed) {
  ClosureOptions options;
  options.solve.seed = seed;
  options.solve.threads = 1;
  return find_closures(mechanism, *make_lane_tracker(), options);
}

TEST_P(RandomLinkages, HaveTheirOwnPoseAndNoneThatNewtonsMethodAloneFinds) {
  constexpr std::uint64_t kStarts = 20;
  const Drawn& drawn = GetParam();
  std::uint64_t decided = 0;
  for (std::uint64_t k = drawn.first; k < drawn.first + drawn.count; ++k) {
    const Mechanism linkage = test::random_linkage(drawn.space, drawn.seed, k);
    const ClosureResult result = by_lanes(linkage, k + 1);
    if (!result.complete || result.moves) continue;
    ++decided;
    const auto by_newton =
        test::poses_by_newton(linkage, kStarts, test::Draw(drawn.seed, k + 1000003));
    EXPECT_EQ(test::fault_of(linkage, result, by_lanes(linkage, k + 1001), by_newton), "")
        << "linkage " << k;
  }
  EXPECT_GE(10 * decided, 9 * drawn.count);
}

TEST(RandomAssemblies, HaveTheClosuresOfTheSameWithoutIdleWheelsAndWithDriversForGears) {
  constexpr std::uint64_t kSeed = 11;
  constexpr std::uint64_t kCount = 40;
  constexpr std::uint64_t kStarts = 20;
  std::uint64_t decided = 0;
  std::uint64_t idle = 0;
  for (std::uint64_t k = 0; k < kCount; ++k) {
    const test::Assembly drawn = test::random_assembly(kSeed, k);
    const ClosureResult result = by_lanes(drawn.mechanism, k + 1);
    if (!result.complete || result.moves) continue;
    ++decided;
    idle += result.idle.size();
    const auto by_newton =
        test::poses_by_newton(drawn.plain, kStarts, test::Draw(kSeed, k + 1000003));
    EXPECT_EQ(test::fault_of(drawn.plain, result, by_lanes(drawn.mechanism, k + 1001), by_newton),
              "")
        << "assembly " << k;
  }
  EXPECT_GE(10 * decided, 9 * kCount);
  EXPECT_GT(idle, 5U);
}

INSTANTIATE_TEST_SUITE_P(Spaces, RandomLinkages,
                         testing::Values(Drawn{"Planar", Space::planar, 3, 0, 40},
                                         Drawn{"Spatial", Space::spatial, 5, 1, 15}),
                         [](const auto& tested) { return std::string(tested.param.name); });

TEST(TheJudgeOfLinkages, SeesALostAClonedAndAMiscountedClosure) {
  const Mechanism linkage = test::random_linkage(Space::planar, 3, 0);
  const ClosureResult right = by_lanes(linkage, 1);
  const auto told = [&](const ClosureResult& result, const ClosureResult& again) {
    return test::fault_of(linkage, result, again, {});
  };
  EXPECT_EQ(told(right, right), "");
  ClosureResult lost = right;
  std::erase_if(lost.closures, [](const Closure& closure) { return closure.q.norm() < 1e-9; });
  EXPECT_EQ(told(lost, right), "its own pose is lost");
  ClosureResult cloned = right;
  cloned.closures.push_back(cloned.closures.front());
  EXPECT_EQ(told(cloned, right), "closure A is told twice");
  ClosureResult bent = right;
  bent.closures.push_back(right.closures.front());
  bent.closures.back().q[0] += 1e-3;
  EXPECT_TRUE(told(bent, right).starts_with("closure A leaves ")) << told(bent, right);
  std::vector<Eigen::VectorXd> unknown{right.closures.front().q};
  unknown.front()[0] += 1e-3;
  EXPECT_TRUE(test::fault_of(linkage, right, right, unknown)
                  .starts_with("Newton's method finds one more, at "));
  ClosureResult more = right;
  ++more.counts.complex;
  EXPECT_EQ(told(right, more), "1 complex closures, by another seed 2");
}

}  // namespace
}  // namespace moivre
