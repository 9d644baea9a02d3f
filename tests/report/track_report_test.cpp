// SPDX-License-Identifier: MIT
// Is a trace told row by row, and its end with the reason?
#include "moivre/report/track_report.h"

#include <gtest/gtest.h>

#include <limits>
#include <nlohmann/json.hpp>

namespace moivre::test {
namespace {

Trace hand_made_trace() {
  Trace trace;
  trace.system = {{"x"}, {2}, 2};
  trace.paths = 2;
  trace.path = 1;
  TraceStep first;
  first.x = {{1, -1}};
  TraceStep second;
  second.s = 0.5;
  second.t = {0.5, 0};
  second.x = {{std::numeric_limits<double>::infinity(), 0}};
  second.h_before = 1e-3;
  second.h_after = 1e-12;
  second.correction = 2e-3;
  second.step = 0.5;
  second.order = 2;
  trace.steps = {first, second};
  trace.end.status = PathStatus::failed;
  trace.end.failure = Failure::step_limit;
  trace.end.t = {0.5, 0};
  trace.end.count.accepted = 1;
  trace.tracker = "cvode";
  return trace;
}

TEST(TrackCsv, HasARowAStepAndLeavesInfiniteCoordinatesEmpty) {
  EXPECT_EQ(track_csv(hand_made_trace()),
            "journey,s,t.re,t.im,x.re,x.im,h_before,h_after,correction,step,order\n"
            "0,0,0,0,1,-1,0,0,0,0,0\n"
            "0,0.5,0.5,0,,0,0.001,1e-12,0.002,0.5,2\n");
}

TEST(TrackJson, GivesTheReasonOfAFailure) {
  const auto json = nlohmann::json::parse(track_json(hand_made_trace(), {"file", 3, "", ""}));
  EXPECT_EQ(json["command"], "track");
  EXPECT_EQ(json["path"], 1);
  EXPECT_EQ(json["start"]["kind"], "total-degree");
  EXPECT_EQ(json["end"]["status"], "failed");
  EXPECT_EQ(json["end"]["reason"], to_string(Failure::step_limit));
  EXPECT_TRUE(json["end"]["x"].is_null());
  ASSERT_EQ(json["steps"].size(), 2U);
  EXPECT_TRUE(json["steps"][1]["x"][0][0].is_null());
}

TEST(TrackJson, NamesAStartSystemOfOnesOwn) {
  const auto json =
      nlohmann::json::parse(track_json(hand_made_trace(), {"file", 3, "g.phc", "p.csv"}));
  EXPECT_EQ(json["start"]["kind"], "own");
  EXPECT_EQ(json["start"]["from"], "g.phc");
  EXPECT_EQ(json["start"]["points"], "p.csv");
}

TEST(TrackVerdict, IsASentence) {
  EXPECT_EQ(track_verdict(hand_made_trace()),
            "path 1: failed at t = 0.5: step limit; 1 step and 0 rejected\n");
}

}  // namespace
}  // namespace moivre::test
