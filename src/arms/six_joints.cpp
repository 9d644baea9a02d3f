// SPDX-License-Identifier: MIT
// Ranks at random postures; joints taken into the displacement behind them; a wrist behind the last
// joint, or axes anywhere.
#include "six_joints.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "exact_motion.h"
#include "moivre/factorization/svd.h"
#include "moivre/urdf/placement.h"
#include "random_values.h"
#include "tip.h"
#include "typed_displacement.h"

namespace moivre {
namespace {

constexpr std::size_t kSix = 6;

Eigen::MatrixXd random_screws(const Arm& arm, std::uint64_t seed, std::uint64_t number) {
  return tip_motion<double>(arm, random_joint_values(arm, seed, number)).screws;
}

Eigen::MatrixXd without(const Eigen::MatrixXd& screws, const std::vector<std::size_t>& left_out) {
  Eigen::MatrixXd kept(screws.rows(), screws.cols() - std::ssize(left_out));
  Eigen::Index column = 0;
  for (Eigen::Index k = 0; k < screws.cols(); ++k) {
    const auto joint = static_cast<std::size_t>(k);
    if (std::find(left_out.begin(), left_out.end(), joint) != left_out.end()) continue;
    kept.col(column++) = screws.col(k);
  }
  return kept;
}

/// Takes the joint at `value` into what is behind it.
void hold(Arm& arm, std::size_t joint, double value) {
  const ArmJoint& held = arm.joints[joint];
  Eigen::Isometry3d by = held.before;
  ExactDisplacement exact = *held.exact_before;
  if (held.is_slide) {
    by.translate(value * held.axis);
  } else {
    by.rotate(Eigen::AngleAxisd(value, held.axis));
  }
  const ExactVector axis{Rational(held.axis.x()), Rational(held.axis.y()), Rational(held.axis.z())};
  exact = exact * (held.is_slide ? exact_slide(axis, value) : exact_turn(axis, value));
  const bool is_last = joint + 1 == arm.joints.size();
  Eigen::Isometry3d& behind = is_last ? arm.tool : arm.joints[joint + 1].before;
  ExactPointer& exact_behind = is_last ? arm.exact_tool : arm.joints[joint + 1].exact_before;
  behind = by * behind;
  exact_behind = exact_motion(reduced(exact * *exact_behind));
  arm.joints.erase(arm.joints.begin() + static_cast<std::ptrdiff_t>(joint));
}

/// Whole sixty-fourths, so that typed and exact numbers are the same.
Rational random_number(std::uint64_t seed, std::uint64_t index, double size) {
  constexpr int kParts = 64;
  constexpr std::uint64_t kBehindOthers = 4000;
  const double unit = 2 * random_unit(seed, RandomStream::arm, kBehindOthers + index) - 1;
  return ratio(Integer(std::llround(kParts * size * unit)), Integer(kParts));
}

/// A turn about a random axis behind the last joint: the tip is where it was while the turn stands
/// at 0.
void add_joint(Arm& arm, const ExactVector& place, std::uint64_t seed, std::uint64_t index) {
  ExactVector axis;
  for (Rational& x : axis) x = random_number(seed, index++, 1);
  axis[static_cast<std::size_t>(index % 3)] += 1;
  Eigen::Isometry3d shift = Eigen::Isometry3d::Identity();
  shift.translate(to_vector(place));
  const ExactDisplacement exact_shift = exact_origin(place, {});
  ArmJoint& added = arm.joints.emplace_back();
  added.before = shift;
  added.exact_before = exact_motion(exact_shift);
  added.axis = to_vector(axis).normalized();
  added.step = exact_motion(exact_step(axis, false));
  added.exact_length = exact_length(*added.step, false);
  arm.tool = shift.inverse() * arm.tool;
  arm.exact_tool = exact_motion(reduced(conjugate(exact_shift) * *arm.exact_tool));
}

/// Axes through a point of the last joint's axis, which make a wrist with it; or axes anywhere.
enum class AddedAxes { of_wrist, anywhere };

/// A point of the last joint's axis, where a wrist of it and added turns may have its centre. Two
/// turns of the arm's own that meet make a wrist with one; with two, the centre is where no posture
/// that people like has it above a joint of the arm.
ExactVector centre_of_wrist(const Arm& arm, double size, std::uint64_t seed) {
  constexpr std::uint64_t kBehindAxes = 128;
  const ArmJoint& last = arm.joints.back();
  if (arm.joints.size() + 1 >= kSix || last.is_slide) return {};
  const Rational unit(std::ldexp(1.0, std::ilogb(size / last.exact_length)));
  const Rational along = random_number(seed, kBehindAxes, 1) * unit;
  ExactVector centre;
  for (std::size_t k = 0; k < centre.size(); ++k)
    centre[k] = along * ratio(last.step->q[k + 1], Integer(1));
  return centre;
}

void complete(Arm& arm, AddedAxes axes, std::uint64_t seed) {
  const double size = std::ldexp(1.0, std::ilogb(arm.length));
  // In the frame of the joint before, which stands at the centre once one is added.
  ExactVector centre = centre_of_wrist(arm, size / 2, seed);
  while (arm.joints.size() < kSix) {
    std::uint64_t index = 16 * arm.joints.size();
    ExactVector place = std::exchange(centre, ExactVector{});
    for (Rational& x : place) {
      if (axes == AddedAxes::anywhere) x = random_number(seed, index, 1) * Rational(size / 2);
      ++index;
    }
    add_joint(arm, place, seed, index);
  }
}

}  // namespace

std::vector<std::size_t> idle_in_every_posture(const Arm& arm, std::uint64_t seed,
                                               double tolerance) {
  constexpr std::uint64_t kPostures = 30, kBehindOthers = 700;
  std::vector<std::size_t> idle;
  while (idle.size() + 1 < arm.joints.size()) {
    Eigen::VectorXd still;
    bool is_moving = true;
    for (std::uint64_t k = 0; k < kPostures && is_moving; ++k) {
      const Eigen::MatrixXd screws = without(random_screws(arm, seed, kBehindOthers + k), idle);
      const Svd stretch = svd(screws, SingularVectors::full);
      const bool is_wide = screws.cols() > screws.rows();
      is_moving = is_wide || stretch.sigma[screws.cols() - 1] <= tolerance * stretch.sigma[0];
      still = stretch.V.col(screws.cols() - 1);
    }
    if (!is_moving) break;
    Eigen::Index most = 0;
    still.cwiseAbs().maxCoeff(&most);
    // The number in the arm of the joint that takes part most, of those that are left.
    std::size_t joint = 0;
    for (Eigen::Index left = -1; joint < arm.joints.size(); ++joint) {
      if (std::find(idle.begin(), idle.end(), joint) == idle.end() && ++left == most) break;
    }
    idle.push_back(joint);
  }
  std::sort(idle.begin(), idle.end());
  return idle;
}

namespace {

/// With a wrist: few paths lead to its closures. Not where it turns only what the arm turns, too,
/// and what the arm leaves out stays left out.
Arm completed(const Arm& arm, std::uint64_t seed) {
  constexpr double kDeficient = 1e-6;
  Arm with_wrist = arm;
  complete(with_wrist, AddedAxes::of_wrist, seed);
  if (idle_in_every_posture(with_wrist, seed, kDeficient).empty()) return with_wrist;
  Arm with_any = arm;
  complete(with_any, AddedAxes::anywhere, seed);
  return with_any;
}

}  // namespace

SixJoints six_joints(const Arm& arm, const std::vector<std::size_t>& held,
                     const Eigen::VectorXd& held_values, std::uint64_t seed) {
  SixJoints six;
  six.arm = arm;
  six.held = held;
  six.held_values = Eigen::VectorXd::Zero(std::ssize(arm.joints));
  for (std::size_t k = 0; k < arm.joints.size(); ++k) {
    if (std::find(held.begin(), held.end(), k) == held.end()) six.own.push_back(k);
  }
  for (auto joint = held.rbegin(); joint != held.rend(); ++joint) {
    const double value = held_values[static_cast<Eigen::Index>(*joint)];
    six.held_values[static_cast<Eigen::Index>(*joint)] = value;
    hold(six.arm, *joint, value);
  }
  if (six.arm.joints.size() < kSix) six.arm = completed(six.arm, seed);
  return six;
}

Eigen::VectorXd own_values(const SixJoints& six, const Eigen::VectorXd& values) {
  Eigen::VectorXd own = six.held_values;
  for (std::size_t k = 0; k < six.own.size(); ++k) {
    own[static_cast<Eigen::Index>(six.own[k])] = values[static_cast<Eigen::Index>(k)];
  }
  return own;
}

}  // namespace moivre
