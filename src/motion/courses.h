// SPDX-License-Identifier: MIT
// How far does each angle and slide of a mechanism go along one branch, and where does it stand at
// either end?
//
//   v(x) = value(q(x)), going on along the branch without jumps
// The branch was followed by arc length, step after step (BranchPiece): between the ends of a step
// v is the polynomial of degree five with its value, slope and bend at both, through dead points as
// elsewhere. Extremes are those of the polynomials, to about 1e-7; samples play no part.
// Not seen: two extremes within one step.
#pragma once

#include <functional>
#include <numbers>

#include "moivre/motion/circuits.h"

namespace moivre {

inline constexpr double kOneTurn = 2 * std::numbers::pi;

/// What turns or slides.
struct MovingPart {
  std::string name;
  CoordinateKind kind = CoordinateKind::angle;
  bool may_turn = true;  ///< a whole turn more is the same pose
  bool goes_on = true;   ///< its value goes on as q does; else it is brought into (-pi, pi]
  std::function<double(const Eigen::VectorXd& q)> value = {};
};

/// Planar: the angle of each moving body. Typed equations: each unknown.
std::vector<MovingPart> body_quantities(const Mechanism& mechanism);
/// Relative angles of revolutes (planar: between moving bodies, others are a body's own), and
/// slides. The mechanism must outlive them.
std::vector<MovingPart> joint_quantities(const Mechanism& mechanism);

struct Course {
  double first = 0;  ///< at the branch's beginning
  double last = 0;
  double lower = 0;
  double upper = 0;
};

Course course(const MotionBranch& branch, const MovingPart& quantity);

/// Of a driver: its law at the branch's ends and samples.
Course driver_course(const MotionBranch& branch, const Driver& driver);

}  // namespace moivre
