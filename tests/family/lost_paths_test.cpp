// SPDX-License-Identifier: MIT
// What does the trace test make of a path that is lost? It goes round, or shows nothing.
#include <gtest/gtest.h>

#include <functional>
#include <memory>

#include "families.h"
#include "moivre/family/learn.h"
#include "moivre/tracker/session.h"
#include "moivre/tracker_lanes/lane_tracker.h"

namespace moivre {
namespace {

/// Of a list of paths, by its place among all lists, and a path: it breaks off.
using Fault = std::function<bool(int list, std::uint64_t path)>;

/// The lanes, in double alone, with a fault planted.
class FaultyTracker : public Tracker {
 public:
  explicit FaultyTracker(Fault fault) : fault_(std::move(fault)) {}
  std::string kind() const override { return inner_->kind(); }
  OptionsInForce options_in_force() const override { return inner_->options_in_force(); }
  std::unique_ptr<TrackerSession> open(const Homotopy& homotopy) const override {
    return std::make_unique<Session>(inner_->open(homotopy), fault_, lists_++);
  }
  int lists() const { return lists_; }

 private:
  class Session : public TrackerSession, public SegmentSource {
   public:
    Session(std::unique_ptr<TrackerSession> inner, const Fault& fault, int list)
        : inner_(std::move(inner)), fault_(fault), list_(list) {}
    void run(SegmentSource& source, const std::atomic<bool>& stop) override {
      source_ = &source;
      inner_->run(*this, stop);
    }
    std::optional<PathSegment> next() override { return source_->next(); }
    void arrived(const PathSegment& segment, SegmentResult&& reached) override {
      if (fault_(list_, segment.path)) reached.status = SegmentStatus::step_too_small;
      source_->arrived(segment, std::move(reached));
    }

   private:
    std::unique_ptr<TrackerSession> inner_;
    const Fault& fault_;
    int list_;
    SegmentSource* source_ = nullptr;
  };

  std::unique_ptr<Tracker> inner_ = make_lane_tracker();
  Fault fault_;
  mutable int lists_ = 0;
};

Family learned_conics() { return learn(conics(), *make_lane_tracker()); }

/// The lists that a test takes where nothing is lost.
int lists_of(const Family& family) {
  const FaultyTracker tracker([](int, std::uint64_t) { return false; });
  EXPECT_TRUE(trace_test(family, tracker).holds);
  return tracker.lists();
}

TEST(LostPaths, AreFollowedOnAnotherWay) {
  const Family family = learned_conics();
  ASSERT_EQ(family.roots.size(), 4U);
  const int lists = lists_of(family);
  for (int faulty = 0; faulty < lists; ++faulty) {
    for (const std::uint64_t victim : {std::uint64_t{0}, std::uint64_t{3}}) {
      const FaultyTracker tracker(
          [&](int list, std::uint64_t path) { return list == faulty && path == victim; });
      const TraceTest test = trace_test(family, tracker);
      EXPECT_TRUE(test.was_made) << faulty;
      EXPECT_TRUE(test.holds) << faulty << ": " << test.defect;
      EXPECT_EQ(test.lost, 0U);
    }
  }
}

TEST(LostPaths, ThatNoWayHelpsShowNothing) {
  const Family family = learned_conics();
  const int lists = lists_of(family);
  for (int first = 0; first < lists; ++first) {
    const FaultyTracker tracker(
        [&](int list, std::uint64_t path) { return list >= first && path == 0; });
    const TraceTest test = trace_test(family, tracker);
    EXPECT_FALSE(test.was_made) << first;
    EXPECT_FALSE(test.holds) << first;
    EXPECT_GT(test.lost, 0U) << first;
  }
}

/// The curve has the root that the family lacks: its point is lost on the way to it.
TEST(LostPaths, OfAMissingRootShowNothing) {
  Family family = learned_conics();
  const int lists = lists_of(family);
  family.roots.pop_back();
  const FaultyTracker honest([](int, std::uint64_t) { return false; });
  ASSERT_EQ(trace_test(family, honest).missing, 1U);
  ASSERT_GE(honest.lists(), lists);
  const int last = honest.lists() - 1;
  for (std::uint64_t victim = 0; victim < 12; ++victim) {
    const FaultyTracker tracker([&](int list, std::uint64_t path) {
      return list > last || (list == last && path == victim);
    });
    EXPECT_FALSE(trace_test(family, tracker).holds) << victim;
  }
}

}  // namespace
}  // namespace moivre
