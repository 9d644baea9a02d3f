// SPDX-License-Identifier: MIT
// Does a pose's text leave out what is rounding beside its lengths, and keep what is small?
#include "pose_text.h"

#include <gtest/gtest.h>

#include "moivre/mechanism/read.h"

namespace moivre {
namespace {

TEST(PoseText, HasNoRoundingBesideItsLengths) {
  const Mechanism mechanism = read_mechanism({"crank", R"toml([units]
length = "mm"
angle = "deg"
[ground.points]
O = [0, 0]
[body.crank.points]
O = [0, 0]
[[joint]]
type = "revolute"
at = ["ground.O", "crank.O"]
)toml"});
  EXPECT_EQ(pose_text(mechanism, Eigen::Vector3d(200, -4e-14, 3e-16)),
            "  crank.x   = 200 mm, y = 0 mm, phi = 0 deg\n");
  EXPECT_EQ(pose_text(mechanism, Eigen::Vector3d(1e-9, -4e-13, 0)),
            "  crank.x   = 1e-09 mm, y = -4e-13 mm, phi = 0 deg\n");
}

}  // namespace
}  // namespace moivre
