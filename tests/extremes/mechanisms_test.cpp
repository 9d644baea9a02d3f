// SPDX-License-Identifier: MIT
// Do extreme mechanisms have their closures: tiny, huge and mixed links, change points, none at
// all, too many?
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <limits>
#include <nlohmann/json.hpp>
#include <numbers>

#include "moivre/closures/closures.h"
#include "moivre/kinematics/newton.h"
#include "moivre/mechanism/read.h"
#include "moivre/motion/motion.h"
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
      EXPECT_EQ(result.paths.tracked, result.paths.finite + result.paths.at_infinity +
                                          result.paths.failed + result.paths.not_needed);
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

/// Of the mechanism's shortest link.
constexpr double kClosedJoint = 1e-3;

double shortest_link(const Mechanism& mechanism) {
  double shortest = std::numeric_limits<double>::infinity();
  for (const Body& body : mechanism.bodies) {
    for (const BodyPoint& point : body.points) {
      if (point.at.norm() > 0) shortest = std::min(shortest, point.at.norm());
    }
  }
  return shortest;
}

TEST(ExtremeMechanisms, ANewtonRunThatConvergesClosesEveryJoint) {
  std::ifstream file(kFolder + "index.json");
  const nlohmann::json index = nlohmann::json::parse(file);
  for (const nlohmann::json& entry : index.at("mechanisms")) {
    SCOPED_TRACE(entry.at("name").get<std::string>());
    const Mechanism mechanism =
        read_mechanism(read_source(kFolder + entry.at("file").get<std::string>()));
    const NewtonResult run = newton(Phi(mechanism), initial_guess(mechanism));
    if (run.status != NewtonStatus::converged) {
      EXPECT_FALSE(run.message.empty());
      continue;
    }
    EXPECT_LE(run.residual, kClosedJoint * shortest_link(mechanism));
  }
}

/// Of the time of an event, in seconds.
constexpr double kSameTime = 1e-10;

TEST(ExtremeMotions, StopOrBranchWhereTheDriverCannotGoOn) {
  std::ifstream file(kFolder + "index.json");
  std::vector<std::unique_ptr<Tracker>> trackers;
  trackers.push_back(make_cvode_tracker());
  trackers.push_back(make_lane_tracker());
  const nlohmann::json index = nlohmann::json::parse(file);
  for (const nlohmann::json& entry : index.at("motions")) {
    const Mechanism mechanism =
        read_mechanism(read_source(kFolder + entry.at("file").get<std::string>()));
    for (const auto& tracker : trackers) {
      SCOPED_TRACE(entry.at("name").get<std::string>() + ", " + tracker->kind());
      MotionOptions options;
      options.solve.threads = 1;
      options.from = entry.at("from").get<double>();
      options.to = entry.at("to").get<double>();
      const MotionResult result = find_motion(mechanism, *tracker, options);
      if (entry.value("expect", "all") == "honest" && !result.complete) {
        EXPECT_FALSE(result.failures.empty());
        EXPECT_TRUE(result.events.empty());
        continue;
      }
      EXPECT_TRUE(result.complete) << result.message;
      EXPECT_EQ(result.branches.size(), entry.at("branches").get<std::size_t>());
      const nlohmann::json& events = entry.at("events");
      ASSERT_EQ(result.events.size(), events.size());
      for (std::size_t k = 0; k < events.size(); ++k) {
        EXPECT_EQ(to_string(result.events[k].at.kind), events[k].at("kind").get<std::string>());
        EXPECT_NEAR(result.events[k].at.time, events[k].at("t").get<double>(), kSameTime);
      }
    }
  }
}

// Crank 3, coupler and rocker 2 each, base 4: stretched where the crank's pin is 4 away from the
// rocker's, at acos(3/8).
TEST(ExtremeMotions, ADeadPointIsWhereTheCosineLawPutsIt) {
  const Mechanism mechanism = read_mechanism(read_source(kFolder + "dead-point.toml"));
  MotionOptions options;
  options.solve.threads = 1;
  options.to = 2;
  const MotionResult result = find_motion(mechanism, *make_cvode_tracker(), options);
  ASSERT_EQ(result.events.size(), 1U);
  const double velocity = std::numbers::pi / 3;
  EXPECT_NEAR(result.events[0].at.time, std::acos(3.0 / 8) / velocity, kSameTime);
  for (const MotionBranch& branch : result.branches) {
    EXPECT_LE(branch.ends, result.events[0].at.time + kSameTime);
  }
}

}  // namespace
}  // namespace moivre
