// SPDX-License-Identifier: MIT
// Do closures leave out velocities and accelerations, and a motion from a given guess the closures?
// Nobody asked for them.
#include "moivre/closures/closures.h"

#include <gtest/gtest.h>

#include "counted_calls.h"
#include "moivre/formulation/formulation.h"
#include "moivre/mechanism/phi.h"
#include "moivre/mechanism/read.h"
#include "moivre/motion/motion.h"
#include "moivre/solver/solve.h"
#include "moivre/tracker_cvode/cvode_tracker.h"

namespace moivre {
namespace {

using Accelerations = test::Counted<&Phi::acceleration_rhs>;
using Solves = test::Counted<&solve>;
using Velocities = test::Counted<&Phi::velocity_rhs>;

Mechanism four_bar() {
  return read_mechanism(
      read_source(std::string(MOIVRE_SOURCE_DIR) + "/problems/mechanisms/four-bar.toml"));
}

/// How often each stage over polynomials was entered.
struct PolynomialCalls {
  int closure_searches = 0;
  int closure_polynomials = 0;
  int solves = 0;
};

PolynomialCalls polynomial_calls_of(auto&& action) {
  PolynomialCalls calls;
  calls.closure_searches = test::calls_of<test::Counted<&find_closures>>([&] {
    calls.closure_polynomials = test::calls_of<test::Counted<&formulate>>(
        [&] { calls.solves = test::calls_of<Solves>(action); });
  });
  return calls;
}

MotionOptions short_motion() {
  MotionOptions options;
  options.to = 0.1;
  options.steps = 4;
  options.checkpoints = 1;
  options.solve.threads = 1;
  return options;
}

TEST(LeaveOut, MotionFromAGivenGuessHasNoPolynomialStage) {
  const Mechanism mechanism = four_bar();
  MotionResult result;
  const PolynomialCalls calls = polynomial_calls_of(
      [&] { result = follow_guesses(mechanism, {initial_guess(mechanism)}, short_motion()); });
  ASSERT_TRUE(result.complete) << result.message;
  EXPECT_EQ(result.branches.size(), 1U);
  EXPECT_EQ(calls.closure_searches, 0);
  EXPECT_EQ(calls.closure_polynomials, 0);
  EXPECT_EQ(calls.solves, 0);
  ASSERT_EQ(result.left_out.size(), 1U);
  EXPECT_EQ(result.left_out[0].what, "closures and checkpoints");
}

TEST(LeaveOut, MotionFromAGivenGuessIsFollowedThroughItsSamplesAlone) {
  const Mechanism mechanism = four_bar();
  MotionOptions options = short_motion();
  std::size_t times_asked_for = 0;
  options.follow = [&](const Mechanism& m, const Eigen::VectorXd& q,
                       const std::vector<double>& times, const BranchOptions& branch,
                       const std::atomic<bool>& stop) {
    times_asked_for += times.size();
    return follow_branch(m, q, times, branch, stop);
  };
  follow_guesses(mechanism, {initial_guess(mechanism)}, options);
  EXPECT_EQ(times_asked_for, static_cast<std::size_t>(options.steps + 1));
}

TEST(LeaveOut, MotionOfAllClosuresSolvesThemAtTheBeginningAndAtEachCheckpoint) {
  const Mechanism mechanism = four_bar();
  MotionResult result;
  const PolynomialCalls calls = polynomial_calls_of(
      [&] { result = find_motion(mechanism, *make_cvode_tracker(), short_motion()); });
  ASSERT_TRUE(result.complete) << result.message;
  EXPECT_EQ(calls.closure_searches, 2);
  EXPECT_EQ(calls.closure_polynomials, 2);
  EXPECT_EQ(calls.solves, 0);  // a dyad is solved by formula
}

TEST(LeaveOut, AMotionAsksForVelocityAndAccelerationOnceASample) {
  const Mechanism mechanism = four_bar();
  int velocity_calls = 0;
  MotionResult result;
  const int acceleration_calls = test::calls_of<Accelerations>([&] {
    velocity_calls = test::calls_of<Velocities>(
        [&] { result = follow_guesses(mechanism, {initial_guess(mechanism)}, short_motion()); });
  });
  ASSERT_EQ(result.branches.size(), 1U);
  const auto samples = static_cast<int>(result.branches[0].samples.size());
  EXPECT_EQ(samples, short_motion().steps + 1);
  EXPECT_EQ(velocity_calls, samples);
  EXPECT_EQ(acceleration_calls, samples);
}

TEST(LeaveOut, CheckpointsAndTheWayBackAskForNoVelocity) {
  const Mechanism mechanism = four_bar();
  MotionResult result;
  const int velocity_calls = test::calls_of<Velocities>(
      [&] { result = find_motion(mechanism, *make_cvode_tracker(), short_motion()); });
  ASSERT_EQ(result.branches.size(), 2U);
  EXPECT_EQ(velocity_calls, 2 * (short_motion().steps + 1));
}

TEST(LeaveOut, ClosuresAskForNoVelocity) {
  const Mechanism mechanism = four_bar();
  ClosureOptions options;
  options.solve.threads = 1;
  ClosureResult result;
  int velocity_calls = 0;
  const int acceleration_calls = test::calls_of<Accelerations>([&] {
    velocity_calls = test::calls_of<Velocities>(
        [&] { result = find_closures(mechanism, *make_cvode_tracker(), options); });
  });
  EXPECT_EQ(result.closures.size(), 2U);
  EXPECT_EQ(velocity_calls, 0);
  EXPECT_EQ(acceleration_calls, 0);
}

}  // namespace
}  // namespace moivre
