// SPDX-License-Identifier: MIT
// Does a driver that goes from one dead point to the other find both branches, and that they are
// one circuit?
#include <gtest/gtest.h>

#include <algorithm>

#include "mechanisms.h"
#include "moivre/motion/circuits.h"
#include "moivre/motion/motion.h"
#include "moivre/tracker_cvode/cvode_tracker.h"

namespace moivre {
namespace {

/// Crank 2 and rod 5: the slide goes from 3 to 7.
std::string stroke_text(const std::string& start, const std::string& velocity) {
  return test::slider_crank_links(2, 5, 0) + "[[driver]]\nslide = \"guide\"\nstart = " + start +
         "\nvelocity = " + velocity + "\n";
}

MotionResult stroke(const std::string& start, const std::string& velocity, double seconds) {
  MotionOptions options;
  options.to = seconds;
  return find_motion(mechanism_text(stroke_text(start, velocity)), *make_cvode_tracker(), options);
}

bool is_dead_point(const MotionResult& motion, const std::optional<std::size_t>& event) {
  return event && motion.events[*event].at.kind == EventKind::dead_point;
}

TEST(AWholeStroke, IsTwoBranchesOfOneCircuit) {
  for (const auto& [start, velocity] : {std::pair("3", "1"), std::pair("7", "-2")}) {
    const MotionResult motion = stroke(start, velocity, std::string(start) == "3" ? 4 : 2);
    EXPECT_TRUE(motion.complete) << motion.message;
    ASSERT_EQ(motion.branches.size(), 2U);
    for (const MotionBranch& branch : motion.branches) {
      EXPECT_TRUE(is_dead_point(motion, branch.begin_event));
      EXPECT_TRUE(is_dead_point(motion, branch.end_event));
      EXPECT_LT(branch.steps, 200);
      for (const BranchSample& sample : branch.samples) EXPECT_TRUE(sample.is_determined);
    }
    EXPECT_EQ(motion.events.size(), 2U) << "both branches meet at each end";
    const Circuits circuits = find_circuits(mechanism_text(stroke_text(start, velocity)), motion);
    ASSERT_EQ(circuits.circuits.size(), 1U);
    EXPECT_EQ(circuits.circuits.front().branches.size(), 2U);
  }
}

TEST(APartOfAStroke, MeetsAtTheEndThatIsADeadPoint) {
  const MotionResult first = stroke("3", "1", 1);
  ASSERT_EQ(first.branches.size(), 2U);
  const MotionResult last = stroke("3.5", "1", 3.5);
  ASSERT_EQ(last.branches.size(), 2U);
  for (const std::size_t k : {std::size_t{0}, std::size_t{1}}) {
    EXPECT_TRUE(is_dead_point(first, first.branches[k].begin_event));
    EXPECT_FALSE(first.branches[k].end_event);
    EXPECT_FALSE(last.branches[k].begin_event);
    EXPECT_TRUE(is_dead_point(last, last.branches[k].end_event));
  }
  EXPECT_TRUE(first.complete && last.complete);
}

/// A parallelogram from its change point on: two branches begin there, and each has a velocity.
TEST(ACrossingAtTheBeginning, IsNoDeadPoint) {
  MotionOptions options;
  options.to = 1;
  const MotionResult motion =
      find_motion(mechanism_file("parallelogram"), *make_cvode_tracker(), options);
  ASSERT_EQ(motion.branches.size(), 2U);
  for (const MotionBranch& branch : motion.branches) {
    EXPECT_FALSE(is_dead_point(motion, branch.begin_event));
  }
}

}  // namespace
}  // namespace moivre
