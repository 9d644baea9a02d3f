// SPDX-License-Identifier: MIT
// Does a study tell a loose tracker from a careful one, its own losses from what solve() repairs,
// and what is proved?
#include "moivre/study/study.h"

#include <gtest/gtest.h>

#include <fstream>
#include <sstream>
#include <stdexcept>

#include "moivre/polynomial/read.h"
#include "moivre/tracker_cvode/cvode_tracker.h"

namespace moivre {
namespace {

System problem(const std::string& name) {
  const std::string path =
      std::string(MOIVRE_SOURCE_DIR) + "/problems/polynomials/" + name + ".phc";
  return read_system(read_source(path));
}

StudySetting setting(CvodeMethod method, double rtol) {
  return {to_string(method), rtol, make_cvode_tracker({.method = method, .rtol = rtol})};
}

StudyResult study(const System& f, const std::vector<StudySetting>& settings,
                  const StudyOptions& options) {
  const auto reference_tracker = make_cvode_tracker({.rtol = 1e-5});
  const auto witness = make_cvode_tracker({.rtol = 1e-4});
  return study_system(f, settings, *reference_tracker, witness.get(), options);
}

const StudyOptions kOneSeed{.seeds = 1};

TEST(Study, ShowsThatTheIntegratorAloneLosesRootsAndThatSolveFindsThem) {
  const StudyResult result =
      study(problem("katsura-6"),
            {setting(CvodeMethod::bdf_projection, 1e-2), setting(CvodeMethod::adams, 1e-2)},
            {.seeds = 1, .known_roots = 64});
  ASSERT_EQ(result.rows.size(), 2u);
  EXPECT_TRUE(result.complete);
  EXPECT_EQ(result.reference.roots, 64u);
  EXPECT_EQ(result.reference.exact, 64u);
  const StudyRow& projected = result.rows[0];
  const StudyRow& free = result.rows[1];
  EXPECT_EQ(projected.own.lost, 0u);
  EXPECT_EQ(projected.walk->jumped, 0u);
  EXPECT_EQ(projected.walk->paths, 64u);
  EXPECT_GT(free.own.lost, 0u);
  EXPECT_GT(free.walk->jumped + free.own.failed, 0u);
  EXPECT_GT(free.repaired.retracked, 0u);
  EXPECT_LT(free.repaired.lost, free.own.lost);
  EXPECT_EQ(free.own.strangers + projected.own.strangers, 0u);
}

TEST(Study, ErrorsOfTheIntegratorFallWithItsTolerance) {
  const StudyResult result =
      study(problem("noon-3"),
            {setting(CvodeMethod::adams, 1e-4), setting(CvodeMethod::adams, 1e-8)}, kOneSeed);
  ASSERT_EQ(result.rows.size(), 2u);
  EXPECT_GT(*result.rows[0].walk->end_error, 100 * *result.rows[1].walk->end_error);
  EXPECT_GT(result.rows[0].walk->drift_after, 100 * result.rows[1].walk->drift_after);
  EXPECT_GT(result.rows[1].own.work.accepted, result.rows[0].own.work.accepted);
}

TEST(Study, ProjectionTakesTheDriftAway) {
  const StudyResult result =
      study(problem("noon-3"), {setting(CvodeMethod::bdf_projection, 1e-3)}, kOneSeed);
  const StudyWalk& walk = *result.rows.at(0).walk;
  EXPECT_LT(walk.drift_after, 1e-3 * walk.drift_before);
}

TEST(Study, ResidualsInDoubleDoubleSaveWhatPlainDoubleLoses) {
  const StudyResult result =
      study(read_system({"test", "1\n(x - 1)*(x - 1.01)*(x - 1.02)*(x - 1.03);\n"}),
            {setting(CvodeMethod::bdf_projection, 1e-3)}, kOneSeed);
  const StudyOutcome& outcome = result.rows.at(0).repaired;
  EXPECT_LT(*outcome.error, 1e-15);
  EXPECT_GT(*outcome.plain_error, 1e-12);
}

TEST(Study, KnownCountsAndWitnessesDecideWhetherTheReferenceIsComplete) {
  const System f = problem("noon-3");
  const std::vector<StudySetting> none;
  EXPECT_TRUE(study(f, none, kOneSeed).reference.complete);
  EXPECT_TRUE(study(f, none, {.seeds = 1, .known_roots = 21}).reference.complete);
  const StudyReference more = study(f, none, {.seeds = 1, .known_roots = 22}).reference;
  EXPECT_FALSE(more.complete);
  EXPECT_EQ(more.completeness, "not complete: 21 of 22 roots were found");
  const auto alone = make_cvode_tracker();
  EXPECT_FALSE(study_system(f, none, *alone, nullptr, kOneSeed).reference.complete);
}

TEST(Study, ASingularRootIsFoundOrLostButHasNoError) {
  const StudyResult result =
      study(problem("griewank-osborne"), {setting(CvodeMethod::bdf_projection, 1e-2)}, kOneSeed);
  EXPECT_EQ(result.reference.roots, 1u);
  EXPECT_EQ(result.reference.with_multiplicity, 3u);
  EXPECT_EQ(result.reference.exact, 0u);
  ASSERT_EQ(result.rows.size(), 1u);
  EXPECT_EQ(result.rows[0].repaired.lost, 0u);
  EXPECT_FALSE(result.rows[0].repaired.error);
}

TEST(Study, OfASystemThatEliminationSolvesHasNoPathsToWalk) {
  const StudyResult result = study(read_system({"test", "x + y - 3; x - y - 1;"}),
                                   {setting(CvodeMethod::bdf_projection, 1e-2)}, kOneSeed);
  ASSERT_EQ(result.rows.size(), 1u);
  EXPECT_FALSE(result.rows[0].walk);
  EXPECT_EQ(result.rows[0].own.lost, 0u);
}

TEST(Study, GivesTheRowsThatAreFinishedWhenItIsStopped) {
  std::atomic<bool> stop{false};
  StudyOptions options = kOneSeed;
  options.progress = [&](const StudyProgress& progress) {
    if (progress.now == "adams") stop = true;
  };
  const auto tracker = make_cvode_tracker();
  const StudyResult result =
      study_system(problem("noon-3"),
                   {setting(CvodeMethod::bdf_projection, 1e-2), setting(CvodeMethod::adams, 1e-2)},
                   *tracker, nullptr, options, stop);
  EXPECT_FALSE(result.complete);
  ASSERT_EQ(result.rows.size(), 1u);
  EXPECT_EQ(result.rows[0].curve, "bdf_projection");
}

TEST(Study, ThatIsStoppedBeforeItBeginsClaimsNothing) {
  const std::atomic<bool> stop{true};
  const auto tracker = make_cvode_tracker();
  const StudyResult result =
      study_system(problem("noon-3"), {setting(CvodeMethod::bdf_projection, 1e-2)}, *tracker,
                   tracker.get(), kOneSeed, stop);
  EXPECT_FALSE(result.complete);
  EXPECT_FALSE(result.reference.complete) << result.reference.completeness;
  EXPECT_TRUE(result.rows.empty());
}

TEST(Study, RefusesOptionsWithTheirReasons) {
  EXPECT_EQ(validate(StudyOptions{}).size(), 0u);
  EXPECT_EQ(validate({.seeds = 0, .walked_paths = 0}).size(), 2u);
  EXPECT_THROW(study(problem("noon-3"), {}, {.seeds = 0}), std::invalid_argument);
}

TEST(Spread, HasTheLowerOfTwoMiddlesAsMedian) {
  const Spread spread = spread_of({4, 1, 3, 2});
  EXPECT_EQ(spread.least, 1);
  EXPECT_EQ(spread.median, 2);
  EXPECT_EQ(spread.most, 4);
}

}  // namespace
}  // namespace moivre
