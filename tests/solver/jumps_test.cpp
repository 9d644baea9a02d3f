// SPDX-License-Identifier: MIT
// Are paths that jump caught, tracked again, and said to be lost where that does not help?
#include <gtest/gtest.h>

#include <functional>

#include "moivre/tracker/session.h"
#include "problem_set.h"

namespace moivre {
namespace {

using test::expect_conservation;
using test::problem;
using test::system_of;
using test::with_seed;

/// Changes results at t = 1: (segment, reached).
using Tampering = std::function<void(const PathSegment&, SegmentResult&)>;

/// Stands between a session and its source, and tampers with what arrives.
class TamperedSource : public SegmentSource {
 public:
  TamperedSource(SegmentSource& source, const Tampering& tamper)
      : source_(source), tamper_(tamper) {}
  std::optional<PathSegment> next() override { return source_.next(); }
  void arrived(const PathSegment& segment, SegmentResult&& reached) override {
    tamper_(segment, reached);
    source_.arrived(segment, std::move(reached));
  }

 private:
  SegmentSource& source_;
  const Tampering& tamper_;
};

class TamperedSession : public TrackerSession {
 public:
  TamperedSession(std::unique_ptr<TrackerSession> inner, const Tampering& tamper)
      : inner_(std::move(inner)), tamper_(tamper) {}
  void run(SegmentSource& source, const std::atomic<bool>& stop) noexcept override {
    TamperedSource tampered(source, tamper_);
    inner_->run(tampered, stop);
  }

 private:
  std::unique_ptr<TrackerSession> inner_;
  const Tampering& tamper_;
};

/// The CVODE tracker with a fault planted.
class TamperedTracker : public Tracker {
 public:
  explicit TamperedTracker(Tampering tamper) : tamper_(std::move(tamper)) {}
  std::string kind() const override { return inner_->kind(); }
  OptionsInForce options_in_force() const override { return inner_->options_in_force(); }
  std::unique_ptr<TrackerSession> open(const Homotopy& homotopy) const override {
    return std::make_unique<TamperedSession>(inner_->open(homotopy), tamper_);
  }

