// SPDX-License-Identifier: MIT
// Which arms are tested? Those of problems/robots, and arms made from Denavit-Hartenberg
// parameters.
#pragma once

#include <array>
#include <cmath>
#include <numbers>
#include <sstream>
#include <string>

#include "moivre/arms/arm_closures.h"
#include "moivre/numeric/random.h"
#include "moivre/tracker_lanes/lane_tracker.h"
#include "moivre/urdf/read.h"

namespace moivre::test {

inline Robot robot_of(const std::string& name) {
  return read_urdf(read_source(MOIVRE_SOURCE_DIR "/problems/robots/" + name + ".urdf"));
}

inline Arm arm_of(const std::string& name, const std::string& tip,
                  const std::vector<HeldJoint>& held = {}) {
  return make_arm(robot_of(name), {std::nullopt, tip, held});
}

/// Six turning joints: each link displaced by d along the axis and a along x, then twisted by alpha
/// (degrees) about x. Those behind the `joints`-th stand still.
struct DenavitHartenberg {
  std::array<double, 6> a, d, alpha_deg;
  int joints = 6;
};

inline Robot robot_of(const DenavitHartenberg& dh) {
  std::ostringstream text;
  text.precision(17);
  text << "<robot name='dh'><link name='l0'/>";
  for (int k = 1; k <= 7; ++k) {
    text << "<link name='l" << k << "'/><joint name='j" << k << "' type='"
         << (k <= dh.joints ? "continuous" : "fixed") << "'><parent link='l" << k - 1
         << "'/><child link='l" << k << "'/>";
    if (k > 1) {
      const auto i = static_cast<std::size_t>(k - 2);
      text << "<origin xyz='" << dh.a[i] << " 0 " << dh.d[i] << "' rpy='"
           << dh.alpha_deg[i] * std::numbers::pi / 180 << " 0 0'/>";
    }
    text << "<axis xyz='0 0 1'/></joint>";
  }
  text << "</robot>";
  return read_urdf({"dh", text.str()});
}

inline Arm arm_of(const DenavitHartenberg& dh) { return make_arm(robot_of(dh), {}); }

/// Every number of every origin and axis off by up to `size`.
inline Robot disturbed(Robot robot, double size, std::uint64_t seed = 9) {
  std::uint64_t number = 0;
  for (RobotJoint& joint : robot.joints) {
    for (ExactVector* const v : {&joint.xyz, &joint.rpy, &joint.axis}) {
      for (Rational& x : *v) {
        x += Rational(size * (2 * random_unit(seed, RandomStream::test, number++) - 1));
      }
    }
  }
  return robot;
}

inline const DenavitHartenberg kPuma{
    {0, 0.4318, 0.0203, 0, 0, 0}, {0, 0, 0.15005, 0.4318, 0, 0}, {90, 0, -90, 90, -90, 0}};
inline const DenavitHartenberg kManseurDoty{
    {0.3, 1, 0, 1.5, 0, 0}, {0, 0, 0.2, 0, 0, 0}, {90, 1, 90, 1, 90, 1}};

/// Of data sheets: turning joints of a KUKA KR 6 R700, a Staubli TX2-60, an ABB IRB 120 and a
/// UFactory xArm 5.
inline const DenavitHartenberg kKr6{
    {0.025, 0.315, -0.035, 0, 0, 0}, {0.4, 0, 0, 0.365, 0, 0.08}, {-90, 0, -90, 90, -90, 0}};
inline const DenavitHartenberg kTx2{
    {0, 0.29, 0, 0, 0, 0}, {0.375, 0, 0.02, 0.31, 0, 0.07}, {-90, 0, 90, -90, 90, 0}};
inline const DenavitHartenberg kIrb120{
    {0, 0.27, 0.07, 0, 0, 0}, {0.29, 0, 0, 0.302, 0, 0.072}, {-90, 0, -90, 90, -90, 0}};
inline const DenavitHartenberg kXarm5{
    {0, 0.28949, 0.35116, 0.076, 0, 0}, {0.267, 0, 0, 0, 0.097, 0}, {-90, 0, 0, -90, 0, 0}, 5};

inline DenavitHartenberg general_arm(std::uint64_t seed) {
  DenavitHartenberg dh{};
  const auto number = [seed](std::uint64_t k) { return random_unit(seed, RandomStream::test, k); };
  for (std::size_t k = 0; k < 6; ++k) {
    dh.a[k] = 0.2 + 0.8 * number(k);
    dh.d[k] = 0.2 + 0.8 * number(k + 10);
    dh.alpha_deg[k] = 20 + 140 * number(k + 20);
  }
  return dh;
}

/// Turns anywhere, slides within half a metre.
inline Eigen::VectorXd random_values(const Arm& arm, std::uint64_t seed, std::uint64_t pose) {
  Eigen::VectorXd values(static_cast<Eigen::Index>(arm.joints.size()));
  for (Eigen::Index k = 0; k < values.size(); ++k) {
    const double unit =
        2 * random_unit(seed, RandomStream::test, pose * 100 + static_cast<std::uint64_t>(k)) - 1;
    const bool is_slide = arm.joints[static_cast<std::size_t>(k)].is_slide;
    values[k] = unit * (is_slide ? 0.5 : std::numbers::pi);
  }
  return values;
}

/// Largest difference, turns modulo whole ones.
inline double distance(const Arm& arm, const Eigen::VectorXd& a, const Eigen::VectorXd& b) {
  double largest = 0;
  for (Eigen::Index k = 0; k < a.size(); ++k) {
    const double difference = a[k] - b[k];
    const bool is_slide = arm.joints[static_cast<std::size_t>(k)].is_slide;
    largest = std::max(
        largest,
        std::abs(is_slide ? difference : std::remainder(difference, 2 * std::numbers::pi)));
  }
  return largest;
}

/// Of the closure that is nearest.
inline double least_distance(const Arm& arm, const ArmResult& result,
                             const Eigen::VectorXd& values) {
  double least = std::numeric_limits<double>::infinity();
  for (const ArmClosure& closure : result.closures) {
    least = std::min(least, distance(arm, closure.values, values));
  }
  return least;
}

/// By how much the worst closure's forward kinematics misses the pose.
inline double worst_miss(const Arm& arm, const ArmResult& result) {
  double worst = 0;
  for (const ArmClosure& closure : result.closures) {
    const Eigen::Isometry3d there = forward_kinematics(arm, closure.values);
    worst = std::max(worst, (there.matrix() - result.pose.matrix()).cwiseAbs().maxCoeff());
  }
  return worst;
}

inline const Tracker& lanes() {
  static const std::unique_ptr<Tracker> tracker = make_lane_tracker({});
  return *tracker;
}

inline SolveOptions one_thread(std::uint64_t seed = 1) {
  SolveOptions options;
  options.seed = seed;
  options.threads = 1;
  return options;
}

}  // namespace moivre::test
