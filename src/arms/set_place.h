// SPDX-License-Identifier: MIT
// A posture next to a set of postures that hold the pose: how is it put right, and does the set go
// on from there?
//
//   U sigma V^T
//              the screws' singular values, joints in radians and arm's lengths: the last columns
//              of V move the tip least
//   settled    Gauss-Newton steps across directions that are kept; what is within the accuracy is
//              no reason to go far: x with P S^T (S x - e) = 0, P across what is kept. A step that
//              is short leaves nothing that is within the accuracy and far; then the normal
//              equations give it, otherwise the singular value decomposition tells which to drop
//   moved      a step along a direction, and back to the set across it
// accuracy: radians, and lengths relative to the arm's. Edges: a place may miss the pose by more
// than that; its residual tells. Private to the module.
#pragma once

#include <deque>
#include <optional>

#include "moivre/factorization/svd.h"
#include "polish.h"

namespace moivre {

/// Radians, and arm's lengths: steps that tell whether a set goes on, and those along it.
inline constexpr double kProbe = 0.05, kStep = 0.05;

/// Of a difference of joint values, in radians and arm's lengths.
JointVector<double> in_arms_lengths(const Arm& arm, JointVector<double> difference);

/// |b - a|, turns modulo whole ones, in radians and arm's lengths.
double apart(const Arm& arm, const JointValues& a, const JointValues& b);

/// A posture near a set.
struct SetPlace {
  JointVector<double> values;
  double residual = 0;
  Linearized at;
};

/// Places of a curve in order: each is large, and stays where it is.
using SetPlaces = std::deque<SetPlace>;

/// U, sigma, V of the place; sigma as many as joints, 0 where there are more joints than six.
Svd stretch_of(const SetPlace& place);
/// Unit: where the tip can move least.
Velocity6<double> least_moved(const SetPlace& place);
/// The same from that of a place nearby.
Velocity6<double> least_moved(const SetPlace& place, const Velocity6<double>& nearby);

SetPlace place_at(const Arm& arm, const Eigen::Isometry3d& pose, const JointVector<double>& values);

/// `frozen`: orthonormal columns, along which nothing is changed.
SetPlace settled(const Arm& arm, const Eigen::Isometry3d& pose, const JointVector<double>& values,
                 const Eigen::Ref<const Eigen::MatrixXd>& frozen, double accuracy);

/// The place at `step` along `direction`; nothing where the pose is missed there.
std::optional<SetPlace> moved(const Arm& arm, const Eigen::Isometry3d& pose, const SetPlace& from,
                              const JointVector<double>& direction, double step, double accuracy);

/// The place of the set half way from here to `gone`, where the set goes straight on; nothing where
/// it does not: other sets and closures may be as near.
std::optional<SetPlace> place_between(const Arm& arm, const Eigen::Isometry3d& pose,
                                      const SetPlace& place, const JointVector<double>& gone,
                                      double accuracy);

/// Whether there is one.
bool leads_to(const Arm& arm, const Eigen::Isometry3d& pose, const SetPlace& place,
              const JointVector<double>& gone, double accuracy);

}  // namespace moivre
