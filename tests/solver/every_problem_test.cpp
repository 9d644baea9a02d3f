// SPDX-License-Identifier: MIT
// Does every problem of the index give the counts that are proved for it, over several seeds, and
// is every account closed?
#include <gtest/gtest.h>

#include "problem_set.h"

namespace moivre {
namespace {

constexpr std::uint64_t kSeeds = 3;
/// Longer ones are left to bench/root_counts.
constexpr std::uint64_t kMostPaths = 300;
/// Up to here a second or less a seed.
constexpr std::uint64_t kPathsForEverySeed = 130;
constexpr int kThreads = 2;

class EveryProblem : public testing::TestWithParam<problems::Problem> {};

TEST_P(EveryProblem, HasTheCountsOfTheIndexAndAClosedAccount) {
  const problems::Problem& p = GetParam();
  const System f = test::system_of(p);
  const std::uint64_t seeds = p.total_degree <= kPathsForEverySeed ? kSeeds : 1;
  for (std::uint64_t seed = 1; seed <= seeds; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    const SolveResult result = test::solve_with_cvode(f, test::with_seed(seed, kThreads));
    test::expect_conservation(result);
    if (!result.complete && test::is_beyond_reach(p)) {
      EXPECT_GT(result.paths.failed, 0U);
      continue;
    }
    test::expect_counts_of_index(result, p);
  }
}

std::vector<problems::Problem> short_problems() {
  std::vector<problems::Problem> chosen;
  for (const problems::Problem& p : test::problem_index()) {
    if (p.total_degree <= kMostPaths) chosen.push_back(p);
  }
  return chosen;
}

std::string name_of(const testing::TestParamInfo<problems::Problem>& info) {
  std::string name = info.param.name;
  std::replace(name.begin(), name.end(), '-', '_');
  return name;
}

INSTANTIATE_TEST_SUITE_P(Index, EveryProblem, testing::ValuesIn(short_problems()), name_of);

}  // namespace

namespace problems {
void PrintTo(const Problem& p, std::ostream* out) { *out << p.name; }
}  // namespace problems
}  // namespace moivre
