// SPDX-License-Identifier: MIT
// Where does one assembled pose go while the drivers move, and where does its branch end?
//
// A branch is a curve Phi(q, t) = 0 through (q0, t0). It is followed by arc length in y = (q / w, t
// / T), w a length of the mechanism for lengths and 1 for angles, T the remaining time. The tangent
// y' satisfies [Phi_q Phi_t] y' = 0. The predictor is y + h y' + h^2 y'' / 2; the corrector is
// Newton's method on the plane across y'. The size of the next step depends on how far the
// prediction misses and how much the tangent turns.
// Samples are corrected at their own times; one factorization of Phi_q serves velocity and
// acceleration there.
//
// The branch ends before `to` where it cannot go on, and says so:
//   dead point    y' is perpendicular to t: Phi_q is singular, [Phi_q Phi_t] is not. The drivers
//                 can go no further, and two branches meet and end (a limit position of the driver,
//                 a toggle, a fold).
//   bifurcation   [Phi_q Phi_t] loses rank: branches cross (a change point), and the continuation
//                 is not unique.
//   joint limit   a joint is at the end of its range.
// Dead points are located by the secant method on the curve. At bifurcations no point can be
// corrected; they are located by extrapolating the smallest singular value to 0. It falls like a
// whole power of the remaining distance: 1 where branches cross, 2 where they touch.
// Not supported: fewer independent equations than coordinates (the pose would move with the drivers
// held): `failed`.
#pragma once

#include <Eigen/Core>
#include <array>
#include <atomic>
#include <optional>
#include <string>
#include <vector>

#include "moivre/mechanism/phi.h"

namespace moivre {

enum class EventKind { dead_point, bifurcation, joint_limit };

/// "dead point", "bifurcation", "joint limit".
std::string to_string(EventKind kind);

/// A place where a branch ends (or, followed the other way, begins).
struct BranchEvent {
  EventKind kind = EventKind::dead_point;
  double time = 0;
  Eigen::VectorXd q;       ///< angles as they came, whole turns included
  std::string joint;       ///< joint limit: which
  double uncertainty = 0;  ///< of `time`, estimated
};

/// The motion at one output time. Angles go on past half a turn: they are not brought back into
/// (-pi, pi].
struct BranchSample {
  double time = 0;
  Eigen::VectorXd q;
  Eigen::VectorXd velocity;      ///< q'; empty where it was not asked for
  Eigen::VectorXd acceleration;  ///< q''; likewise
  double residual = 0;           ///< residual_by_size (mechanism/phi.h)
  bool is_determined = true;  ///< Phi_q has full rank: velocity and acceleration are the only ones
};

enum class BranchStatus {
  reached,  ///< the last time asked for
  ended,    ///< at `event`
  failed,   ///< see `message`
  interrupted
};

struct BranchOptions {
  double largest_turn_rad = 0.2;  ///< of the tangent in one step
  double largest_miss = 0.05;     ///< of the prediction relative to the step
  double longest_step = 0.5;      ///< in y: a radian, or the mechanism's length, is 1
  double largest_approach = 0.5;  ///< share of the way to where branches seem to cross, in one step
  int maximum_steps = 20000;      ///< accepted and rejected
  /// Times of velocity and acceleration, ascending; at other times only the pose is found. nullopt:
  /// at all times.
  std::optional<std::vector<double>> velocity_times;
};

/// Every broken rule as a sentence; empty when the options can be used.
std::vector<std::string> validate(const BranchOptions& options);

/// An assembled pose.
struct BranchPose {
  double time = 0;
  Eigen::VectorXd q;
};

/// One step of a branch: q(x), 0 <= x <= until, on the curve of degree five through both ends of
/// the step, 0 and `length`.
struct BranchPiece {
  double length = 0;
  double until = 0;                  ///< less than `length` where the last time is reached before
  std::array<Eigen::VectorXd, 2> q;  ///< at 0 and at `length`, angles as they came
  std::array<Eigen::VectorXd, 2>
      slope;                            ///< dq/dx; empty where the piece is known by its ends alone
  std::array<Eigen::VectorXd, 2> bend;  ///< d2q/dx2
};

struct Branch {
  BranchStatus status = BranchStatus::failed;
  std::string message = "follow_branch() was not run";
  std::vector<BranchSample> samples;  ///< in the order of the times, up to where the branch ends
  std::vector<BranchPiece> pieces;    ///< step by step, to where the branch ends
  std::optional<BranchEvent> event;   ///< where status is `ended`
  std::optional<BranchPose> beyond;  ///< dead point: a pose of the branch that meets this one there
  int steps = 0;                     ///< accepted
  int rejected = 0;
};

/// Follows the pose q0, assembled at times.front(), through `times` (strictly monotone, either way;
/// two or more).
/// Throws std::invalid_argument when q0, the times or the options are not as said.
Branch follow_branch(const Mechanism& mechanism, const Eigen::VectorXd& q0,
                     const std::vector<double>& times, const BranchOptions& options = {},
                     const std::atomic<bool>& stop = std::atomic<bool>{false});

}  // namespace moivre
