// SPDX-License-Identifier: MIT
// Unit displacements in double.
#include "pose_loop.h"

#include <cmath>

#include "exact_motion.h"
#include "typed_displacement.h"

namespace moivre {
namespace {

/// The pose's inverse, lengths in units of 2^exponent.
RealDisplacement back_from(const Eigen::Isometry3d& pose, int exponent) {
  const Eigen::Quaterniond q(pose.linear());
  const Eigen::Vector3d t = std::ldexp(0.5, -exponent) * pose.translation();
  const RealDisplacement turn{{q.w(), q.x(), q.y(), q.z()}, {}};
  const RealDisplacement shift{{1, 0, 0, 0}, {0, t.x(), t.y(), t.z()}};
  return conjugate(shift * turn);
}

}  // namespace

PoseLoop pose_loop(const Arm& arm, std::uint64_t seed) {
  PoseLoop poses;
  poses.open = open_loop(arm, seed);
  poses.cut = choose_cut(poses.open, CutPlace::away_from_pose);
  poses.tool = rounded(in_unit(*arm.exact_tool, poses.open.unit_exponent));
  return poses;
}

Loop loop_at(const PoseLoop& poses, const Eigen::Isometry3d& pose) {
  Loop loop = poses.open;
  LoopJoint& first = loop.joints.front();
  first.rounded.before =
      unit(poses.tool * back_from(pose, loop.unit_exponent) * first.rounded.before);
  return loop;
}

}  // namespace moivre
