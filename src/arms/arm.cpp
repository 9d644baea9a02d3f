// SPDX-License-Identifier: MIT
// The way from the base to the tip, joint by joint; what is wrong with a choice of links and held
// joints.
#include "moivre/arms/arm.h"

#include <cmath>

#include "exact_motion.h"
#include "moivre/arms/rules.h"
#include "moivre/expression/joined.h"
#include "moivre/numeric/invalid_input.h"
#include "moivre/urdf/choice.h"
#include "moivre/urdf/placement.h"
#include "typed_displacement.h"

namespace moivre {
namespace {

constexpr std::size_t kMostFree = 6;

/// A joint that is passed, and which way.
struct Passage {
  std::size_t joint = 0;
  bool is_backwards = false;  ///< from the child to the parent
};

/// Joints from the link up to the root.
std::vector<std::size_t> way_up(const Robot& robot, std::size_t link) {
  std::vector<std::size_t> joints;
  while (robot.links[link].joint) {
    joints.push_back(*robot.links[link].joint);
    link = robot.joints[joints.back()].parent;
  }
  return joints;
}

std::vector<Passage> way(const Robot& robot, std::size_t base, std::size_t tip) {
  std::vector<std::size_t> up = way_up(robot, base);
  std::vector<std::size_t> down = way_up(robot, tip);
  while (!up.empty() && !down.empty() && up.back() == down.back()) {
    up.pop_back();
    down.pop_back();
  }
  std::vector<Passage> passages;
  for (const std::size_t joint : up) passages.push_back({joint, true});
  for (auto joint = down.rbegin(); joint != down.rend(); ++joint) {
    passages.push_back({*joint, false});
  }
  return passages;
}

/// The joint that it follows through any number of others.
std::size_t leader_of(const Robot& robot, std::size_t joint) {
  while (robot.joints[joint].mimic) joint = robot.joints[joint].mimic->leader;
  return joint;
}

void check_mimics(const Robot& robot, const std::vector<std::size_t>& free,
                  std::vector<std::string>& faults) {
  for (std::size_t k = 0; k < free.size(); ++k) {
    for (std::size_t j = 0; j < k; ++j) {
      if (leader_of(robot, free[j]) != leader_of(robot, free[k])) continue;
      faults.push_back("joints '" + robot.joints[free[j]].name + "' and '" +
                       robot.joints[free[k]].name +
                       "' move together (mimic) and are both in the chain, which is not "
                       "supported; hold one of them by `held`");
    }
  }
}

void check_free(const Robot& robot, const std::vector<std::size_t>& free,
                std::vector<std::string>& faults) {
  std::vector<std::string> names;
  for (const std::size_t joint : free) names.push_back(robot.joints[joint].name);
  if (free.empty()) faults.emplace_back("no joint between base and tip is free to move");
  if (free.size() > kMostFree) {
    faults.push_back(
        "there are " + std::to_string(free.size()) +
        " free joints; with more than six the arm can move while the tip stands. Hold " +
        std::to_string(free.size() - kMostFree) + " of them by `held`: " + listed_names(names));
  }
}

/// A chain while it is walked: what has been passed since the last free joint.
struct Walk {
  Eigen::Isometry3d transform = Eigen::Isometry3d::Identity();
  ExactDisplacement exact = ExactDisplacement::identity();

