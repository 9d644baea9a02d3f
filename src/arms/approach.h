// SPDX-License-Identifier: MIT
// Which closures of a pose does a closure of another pose become, when the tip goes from there to
// here?
//
// The tip's way, s from 0 to 1, is complex in between, so that no two closures meet on it before
// its end (the way avoids the singular poses, which have real codimension 2 in it):
//   R(s) = R_0 exp(u [w]),  p(s) = p_0 + u (p_1 - p_0),  u(s) = s + i detour s (1 - s),
//   w the rotation vector of R_0^T R_1.
// All joint values, complex ones too, follow by Newton's method on the product of transforms, as
// typed; no polynomial is seen here.
// Where they end:
//   regular    Newton's method contracts at the pose itself: a simple closure
//   singular   it contracts as near to the pose as rounding allows, but not there: closures meet,
//              or a set of closures is there
//   infinite   joints without end: a slide that leaves, an angle whose tangent becomes +-i
//   lost       none of these
#pragma once

#include <cstdint>
#include <vector>

#include "tip.h"

namespace moivre {

enum class ApproachKind { regular, singular, infinite, lost };

struct ApproachEnd {
  ApproachKind kind = ApproachKind::lost;
  JointVector<Complex> values;
  double accuracy = 0;   ///< of a regular end: its last Newton step
  double remaining = 1;  ///< 1 - s
  double to_go = 0;  ///< of a singular end: how far its last velocity leads on the remaining way
  std::uint64_t path = 0;  ///< that found the closure which it comes from
};

/// How the tip goes from one pose to another.
struct TipWay {
  Placement<double> begin, end;
  Eigen::Vector3d turn;  ///< w, in the tip's frame
  double detour = 1;
};
TipWay tip_way(const Eigen::Isometry3d& begin, const Eigen::Isometry3d& end, double detour);

/// `contraction`: by how much a second Newton step must be smaller than the first; smaller is more
/// careful.
ApproachEnd approach(const Arm& arm, const TipWay& way, const JointVector<Complex>& start,
                     double contraction = 0.1);

/// Newton's method at one pose. False where it does not contract, goes farther than `farthest`, or
/// ends on a set of closures.
bool correct_at(const Arm& arm, const Placement<Complex>& pose, JointVector<Complex>& values,
                double farthest, double& accuracy);

Placement<Complex> complex_placement(const Eigen::Isometry3d& pose);

/// The largest difference, turns modulo whole ones, slides relative to the arm's length.
double distance_of(const Arm& arm, const JointVector<Complex>& a, const JointVector<Complex>& b);

/// No end is lost, and regular ones are different.
bool are_different(const Arm& arm, const std::vector<ApproachEnd>& ends);
/// At a real pose the conjugate of a closure is another one, or the closure itself: the regular
/// ends whose conjugate no other path led to.
std::vector<std::size_t> without_conjugate(const Arm& arm, const std::vector<ApproachEnd>& ends);

}  // namespace moivre
