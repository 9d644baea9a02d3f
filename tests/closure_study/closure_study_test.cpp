// SPDX-License-Identifier: MIT
// Does a mechanism's study find its closures with every setting?
#include "moivre/closure_study/closure_study.h"

#include <gtest/gtest.h>

#include <algorithm>

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
  const auto reference_tracker = make_cvode_tracker({.rtol = 1e-5});
  const auto witness = make_cvode_tracker({.rtol = 1e-4});
  return study_mechanism(mechanism(name), {setting(1e-2), setting(1e-3)}, *reference_tracker,
                         witness.get(), {.seeds = 1});
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

std::vector<double> column(const StudyTable& table, const std::string& name) {
  const auto at = std::find(table.columns.begin(), table.columns.end(), name);
  const auto index = static_cast<std::size_t>(at - table.columns.begin());
  std::vector<double> values;
  for (const auto& row : table.rows) values.push_back(row.at(index));
  return values;
}

TEST(ClosureStudy, DifferencesOfTheMotionFallWithTheFourthPowerOfTheSpacing) {
  const StudyResult result = study("four-bar");
  ASSERT_EQ(result.tables.size(), 1u);
  for (const char* name : {"velocity_error", "acceleration_error"}) {
    const std::vector<double> errors = column(result.tables[0], name);
    ASSERT_GE(errors.size(), 3u);
    EXPECT_NEAR(errors[1] / errors[2], 16, 2) << name;
  }
}

TEST(ClosureStudy, PositionsOfTheMotionAreClosuresSolvedAfresh) {
  const StudyResult result = study("four-bar");
  ASSERT_EQ(result.tables.size(), 1u);
  for (const double error : column(result.tables[0], "position_error")) EXPECT_LT(error, 1e-14);
}

TEST(ClosureStudy, ABranchThatEndsIsComparedBeforeItsDeadPoint) {
  const StudyResult result = study("slider-crank");
  ASSERT_EQ(result.tables.size(), 1u);
  EXPECT_EQ(result.tables[0].title,
            "motion of the first closure over 0.08993 s, of a branch that ends at 0.1199 s");
  const std::vector<double> errors = column(result.tables[0], "velocity_error");
  EXPECT_LT(errors.at(4), 1e-9);
}

TEST(ClosureStudy, OfAMechanismThatStandsHasNoMotion) {
  const StudyResult result = study("3-rpr");
  EXPECT_TRUE(result.tables.empty());
  ASSERT_EQ(result.remarks.size(), 1u);
}

TEST(ClosureStudy, OfAMechanismThatCannotBeAssembledHasAnEmptyReference) {
  const StudyResult result = study("unassemblable-triangle");
  EXPECT_TRUE(result.complete);
  EXPECT_EQ(result.reference.exact, result.reference.roots);
  EXPECT_TRUE(result.tables.empty());
  EXPECT_EQ(result.remarks.size(), 1u);
}

}  // namespace
}  // namespace moivre
