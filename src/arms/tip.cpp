// SPDX-License-Identifier: MIT
// Real joint values, of which most are: columns of four numbers, which processors take by twos.
#include "tip.h"

namespace moivre {
namespace {

using Column = Eigen::Vector4d;  // its last number is 0
struct Columns {
  Column x = Column::UnitX(), y = Column::UnitY(), z = Column::UnitZ();
};

/// R b, of numbers in a row.
inline Column combined(const Columns& R, const double* b) {
  return R.x * b[0] + R.y * b[1] + R.z * b[2];
}

inline void put(const Column& from, double* to) {
  for (int i = 0; i < 3; ++i) to[i] = from[i];
}

/// Columns x and y of R, turned about the third one.
inline void turn(Column& x, Column& y, double c, double s) {
  const Column before = x;
  x = c * before + s * y;
  y = c * y - s * before;
}

inline void turn(Columns& R, const Eigen::Vector3d& axis, double angle) {
  const double s = std::sin(angle), c = std::cos(angle);
  if (std::abs(axis.z()) == 1) {
    turn(R.x, R.y, c, axis.z() * s);
  } else if (std::abs(axis.y()) == 1) {
    turn(R.z, R.x, c, axis.y() * s);
  } else if (std::abs(axis.x()) == 1) {
    turn(R.y, R.z, c, axis.x() * s);
  } else {
    const Eigen::Matrix3d by = turn_about<double>(axis, angle);
    R = {combined(R, by.data()), combined(R, by.data() + 3), combined(R, by.data() + 6)};
  }
}

}  // namespace

template <>
TipMotion<double> tip_motion<double>(const Arm& arm, const JointVector<double>& q) {
  constexpr Eigen::Index kColumn = 4;  // of a displacement's numbers
  const auto n = static_cast<Eigen::Index>(arm.joints.size());
  TipMotion<double> motion;
  motion.screws.resize(6, n);
  Columns R;
  Column p = Column::Zero();
  const auto go = [&](const Eigen::Isometry3d& displacement) {
    const double* const by = displacement.data();
    p += combined(R, by + 3 * kColumn);
    R = {combined(R, by), combined(R, by + kColumn), combined(R, by + 2 * kColumn)};
  };
  for (Eigen::Index k = 0; k < n; ++k) {
    const ArmJoint& joint = arm.joints[static_cast<std::size_t>(k)];
    go(joint.before);
    const Column axis = combined(R, joint.axis.data());
    // A turn's place, until the tip's is known.
    double* const screw = motion.screws.data() + 6 * k;
    put(joint.is_slide ? axis : p, screw);
    put(axis, screw + 3);
    if (joint.is_slide) {
      p += axis * q[k];
      motion.screws.col(k).tail<3>().setZero();
    } else {
      turn(R, joint.axis, q[k]);
    }
  }
  go(arm.tool);
  put(R.x, motion.tip.R.data());
  put(R.y, motion.tip.R.data() + 3);
  put(R.z, motion.tip.R.data() + 6);
  put(p, motion.tip.p.data());
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
