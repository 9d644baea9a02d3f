// SPDX-License-Identifier: MIT
// How many closures do the published mechanisms have, complex and real, and how few paths find
// them?
#include "moivre/closures/closures.h"

#include <gtest/gtest.h>

#include <numbers>

#include "mechanisms.h"
#include "moivre/mechanism/phi.h"
#include "published_counts.h"

namespace moivre {
namespace {

using test::kDegree;
constexpr std::uint64_t kSeeds = 20;

// |Phi_i| beside the sum of the magnitudes of its terms: rounding of a few operations, no more.
constexpr double kResidual = 1e-12;

void expect_account(const ClosureResult& result) {
  EXPECT_TRUE(result.complete) << result.message;
  PathCounts sum;
  for (const Stage& stage : result.stages) {
    sum += stage.paths;
    EXPECT_EQ(stage.paths.tracked, stage.paths.finite + stage.paths.at_infinity +
                                       stage.paths.failed + stage.paths.not_needed);
  }
  EXPECT_EQ(sum, result.paths);
}

void expect_assembled(const ClosureResult& result, const Mechanism& mechanism) {
  const Phi phi(mechanism);
  for (const Closure& closure : result.closures) {
    const Eigen::VectorXd value = phi.value(closure.q, result.time);
    const Eigen::VectorXd terms = phi.term_magnitudes(closure.q, result.time);
    for (Eigen::Index i = 0; i < value.size(); ++i) {
      EXPECT_LE(std::abs(value[i]), kResidual * terms[i])
          << "closure " << closure.id << ", " << phi.row_names()[static_cast<std::size_t>(i)];
    }
  }
}

class PublishedCounts : public testing::TestWithParam<PublishedCount> {};

TEST_P(PublishedCounts, AreMetForEverySeed) {
  const PublishedCount& published = GetParam();
  Mechanism mechanism = mechanism_file(published.file);
  if (published.driver_deg) mechanism = driven_from(mechanism, *published.driver_deg * kDegree);
  for (std::uint64_t seed = 1; seed <= kSeeds; ++seed) {
    const ClosureResult result = closures_of(mechanism, seed);
    EXPECT_EQ(result.counts.complex, published.complex) << "seed " << seed;
    EXPECT_EQ(result.counts.real, published.real) << "seed " << seed;
    EXPECT_EQ(result.closures.size(), published.real) << "seed " << seed;
    EXPECT_LE(result.paths.tracked, published.most_paths) << "seed " << seed;
    EXPECT_FALSE(result.moves);
    expect_account(result);
    expect_assembled(result, mechanism);
  }
}

INSTANTIATE_TEST_SUITE_P(Mechanisms, PublishedCounts, testing::ValuesIn(published_counts()),
                         [](const auto& tested) {
                           std::string name = name_of(tested.param);
                           for (char& c : name) c = c == '-' || c == ' ' ? '_' : c;
                           return name;
                         });

Eigen::Index index_of(const Mechanism& mechanism, const std::string& name) {
  const auto all = coordinates(mechanism);
  for (std::size_t k = 0; k < all.size(); ++k) {
    if (all[k].name == name) return static_cast<Eigen::Index>(k);
  }
  throw std::invalid_argument(name);
}

std::vector<double> sorted_values(const Mechanism& mechanism, const ClosureResult& result,
                                  const std::string& name, double unit = 1) {
  std::vector<double> values;
  for (const Closure& closure : result.closures) {
    values.push_back(closure.q[index_of(mechanism, name)] / unit);
  }
  std::sort(values.begin(), values.end());
  return values;
}

TEST(SeedP15, FourBarClosuresToAllPrintedDigits) {
  const Mechanism mechanism = mechanism_file("four-bar");
  const ClosureResult result = closures_of(mechanism);
  const auto coupler = sorted_values(mechanism, result, "coupler.phi", kDegree);
  const auto rocker = sorted_values(mechanism, result, "rocker.phi", kDegree);
  ASSERT_EQ(coupler.size(), 2u);
  EXPECT_NEAR(coupler[0], -60.9780, 5e-5);
  EXPECT_NEAR(coupler[1], 20.2979, 5e-5);
  EXPECT_NEAR(rocker[0], -98.0050, 5e-5);
  EXPECT_NEAR(rocker[1], 57.3249, 5e-5);
}

TEST(SeedP29, BothSlidersOfExample313BothWaysIn) {
  for (const auto& [file, name] : {std::pair<std::string, std::string>{"slider-crank", "slider.x"},
                                   {"slider-crank-equations", "d"}}) {
    const Mechanism mechanism = mechanism_file(file);
    const auto d = sorted_values(mechanism, closures_of(mechanism), name);
    ASSERT_EQ(d.size(), 2u);
    EXPECT_NEAR(d[0], 4 * std::sqrt(3.0), 1e-13);
    EXPECT_NEAR(d[1], 6 * std::sqrt(3.0), 1e-13);
  }
}

TEST(SeedP12, BothClosuresOfTheRedundantSystemAt30And60Degrees) {
  const Mechanism at30 = mechanism_file("redundant-system");
  auto l1 = sorted_values(at30, closures_of(at30), "l1");
  ASSERT_EQ(l1.size(), 2u);
  EXPECT_NEAR(l1[0], -2, 1e-12);
  EXPECT_NEAR(l1[1], 2, 1e-12);
  const Mechanism at60 = driven_from(at30, 60 * kDegree);
  l1 = sorted_values(at60, closures_of(at60), "l1");
  ASSERT_EQ(l1.size(), 2u);
  EXPECT_NEAR(l1[0], 0.230329, 5e-7);
  EXPECT_NEAR(l1[1], 3.573518, 5e-7);
}

TEST(SeedP11, DoubleParallelCrankHasARedundantRowAndAnIsolatedClosureAt60Degrees) {
  const ClosureResult result = closures_of(mechanism_file("double-parallel-crank"));
  ASSERT_TRUE(result.mobility);
  EXPECT_EQ(result.mobility->rank, 11);
  EXPECT_EQ(result.mobility->redundant.size(), 1u);
  EXPECT_FALSE(result.moves);
}

TEST(Closures, AChangePointIsSingularAndDoesNotMove) {
  const ClosureResult result = closures_of(mechanism_file("parallelogram"));
  ASSERT_EQ(result.closures.size(), 1u);
  EXPECT_TRUE(result.closures[0].singular);
  EXPECT_EQ(result.closures[0].multiplicity, 2u);
  EXPECT_FALSE(result.moves);
  EXPECT_EQ(closures_of(driven_from(mechanism_file("parallelogram"), 1.0)).counts.real, 2u);
}

TEST(Closures, TheSixBarOfTheReadmeHasFour) {
  const Source readme = read_source(std::string(MOIVRE_SOURCE_DIR) + "/README.md");
  const std::string open = "```toml\n";
  const std::size_t begin = readme.text.find(open) + open.size();
  const std::string file = readme.text.substr(begin, readme.text.find("```", begin) - begin);
  const ClosureResult result = closures_of(mechanism_text(file));
  EXPECT_TRUE(result.complete);
  EXPECT_EQ(result.counts.real, 4u);
}

/// At 210 degrees a crank of 40 is 20 below the slider's line, as far as the rod is long: a dead
/// point. The sine of 210 degrees is rounded, so that one closure is not proved to be two, or none.
TEST(Closures, ADeadPointMissedByRoundingHasLostNoRoot) {
  const Mechanism mechanism =
      mechanism_text("[units]\nangle = \"deg\"\n" + test::slider_crank_links(40, 20, 0) +
                     "[[driver]]\nangle = \"crank\"\nstart = 210\n");
  const ClosureResult result = closures_of(mechanism, 1);
  EXPECT_TRUE(result.complete) << result.message;
  ASSERT_EQ(result.solutions.size(), 1U);
  EXPECT_TRUE(result.solutions.front().cluster);
  EXPECT_EQ(result.solutions.front().multiplicity, 2U);
  EXPECT_NE(result.completeness, RootCompleteness::proved);
}

TEST(Closures, CannotBeAssembledIsAnAnswer) {
  const ClosureResult result = closures_of(mechanism_file("unassemblable-triangle"));
  EXPECT_TRUE(result.complete);
  EXPECT_EQ(result.counts.real, 0u);
  EXPECT_EQ(result.counts.complex, 2u);
  EXPECT_EQ(result.message, "cannot be assembled: every closure is complex (2)");
}

TEST(Closures, LimitsFilterAndAreCounted) {
  Mechanism mechanism = mechanism_file("four-bar");
  mechanism.joints[2].limits =
      Limits{0, std::numbers::pi};  // of the rocker relative to the coupler
  const ClosureResult result = closures_of(mechanism);
  EXPECT_EQ(result.counts.real, 2u);
  EXPECT_EQ(result.counts.filtered, 1u);
  ASSERT_EQ(result.closures.size(), 1u);
  EXPECT_GT(result.closures[0].q[index_of(mechanism, "coupler.phi")], 0);
}

TEST(Closures, TheDriversTimeMovesTheCrank) {
  const Mechanism mechanism = mechanism_file("slider-crank-equations");
  const ClosureResult later = closures_of(mechanism, 1, 0.5);  // 30 degrees + 0.5 rad
  for (const Closure& closure : later.closures) {
    EXPECT_NEAR(closure.q[0], 30 * kDegree + 0.5, 1e-14);
  }
  expect_assembled(later, mechanism);
}

// All positions are 0 there but for rounding: an equation between two of them has no scale but the
// mechanism's.
TEST(Closures, ABodyWeldedToTheOriginOfOneThatStandsWhereItWasDrawnLosesNoClosure) {
  const std::string platform = R"toml(
[ground.points]
A = [1.1, 1.3]
B = [-1.9, 0.1]
C = [-0.9, 1.7]
[body.plate.points]
A = [1.1, -1.0]
B = [-0.9, -1.4]
C = [2.0, -0.8]
O = [0, 0]
[[joint]]
type = "rod"
at = ["ground.A", "plate.A"]
length = 2.3
[[joint]]
type = "rod"
at = ["ground.B", "plate.B"]
length = 1.8027756377319946
[[joint]]
type = "rod"
at = ["ground.C", "plate.C"]
length = 3.8288379438153295
)toml";
  const std::string tag = R"toml(
[body.tag.points]
O = [0, 0]
[[joint]]
type = "weld"
at = ["plate.O", "tag.O"]
)toml";
  const ClosureResult alone = closures_of(mechanism_text(platform));
  const ClosureResult tagged = closures_of(mechanism_text(platform + tag));
  EXPECT_TRUE(tagged.complete) << tagged.message;
  EXPECT_EQ(tagged.counts.rejected, 0U);
  EXPECT_EQ(tagged.counts.complex, alone.counts.complex);
  EXPECT_EQ(tagged.counts.real, alone.counts.real);
}

