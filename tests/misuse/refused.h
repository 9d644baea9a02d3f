// SPDX-License-Identifier: MIT
// With which words is a wrong call refused? And what every test of it needs.
#pragma once

#include <gtest/gtest.h>

#include <limits>
#include <memory>
#include <string>

#include "moivre/numeric/invalid_input.h"
#include "moivre/tracker_cvode/cvode_tracker.h"
#include "moivre/tracker_lanes/lane_tracker.h"

namespace moivre::test {

inline constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
inline constexpr double kInfinity = std::numeric_limits<double>::infinity();

inline const Tracker& cvode() {
  static const std::unique_ptr<Tracker> tracker = make_cvode_tracker();
  return *tracker;
}

inline const Tracker& lanes() {
  static const std::unique_ptr<Tracker> tracker = make_lane_tracker();
  return *tracker;
}

/// The message; "not refused" where nothing was thrown. Any other exception fails the test.
template <class Call>
std::string refusal_of(const Call& call) {
  try {
    call();
  } catch (const InvalidInput& refusal) {
    return refusal.what();
  }
  return "not refused";
}

template <class Call>
void expect_refused(const Call& call, const std::string& word) {
  const std::string refusal = refusal_of(call);
  EXPECT_NE(refusal.find(word), std::string::npos) << refusal;
  EXPECT_EQ(refusal.find("--"), std::string::npos) << "the command line's words: " << refusal;
}

}  // namespace moivre::test
