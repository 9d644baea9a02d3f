// SPDX-License-Identifier: MIT
// Does the table of joint types say what Phi holds? Rows and freedoms of each, and the thread of a
// screw.
#include "moivre/mechanism/joint_type.h"

#include <gtest/gtest.h>

#include <numbers>

#include "files.h"
#include "moivre/mechanism/driven_joint.h"
#include "moivre/mechanism/phi.h"

namespace moivre {
namespace {

Mechanism two_bodies(JointType type, Space space) {
  Mechanism mechanism;
  mechanism.space = space;
  mechanism.bodies[0].points.push_back({"A", {1, 2, 0}, {}});
  mechanism.bodies.push_back({"b", {{"B", {0.5, 0, 0}, {}}}, {}});
  Joint joint;
  joint.type = type;
  joint.name = "J";
  joint.at = {PointOf{0, 0}, PointOf{1, 0}};
  joint.pitch = 0.1;
  joint.radius = 1;
  joint.gear.radii = {1, 1};
  joint.profile = periodic_spline({0, 2, 4, 2 * std::numbers::pi}, {0, 1, 1, 0});
  mechanism.joints.push_back(joint);
  return mechanism;
}

TEST(JointTypes, LeaveSixOrThreeFreedomsMinusTheirRowsOfPhi) {
  for (const JointTraits& type : all_joint_types()) {
    for (const Space space : {Space::planar, Space::spatial}) {
      if (!exists_in(space, type)) {
        EXPECT_THROW(freedoms(type.type, space), std::logic_error) << type.name;
        continue;
      }
      const auto rows = static_cast<int>(Phi(two_bodies(type.type, space)).size());
      EXPECT_EQ(freedoms(type.type, space), (space == Space::planar ? 3 : 6) - rows) << type.name;
    }
  }
}

TEST(JointTypes, StandInTheOrderOfTheirEnumeration) {
  for (std::size_t k = 0; k < all_joint_types().size(); ++k) {
    EXPECT_EQ(static_cast<std::size_t>(all_joint_types()[k].type), k);
  }
}

const std::string kJack = R"toml(
space = "spatial"
[ground.points]
O = [0, 0, 0]
[body.nut.points]
O = [0, 0, 0]
[[joint]]
type = "screw"
at = ["ground.O", "nut.O"]
axis = [0, 0, 1]
pitch = 0.5
name = "thread"
[[driver]]
)toml";

TEST(AScrew, GoesOnByItsPitchInAWholeTurn) {
  constexpr double kTwoTurnsAndMore = 4.5 * std::numbers::pi;
  for (const bool by_slide : {false, true}) {
    const double advance = 0.5 * kTwoTurnsAndMore / (2 * std::numbers::pi);
    const Mechanism jack =
        test::typed(kJack + (by_slide ? "slide = \"thread\"\nstart = " + std::to_string(advance)
                                      : "angle = \"thread\"\nstart = 14.137166941154069"));
    const DrivenJoint driven = driven_joint(jack, 0, 0);
    EXPECT_NEAR(driven.angle.value(), kTwoTurnsAndMore, 1e-5);
    EXPECT_NEAR(driven.slide.value(), advance, 1e-5);
    Eigen::VectorXd q = Eigen::VectorXd::Zero(6);
    q[2] = driven.slide.value();
    q[5] = std::numbers::pi / 2;
    EXPECT_LT(Phi(jack).value(q, 0).norm(), 1e-5);
    q[2] += 0.5;  // a whole turn on: the thread holds, the driver does not
    const Eigen::VectorXd beside = Phi(jack).value(q, 0);
    EXPECT_LT(beside.head(5).norm(), 1e-5);
    EXPECT_GT(std::abs(beside[5]), 0.1);
  }
}

}  // namespace
}  // namespace moivre
