// SPDX-License-Identifier: MIT
// Do extreme mechanisms have their closures: tiny, huge and mixed links, change points, none at all, too many?
#include <gtest/gtest.h>

#include <fstream>
#include <nlohmann/json.hpp>

#include "moivre/closures/closures.h"
#include "moivre/mechanism/read.h"
#include "moivre/tracker_cvode/cvode_tracker.h"
#include "moivre/tracker_lanes/lane_tracker.h"

namespace moivre {
namespace {

const std::string kFolder = MOIVRE_SOURCE_DIR "/problems/extremes/";
/// Of Phi relative to its terms: a few roundings.
constexpr double kResidual = 1e-14;

TEST(ExtremeMechanisms, HaveTheirClosuresOrSayWhyNot) {
  std::ifstream file(kFolder + "index.json");
  std::vector<std::unique_ptr<Tracker>> trackers;
  trackers.push_back(make_cvode_tracker());
  trackers.push_back(make_lane_tracker());
  const nlohmann::json index = nlohmann::json::parse(file);
  for (const nlohmann::json& entry : index.at("mechanisms")) {
    const Mechanism mechanism =
        read_mechanism(read_source(kFolder + entry.at("file").get<std::string>()));
    for (const auto& tracker : trackers) {
      SCOPED_TRACE(entry.at("name").get<std::string>() + ", " + tracker->kind());
      ClosureOptions options;
      options.solve.threads = 1;
      const ClosureResult result = find_closures(mechanism, *tracker, options);
      EXPECT_EQ(result.paths.tracked,
                result.paths.finite + result.paths.at_infinity + result.paths.failed);
      if (entry.value("moves", false)) {
        EXPECT_TRUE(result.moves.has_value());
        continue;
      }
      EXPECT_TRUE(result.complete) << result.message;
      std::uint64_t with_multiplicity = 0;
      for (const Closure& closure : result.closures) {
        with_multiplicity += closure.singular ? closure.multiplicity : 1;
        EXPECT_LE(closure.residual, kResidual);
      }
      // Closures nearer than rounding lets Phi tell are one, singular and of their multiplicity.
      const auto expected = entry.at("closures").get<std::uint64_t>();
      EXPECT_TRUE(result.closures.size() == expected || with_multiplicity == expected)
          << result.closures.size();
    }
  }
}

}  // namespace
}  // namespace moivre
