// SPDX-License-Identifier: MIT
// Do the parts of a list, each by itself, make up the list? And does a part go no further than it
// may?
#include "moivre/numeric/part_of_lists.h"

#include <gtest/gtest.h>

#include "moivre/numeric/job_list.h"

namespace moivre {
namespace {

const std::atomic<bool> kGoOn{false};
const Fingerprint kList{1, 2}, kNext{3, 4};

class KeptInMemory : public Observations {
 public:
  std::map<std::uint64_t, std::string> recall(const Fingerprint& list) override {
    return lists_[list];
  }
  using Observations::keep;
  void keep(const Fingerprint& list, std::span<const JobOutcome> outcomes) override {
    for (const JobOutcome& outcome : outcomes) lists_[list][outcome.job] = outcome.bytes;
  }

 private:
  std::map<Fingerprint, std::map<std::uint64_t, std::string>> lists_;
};

/// The jobs that are done of a list of so many.
std::vector<std::size_t> done_of(PartOfLists& part, const Fingerprint& list, std::size_t count) {
  std::vector<std::size_t> done;
  JobList jobs;
  jobs.fingerprint = list;
  jobs.count = count;
  jobs.take = [](std::size_t, std::string_view) { return OutcomeKind::other; };
  jobs.solve = [&](std::span<const std::size_t> numbers) {
    std::vector<JobOutcome> outcomes;
    for (const std::size_t job : numbers) {
      done.push_back(job);
      outcomes.push_back({job, std::to_string(job)});
    }
    return outcomes;
  };
  do_jobs(jobs, part, kGoOn);
  return done;
}

TEST(PartOfLists, DoesEachJobInOnePart) {
  std::vector<int> times(100, 0);
  for (std::uint64_t k = 1; k <= 7; ++k) {
    KeptInMemory kept;
    PartOfLists part(kept, {k, 7}, [] {});
    for (const std::size_t job : done_of(part, kList, times.size())) ++times[job];
    EXPECT_EQ(kept.recall(kList).size(), k <= 2 ? 15U : 14U);
  }
  EXPECT_EQ(times, std::vector<int>(100, 1));
}

TEST(PartOfLists, DoesNothingAgain) {
  KeptInMemory kept;
  PartOfLists part(kept, {2, 3}, [] {});
  EXPECT_EQ(done_of(part, kList, 9), (std::vector<std::size_t>{1, 4, 7}));
  EXPECT_TRUE(done_of(part, kList, 9).empty());
}

TEST(PartOfLists, StopsBehindListsOfWhichOthersJobsAreMissing) {
  KeptInMemory kept;
  int stops = 0;
  PartOfLists part(kept, {1, 2}, [&] { ++stops; });
  done_of(part, kList, 4);
  EXPECT_EQ(done_of(part, kNext, 4), (std::vector<std::size_t>{0, 2}));
  EXPECT_EQ(stops, 0);
  EXPECT_FALSE(part.is_done());
  part.lists_are_done();
  EXPECT_EQ(stops, 1);
  EXPECT_TRUE(part.is_done());
}

TEST(PartOfLists, GoesOnWhereNothingIsMissing) {
  KeptInMemory kept;
  PartOfLists other(kept, {2, 2}, [] {});
  done_of(other, kList, 4);
  PartOfLists part(kept, {1, 2}, [] { FAIL(); });
  EXPECT_EQ(done_of(part, kList, 4), (std::vector<std::size_t>{0, 2}));
  part.lists_are_done();
  EXPECT_FALSE(part.is_done());
}

}  // namespace
}  // namespace moivre
