// SPDX-License-Identifier: MIT
// Does a solve leave out endgames, double-double, threads and SUNDIALS where its paths do not need
// them? Calls are counted.
#include <gtest/gtest.h>

#include <mutex>

#include "counted_packages.h"
#include "moivre/polynomial/read.h"
#include "moivre/solver/solve.h"
#include "moivre/tracker/path_system.h"
#include "moivre/tracker/session.h"
#include "moivre/tracker_cvode/cvode_tracker.h"
#include "moivre/tracker_lanes/lane_tracker.h"

namespace moivre {
namespace {

constexpr int kThreads = 4;

System problem(const std::string& name) {
  return read_system(
      read_source(std::string(MOIVRE_SOURCE_DIR) + "/problems/polynomials/" + name + ".phc"));
}

/// Follows as `inner` does and counts what it was asked for.
class CountingTracker : public Tracker {
 public:
  explicit CountingTracker(std::unique_ptr<Tracker> inner) : inner_(std::move(inner)) {}

  std::string kind() const override { return inner_->kind(); }
  OptionsInForce options_in_force() const override { return inner_->options_in_force(); }
  std::unique_ptr<TrackerSession> open(const Homotopy& homotopy) const override {
    const std::lock_guard lock(mutex_);
    ++sessions;
    return std::make_unique<Session>(*this, inner_->open(homotopy));
  }

  std::unique_ptr<Tracker> in_double_double() const override {
    auto fine = inner_->in_double_double();
    if (fine == nullptr) return nullptr;
    return std::make_unique<Fine>(*this, std::move(fine));
  }

  mutable int sessions = 0;
  mutable int fine_sessions = 0;  // in double-double
  mutable int segments = 0;
  mutable int samples = 0;

 private:
  class Source : public SegmentSource {
   public:
    Source(const CountingTracker& counts, SegmentSource& inner) : counts_(counts), inner_(inner) {}
    std::optional<PathSegment> next() override {
      std::optional<PathSegment> segment = inner_.next();
      if (segment) {
        const std::lock_guard lock(counts_.mutex_);
        ++counts_.segments;
        counts_.samples += segment->samples;
      }
      return segment;
    }
    void arrived(const PathSegment& segment, SegmentResult&& reached) override {
      inner_.arrived(segment, std::move(reached));
    }

   private:
    const CountingTracker& counts_;
    SegmentSource& inner_;
  };
  class Session : public TrackerSession {
   public:
    Session(const CountingTracker& counts, std::unique_ptr<TrackerSession> inner)
        : counts_(counts), inner_(std::move(inner)) {}
    void run(SegmentSource& source, const std::atomic<bool>& stop) noexcept override {
      Source counted(counts_, source);
      inner_->run(counted, stop);
    }

   private:
    const CountingTracker& counts_;
    std::unique_ptr<TrackerSession> inner_;
  };

  class Fine : public Tracker {
   public:
    Fine(const CountingTracker& counts, std::unique_ptr<Tracker> inner)
        : counts_(counts), inner_(std::move(inner)) {}
    std::string kind() const override { return inner_->kind(); }
    OptionsInForce options_in_force() const override { return inner_->options_in_force(); }
    std::unique_ptr<TrackerSession> open(const Homotopy& homotopy) const override {
      const std::lock_guard lock(counts_.mutex_);
      ++counts_.fine_sessions;
      return inner_->open(homotopy);
    }

   private:
    const CountingTracker& counts_;
    std::unique_ptr<Tracker> inner_;
  };

