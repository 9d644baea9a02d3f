// SPDX-License-Identifier: MIT
// Real joint values, of which most are: columns of four numbers, which processors take by twos.
#include "tip.h"

#include "moivre/numeric/fused.h"

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

inline void turn(Columns& R, const Eigen::Vector3d& axis, double c, double s) {
  if (std::abs(axis.z()) == 1) {
    turn(R.x, R.y, c, axis.z() * s);
  } else if (std::abs(axis.y()) == 1) {
    turn(R.z, R.x, c, axis.y() * s);
  } else if (std::abs(axis.x()) == 1) {
    turn(R.y, R.z, c, axis.x() * s);
  } else {
    const Eigen::Matrix3d by = turn_by<double>(axis, c, s);
    R = {combined(R, by.data()), combined(R, by.data() + 3), combined(R, by.data() + 6)};
  }
}

/// Cosines and sines of all joints, four at once.
struct Turns {
  static constexpr Eigen::Index kTogether = 4;
  double angle[kMostJoints], c[kMostJoints], s[kMostJoints];
};

/// By polynomials in the distance to the nearest quarter turn, to a unit of the last bit [fdlibm].
inline void find_four(Turns& turns, Eigen::Index begin) {
  constexpr double kRound = 0x1.8p52;                    // what is added to it has no fraction
  constexpr double kFirst = 1.57079632673412561417e+00;  // 33 bits of a quarter turn
  constexpr double kSecond = 6.07710050630396597660e-11, kRest = 2.02226624879595063154e-21;
  constexpr double kS[] = {-1.66666666666666324348e-01, 8.33333333332248946124e-03,
                           -1.98412698298579493134e-04, 2.75573137070700676789e-06,
                           -2.50507602534068634195e-08, 1.58969099521155010221e-10};
  constexpr double kC[] = {4.16666666666666019037e-02, -1.38888888888741095749e-03,
                           2.48015872894767294178e-05, -2.75573143513906633035e-07,
                           2.08757232129817482790e-09, -1.13596475577881948265e-11};
  for (Eigen::Index k = begin; k < begin + Turns::kTogether; ++k) {
    const double x = turns.angle[k];
    const double quarters = (x * (2 / std::numbers::pi) + kRound) - kRound;
    const double r = ((x - quarters * kFirst) - quarters * kSecond) - quarters * kRest;
    const double z = r * r;
    const double s =
        r + r * z * (kS[0] + z * (kS[1] + z * (kS[2] + z * (kS[3] + z * (kS[4] + z * kS[5])))));
    const double half = 0.5 * z, w = 1 - half;
    const double c =
        w + (((1 - w) - half) +
             z * z * (kC[0] + z * (kC[1] + z * (kC[2] + z * (kC[3] + z * (kC[4] + z * kC[5]))))));
    // -2, -1, 0, 1 or 2
    const double of_four = quarters - 4 * ((quarters * 0.25 + kRound) - kRound);
    const double odd = std::abs(of_four);
    const double sine = odd == 1 ? c : s, cosine = odd == 1 ? s : c;
    turns.s[k] = of_four == -1 || odd == 2 ? -sine : sine;
    turns.c[k] = of_four == 1 || odd == 2 ? -cosine : cosine;
  }
}

inline void find_turns(const JointVector<double>& q, Turns& turns) {
  constexpr double kFar = 1e5;  // products of more quarters are rounded
  const Eigen::Index n = q.size();
  bool are_near = true;
  for (Eigen::Index k = 0; k < n; ++k) {
    turns.angle[k] = q[k];
    are_near = are_near && std::abs(q[k]) < kFar;
  }
  if (are_near) {
    for (Eigen::Index k = n; k % Turns::kTogether != 0; ++k) turns.angle[k] = 0;
    for (Eigen::Index k = 0; k < n; k += Turns::kTogether) find_four(turns, k);
    return;
  }
  for (Eigen::Index k = 0; k < n; ++k) {
    turns.s[k] = std::sin(q[k]);
    turns.c[k] = std::cos(q[k]);
  }
}

inline void find_tip_motion(const Arm& arm, const JointVector<double>& q,
                            TipMotion<double>& motion) {
  constexpr Eigen::Index kColumn = 4;  // of a displacement's numbers
  const auto n = static_cast<Eigen::Index>(arm.joints.size());
  motion.screws.resize(6, n);
  Turns turns;
  find_turns(q, turns);
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
      turn(R, joint.axis, turns.c[k], turns.s[k]);
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
}

}  // namespace

template <>
TipMotion<double> tip_motion<double>(const Arm& arm, const JointVector<double>& q) {
  TipMotion<double> motion;
  fused([&] { find_tip_motion(arm, q, motion); });
  return motion;
}

}  // namespace moivre