 private:
  std::unique_ptr<Tracker> inner_ = make_cvode_tracker();
  Tampering tamper_;
};

/// The segment from t = 0 to t = 1, not a circle nor the way back.
bool is_whole_way(const PathSegment& segment) {
  return segment.contour.at(0).t == 0.0 && segment.contour.at(1).t == 1.0;
}

constexpr std::uint64_t kVictim = 5;
constexpr int kEveryCare = 100;

/// Path kVictim arrives where the first path that arrived did, at cares up to `greatest_care`.
TamperedTracker with_a_jump(int greatest_care) {
  auto first_end = std::make_shared<Point>();
  return TamperedTracker([=](const PathSegment& segment, SegmentResult& reached) {
    if (!is_whole_way(segment)) return;
    if (segment.path == kVictim) {
      if (segment.tolerance_level > greatest_care) return;
      reached.status = SegmentStatus::arrived;
      reached.x = *first_end;
    } else if (first_end->empty() && reached.status == SegmentStatus::arrived) {
      *first_end = reached.x;
    }
  });
}

TEST(Jump, IsSeenAndTrackedAgainUntilEveryRootIsFound) {
  for (const char* name : {"katsura-5", "dense-real-3-4", "dense-complex-4-3"}) {
    const auto& p = problem(name);
    for (std::uint64_t seed = 1; seed <= 3; ++seed) {
      SCOPED_TRACE(p.name + ", seed " + std::to_string(seed));
      const SolveResult result = solve(system_of(p), with_a_jump(0), with_seed(seed));
      expect_conservation(result);
      EXPECT_TRUE(result.complete);
      EXPECT_GE(result.paths.retracked, 2U);
      EXPECT_EQ(result.solutions.size(), p.roots.distinct);
    }
  }
}

/// Without the last resorts: the tracker in double-double, which jumps nowhere, and another start.
SolveOptions in_double_alone(std::uint64_t seed) {
  SolveOptions options = with_seed(seed);
  options.precision = Precision::double_precision;
  options.second_start = false;
  return options;
}

TEST(Jump, ThatComesAgainAtEveryCareIsSettledInDoubleDouble) {
  const auto& p = problem("dense-complex-4-3");
  const SolveResult result = solve(system_of(p), with_a_jump(kEveryCare), with_seed(1));
  expect_conservation(result);
  EXPECT_TRUE(result.complete);
  EXPECT_EQ(result.solutions.size(), p.roots.distinct);
  EXPECT_GE(result.paths.double_double, 1U);
}

TEST(Jump, ThatComesAgainAtEveryCareIsAFailureThatIsSaid) {
  const auto& p = problem("dense-complex-4-3");
  for (std::uint64_t seed = 1; seed <= 3; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    const SolveResult result = solve(system_of(p), with_a_jump(kEveryCare), in_double_alone(seed));
    expect_conservation(result);
    EXPECT_FALSE(result.complete);
    ASSERT_EQ(result.failures.size(), 1U);
    EXPECT_EQ(result.failures[0].path, kVictim);
    EXPECT_EQ(result.failures[0].failure, Failure::jumped);
    EXPECT_EQ(result.solutions.size(), p.roots.distinct - 1);
  }
}

TEST(Jump, OfTwoPathsThatChangeEndsChangesNoRoot) {
  const auto& p = problem("katsura-5");
  const System f = system_of(p);
  const SolveResult honest = test::solve_with_cvode(f);
  auto ends = std::make_shared<std::map<std::uint64_t, Point>>();
  // Each of the two takes the end that an honest run would give the other.
  {
    const TamperedTracker recorder([=](const PathSegment& segment, SegmentResult& reached) {
      if (is_whole_way(segment)) (*ends)[segment.path] = reached.x;
    });
    solve(f, recorder, with_seed(1));
  }
  constexpr std::uint64_t kOther = 2;
  const TamperedTracker swapped([=](const PathSegment& segment, SegmentResult& reached) {
    if (!is_whole_way(segment)) return;
    if (segment.path == kOther) reached.x = ends->at(kVictim);
    if (segment.path == kVictim) reached.x = ends->at(kOther);
  });
  const SolveResult result = solve(f, swapped, with_seed(1));
  expect_conservation(result);
  EXPECT_TRUE(result.complete);
  ASSERT_EQ(result.solutions.size(), honest.solutions.size());
  for (const Solution& s : honest.solutions) {
    EXPECT_EQ(test::solutions_near(result, s.x, 1e-13), 1U);
  }
}

TEST(LostPath, IsTrackedAgainAtTheNextCare) {
  const auto& p = problem("katsura-5");
  const TamperedTracker tracker([](const PathSegment& segment, SegmentResult& reached) {
    if (segment.path % 3 != 0 || segment.tolerance_level > 0 || !is_whole_way(segment)) return;
    reached.status = SegmentStatus::step_too_small;
  });
  const SolveResult result = solve(system_of(p), tracker, with_seed(1));
  expect_conservation(result);
  EXPECT_TRUE(result.complete);
  EXPECT_EQ(result.solutions.size(), p.roots.distinct);
}

// x^3 + x^2 + 2 = 0, y = -1 - 1/x: one real root, a conjugate pair, and a simple end at (0 : 1 :
// 0).
const char* const kPairAndInfinity = "2\n x*y + x + 1;\n x*y - x^2 + 2*y + 3;\n";

SolveOptions from_the_degrees(std::uint64_t seed) {
  SolveOptions options = with_seed(seed);
  options.start = StartKind::total_degree;
  return options;
}

/// A path whose end is not real, by an honest run.
std::uint64_t path_to_a_root_that_is_not_real(const System& f, std::uint64_t seed) {
  const SolveResult honest = test::solve_with_cvode(f, from_the_degrees(seed));
  EXPECT_EQ(honest.solutions.size(), 3U);
  EXPECT_EQ(honest.paths.at_infinity, 1U);
  for (const Solution& s : honest.solutions) {
    if (!s.real) return s.path;
  }
  throw std::invalid_argument("every root is real");
}

/// Path `victim` arrives at the end at infinity, at cares up to `greatest_care`: no failure shows,
/// no root is doubled.
TamperedTracker with_a_path_to_infinity(std::uint64_t victim, int greatest_care) {
  return TamperedTracker([=](const PathSegment& segment, SegmentResult& reached) {
    if (segment.path != victim || segment.tolerance_level > greatest_care ||
        !is_whole_way(segment)) {
      return;
    }
    reached.x = {0, 1, 0};
  });
}

TEST(EndAtInfinity, IsNotBelievedWhereNoFaceConfirmsIt) {
  const System f = test::read(kPairAndInfinity);
  for (const int greatest_care : {0, kEveryCare}) {
    for (std::uint64_t seed = 1; seed <= 5; ++seed) {
      SCOPED_TRACE("seed " + std::to_string(seed));
      const std::uint64_t victim = path_to_a_root_that_is_not_real(f, seed);
      const SolveResult result =
          solve(f, with_a_path_to_infinity(victim, greatest_care), from_the_degrees(seed));
      expect_conservation(result);
      // The path goes on from where it was last seen, or is said to be lost.
      EXPECT_TRUE(!result.complete || result.solutions.size() == 3U);
      if (greatest_care == 0) {
        EXPECT_TRUE(result.complete);
      }
    }
  }
}

/// Sends path `victim` out from where path `other` sets out, at cares up to `greatest_care`: a jump
/// right at the start.
class MisledTracker : public Tracker {
 public:
  MisledTracker(std::uint64_t victim, Point start, int greatest_care)
      : victim_(victim), start_(std::move(start)), greatest_care_(greatest_care) {}
  std::string kind() const override { return inner_->kind(); }
  OptionsInForce options_in_force() const override { return inner_->options_in_force(); }
  std::unique_ptr<TrackerSession> open(const Homotopy& homotopy) const override {
    return std::make_unique<Session>(*this, inner_->open(homotopy));
  }

