// SPDX-License-Identifier: MIT
// How well does one link push the next? The transmission angle at the joints between two moving
// bodies, 0 (locked) to 90 degrees.
//
// Hold the drivers and open one joint. If each of its two bodies can now move its end of the joint
// along one line only, the transmission angle is the angle between these two lines, in [0, pi/2]:
//   revolute   the joint's point moves along u1 as a point of body 1, and along u2 as a point of
//              body 2; angle = angle(u1, u2).
//   slot, rod  one body is fixed, the other moves its point along u; n is the slot's normal or the
//              rod's direction;
//              sin(angle) = |n . u| / |u|.
// For the four-bar this is the angle between coupler and rocker, for the slider-crank that between
// the connecting rod and the normal of the slide [Norton12, 3.3] [BalliChand02]. There u1 is
// perpendicular to the coupler, which turns about the crank's pin, and u2 is perpendicular to the
// rocker, which turns about its pivot. Links with three joints, and groups of more than two links,
// follow the same rule: u is perpendicular to the line to the point about which the body then
// turns. The angle is 0 exactly where the two lines coincide; the mechanism is at a dead point
// there.
// There is no value at the driven joint and at joints of the driven body (it is fixed when the
// drivers are held); where an end can still move in two directions (the joint is no floating joint
// of a dyad or of a larger group); at prismatic joints and gears;
// at joints to the ground; where constraints are redundant; and in spatial mechanisms.
#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "moivre/mechanism/phi.h"

namespace moivre {

/// A joint that may have a transmission angle, by its type and its bodies.
struct TransmissionJoint {
  std::size_t joint = 0;       ///< index into Mechanism::joints
  Eigen::Index first_row = 0;  ///< of Phi
  Eigen::Index rows = 0;
};

/// Revolutes, slots and rods between two moving bodies that no driver ties; in the file's order.
std::vector<TransmissionJoint> transmission_joints(const Mechanism& mechanism);

/// In radians; nullopt where it is not defined in this pose. `phi`: of the mechanism. `Phi_q`: at
/// q.
std::optional<double> transmission_angle(const Mechanism& mechanism, const Phi& phi,
                                         const TransmissionJoint& joint, const Eigen::VectorXd& q,
                                         const Eigen::MatrixXd& Phi_q);

}  // namespace moivre