  std::unique_ptr<Tracker> inner_;
  mutable std::mutex mutex_;
};

SolveOptions on_threads(int threads) {
  SolveOptions options;
  options.threads = threads;
  return options;
}

std::vector<std::unique_ptr<Tracker>> both_trackers() {
  std::vector<std::unique_ptr<Tracker>> trackers;
  trackers.push_back(make_cvode_tracker());
  trackers.push_back(make_lane_tracker());
  return trackers;
}

TEST(LeaveOut, NoEndgameRunsOnRegularEnds) {
  for (auto& inner : both_trackers()) {
    const CountingTracker tracker(std::move(inner));
    const SolveResult result = solve(problem("katsura-5"), tracker, on_threads(1));
    ASSERT_TRUE(result.complete);
    ASSERT_EQ(result.paths.finite, result.start.paths);
    EXPECT_EQ(tracker.segments, static_cast<int>(result.start.paths)) << tracker.kind();
    EXPECT_EQ(tracker.samples, 0) << tracker.kind();
  }
}

// The lanes have factors of their own: where they track, only an endgame asks PathSystem for any,
// at an end that it judges.
TEST(LeaveOut, AnEndgameFactorsLessThanOnceAPathOnTheWayToRegularEnds) {
  const auto tracker = make_lane_tracker();
  const auto factorizations_of = [&](const std::string& name) {
    return test::calls_of<test::Counted<&PathSystem::linearize>>([&] {
      const SolveResult result = solve(problem(name), *tracker, on_threads(1));
      EXPECT_TRUE(result.complete);
    });
  };
  constexpr int kPathsOfKatsura = 32;
  EXPECT_LT(factorizations_of("katsura-5"), kPathsOfKatsura);
  EXPECT_GT(factorizations_of("multiplicity-3"), 0);
}

TEST(LeaveOut, AnEndgameRunsWhereARootIsMultiple) {
  const CountingTracker tracker(make_cvode_tracker());
  const SolveResult result = solve(problem("multiplicity-3"), tracker, on_threads(1));
  ASSERT_TRUE(result.complete);
  EXPECT_GT(tracker.samples, 0);
}

TEST(LeaveOut, WellConditionedPathsNeedNoDoubleDouble) {
  for (auto& inner : both_trackers()) {
    const CountingTracker tracker(std::move(inner));
    const SolveResult result = solve(problem("katsura-5"), tracker, on_threads(1));
    ASSERT_TRUE(result.complete);
    EXPECT_GT(result.work.work.linearizations, 0U);
    EXPECT_EQ(result.work.work.fine_values, 0U) << tracker.kind();
    EXPECT_EQ(tracker.fine_sessions, 0) << tracker.kind();
  }
}

TEST(LeaveOut, OnePathInDoubleDoubleTakesTheLanesToo) {
  const System two_near =
      read_system({"test", "2\nx^2 + y^2 - 2;\n(x - y)*(x - y - 0.0000001)*(x + y - 1);\n"});
  const CountingTracker tracker(make_lane_tracker());
  const SolveResult result = solve(two_near, tracker, on_threads(1));
  ASSERT_TRUE(result.complete);
  ASSERT_GT(result.paths.double_double, 0U);
  EXPECT_LE(tracker.fine_sessions, 3);  // one more where paths have waited for each other
}

TEST(LeaveOut, ManyPathsInDoubleDoubleTakeTheLanes) {
  const CountingTracker tracker(make_lane_tracker());
  const SolveResult result = solve(problem("wilkinson-20"), tracker, on_threads(1));
  ASSERT_GT(result.paths.double_double, 2U);
  EXPECT_GT(tracker.fine_sessions, 0);
}

TEST(LeaveOut, FourPathsNeedNoThreadPool) {
  const System four = read_system({"test", "2\nx^2 + y^2 - 5;\nx*y - 2;\n"});
  for (auto& inner : both_trackers()) {
    const CountingTracker tracker(std::move(inner));
    SolveResult result;
    const int pools = test::calls_of<test::ThreadPools>(
        [&] { result = solve(four, tracker, on_threads(kThreads)); });
    ASSERT_TRUE(result.complete);
    ASSERT_EQ(result.start.paths, 4U);
    EXPECT_EQ(pools, 0) << tracker.kind();
    EXPECT_EQ(tracker.sessions, 1) << tracker.kind();
  }
}

TEST(LeaveOut, ManyPathsTakeTheThreads) {
  const CountingTracker tracker(make_cvode_tracker());
  const int pools = test::calls_of<test::ThreadPools>(
      [&] { solve(problem("katsura-5"), tracker, on_threads(kThreads)); });
  EXPECT_GT(pools, 0);
  EXPECT_EQ(tracker.sessions, kThreads);
}

TEST(LeaveOut, LanesInitializeNothingOfSundials) {
  const auto lanes = make_lane_tracker();
  const auto fallback = make_cvode_tracker();
  SolveOptions options = on_threads(1);
  options.fallback = fallback.get();
  int memories = 0;
  const int contexts = test::calls_of<test::SundialsContexts>([&] {
    memories =
        test::calls_of<test::CvodeMemories>([&] { solve(problem("katsura-5"), *lanes, options); });
  });
  EXPECT_EQ(contexts, 0);
  EXPECT_EQ(memories, 0);
}

TEST(LeaveOut, CvodeHasOneMemoryASession) {
  const auto tracker = make_cvode_tracker();
  const int memories = test::calls_of<test::CvodeMemories>(
      [&] { solve(problem("katsura-5"), *tracker, on_threads(1)); });
  EXPECT_EQ(memories, 1);
}

TEST(LeaveOut, WhatEliminationSolvesIsNotTracked) {
  const CountingTracker tracker(make_cvode_tracker());
  const SolveResult result =
      solve(read_system({"test", "2\nx + y - 3;\nx - y - 1;\n"}), tracker, on_threads(kThreads));
  ASSERT_TRUE(result.complete);
  EXPECT_EQ(result.solutions.size(), 1U);
  EXPECT_EQ(tracker.sessions, 0);
}

}  // namespace
}  // namespace moivre
