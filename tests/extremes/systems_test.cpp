// SPDX-License-Identifier: MIT
// Does each extreme system give the right answer with both trackers, or an honest failure? Multiprecision is the judge.
//
// Whatever the case: the account is closed, every root called simple is one by Smale's alpha test, no two are the same, and
// none is further from the truth than its accuracy says.
#include <gtest/gtest.h>

#include "moivre/multiprecision/reference_roots.h"
#include "moivre/tracker_lanes/lane_tracker.h"
#include "problem_set.h"

namespace moivre {
namespace {

const std::string kFolder = MOIVRE_SOURCE_DIR "/problems/extremes/";
constexpr int kDigits = 20;
/// Two roots this near to each other, relative to their size, are one: below what any case holds.
constexpr double kSame = 1e-12;

struct Case {
  std::string name;
  std::string file;
  std::string expect;
  std::uint64_t simple = 0;
  std::vector<std::uint64_t> multiple;
};

std::vector<Case> cases() {
  std::ifstream file(kFolder + "index.json");
  const nlohmann::json index = nlohmann::json::parse(file);
  std::vector<Case> all;
  for (const nlohmann::json& entry : index.at("systems")) {
    if (!entry.at("test").get<bool>()) continue;
    all.push_back({entry.at("name"), entry.at("file"), entry.at("expect"),
                   entry.value("simple", std::uint64_t{0}),
                   entry.value("multiple", std::vector<std::uint64_t>{})});
  }
  return all;
}

void PrintTo(const Case& c, std::ostream* out) { *out << c.name; }

/// Every root called simple is a root, known as well as it says, and no other's twin.
void expect_true_roots(const System& f, const SolveResult& result) {
  std::vector<Point> points;
  std::vector<double> accuracy;
  for (const Solution& s : result.solutions) {
    if (s.singular) continue;
    points.push_back(s.x);
    accuracy.push_back(s.accuracy);
  }
  const std::vector<ReferenceRoot> roots = reference_roots(f, points, kDigits);
  for (std::size_t k = 0; k < roots.size(); ++k) {
    ASSERT_TRUE(roots[k].converged) << "root " << k;
    EXPECT_LE(roots[k].forward_error, accuracy[k]) << "root " << k;
    for (std::size_t other = 0; other < k; ++other) {
      double apart = 0;
      for (std::size_t i = 0; i < points[k].size(); ++i) {
        const double size = std::max(std::abs(points[k][i]), std::abs(points[other][i]));
        if (size > 0) apart = std::max(apart, std::abs(points[k][i] - points[other][i]) / size);
      }
      EXPECT_GT(apart, kSame) << "roots " << k << " and " << other;
    }
  }
}

/// Multiplicities of the singular roots, ascending; and the number of the others.
std::pair<std::vector<std::uint64_t>, std::uint64_t> counts(const SolveResult& result) {
  std::vector<std::uint64_t> multiple;
  for (const Solution& s : result.solutions) {
    if (s.singular) multiple.push_back(s.multiplicity);
  }
  std::sort(multiple.begin(), multiple.end());
  return {multiple, result.solutions.size() - multiple.size()};
}

void expect_answer(const Case& c, const SolveResult& result) {
  const auto [multiple, simple] = counts(result);
  if (c.expect == "all" || (c.expect == "honest" && result.complete)) {
    EXPECT_TRUE(result.complete) << result.message;
    EXPECT_EQ(simple, c.simple);
    EXPECT_EQ(multiple, c.multiple);
  } else if (c.expect == "honest") {
    EXPECT_GT(result.paths.failed, 0U);
    EXPECT_LE(simple, c.simple);
    EXPECT_TRUE(multiple.empty());
  } else if (c.expect == "cluster") {
    ASSERT_TRUE(result.complete) << result.message;
    EXPECT_EQ(test::sum_of_multiplicities(result), c.simple);
  } else {
    EXPECT_TRUE(result.complete) << result.message;
    EXPECT_TRUE(result.solutions.empty());
    EXPECT_TRUE(c.expect == "set" || result.paths.finite == 0);
  }
}

class Extreme : public testing::TestWithParam<Case> {};

TEST_P(Extreme, IsAnsweredRightlyOrHonestly) {
  const Case& c = GetParam();
  const System f = read_system(read_source(kFolder + c.file));
  std::vector<std::unique_ptr<Tracker>> trackers;
  trackers.push_back(make_cvode_tracker());
  trackers.push_back(make_lane_tracker());
  for (const auto& tracker : trackers) {
    SCOPED_TRACE(tracker->kind());
    if (c.expect == "refused") {
      EXPECT_THROW(solve(f, *tracker, test::with_seed(1)), std::invalid_argument);
      continue;
    }
    const SolveResult result = solve(f, *tracker, test::with_seed(1));
    test::expect_conservation(result);
    expect_true_roots(f, result);
    expect_answer(c, result);
  }
}

TEST(ClusterOfTwo, LiesWithinItsAccuracy) {
  const System f = read_system(read_source(kFolder + "two-near.phc"));
  const SolveResult result = test::solve_with_cvode(f);
  for (const double root : {1 - 1e-7, 1 + 1e-7}) {
    EXPECT_TRUE(std::any_of(result.solutions.begin(), result.solutions.end(), [&](const auto& s) {
      return test::distance(s.x, {root, root}) <= s.accuracy;
    }));
  }
}

INSTANTIATE_TEST_SUITE_P(Index, Extreme, testing::ValuesIn(cases()), [](const auto& test) {
  std::string name = test.param.name;
  std::replace(name.begin(), name.end(), '-', '_');
  return name;
});

}  // namespace
}  // namespace moivre
