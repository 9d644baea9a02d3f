// SPDX-License-Identifier: MIT
// Is a run to which outcomes are told again the run that observed them, wherever that was cut off?
#include "observed_paths.h"

#include <gtest/gtest.h>

#include <limits>
#include <thread>

#include "moivre/numeric/random.h"
#include "moivre/tracker_cvode/cvode_tracker.h"
#include "moivre/tracker_lanes/lane_tracker.h"
#include "observers.h"
#include "problem_set.h"

namespace moivre::test {
namespace {

constexpr std::uint64_t kAll = std::numeric_limits<std::uint64_t>::max();

void expect_same_work(const StepCount& a, const StepCount& b) {
  EXPECT_EQ(a.accepted, b.accepted);
  EXPECT_EQ(a.rejected, b.rejected);
  EXPECT_EQ(a.work.values, b.work.values);
  EXPECT_EQ(a.work.factorizations, b.work.factorizations);
}

void expect_same(const SolveResult& a, const SolveResult& b) {
  EXPECT_EQ(a.complete, b.complete);
  EXPECT_EQ(a.message, b.message);
  EXPECT_EQ(a.paths, b.paths);
  EXPECT_EQ(a.failures.size(), b.failures.size());
  expect_same_work(a.work, b.work);
  ASSERT_EQ(a.solutions.size(), b.solutions.size());
  for (std::size_t k = 0; k < a.solutions.size(); ++k) {
    const Solution& p = a.solutions[k];
    const Solution& q = b.solutions[k];
    EXPECT_EQ(p.path, q.path);
    EXPECT_EQ(p.x, q.x);
    EXPECT_EQ(p.winding, q.winding);
    EXPECT_EQ(p.accuracy, q.accuracy);
    EXPECT_EQ(p.condition, q.condition);
    EXPECT_EQ(p.certified, q.certified);
  }
  ASSERT_EQ(a.ledger.size(), b.ledger.size());
  for (std::size_t path = 0; path < a.ledger.size(); ++path) {
    EXPECT_EQ(a.ledger[path].steps, b.ledger[path].steps) << path;
    EXPECT_EQ(a.ledger[path].followed, b.ledger[path].followed) << path;
    EXPECT_EQ(a.ledger[path].verdict, b.ledger[path].verdict) << path;
  }
}

/// Cut off after any number of outcomes, and twice.
void expect_the_same_wherever_it_is_cut(const System& f, const Tracker& tracker,
                                        SolveOptions options) {
  const SolveResult undisturbed = solve(f, tracker, options);
  Memory whole;
  options.observations = &whole;
  expect_same(solve(f, tracker, options), undisturbed);
  const std::uint64_t outcomes = whole.kept();
  ASSERT_GT(outcomes, 0);
  whole.begin_again(kAll);
  expect_same(solve(f, tracker, options), undisturbed);
  EXPECT_EQ(whole.kept(), 0) << "paths were followed again";
  for (std::uint64_t trial = 0; trial < 6; ++trial) {
    Memory memory;
    options.observations = &memory;
    options.threads = 1 + static_cast<int>(trial % 2);
    for (const std::uint64_t part : {std::uint64_t{2}, std::uint64_t{3}}) {
      memory.begin_again(random_bits(trial, RandomStream::test, part) % (outcomes / part + 1));
      solve(f, tracker, options);
    }
    memory.begin_again(kAll);
    expect_same(solve(f, tracker, options), undisturbed);
  }
}

TEST(ObservedPaths, SimpleRootsAndPathsToInfinityAreTheSame) {
  SolveOptions options;
  options.start = StartKind::total_degree;
  const System f = system_of(problem("cyclic-5"));
  expect_the_same_wherever_it_is_cut(f, *make_lane_tracker(), options);
  expect_the_same_wherever_it_is_cut(f, *make_cvode_tracker(), options);
}

TEST(ObservedPaths, CyclesThatPathsWalkTogetherAreTheSame) {
  SolveOptions options;
  options.start = StartKind::total_degree;
  for (const char* file : {"reimer-4", "griewank-osborne", "multiplicity-4"}) {
    expect_the_same_wherever_it_is_cut(system_of(problem(file)), *make_lane_tracker(), options);
  }
}

TEST(ObservedPaths, PathsOfTwoStagesAreTheSame) {
  SolveOptions options;
  options.start = StartKind::polyhedral;
  expect_the_same_wherever_it_is_cut(system_of(problem("cassou")), *make_lane_tracker(), options);
}

TEST(ObservedPaths, AnotherSeedOrTrackerRemembersNothing) {
  const System f = system_of(problem("cyclic-5"));
  Memory memory;
  SolveOptions options;
  options.observations = &memory;
  solve(f, *make_lane_tracker(), options);
  const std::uint64_t outcomes = memory.kept();
  options.seed = 2;
  memory.begin_again(kAll);
  solve(f, *make_lane_tracker(), options);
  EXPECT_GE(memory.kept(), outcomes / 2);
  options.seed = 1;
  memory.begin_again(kAll);
  solve(f, *make_cvode_tracker(), options);
  EXPECT_GE(memory.kept(), outcomes / 2);
}

TEST(ObservedPaths, AnEndComesBackToTheLastBit) {
  PathEnd end;
  end.status = PathStatus::failed;
  end.failure = Failure::precision;
  end.x = {{1.0 / 3, -0.0}, {5e-324, 1e300}};
  end.is_as_rounded = true;
  end.winding = 3;
  end.accuracy = 1e-9;
  end.t = {0.25, 1.0 / 7};
  end.stage = 1;
  end.sheet = {{2, 3}};
  end.count.work.fine_values = 77;
  PathFrame frame;
  frame.log2 = {1, -3};
  frame.factors = {0.5, 2};
  frame.weights = {0.1};
  end.endgame_start = EndgameStart{{{4, 5}}, 0.01, std::make_shared<const PathFrame>(frame)};
  const PathEnd again = end_of(bytes_of(end));
  EXPECT_EQ(bytes_of(again), bytes_of(end));
  EXPECT_EQ(again.x, end.x);
  EXPECT_EQ(again.failure, end.failure);
  EXPECT_EQ(again.endgame_start->frame->log2, frame.log2);
  EXPECT_THROW(end_of(bytes_of(end).substr(1)), std::invalid_argument);
}

TEST(ObservedPaths, SeveralThatShareTheirPathsComeToWhatOneComesTo) {
  SolveOptions options;
  options.threads = 1;
  options.start = StartKind::total_degree;
  // Of reimer-4 and multiplicity-4 most paths end in cycles, which they walk together.
  for (const char* name : {"cyclic-5", "reimer-4", "multiplicity-4"}) {
    const System f = system_of(problem(name));
    for (const auto& tracker : {make_cvode_tracker(), make_lane_tracker()}) {
      const SolveResult alone = solve(f, *tracker, options);
      Company company;
      Share::drawn = 0;
      std::vector<SolveResult> results(3);
      std::vector<std::thread> threads;
      for (SolveResult& result : results) {
        threads.emplace_back([&] {
          OneOfCompany member(company);
          SolveOptions own = options;
          own.observations = &member;
          result = solve(f, *tracker, own);
        });
      }
      for (std::thread& thread : threads) thread.join();
      for (const SolveResult& result : results) expect_same(result, alone);
      // Each path once, and each cycle.
      std::uint64_t jobs = 0;
      for (const auto& [key, list] : company.lists) jobs += list.outcomes.size();
      EXPECT_EQ(Share::drawn, jobs);
      EXPECT_GE(jobs, alone.paths.tracked);
    }
  }
}

// Others may begin, and tell, before one has read what it knows: it takes each outcome once.
TEST(ObservedPaths, WhatOneKnowsAndOthersHaveToldBeforeIsTakenOnce) {
  /// One of a company who remembers a run before.
  class OneWhoRemembers : public OneOfCompany {
   public:
    OneWhoRemembers(Company& company, Memory& memory) : OneOfCompany(company), memory_(memory) {}
    std::map<std::uint64_t, std::string> recall(const Fingerprint& list) override {
      return memory_.recall(list);
    }

   private:
    Memory& memory_;
  };
  SolveOptions options;
  options.threads = 1;
  options.start = StartKind::total_degree;
  const System f = system_of(problem("cyclic-5"));
  const auto tracker = make_lane_tracker();
  Memory memory;
  options.observations = &memory;
  const SolveResult alone = solve(f, *tracker, options);
  Company company;
  OneOfCompany other(company);
  options.observations = &other;
  expect_same(solve(f, *tracker, options), alone);
  OneWhoRemembers late(company, memory);
  options.observations = &late;
  expect_same(solve(f, *tracker, options), alone);
}

}  // namespace
}  // namespace moivre::test
