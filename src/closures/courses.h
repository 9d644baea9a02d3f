// SPDX-License-Identifier: MIT
// How far does each angle and slide of a mechanism go along one branch, and where does it stand at either end?
//
//   v(t) = value(q(t)), going on along the branch without jumps
// Poses: the branch's ends, its samples, and beside an event a few poses at t_e + (t_s - t_e) u^2, u = 1/6 .. 5/6, t_s the sample
// beside it: there q moves with the root of the time, and v is smooth in u.
// Extremes between poses: of the polynomial of degree five through value, velocity and acceleration at two samples; of the one
// through the values beside an event. Where it leaves the poses by more than kFar, Newton's method says where v stands.
#pragma once

#include <functional>

#include "moivre/closures/circuits.h"

namespace moivre {

struct Quantity {
  std::string name;
  CoordinateKind kind = CoordinateKind::angle;
  bool may_turn = true;  ///< a whole turn more is the same pose
  bool goes_on = true;   ///< its value goes on as q does; else it is brought into (-pi, pi]
  std::function<double(const Eigen::VectorXd& q)> value;
};

/// Planar: the angle of each moving body. Typed equations: each unknown.
std::vector<Quantity> body_quantities(const Mechanism& mechanism);
/// Relative angles of revolutes (planar: between moving bodies, others are a body's own), and slides. The mechanism must outlive
/// them.
std::vector<Quantity> joint_quantities(const Mechanism& mechanism);

struct Course {
  double first = 0;  ///< at the branch's beginning
  double last = 0;
  double lower = 0;
  double upper = 0;
};

/// Of each quantity along the branch.
std::vector<Course> courses(const Phi& phi, const MotionBranch& branch,
                            const std::vector<Quantity>& quantities);

/// Of each driver.
std::vector<Course> driver_courses(const Mechanism& mechanism, const MotionBranch& branch);

}  // namespace moivre