 private:
  class Session : public TrackerSession, public SegmentSource {
   public:
    Session(const MisledTracker& tracker, std::unique_ptr<TrackerSession> inner)
        : tracker_(tracker), inner_(std::move(inner)) {}
    void run(SegmentSource& source, const std::atomic<bool>& stop) noexcept override {
      source_ = &source;
      inner_->run(*this, stop);
    }
    std::optional<PathSegment> next() override {
      std::optional<PathSegment> segment = source_->next();
      if (segment && segment->path == tracker_.victim_ &&
          segment->tolerance_level <= tracker_.greatest_care_ && is_whole_way(*segment))
        segment->x = tracker_.start_;
      return segment;
    }
    void arrived(const PathSegment& segment, SegmentResult&& reached) override {
      source_->arrived(segment, std::move(reached));
    }

   private:
    const MisledTracker& tracker_;
    std::unique_ptr<TrackerSession> inner_;
    SegmentSource* source_ = nullptr;
  };

  std::unique_ptr<Tracker> inner_ = make_cvode_tracker();
  std::uint64_t victim_;
  Point start_;
  int greatest_care_;
};

// (x + y - 1) (x^2 + x y - 3) = (x + y - 1) (x y + x + y - 2) = 0: a line, three isolated roots,
// ends at infinity.
const char* const kLineAndRoots =
    "2\n (x + y - 1)*(x^2 + x*y - 3);\n (x + y - 1)*(x*y + x + y - 2);\n";

TEST(Jump, OntoAPathToInfinityOrToACurveIsSeen) {
  const System f = test::read(kLineAndRoots);
  for (std::uint64_t seed = 1; seed <= 3; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    const SolveResult honest = test::solve_with_cvode(f, from_the_degrees(seed));
    ASSERT_TRUE(honest.complete);
    ASSERT_EQ(honest.solutions.size(), 3U);
    std::map<std::uint64_t, Point> starts;
    const TamperedTracker recorder([&](const PathSegment& segment, SegmentResult&) {
      if (is_whole_way(segment)) starts[segment.path] = segment.x;
    });
    solve(f, recorder, from_the_degrees(seed));
    std::size_t misled = 0;
    for (const auto& [other, start] : starts) {
      const bool ends_at_a_root =
          std::any_of(honest.solutions.begin(), honest.solutions.end(),
                      [other = other](const Solution& root) { return root.path == other; });
      if (ends_at_a_root) continue;
      for (const int greatest_care : {0, kEveryCare}) {
        const std::uint64_t victim = honest.solutions[misled % 3].path;
        SolveOptions options = from_the_degrees(seed);
        options.precision = Precision::double_precision;
        options.second_start = false;
        const SolveResult result = solve(f, MisledTracker(victim, start, greatest_care), options);
        expect_conservation(result);
        EXPECT_EQ(result.complete, greatest_care == 0);
        EXPECT_EQ(result.solutions.size(), greatest_care == 0 ? 3U : 2U);
        ++misled;
      }
    }
    EXPECT_EQ(misled, 12U);
  }
}

TEST(Fallback, TakesWhatTheTrackerCannotSettle) {
  const System f = system_of(problem("katsura-5"));
  CvodeOptions short_of_steps;
  short_of_steps.maximum_steps = 5;
  const auto fallback = make_cvode_tracker();
  SolveOptions options = with_seed(1);
  options.fallback = fallback.get();
  const SolveResult alone = solve(f, *make_cvode_tracker(short_of_steps), with_seed(1));
  const SolveResult helped = solve(f, *make_cvode_tracker(short_of_steps), options);
  expect_conservation(alone);
  expect_conservation(helped);
  EXPECT_EQ(alone.paths.handed_over, 0U);
  EXPECT_EQ(alone.paths.failed, alone.paths.tracked);
  EXPECT_EQ(helped.paths.handed_over, helped.paths.tracked);
  EXPECT_TRUE(helped.complete);
  EXPECT_EQ(helped.solutions.size(), problem("katsura-5").roots.distinct);
}

}  // namespace
}  // namespace moivre
