// SPDX-License-Identifier: MIT
// Does a mechanism's study find its closures with every setting?
#include "moivre/closure_study/closure_study.h"

#include <gtest/gtest.h>

#include "moivre/closures/closures.h"
#include "moivre/mechanism/read.h"
#include "moivre/tracker_cvode/cvode_tracker.h"

namespace moivre {
namespace {

Mechanism mechanism(const std::string& name) {
  return read_mechanism(
      read_source(std::string(MOIVRE_SOURCE_DIR) + "/problems/mechanisms/" + name + ".toml"));
}

StudySetting setting(double rtol) {
  return {"bdf_projection", rtol, make_cvode_tracker({.rtol = rtol})};
}

StudyResult study(const std::string& name) {
  const auto referee = make_cvode_tracker({.rtol = 1e-5});
  const auto witness = make_cvode_tracker({.rtol = 1e-4});
  return study_mechanism(mechanism(name), {setting(1e-2), setting(1e-3)}, *referee, witness.get(),
                         {.seeds = 1});
}

TEST(ClosureStudy, FindsTheClosuresOfAFourBarWithEverySetting) {
  const StudyResult result = study("four-bar");
  EXPECT_TRUE(result.complete);
  EXPECT_TRUE(result.reference.complete);
  EXPECT_EQ(result.reference.roots, 2u);
  ASSERT_EQ(result.rows.size(), 2u);
  for (const StudyRow& row : result.rows) {
    EXPECT_EQ(row.repaired.lost, 0u);
    EXPECT_EQ(row.repaired.strangers, 0u);
    EXPECT_FALSE(row.walk);
  }
}

TEST(ClosureStudy, DifferencesOfTheMotionFallWithTheFourthPowerOfTheSpacing) {
  const StudyResult result = study("four-bar");
  ASSERT_EQ(result.tables.size(), 1u);
  const auto& rows = result.tables[0].rows;
  ASSERT_GE(rows.size(), 3u);
  for (const std::size_t column : {std::size_t{2}, std::size_t{3}}) {
    const double ratio = rows[1][column] / rows[2][column];
    EXPECT_NEAR(ratio, 16, 2) << result.tables[0].columns[column];
  }
}

TEST(ClosureStudy, OfAMechanismThatCannotBeAssembledHasAnEmptyReference) {
  const StudyResult result = study("unassemblable-triangle");
  EXPECT_TRUE(result.complete);
  EXPECT_EQ(result.reference.exact, result.reference.roots);
  EXPECT_TRUE(result.tables.empty());
}

}  // namespace
}  // namespace moivre
