// SPDX-License-Identifier: MIT
// Which bodies turn about a line while everything else stands, and does the row that holds them leave one pose of all?
#include "moivre/mechanism/spins.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include "files.h"
#include "moivre/mechanism/phi.h"
#include "moivre/mechanism/pose.h"

namespace moivre {
namespace {

using Eigen::VectorXd;
using test::typed;

Mechanism held(const char* text) {
  Mechanism mechanism = typed(text);
  mechanism.held_spins = find_spins(mechanism);
  return mechanism;
}

TEST(Spins, AreOfABodyThatTwoBallsAloneTieToOthers) {
  const Mechanism mechanism = typed(test::kSpinningCoupler);
  const std::vector<Spin> spins = find_spins(mechanism);
  ASSERT_EQ(spins.size(), 1U);
  EXPECT_EQ(mechanism.bodies[spins[0].body].name, "coupler");
  EXPECT_EQ(spins[0].line[0].body, spins[0].body);
  EXPECT_EQ(spins[0].line[1].body, spins[0].body);
}

TEST(Spins, AreNotOfABodyWithAThirdJointOrADrivenPoint) {
  const std::string text = test::kSpinningCoupler;
  EXPECT_TRUE(find_spins(typed(text + "[[joint]]\ntype = \"point-on-plane\"\nat = [\"ground.O4\", "
                                      "\"coupler.B\"]\naxis = [0, 0, 1]\n"))
                  .empty());
  EXPECT_TRUE(find_spins(typed(text + "[[driver]]\nx = \"coupler.B\"\nstart = 1\n")).empty());
  EXPECT_TRUE(find_spins(test::example("rssr")).empty());
  EXPECT_TRUE(find_spins(test::example("four-bar")).empty());
}

TEST(Spins, HaveOneRowThatTheTurnAloneChanges) {
  const Mechanism mechanism = held(test::kSpinningCoupler);
  const Phi phi(mechanism);
  ASSERT_EQ(phi.size(), Phi(typed(test::kSpinningCoupler)).size() + 1);
  const Eigen::Index row = phi.size() - phi.driver_size() - 1;
  EXPECT_EQ(phi.row_names()[static_cast<std::size_t>(row)], "spin of coupler");
  VectorXd q = VectorXd::Zero(phi.dimension());
  EXPECT_EQ(phi.value(q, 0)[row], 0) << "as drawn";
  // Turned about its line, which is drawn along x, by every angle: the row vanishes at two of them, half a turn apart.
  int changes = 0;
  double before = 0;
  for (int k = 1; k <= 100; ++k) {
    q[9] = 0.0628 * k - 2;
    const double value = phi.value(q, 0)[row];
    changes += before * value < 0 ? 1 : 0;
    before = value;
  }
  EXPECT_EQ(changes, 2);
}

}  // namespace
}  // namespace moivre
