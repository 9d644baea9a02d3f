// SPDX-License-Identifier: MIT
// Does a solve survive an allocation that fails, wherever that is? With what is finished, or
// std::bad_alloc; and paths that cannot be kept are refused beforehand.
#include <gtest/gtest.h>

#include <atomic>
#include <cstdlib>
#include <new>
#include <stdexcept>

#include "moivre/polynomial/read.h"
#include "moivre/solver/solve.h"
#include "moivre/tracker_cvode/cvode_tracker.h"

namespace {

constexpr std::int64_t kNever = INT64_MAX;

/// Allocations until they fail, and how many fail then.
std::atomic<std::int64_t> until_failure{kNever};
std::atomic<std::int64_t> failures{1};

bool fails() {
  if (until_failure.load(std::memory_order_relaxed) == kNever) return false;
  return until_failure.fetch_sub(1) <= 0 && failures.fetch_sub(1) > 0;
}

}  // namespace

void* operator new(std::size_t size, const std::nothrow_t&) noexcept {
  return fails() ? nullptr : std::malloc(size > 0 ? size : 1);
}
void* operator new(std::size_t size) {
  if (void* memory = operator new(size, std::nothrow)) return memory;
  throw std::bad_alloc();
}
// Inlined, the call of free would look to g++ as if it met memory of another kind.
[[gnu::noinline]] void operator delete(void* memory) noexcept { std::free(memory); }
[[gnu::noinline]] void operator delete(void* memory, std::size_t) noexcept { std::free(memory); }

namespace moivre {
namespace {

System two_cubics() {
  return read_system({"test", "2\nx^3 + 2*x*y - y^2 + 1;\ny^3 - x^2*y + 3*x - 2;\n"});
}

/// Where a result is told its counts add up; a complete one has every root.
void expect_whole(const SolveResult& result) {
  const PathCounts& paths = result.paths;
  EXPECT_EQ(paths.tracked, paths.finite + paths.at_infinity + paths.failed);
  std::uint64_t sum = paths.on_positive_dimensional;
  for (const Solution& root : result.solutions) sum += root.multiplicity;
  EXPECT_EQ(paths.finite, sum);
  if (result.complete) {
    EXPECT_EQ(result.solutions.size(), 9U);
  }
}

TEST(Memory, AnAllocationThatFailsEndsASolveWithWhatIsFinished) {
  const System f = two_cubics();
  const auto tracker = make_cvode_tracker();
  for (const int threads : {1, 2}) {
    for (const std::int64_t lasting : {std::int64_t{1}, std::int64_t{20}}) {
      std::size_t told = 0;
      std::size_t thrown = 0;
      bool has_failed = true;
      for (std::int64_t n = 0; has_failed; n += 1 + n / 20) {
        SolveOptions options;
        options.threads = threads;
        failures = lasting;
        until_failure = n;
        try {
          const SolveResult result = solve(f, *tracker, options);
          has_failed = failures.load() < lasting;
          until_failure = kNever;
          expect_whole(result);
          ++told;
        } catch (const std::bad_alloc&) {
          until_failure = kNever;
          ++thrown;
        }
      }
      EXPECT_GE(told, lasting > 1 ? 1U : 2U) << threads << ' ' << lasting;
      EXPECT_GT(thrown, 1U) << threads << ' ' << lasting;
    }
  }
}

TEST(Memory, PathsThatCannotBeKeptAreRefused) {
  SolveOptions options;
  options.memory = 1 << 20;
  const System f = read_system({"test", "1\nx^100000 - 1;\n"});
  try {
    solve(f, *make_cvode_tracker(), options);
    FAIL() << "was begun";
  } catch (const std::invalid_argument& refusal) {
    EXPECT_STREQ(refusal.what(), "100000 paths take 0.0016 GB at least, and there are 0.00105 GB");
  }
}

}  // namespace
}  // namespace moivre
