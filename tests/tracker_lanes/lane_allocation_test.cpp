// SPDX-License-Identifier: MIT
// Does a step of the lanes allocate? This program counts every call of operator new; longer
// segments must not add any.
#include <gtest/gtest.h>

#include <atomic>
#include <cstdlib>
#include <new>

#include "moivre/polynomial/read.h"
#include "moivre/start/total_degree.h"
#include "moivre/tracker/session.h"
#include "moivre/tracker_lanes/lane_tracker.h"

namespace {
std::atomic<std::uint64_t> allocations{0};
}  // namespace

void* operator new(std::size_t size, const std::nothrow_t&) noexcept {
  ++allocations;
  return std::malloc(size > 0 ? size : 1);
}
void* operator new(std::size_t size) {
  if (void* memory = operator new(size, std::nothrow)) return memory;
  throw std::bad_alloc();
}
[[gnu::noinline]] void operator delete(void* memory) noexcept { std::free(memory); }
[[gnu::noinline]] void operator delete(void* memory, std::size_t) noexcept { std::free(memory); }

namespace moivre {
namespace {

/// The paths of a system, all of them once; counts the steps of their segments.
class AllPaths : public SegmentSource {
 public:
  explicit AllPaths(const TotalDegreeStart& start) : start_(start) {}
  std::optional<PathSegment> next() override {
    if (next_ == start_.paths) return std::nullopt;
    const std::uint64_t path = next_++;
    return PathSegment{path, Contour::segment(0, 1), start_point(start_, path), 0, 0, nullptr};
  }
  void arrived(const PathSegment&, SegmentResult&& reached) override {
    steps += reached.count.accepted + reached.count.rejected;
  }

  std::uint64_t steps = 0;

 private:
  const TotalDegreeStart& start_;
  std::uint64_t next_ = 0;
};

struct Tally {
  std::uint64_t steps;
  std::uint64_t allocations;
};

/// Of the second run of a session: the first may make room once and for all.
Tally tally(const Homotopy& homotopy, const TotalDegreeStart& start, double tolerance) {
  const auto session = make_lane_tracker({.tolerance = tolerance})->open(homotopy);
  const std::atomic<bool> stop{false};
  AllPaths first(start);
  session->run(first, stop);
  AllPaths second(start);
  const std::uint64_t before = allocations;
  session->run(second, stop);
  return {second.steps, allocations - before};
}

TEST(LaneAllocations, DoNotGrowWithTheNumberOfSteps) {
  const System f = read_system({"test", "2\nx^3 + 2*x*y - y^2 - 3; y^3 - x^2*y + 4*x - 1;\n"});
  const TotalDegreeStart start = total_degree_start(degrees(f), 1);
  const Homotopy homotopy(f, start_system(start, f.variables));
  const Tally loose = tally(homotopy, start, 1e-2);
  const Tally tight = tally(homotopy, start, 1e-5);
  EXPECT_GT(tight.steps, 3 * loose.steps / 2);
  EXPECT_GT(loose.allocations, 0U);
  EXPECT_EQ(tight.allocations, loose.allocations);
}

}  // namespace
}  // namespace moivre
