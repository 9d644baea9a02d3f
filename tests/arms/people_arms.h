// SPDX-License-Identifier: MIT
// Which arms did people bring, and at which postures? Five joints, home poses, axes in line, angles
// typed to five digits; poses at singular postures and within 1e-9 to 1e-3 of them.
#pragma once

#include <gtest/gtest.h>

#include <iomanip>
#include <sstream>

#include "moivre/arms/poses.h"
#include "robots.h"

namespace moivre::test {

struct PeoplesArm {
  const char* name;
  std::vector<HeldJoint> held;
  std::vector<std::vector<double>> values;  ///< that poses are made from
  bool moves = false;  ///< the tip can stand while the joints move, at every one of these poses
};

inline const std::vector<PeoplesArm>& peoples_arms() {
  static const std::vector<PeoplesArm> arms{
      {"adept_one_four_digits", {}, {{0, 0, 0, 0}, {0.3, 0, 0.1, -0.4}}, false},
      {"bravo7",
       {},
       {{1.028, 0.551, 0.253, 0.221, 1.257, 1.387}, {0.865, 1.436, 0.387, 1.433, 0.605, 0.75}},
       false},
      {"crx10ial",
       {},
       {{2.356194490192345, 0.0, -1.5707963267948966, 1.5707963267948966, 2.356194490192345,
         -2.356194490192345}},
       true},
      {"crx10ia_three_digits",
       {},
       {{-1.5707963268, 3.1415936536, 1.5707973268, -1.5707953268, 0, -1.5707962268}},
       false},
      {"elfin5",
       {},
       {{1.4415781224, 1.8892079798, 0.0252250007, -1.8308947962, 3.141592653589793, -0.840960168},
        {3.1415926546, 1.5717963268, 3.1416026536, 3.1416926536, 3.1415926546, 0}},
       true},
      {"fiveaxis",
       {},
       {{0.1, 0.2, 0.3, 0, 0.5},
        {0.1, 0.2, 0.3, 1e-09, 0.5},
        {0.1, 0.2, 0.3, 1e-06, 0.5},
        {0.1, 0.2, 0.3, -1e-06, -1.1},
        {0.1, 0.2, 0.3, 0.001, 0.5},
        {0.1, 0.2, 0.3, 3.141592653589793, 0.5},
        {0.1, 0.2, 0.3, 3.141591653589793, 0.5}},
       false},
      {"iiwa7_six_digits",
       {{"joint_3", 0.3}},
       {{3.1425926536, -1.5706963268, 3.1415926536, -1.5697963268, -1.5707963268, -1.5707953268}},
       false},
      {"iiwa14",
       {{"joint_a7", 2.721}},
       {{1.5799575184990262, 1.4893770988454786, -1.4313939433151546, -0.9970733816555748,
         0.20949707863316602, 1.8251363904224793}},
       false},
      {"m20ia",
       {},
       {{1.650741947, 1.2045614334, -1.285740796, 1.7505745137, 3.141592653589793, 1.3112157633}},
       true},
      {"m430ia2p", {}, {{0, 0, 0, 0, 0, 0}, {0.4, 0, 0, -0.4, 0, 0}}, true},
      {"pincher_arm",
       {},
       {{0.3002, 0.9533, 0.6616, -0.6595, -0.4796},
        {0.8965, -1.1874, 0.7709, 0.713, -0.077},
        {-0.4727, -0.5318, -0.5883, -0.1318, 0.0109},
        {0.1284, 1.1892, 0.7024, 0.2932, 1.1735},
        {-0.6833, -0.8155, 0.2701, -1.0945, -1.1144},
        {0.0357, -0.0811, 1.0012, 0.3101, 0.0339}},
       false},
      {"pincher_finger",
       {},
       {{0.3287, -0.5525, -1.1017, -1.1603, 0.7518},
        {0.9906, 0.2559, 0.5508, 0.1047, 1.0442},
        {0.758, -1.1934, 0.8578, -1.1194, 0.5512},
        {-0.7784, 0.8716, 0.0995, -0.4807, -0.1856},
        {-1.132, -0.9017, 0.4095, 0.3533, 0.2769}},
       false},
      {"px150", {}, {{0.3, -0.5, 0.4, 0.6, -0.3, 0.2}}, true},
      {"railed_6dof",
       {},
       {{-1.8701892318988271, -1.5707963267948966, -1.5707963267948966, 0.0, 1.5707963267948966,
         -1.5707963267948966}},
       false},
      {"schunk_lwa4p",
       {},
       {{-0.6114129202884033, -0.864836266284267, 0.07386111100500914, 0.0012484447909621998, 0.0,
         -0.31325917849104146}},
       false},
      {"sia20", {{"joint_2", 0.3}}, {{3e-10, -8e-10, 7e-10, -8e-10, -6e-10, 4e-10}}, true},
      {"so101",
       {},
       {{0.0236, 0.9009, -0.7117, 0.8973, -0.3763},
        {-0.1533, 0.6554, -0.1816, 0.0992, -0.9449},
        {0.507, 0.0763, -0.3405, 0.5769, -0.3936},
        {-0.093, -0.7319, -0.1938, -0.5931, -0.4754},
        {0.5007, -0.4392, -0.0296, 0.9615, 0.9233}},
       false},
      {"stanford", {}, {{0, 0, 0, 0, 0, 0}, {0.5, 0.8, 0, 0.4, 0.6, -0.3}}, true},
      {"tx2_90", {}, {{0, 0, 0, 0, 0, 0}, {0, 0, 0, 0.3, 0, -0.3}}, true},
      {"tx90",
       {},
       {{1.3848149455, 2.4377942563, 1.5707959964, 1.420266775, 2.0224936922, 2.4458808162}},
       false},
      {"ur10_six_digits", {}, {{1e-05, 1.5707973, 0.001, -1.5697963, 0, 1.5708963}}, true},
      {"ur30", {}, {{0, -3e-10, -5e-10, -4e-10, -8e-10, 7e-10}}, false},
      {"ur5_ros", {}, {{0.3, -1.0, 1.2, 0.4, 0, 0.7}, {0, 0, 0, 0, 0, 0}}, true},
      {"ur5_ros",
       {},
       {{0.3, -1.0, 1.2, 0.4, 1e-09, 0.7},
        {0.3, -1.0, 1.2, 0.4, 1e-07, 0.7},
        {0.3, -1.0, 1.2, 0.4, 1e-06, 0.7},
        {0.3, -1.0, 1.2, 0.4, 1e-05, 0.7}},
       false},
      {"ur5_six_digits",
       {},
       {{-3.062280276, 0.5865107472, -2.3426011024, 2.6509925784, 3.141592653589793,
         -0.9427030638}},
       false},
      {"wx250s_horn",
       {{"elbow", -0.55}},
       {{0.329, -0.553, -1.102, -1.16, 0.752, 0.991},
        {0.028, 1.081, -0.854, 1.077, -0.452, -0.184},
        {-0.572, -0.484, 0.754, -0.979, 0.24, 0.549}},
       true},
      {"yumi",
       {{"yumi_joint_3_r", -0.3}, {"yumi_joint_7_r", 0.4}},
       {{0.3, -0.5, 0.4, 0.6, -0.3, 0.01}},
       false},
      {"zu7_four_digits",
       {},
       {{-2.2399200506, -1.8255628377, -2.9287166493, 3.0359665499, 3.141592653589793,
         1.1265836799}},
       false},
  };
  return arms;
}

inline Arm made_of(const PeoplesArm& peoples) {
  const std::string file =
      std::string(MOIVRE_SOURCE_DIR "/tests/arms/people/") + peoples.name + ".urdf";
  return make_arm(read_urdf(read_source(file)), {std::nullopt, std::nullopt, peoples.held});
}

/// That pose k is made from.
inline Eigen::VectorXd own_of(const PeoplesArm& peoples, std::size_t k = 0) {
  const std::vector<double>& values = peoples.values[k];
  return Eigen::Map<const Eigen::VectorXd>(values.data(), std::ssize(values));
}

inline bool is_told(const Arm& arm, const ArmResult& result, const Eigen::VectorXd& own,
                    double near = 1e-5) {
  if (least_distance(arm, result, own) < near) return true;
  return std::any_of(result.moves.begin(), result.moves.end(),
                     [&](const SelfMotion& set) { return is_on(arm, set, own, near); });
}

/// Of a file's first pose.
struct Answer {
  Arm arm;
  Eigen::VectorXd own;
  ArmResult result;
};

inline Answer answer_of(const std::string& name) {
  const auto peoples = std::find_if(peoples_arms().begin(), peoples_arms().end(),
                                    [&](const PeoplesArm& one) { return one.name == name; });
  Answer answer{made_of(*peoples), {}, {}};
  answer.own = own_of(*peoples);
  answer.result = find_arm_closures(answer.arm, forward_kinematics(answer.arm, answer.own), lanes(),
                                    one_thread());
  return answer;
}

/// Of all that is told the nearest posture, closure or sample of a set, is no farther.
inline bool is_shown(const Arm& arm, const ArmResult& result, const Eigen::VectorXd& own,
                     double within) {
  const auto is_near = [&](const Eigen::VectorXd& values) {
    return distance(arm, values, own) < within;
  };
  return std::any_of(result.closures.begin(), result.closures.end(),
                     [&](const ArmClosure& closure) { return is_near(closure.values); }) ||
         std::any_of(result.moves.begin(), result.moves.end(), [&](const SelfMotion& set) {
           return std::any_of(set.samples.begin(), set.samples.end(), is_near);
         });
}

/// One pose of a list: more searches from random postures would often find the posture.
inline void expect_shown(const PeoplesArm& peoples, const TypedPose& pose) {
  const Arm arm = made_of(peoples);
  const Eigen::VectorXd own = own_of(peoples);
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    SCOPED_TRACE(peoples.name + (" seed " + std::to_string(seed)));
    const ArmResult result =
        find_arm_closures(arm, std::vector{pose}, lanes(), one_thread(seed)).front();
    EXPECT_TRUE(result.complete) << result.message;
    EXPECT_TRUE(is_shown(arm, result, own, 0.5));
  }
}

/// As a file of poses with so many decimals has it.
inline TypedPose rounded_pose(const Eigen::Isometry3d& tip, int decimals) {
  const Eigen::Quaterniond turn(tip.linear());
  std::ostringstream text;
  text << std::fixed << std::setprecision(decimals);
  for (const double x : tip.translation()) text << x << ' ';
  text << turn.w() << ' ' << turn.x() << ' ' << turn.y() << ' ' << turn.z();
  return read_poses({"pose", text.str()}).front();
}

}  // namespace moivre::test
