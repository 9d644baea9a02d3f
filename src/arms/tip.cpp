// SPDX-License-Identifier: MIT
// Real joint values, of which most are: nothing is multiplied by 0, nor kept twice.
#include "tip.h"

namespace moivre {
namespace {

/// R b, of numbers in a row: many of a typed displacement are 0.
inline void combine(const Eigen::Matrix3d& R, const double* b, double* v) {
  const double* const r = R.data();
  v[0] = v[1] = v[2] = 0;
  for (int k = 0; k < 3; ++k) {
    if (b[k] == 0) continue;
    for (int i = 0; i < 3; ++i) v[i] += r[3 * k + i] * b[k];
  }
}

}  // namespace

template <>
TipMotion<double> tip_motion<double>(const Arm& arm, const JointVector<double>& q) {
  constexpr Eigen::Index kColumn = 4;  // of a displacement's numbers
  const auto n = static_cast<Eigen::Index>(arm.joints.size());
  TipMotion<double> motion;
  motion.screws.resize(6, n);
  Eigen::Matrix3d& R = motion.tip.R;
  Eigen::Vector3d& p = motion.tip.p;
  R.setIdentity();
  p.setZero();
  const auto go = [&](const Eigen::Isometry3d& displacement) {
    const double* const by = displacement.data();
    Eigen::Vector3d shift;
    combine(R, by + 3 * kColumn, shift.data());
    p += shift;
    Eigen::Matrix3d next;
    for (Eigen::Index k = 0; k < 3; ++k) combine(R, by + k * kColumn, next.col(k).data());
    R = next;
  };
  for (Eigen::Index k = 0; k < n; ++k) {
    const ArmJoint& joint = arm.joints[static_cast<std::size_t>(k)];
    go(joint.before);
    Eigen::Vector3d axis;
    combine(R, joint.axis.data(), axis.data());
    // A turn's place, until the tip's is known.
    motion.screws.col(k) << (joint.is_slide ? axis : p), axis;
    if (joint.is_slide) {
      p += axis * q[k];
      motion.screws.col(k).tail<3>().setZero();
    } else {
      turn(R, joint.axis, q[k]);
    }
  }
  go(arm.tool);
  const double share = 1 / arm.length;
  for (Eigen::Index k = 0; k < n; ++k) {
    if (arm.joints[static_cast<std::size_t>(k)].is_slide) continue;
    double* const screw = motion.screws.data() + 6 * k;
    const double x = p.x() - screw[0], y = p.y() - screw[1], z = p.z() - screw[2];
    screw[0] = (screw[4] * z - screw[5] * y) * share;
    screw[1] = (screw[5] * x - screw[3] * z) * share;
    screw[2] = (screw[3] * y - screw[4] * x) * share;
  }
  return motion;
}

}  // namespace moivre
