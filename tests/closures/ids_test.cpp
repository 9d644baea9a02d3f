// SPDX-License-Identifier: MIT
// Does an id name the same pose whatever found it: seed, tracker, threads?
#include <gtest/gtest.h>

#include "mechanisms.h"
#include "moivre/mechanism/phi.h"
#include "moivre/tracker_lanes/lane_tracker.h"

namespace moivre {
namespace {

TEST(ClosureIds, AnIdMeansTheSamePoseForEverySeedAndBothTrackers) {
  constexpr double kSamePose = 1e-6;  // the parallelogram's closure is double
  const auto lanes = make_lane_tracker();
  for (const std::string file :
       {"jansen-leg", "3-rpr", "parallelogram", "gear-five-bar", "ur5", "3-rps"}) {
    const Mechanism mechanism = mechanism_file(file);
    const Phi phi(mechanism);
    const ClosureResult first = closures_of(mechanism, 1);
    std::vector<ClosureResult> others;
    for (std::uint64_t seed = 2; seed <= 6; ++seed) others.push_back(closures_of(mechanism, seed));
    others.push_back(find_closures(mechanism, *lanes));
    for (const ClosureResult& other : others) {
      ASSERT_EQ(other.closures.size(), first.closures.size()) << file;
      for (std::size_t k = 0; k < first.closures.size(); ++k) {
        EXPECT_EQ(other.closures[k].id, first.closures[k].id);
        const Eigen::VectorXd apart = other.closures[k].q - first.closures[k].q;
        EXPECT_LE(phi.canonical(apart).cwiseAbs().maxCoeff(), kSamePose)
            << file << ", closure " << first.closures[k].id << ", " << other.tracker << ", seed "
            << other.seed;
      }
    }
  }
}

}  // namespace
}  // namespace moivre