TEST(Closures, IdsAreLettersInOrder) {
  const ClosureResult result = closures_of(mechanism_file("jansen-leg"));
  ASSERT_EQ(result.closures.size(), 8u);
  EXPECT_EQ(result.closures.front().id, "A");
  EXPECT_EQ(result.closures.back().id, "H");
}

TEST(Closures, AreToldAsInterruptedWhateverIsMissingThen) {
  const Mechanism arm = mechanism_file("general-6r");
  for (std::uint64_t last = 1; last <= 24; last += 2) {
    std::atomic<bool> stop{false};
    ClosureOptions options;
    options.solve.threads = 1;
    options.solve.progress = [&](const Progress& progress) {
      if (progress.done >= last) stop = true;
    };
    const ClosureResult result = find_closures(arm, *make_cvode_tracker(), options, stop);
    EXPECT_FALSE(result.complete) << last;
    EXPECT_EQ(result.message, "interrupted: what is finished is reported") << last;
    EXPECT_EQ(result.counts.complex, result.solutions.size()) << last;
  }
}

TEST(Closures, NothingDependsOnTheNumberOfThreads) {
  const Mechanism mechanism = mechanism_file("assur-7-serial");
  ClosureOptions options;
  options.solve.threads = 1;
  const ClosureResult one = find_closures(mechanism, *make_cvode_tracker(), options);
  options.solve.threads = 3;
  const ClosureResult three = find_closures(mechanism, *make_cvode_tracker(), options);
  ASSERT_EQ(one.closures.size(), three.closures.size());
  for (std::size_t k = 0; k < one.closures.size(); ++k) {
    EXPECT_EQ(one.closures[k].q, three.closures[k].q);
    EXPECT_EQ(one.closures[k].path, three.closures[k].path);
  }
}

}  // namespace
}  // namespace moivre
