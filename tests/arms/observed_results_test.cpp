// SPDX-License-Identifier: MIT
// Are poses whose results are told again, or that several share, those that one solves?
#include "observed_results.h"

#include <gtest/gtest.h>

#include <functional>

#include "../solver/observers.h"
#include "moivre/arms/held_range.h"
#include "robots.h"

namespace moivre::test {
namespace {

using Solving = std::function<std::vector<ArmResult>(const SolveOptions&)>;

/// All that results say, but for the time that they took.
std::vector<std::string> told_by(std::vector<ArmResult> results) {
  std::vector<std::string> all;
  for (ArmResult& result : results) {
    result.time_s = {};
    all.push_back(bytes_of(result));
    for (const double number : result.pose.matrix().reshaped()) {
      all.back() += std::to_string(number) + ' ';
    }
    all.back() += result.tracker + std::to_string(result.tracker_options.size());
    all.back() += std::to_string(result.seed);
  }
  return all;
}

/// Cut off after any number of outcomes, and by a company of three.
void expect_the_same_however_it_is_observed(const Solving& solve, std::uint64_t jobs) {
  SolveOptions options = one_thread(3);
  const auto alone = told_by(solve(options));
  Memory whole;
  options.observations = &whole;
  EXPECT_EQ(told_by(solve(options)), alone);
  const std::uint64_t outcomes = whole.kept();
  EXPECT_GE(outcomes, jobs);
  whole.begin_again(std::numeric_limits<std::uint64_t>::max());
  EXPECT_EQ(told_by(solve(options)), alone);
  EXPECT_EQ(whole.kept(), 0) << "poses were solved again";
  for (const std::uint64_t room : {outcomes / 3, outcomes - jobs / 2, outcomes - 1}) {
    Memory memory;
    memory.begin_again(room);
    options.observations = &memory;
    solve(options);
    memory.begin_again(std::numeric_limits<std::uint64_t>::max());
    EXPECT_EQ(told_by(solve(options)), alone);
    EXPECT_LE(memory.kept(), outcomes - room);
  }
  Company company;
  Share::drawn = 0;
  std::vector<std::vector<ArmResult>> results(3);
  std::vector<std::thread> threads;
  for (auto& own : results) {
    threads.emplace_back([&] {
      OneOfCompany member(company);
      SolveOptions shared = one_thread(3);
      shared.observations = &member;
      own = solve(shared);
    });
  }
  for (std::thread& thread : threads) thread.join();
  for (auto& own : results) EXPECT_EQ(told_by(std::move(own)), alone);
  EXPECT_GE(Share::drawn, jobs);
  std::uint64_t shared = 0;
  for (const auto& [key, list] : company.lists) shared += list.outcomes.size();
  EXPECT_EQ(Share::drawn, shared) << "each job is done once";
}

/// Some of them special: a wrist that moves, an arm that is stretched, a pose out of reach.
TEST(ObservedResults, OfPosesAreThoseOfOneRun) {
  Eigen::VectorXd straight(6), stretched(6);
  straight << 0.3, 0.4, 0.5, 0.2, 0, 0.1;
  stretched << 0.3, 0.4, std::atan2(0.4318, 0.0203) - std::numbers::pi, 0.2, 0.7, 0.1;
  for (const Arm& arm : {make_arm(robot_of("puma560"), {}), arm_of(kManseurDoty)}) {
    std::vector<Eigen::Isometry3d> poses;
    for (std::uint64_t k = 0; k < 40; ++k) {
      poses.push_back(forward_kinematics(arm, random_values(arm, 6, k)));
    }
    poses[3] = forward_kinematics(arm, straight);
    poses[5] = forward_kinematics(arm, stretched);
    poses[20].translation().x() += 30;
    expect_the_same_however_it_is_observed(
        [&](const SolveOptions& options) {
          return find_arm_closures(arm, poses, lanes(), options);
        },
        poses.size());
  }
}

TEST(ObservedResults, OfAJointHeldAtManyValuesAreThoseOfOneRun) {
  const auto arms = arms_along(robot_of("panda"), {std::nullopt, "panda_hand_tcp", {}},
                               {"panda_joint7", -0.5, 0.8, 6});
  const TypedPose pose{forward_kinematics(arms[1], random_values(arms[1], 3, 1))};
  expect_the_same_however_it_is_observed(
      [&](const SolveOptions& options) {
        return find_closures_of_each(arms, pose, lanes(), options);
      },
      arms.size());
}

class AllButOne : public Memory {
 public:
  explicit AllButOne(std::uint64_t missing) : missing_(missing) {}
  std::map<std::uint64_t, std::string> recall(const Fingerprint& list) override {
    auto known = Memory::recall(list);
    known.erase(missing_);
    return known;
  }

 private:
  std::uint64_t missing_;
};

/// A result has the value of its place: the third of five would pass for the second.
TEST(ObservedResults, EndBeforeTheFirstThatAStopLeavesOut) {
  constexpr std::uint64_t kMissing = 1;
  const auto arms = arms_along(robot_of("panda"), {std::nullopt, "panda_hand_tcp", {}},
                               {"panda_joint7", -0.5, 0.8, 5});
  const TypedPose pose{forward_kinematics(arms[1], random_values(arms[1], 3, 1))};
  AllButOne memory(kMissing);
  SolveOptions options = one_thread(3);
  options.observations = &memory;
  const auto all = told_by(find_closures_of_each(arms, pose, lanes(), options));
  EXPECT_EQ(all.size(), arms.size());
  const std::atomic<bool> stop{true};
  const auto first = told_by(find_closures_of_each(arms, pose, lanes(), options, stop));
  EXPECT_EQ(first, std::vector(all.begin(), all.begin() + kMissing));
}

TEST(ObservedResults, BytesThatAreCutAreRefused) {
  ArmResult result;
  result.failures.push_back({7, Failure::precision, {0.25, 1.0 / 3}, 2});
  SelfMotion set;
  set.directions = Eigen::MatrixXd::Random(6, 2);
  result.moves.push_back(set);
  const std::string bytes = bytes_of(result);
  const ArmResult again = arm_result_of(bytes);
  EXPECT_EQ(bytes_of(again), bytes);
  EXPECT_EQ(again.failures.front().t, result.failures.front().t);
  EXPECT_EQ(again.moves.front().directions, set.directions);
  EXPECT_THROW(arm_result_of(std::string_view(bytes).substr(1)), std::invalid_argument);
  EXPECT_THROW(arm_result_of(bytes + 'x'), std::invalid_argument);
}

}  // namespace
}  // namespace moivre::test
