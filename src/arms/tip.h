// SPDX-License-Identifier: MIT
// Where is the tip for these joint values, real or complex, and how does each joint move it there?
//
//   tip(q) = B_1 J_1(q_1) ... B_n J_n(q_n) T,  a rotation R (3 x 3) and a place p, of the numbers
//                                              as typed
//   screws, 6 x n: column k is the tip's velocity where joint k alone moves at speed 1. Rows 1 to
//   3: its translation relative to the arm's length; rows 4 to 6: its rotation. A slide's speed 1
//   is an arm's length.
// For complex q the same formulas hold: R is then complex orthogonal (R^T R = 1).
#pragma once

#include <Eigen/Core>
#include <cmath>
#include <numbers>

#include "moivre/arms/arm.h"
#include "moivre/numeric/complex.h"

namespace moivre {

inline constexpr int kMostJoints = 16;

template <class S>
using JointVector = Eigen::Matrix<S, Eigen::Dynamic, 1, 0, kMostJoints, 1>;
/// Of either kind of vector.
using JointValues = Eigen::Ref<const Eigen::VectorXd>;
template <class S>
using Velocity6 = Eigen::Matrix<S, 6, 1>;
template <class S>
using Screws = Eigen::Matrix<S, 6, Eigen::Dynamic, 0, 6, kMostJoints>;

template <class S>
struct Placement {
  Eigen::Matrix<S, 3, 3> R;
  Eigen::Matrix<S, 3, 1> p;
};

template <class S>
struct TipMotion {
  Placement<S> tip;
  Screws<S> screws;
};

/// Rotation about the unit axis by an angle of this cosine and sine [Rodrigues].
template <class S>
Eigen::Matrix<S, 3, 3> turn_by(const Eigen::Vector3d& a, const S& c, const S& s) {
  const S v = S(1) - c;
  Eigen::Matrix<S, 3, 3> R;
  R << a.x() * a.x() * v + c, a.x() * a.y() * v - a.z() * s, a.x() * a.z() * v + a.y() * s,
      a.y() * a.x() * v + a.z() * s, a.y() * a.y() * v + c, a.y() * a.z() * v - a.x() * s,
      a.z() * a.x() * v - a.y() * s, a.z() * a.y() * v + a.x() * s, a.z() * a.z() * v + c;
  return R;
}

template <class S>
Eigen::Matrix<S, 3, 3> turn_about(const Eigen::Vector3d& axis, const S& angle) {
  return turn_by<S>(axis, std::cos(angle), std::sin(angle));
}

/// a b, b real or not: small enough to be written out.
template <class S, class T>
Eigen::Matrix<S, 3, 3> product(const Eigen::Matrix<S, 3, 3>& a, const Eigen::Matrix<T, 3, 3>& b) {
  Eigen::Matrix<S, 3, 3> result;
  for (Eigen::Index k = 0; k < 3; ++k) {
    for (Eigen::Index i = 0; i < 3; ++i) {
      result(i, k) = a(i, 0) * b(0, k) + a(i, 1) * b(1, k) + a(i, 2) * b(2, k);
    }
  }
  return result;
}

/// R v.
template <class S>
Eigen::Matrix<S, 3, 1> at(const Eigen::Matrix<S, 3, 3>& R, const Eigen::Vector3d& v) {
  return R.col(0) * v.x() + R.col(1) * v.y() + R.col(2) * v.z();
}

/// R turn_about(axis, angle).
template <class S>
void turn(Eigen::Matrix<S, 3, 3>& R, const Eigen::Vector3d& axis, const S& angle) {
  R = product<S, S>(R, turn_about<S>(axis, angle));
}

template <class S>
TipMotion<S> tip_motion(const Arm& arm, const JointVector<S>& q) {
  using Vector = Eigen::Matrix<S, 3, 1>;
  const auto n = static_cast<Eigen::Index>(arm.joints.size());
  Eigen::Matrix<S, 3, 3> R = Eigen::Matrix<S, 3, 3>::Identity();
  Vector p = Vector::Zero();
  Eigen::Matrix<S, 3, Eigen::Dynamic, 0, 3, kMostJoints> axes(3, n), places(3, n);
  for (Eigen::Index k = 0; k < n; ++k) {
    const ArmJoint& joint = arm.joints[static_cast<std::size_t>(k)];
    const Eigen::Matrix3d before = joint.before.linear();
    p += at<S>(R, joint.before.translation());
    R = product<S, double>(R, before);
    axes.col(k) = at<S>(R, joint.axis);
    places.col(k) = p;
    if (joint.is_slide) {
      p += axes.col(k) * q[k];
    } else {
      turn(R, joint.axis, q[k]);
    }
  }
  TipMotion<S> motion;
  const Eigen::Matrix3d tool = arm.tool.linear();
  motion.tip.p = p + at<S>(R, arm.tool.translation());
  motion.tip.R = product<S, double>(R, tool);
  motion.screws.resize(6, n);
  for (Eigen::Index k = 0; k < n; ++k) {
    const Vector axis = axes.col(k);
    if (arm.joints[static_cast<std::size_t>(k)].is_slide) {
      motion.screws.col(k) << axis, Vector::Zero();
    } else {
      const Vector lever = motion.tip.p - places.col(k);
      // Eigen's cross product conjugates complex numbers.
      const Vector moved(axis.y() * lever.z() - axis.z() * lever.y(),
                         axis.z() * lever.x() - axis.x() * lever.z(),
                         axis.x() * lever.y() - axis.y() * lever.x());
      motion.screws.col(k) << moved * (1 / arm.length), axis;
    }
  }
  return motion;
}

template <>
TipMotion<double> tip_motion<double>(const Arm& arm, const JointVector<double>& q);

/// From `from` to `to`, to first order: translation relative to the arm's length, rotation.
template <class S>
Velocity6<S> small_difference(const Arm& arm, const Placement<S>& to, const Placement<S>& from) {
  const Eigen::Matrix<S, 3, 3> E = to.R * from.R.transpose();
  Velocity6<S> difference;
  difference << (to.p - from.p) / arm.length, (E(2, 1) - E(1, 2)) / 2.0, (E(0, 2) - E(2, 0)) / 2.0,
      (E(1, 0) - E(0, 1)) / 2.0;
  return difference;
}

/// In the joints' own units, of a step in radians and arm's lengths.
template <class S>
JointVector<S> in_joints(const Arm& arm, JointVector<S> step) {
  for (Eigen::Index k = 0; k < step.size(); ++k) {
    if (arm.joints[static_cast<std::size_t>(k)].is_slide) step[k] *= arm.length;
  }
  return step;
}

/// The same turn in (-pi, pi], a half turn from either side as pi.
inline double reduced_turn(double value) {
  constexpr double kRounded = 1e-12;
  if (!(std::abs(value) < std::numbers::pi)) value = std::remainder(value, 2 * std::numbers::pi);
  return value <= -std::numbers::pi + kRounded ? std::numbers::pi : value;
}

/// Of one joint from a to b, turns modulo whole ones, in radians or arm's lengths.
inline double joint_way(const Arm& arm, const JointValues& a, const JointValues& b,
                        Eigen::Index k) {
  const double way = b[k] - a[k];
  if (arm.joints[static_cast<std::size_t>(k)].is_slide) return way / arm.length;
  return std::abs(way) < std::numbers::pi ? way : std::remainder(way, 2 * std::numbers::pi);
}

/// Of all joints.
inline JointVector<double> way_between(const Arm& arm, const JointValues& a, const JointValues& b) {
  JointVector<double> way(a.size());
  for (Eigen::Index k = 0; k < way.size(); ++k) way[k] = joint_way(arm, a, b, k);
  return way;
}

}  // namespace moivre
