// SPDX-License-Identifier: MIT
// Does a witness notice that a closure was lost, and say nothing where none was?
#include "witness.h"

#include <gtest/gtest.h>

#include "closure_poses.h"
#include "closure_roots.h"
#include "mechanisms.h"
#include "people.h"

namespace moivre {
namespace {

struct Searched {
  explicit Searched(const Mechanism& of, bool certify) : mechanism(of) {
    options.certify = certify;
    options.solve.threads = 1;
    search = std::make_unique<ClosureSearch>(mechanism, *tracker, options, stop);
    search->result.complete = true;
    find_roots(*search);
    find_poses(*search);
  }

  /// Contradictions where the closures are all but those that `is_lost` names.
  template <class IsLost>
  std::uint64_t contradictions(const IsLost& is_lost) {
    const std::vector<Closure> all = search->result.closures;
    std::erase_if(search->result.closures, is_lost);
    search->rootless = 0;
    look_for_witnesses(*search);
    search->result.closures = all;
    return search->rootless;
  }

  Mechanism mechanism;
  std::unique_ptr<Tracker> tracker = make_cvode_tracker();
  ClosureOptions options;
  std::atomic<bool> stop{false};
  std::unique_ptr<ClosureSearch> search;
};

TEST(Witness, NoticesThatTheDrawnPoseIsMissingThoughAllIsProved) {
  for (const char* name : {"vpp-shock-undecided", "walschaerts-motion-slow"}) {
    Searched searched(test::person(name), true);
    mark_drawn(*searched.search);
    EXPECT_EQ(searched.contradictions([](const Closure&) { return false; }), 0U) << name;
    EXPECT_EQ(searched.contradictions([](const Closure& one) { return one.is_drawn; }), 1U) << name;
  }
}

TEST(Witness, NoticesThatSomeOfManyAreMissingWhereNothingIsProved) {
  Searched searched(mechanism_file("assur-7-serial"), false);
  EXPECT_EQ(searched.contradictions([](const Closure&) { return false; }), 0U);
  EXPECT_EQ(searched.contradictions([](const Closure&) { return true; }), 1U);
}

TEST(Witness, NoticesAPoseWithinFitThatIsNotListed) {
  Mechanism mechanism = test::person("fit-not-assembled");
  mechanism.fit = 0.05;
  Searched searched(mechanism, true);
  EXPECT_EQ(searched.contradictions([](const Closure&) { return false; }), 0U);
  EXPECT_EQ(searched.contradictions([](const Closure& one) { return one.is_fitted; }), 1U);
}

}  // namespace
}  // namespace moivre
