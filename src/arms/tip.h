// SPDX-License-Identifier: MIT
// Where is the tip for these joint values, real or complex, and how does each joint move it there?
//
//   tip(q) = B_1 J_1(q_1) ... B_n J_n(q_n) T,  a rotation R (3 x 3) and a place p, of the numbers as typed
//   screws, 6 x n: column k is the tip's velocity where joint k alone moves at speed 1. Rows 1 to 3: its translation beside the
//   arm's length; rows 4 to 6: its rotation. A slide's speed 1 is an arm's length.
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

/// Rotation by `angle` about the unit axis [Rodrigues].
template <class S>
Eigen::Matrix<S, 3, 3> turn_about(const Eigen::Vector3d& a, const S& angle) {
  const S s = std::sin(angle);
  const S c = std::cos(angle);
  const S v = S(1) - c;
  Eigen::Matrix<S, 3, 3> R;
  R << a.x() * a.x() * v + c, a.x() * a.y() * v - a.z() * s, a.x() * a.z() * v + a.y() * s,
      a.y() * a.x() * v + a.z() * s, a.y() * a.y() * v + c, a.y() * a.z() * v - a.x() * s,
      a.z() * a.x() * v - a.y() * s, a.z() * a.y() * v + a.x() * s, a.z() * a.z() * v + c;
  return R;
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
    p += R * joint.before.translation().cast<S>();
    R = (R * joint.before.linear().cast<S>()).eval();
    axes.col(k) = R * joint.axis.cast<S>();
    places.col(k) = p;
    if (joint.is_slide) {
      p += axes.col(k) * q[k];
    } else {
      R = (R * turn_about<S>(joint.axis, q[k])).eval();
    }
  }
  TipMotion<S> motion;
  motion.tip.p = p + R * arm.tool.translation().cast<S>();
  motion.tip.R = R * arm.tool.linear().cast<S>();
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
      motion.screws.col(k) << moved / arm.length, axis;
    }
  }
  return motion;
}

/// From `from` to `to`, to first order: translation beside the arm's length, rotation.
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

/// From a to b, turns modulo whole ones, in radians and arm's lengths.
inline Eigen::VectorXd way_between(const Arm& arm, const Eigen::VectorXd& a,
                                   const Eigen::VectorXd& b) {
  Eigen::VectorXd way = b - a;
  for (Eigen::Index k = 0; k < way.size(); ++k) {
    const bool is_slide = arm.joints[static_cast<std::size_t>(k)].is_slide;
    way[k] = is_slide ? way[k] / arm.length : std::remainder(way[k], 2 * std::numbers::pi);
  }
  return way;
}

}  // namespace moivre
