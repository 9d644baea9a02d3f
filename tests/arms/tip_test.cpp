// SPDX-License-Identifier: MIT
// Do real joint values, whose cosines and sines are found together, move the tip as complex ones
// do, near quarter turns and after many of them too?
#include "../../src/arms/tip.h"

#include <gtest/gtest.h>

#include <array>

#include "robots.h"

namespace moivre::test {
namespace {

void expect_same_motion(const Arm& arm, const JointVector<double>& values) {
  const TipMotion<double> real = tip_motion<double>(arm, values);
  const TipMotion<Complex> complex = tip_motion<Complex>(arm, values.cast<Complex>());
  constexpr double kLastBits = 4e-15;
  EXPECT_LT((real.tip.R - complex.tip.R.real()).cwiseAbs().maxCoeff(), kLastBits);
  EXPECT_LT((real.tip.p - complex.tip.p.real()).cwiseAbs().maxCoeff(), kLastBits * arm.length);
  EXPECT_LT((real.screws - complex.screws.real()).cwiseAbs().maxCoeff(), kLastBits);
}

TEST(TipTest, RealValuesMoveItAsComplexOnesDo) {
  constexpr std::array<double, 6> kBeside{0, 1e-300, 1e-17, 1e-9, 1e-3, 0.4};
  constexpr std::array<double, 5> kTurns{0, 1, 1000, 60'000, 1e9};  // the last ones are far
  for (const Arm& arm : {arm_of(kPuma), arm_of("ur5", "tool0")}) {
    for (std::uint64_t k = 0; k < 100; ++k) expect_same_motion(arm, random_values(arm, 3, k));
    for (const double beside : kBeside) {
      for (const double turns : kTurns) {
        JointVector<double> values(6);
        for (int k = 0; k < 6; ++k) {
          values[k] = (k % 2 == 0 ? 1 : -1) * (turns + k) * std::numbers::pi / 2 + beside;
        }
        expect_same_motion(arm, values);
      }
    }
  }
}

TEST(TipTest, WhatIsNotFiniteStaysSo) {
  const Arm arm = arm_of(kPuma);
  JointVector<double> values = JointVector<double>::Zero(6);
  values[3] = std::numeric_limits<double>::infinity();
  EXPECT_FALSE(tip_motion<double>(arm, values).tip.R.allFinite());
}

}  // namespace
}  // namespace moivre::test
