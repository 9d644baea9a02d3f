// SPDX-License-Identifier: MIT
// Which numbers does a designer read off a mechanism in motion, what values do they take along each
// branch, which are the least and the largest, and how quick is the return?
//
// Quantities, by group, each a function of one sample of a branch:
//   coordinates    of bodies, or the unknowns, with velocity and acceleration
//   points         places of named points, with velocity and acceleration
//   joints         relative angle (revolute, planar slot, cylindrical) and slide (prismatic, slot,
//                  cylindrical), likewise
//   coefficients   first and second derivative by each driver (kinematics/coefficients.h) of the
//                  bodies' angles, the joints' slides, the points without a joint, the unknowns;
//                  spatial: of the joints' angles in place of the bodies'
//   transmission   transmission angle of joints between moving bodies (kinematics/transmission.h)
//   advantage      mechanical advantage: output torque (or force along a slide) over the driver's,
//                  without friction and inertia.
//                  By the balance of power it is |df / do|, f the driver's value, o the output's,
//                  with the other drivers held.
//                  For angles it is omega_in / omega_out [Norton12, 6.6]. It is infinite where the
//                  output stands still for an instant
//   singularity    smallest singular value of Phi_q with its rows and columns brought to unit
//                  length: 0 at a dead point
//
// Outputs are bodies (their angle, or their slide where a prismatic joint ties them to the ground),
// joints (angle or slide), points' coordinates ("rocker.B.x") or unknowns, by name. If none is
// named: bodies with a joint to the ground that are not driven.
// Angles in radians (of spatial joints in [-pi, pi]), lengths in the file's unit; derivatives by an
// angle are by a radian.
// NaN where a quantity is not defined: derivatives at a pose whose velocity is not unique. Idle
// joints are held, as in motion.
//
// Along each branch:
//   values    of every quantity at every sample; angles that turn go on from
//             (-pi, pi] at the branch's begin
//   extremes  the least and the largest over the branch, refined between the samples by Brent's
//             minimization of the motion itself.
//             If the samples show an extreme, its value is exact to rounding. A spike between two
//             samples is not seen. Events count as samples if the quantity is defined there. At a
//             dead point velocities have no bound; the extreme is then unbounded, at the time of
//             the dead point. An advantage is unbounded where the output stands still for an
//             instant.
//   time ratio  of an output over the first turn of the only driver, an angle at constant speed.
//               The output is at its least at t1
//             and at its largest at t2. The ratio is the longer of the two times between them over
//             the shorter one, >= 1 [Norton12, 3.4]. There is none if the output turns fully, or
//             has not returned after the turn.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "moivre/kinematics/branch.h"
#include "moivre/mechanism/mechanism.h"
#include "moivre/motion/motion.h"

namespace moivre {

enum class QuantityGroup {
  coordinates,
  points,
  joints,
  coefficients,
  transmission,
  advantage,
  singularity
};

std::string to_string(QuantityGroup group);
/// For people, a clause.
std::string description(QuantityGroup group);
std::vector<QuantityGroup> quantity_groups();

/// An angle or a slide: how a quantity changes with time or with a driver.
enum class QuantityOrder { value, velocity, acceleration };

struct Quantity {
  QuantityGroup group = QuantityGroup::coordinates;
  std::string name;  ///< without a unit; "joint B.velocity"
  std::string of;    ///< "joint B": the same for a value, its velocity and its acceleration
  QuantityOrder order = QuantityOrder::value;
  bool is_angle = false;  ///< radians (per second ...), which tables may show in degrees
  bool turns = false;     ///< an angle that a whole turn more leaves the same
  std::string
      unit;  ///< what stands behind "rad" or "deg", else all of it; empty where it has no name
  bool is_runaway = false;  ///< a derivative: without bound where the pose has no velocity
};

struct QuantityChoice {
  std::vector<QuantityGroup> groups;
  std::vector<std::string> outputs;  ///< names; empty: by default
};

class QuantityReader {
 public:
  /// Throws std::invalid_argument where an output is not known, with those that are.
  QuantityReader(const Mechanism& mechanism, const QuantityChoice& choice);
  ~QuantityReader();
  QuantityReader(const QuantityReader&) = delete;
  QuantityReader& operator=(const QuantityReader&) = delete;

  const std::vector<Quantity>& quantities() const;
  /// One per quantity. A pose without velocities has only what needs none.
  std::vector<double> read(const BranchSample& pose) const;
  double read(std::size_t quantity, const BranchSample& pose) const;
  /// Of an advantage: do / df, which changes its sign where the advantage is infinite. NaN of
  /// others.
  double rate(std::size_t quantity, const BranchSample& pose) const;
  /// Whether the quantity (a velocity, ...) is unbounded near the dead point `q`.
  bool runs_away(std::size_t quantity, const Eigen::VectorXd& q, double time) const;

  /// The sample of a regular pose.
  BranchSample sample_at(double time, const Eigen::VectorXd& q) const;
  /// A sample between two: Newton's method from the quintic through both. Status false
  /// (is_determined) where it does not settle.
  BranchSample between(const BranchSample& before, const BranchSample& after, double time) const;

  /// The outputs' values, as quantities of a reader of their own: see time_ratio.h.
  const std::vector<std::string>& outputs() const;

 private:
  struct Parts;
  std::unique_ptr<const Parts> parts_;
};

struct Extreme {
  double value = 0;  ///< NaN: not known; of an unbounded one, infinite with its sign
  double time = 0;
  bool is_refined = false;  ///< between samples; else of a sample or an event
  bool is_unbounded() const;
};

struct Extremes {
  Extreme least;
  Extreme largest;
};

struct TimeRatio {
  std::string output;
  double ratio = 1;       ///< longer / shorter
  double rising_s = 0;    ///< from the least to the largest
  double falling_s = 0;   ///< and back; both together are a turn of the driver
  double from = 0;        ///< the least value
  double to = 0;          ///< the largest
  bool is_angle = false;  ///< of `from` and `to`: radians
};

struct BranchReadings {
  std::string id;
  std::vector<std::vector<double>> values;  ///< [sample][quantity]; NaN where not defined
  std::vector<Extremes> extremes;           ///< one per quantity; none where not asked for
  std::vector<TimeRatio> time_ratios;       ///< of the outputs that have one
};

struct Readings {
  std::vector<Quantity> quantities;      ///< those that are defined somewhere on a branch
  std::vector<BranchReadings> branches;  ///< as in the motion
};

/// Extremes and time ratios take several times as long as the values.
Readings read_motion(const MotionResult& motion, const Mechanism& mechanism,
                     const QuantityReader& reader, bool with_extremes = true);

}  // namespace moivre