  void pass(const Eigen::Isometry3d& by, const ExactDisplacement& exact_by, bool is_backwards) {
    transform = transform * (is_backwards ? by.inverse() : by);
    exact = reduced(exact * (is_backwards ? conjugate(exact_by) : exact_by));
  }
};

Eigen::Isometry3d origin_of(const RobotJoint& joint) {
  Eigen::Isometry3d origin = Eigen::Isometry3d::Identity();
  origin.translate(to_vector(joint.xyz));
  origin.rotate(rotation(joint.rpy));
  return origin;
}

Eigen::Isometry3d moved(const Eigen::Vector3d& axis, bool is_slide, double value) {
  Eigen::Isometry3d move = Eigen::Isometry3d::Identity();
  if (is_slide) {
    move.translate(value * axis);
  } else {
    move.rotate(Eigen::AngleAxisd(value, axis));
  }
  return move;
}

ArmJoint free_joint(const RobotJoint& joint, const Walk& walk, bool is_backwards) {
  ArmJoint free;
  free.name = joint.name;
  free.is_slide = joint.type == RobotJointType::prismatic;
  free.limits = joint.limits;
  free.before = walk.transform;
  free.exact_before = exact_motion(walk.exact);
  const double sign = is_backwards ? -1 : 1;
  free.axis = sign * to_vector(joint.axis).stableNormalized();
  const ExactDisplacement step = exact_step(joint.axis, free.is_slide);
  free.exact_length = exact_length(step, free.is_slide);
  free.step = exact_motion(is_backwards ? conjugate(step) : step);
  return free;
}

/// By how much a typed number may differ from the one that is meant. Numbers of few decimals are
/// meant as they stand.
double rounding_of(const Rational& number, bool is_angle) {
  constexpr int kFewDecimals = 3;
  if (is_angle) {
    if (const auto missed = missed_right_angle(number)) return *missed;
  }
  const int typed = decimals(number);
  return typed > kFewDecimals ? 0.5 * std::pow(10, -typed) : 0;
}

/// What the typed numbers of a joint leave open, radians and metres.
struct Rounding {
  double angle = 0, length = 0;
};
Rounding rounding_of(const RobotJoint& joint) {
  Rounding rounding;
  for (const Rational& x : joint.rpy) rounding.angle += rounding_of(x, true);
  for (const Rational& x : joint.xyz) rounding.length += rounding_of(x, false);
  return rounding;
}

/// Passes a joint that does not move, and the origin of one that does; that one is added to the
/// arm.
void pass(const Robot& robot, const Passage& passage, const std::vector<HeldJoint>& held, Arm& arm,
          Walk& walk) {
  const RobotJoint& joint = robot.joints[passage.joint];
  const Eigen::Isometry3d origin = origin_of(joint);
  const ExactDisplacement exact = exact_origin(joint.xyz, joint.rpy);
  arm.length += origin.translation().norm();
  if (!passage.is_backwards) walk.pass(origin, exact, false);
  if (is_moving(joint)) {
    const bool is_slide = joint.type == RobotJointType::prismatic;
    if (const auto value = held_value(robot, passage.joint, held)) {
      walk.pass(moved(to_vector(joint.axis).stableNormalized(), is_slide, *value),
                is_slide ? exact_slide(joint.axis, *value) : exact_turn(joint.axis, *value),
                passage.is_backwards);
      const bool is_beyond =
          joint.limits && (*value < joint.limits->lower || *value > joint.limits->upper);
      arm.held.push_back({joint.name, *value, is_beyond});
      if (is_slide) arm.length += std::abs(*value);
    } else {
      arm.joints.push_back(free_joint(joint, walk, passage.is_backwards));
      walk = {};
      const bool has_ends = is_slide && joint.limits;
      if (has_ends) {
        arm.length += std::max(std::abs(joint.limits->lower), std::abs(joint.limits->upper));
      }
    }
  }
  if (passage.is_backwards) walk.pass(origin, exact, true);
}

}  // namespace

Arm make_arm(const Robot& robot, const ArmChoice& choice) {
  require_unbroken(broken_rules(robot));
  std::vector<std::string> faults;
  check_held(robot, choice.held, faults);
  const std::size_t base = find_link(robot, choice.base, robot.root, faults);
  const std::size_t tip = find_tip(robot, choice.tip, faults);
  require_unbroken(faults);
  const std::vector<Passage> passages = way(robot, base, tip);
  std::vector<std::size_t> free;
  for (const Passage& passage : passages) {
    const bool is_free =
        is_moving(robot.joints[passage.joint]) && !held_value(robot, passage.joint, choice.held);
    if (is_free) free.push_back(passage.joint);
  }
  check_free(robot, free, faults);
  check_mimics(robot, free, faults);
  require_unbroken(faults);

  Arm arm;
  arm.robot = robot.name;
  arm.base = robot.links[base].name;
  arm.tip = robot.links[tip].name;
  arm.length = 0;
  Walk walk;
  Rounding rounding;
  for (const Passage& passage : passages) {
    pass(robot, passage, choice.held, arm, walk);
    const Rounding own = rounding_of(robot.joints[passage.joint]);
    rounding.angle += own.angle;
    rounding.length += own.length;
  }
  arm.tool = walk.transform;
  arm.exact_tool = exact_motion(walk.exact);
  if (arm.length == 0) arm.length = 1;
  arm.rounding = rounding.angle + rounding.length / arm.length;
  return arm;
}

bool has_slides(const Arm& arm) {
  return std::any_of(arm.joints.begin(), arm.joints.end(),
                     [](const ArmJoint& joint) { return joint.is_slide; });
}

std::vector<Eigen::Isometry3d> joint_frames(const Arm& arm, const Eigen::VectorXd& values) {
  require_values(arm, values);
  std::vector<Eigen::Isometry3d> frames;
  Eigen::Isometry3d frame = Eigen::Isometry3d::Identity();
  Eigen::Index k = 0;
  for (const ArmJoint& joint : arm.joints) {
    frame = frame * joint.before * moved(joint.axis, joint.is_slide, values[k++]);
    frames.push_back(frame);
  }
  return frames;
}

Eigen::Isometry3d forward_kinematics(const Arm& arm, const Eigen::VectorXd& values) {
  const std::vector<Eigen::Isometry3d> frames = joint_frames(arm, values);
  return frames.empty() ? arm.tool : frames.back() * arm.tool;
}

}  // namespace moivre
