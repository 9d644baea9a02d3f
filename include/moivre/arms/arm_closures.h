// SPDX-License-Identifier: MIT
// With which joint values does a serial arm hold its tip in a given pose? All solutions, by
// homotopy continuation.
//
// All closures of one pose that is nothing special, complex ones too, are the roots of a small
// multilinear system (docs/decisions/0021-inverse-kinematics.md). They are put right on the arm as
// typed, and followed while the tip moves to the pose asked
// (docs/decisions/0074-a-pose-is-approached.md). In the loop of the chain and its pose a few
// neighbouring joints are eliminated linearly; the half-angle tangents of the others are the
// unknowns:
//   two joints                          4 equations in 4 unknowns, 24 paths: 16 closures of a
//                                       general arm, 8 rejected roots
//   three that meet or are parallel     3 unknowns, 6 paths, then two solutions each
// Closures outside a joint's limits are kept and marked. An arm with fewer than six joints gets a
// wrist behind its last joint; its closures are those where these stand at 0. They are least
// squares, and miss the pose by its accuracy at most, or by what the file's digits leave open (then
// marked).
// Roots that are no closures (a tangent of +-i is no rotation) are counted as `rejected`.
// Edges: at a singular pose joints may move while the tip stands still (a straight wrist, axes in
// line). `moves` has these sets.
#pragma once

#include <Eigen/Geometry>
#include <atomic>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "moivre/arms/arm.h"
#include "moivre/arms/poses.h"
#include "moivre/solver/solve.h"

namespace moivre {

/// By how much forward kinematics of a closure may miss the pose: radians, and lengths relative to
/// the arm's.
inline constexpr double kReach = 1e-10;

/// The tip's velocity in the base's frame.
struct Twist {
  Eigen::Vector3d translation =
      Eigen::Vector3d::Zero();                         ///< of the tip's origin, in the file's unit
  Eigen::Vector3d rotation = Eigen::Vector3d::Zero();  ///< radians
};

/// What is lost at a singular closure, and hard to move near one: by the singular vectors of the
/// smallest singular value.
struct WeakestMotion {
  Eigen::VectorXd
      joints;  ///< unit: these joint velocities move the tip least; in radians and the file's unit
  Twist tip;   ///< unit: this motion of the tip takes the fastest joints
};

/// One way to hold the pose.
struct ArmClosure {
  std::string id;  ///< A, B, ... by values: the same for every seed, tracker and thread count
  Eigen::VectorXd values;  ///< turns in (-pi, pi], slides in the file's unit
  /// The same with whole turns added where that brings a joint between its limits; otherwise the
  /// joint keeps its value.
  Eigen::VectorXd in_limits;
  std::vector<std::size_t> beyond;  ///< joints outside their limits
  double residual = 0;  ///< its miss of the pose: radians, and lengths relative to the arm's
  int newton_iterations = 0;
  double smallest_singular_value = 0;  ///< of the Jacobian, lengths relative to the arm's
  WeakestMotion weakest;               ///< likewise
  std::uint64_t path = 0;
  std::uint64_t multiplicity = 1;
  bool singular = false;
  /// By how much the digits of the file's numbers may move a joint, to first order: radians, and
  /// lengths relative to the arm's.
  double moved_by_digits = 0;
  /// It misses the pose by more than this is accurate, but by no more than the digits of the file
  /// leave open.
  bool within_digits = false;
};

/// A system that is solved as a whole.
struct ArmStage {
  std::string group;  ///< its joints
  std::uint64_t solves = 0;
  PathCounts paths;
};

struct ArmCounts {
  std::uint64_t complex = 0;  ///< isolated closures, the real ones among them
  std::uint64_t real = 0;
  std::uint64_t beyond_limits = 0;  ///< of the real ones
  std::uint64_t rejected = 0;       ///< roots that are no closures
};

/// factors . values = value, turns modulo whole ones; where a turn has the factor 1 or -1 the value
/// is in (-pi, pi].
struct JointRelation {
  Eigen::VectorXd factors;
  double value = 0;
};

/// A set of postures that hold the pose: the tip stands while the joints move along it.
struct SelfMotion {
  int dimension = 1;
  Eigen::VectorXd values;      ///< of one posture, turns in (-pi, pi]
  Eigen::MatrixXd directions;  ///< a unit column for each dimension: how its joints may move
  Twist lost;                  ///< unit: how the tip cannot move from there
  /// That hold on the whole set, where it is a piece of a plane in joint space, for the joints that
  /// move. Empty: it is curved.
  std::vector<JointRelation> relations;
  std::vector<Eigen::VectorXd>
      samples;          ///< postures of it, turns without reduction: a way along it
  bool closes = false;  ///< it has one dimension and comes back to its beginning
  double misfit = 0;    ///< the most that a sample misses the pose by
  /// It misses the pose by more than this is accurate, but by no more than the digits of the file
  /// leave open.
  bool within_digits = false;
};

/// By how much the tip misses a pose: two numbers that no common unit has.
struct PoseMisfit {
  double position = 0;  ///< the file's unit, metres
  double rotation = 0;  ///< radians
};

struct NearestPosture {
  Eigen::VectorXd values;
  double misfit = 0;  ///< the larger of both: radians, and lengths relative to the arm's
  PoseMisfit apart;
};

struct ArmResult {
  bool complete = false;
  std::string message = "find_arm_closures() was not run";
  std::uint64_t seed = 0;
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  double accuracy = kReach;  ///< of the pose: radians, and lengths relative to the arm's
  StartFacts start;
  std::string tracker;
  OptionsInForce tracker_options;
  PathCounts paths;
  std::vector<ArmStage> stages;
  ArmCounts counts;
  std::vector<ArmClosure> closures;  ///< by id
  std::vector<SelfMotion> moves;
  /// The posture that comes nearest to the pose, where there is no closure.
  std::optional<NearestPosture> nearest;
  std::vector<FailedPath> failures;
  std::vector<LeftOut> left_out;
  StepCount work;
  SolveTime time_s;
};

/// Whether the posture is on the set, as far as its samples show: no farther from it than `within`,
/// radians and arm's lengths.
bool is_on(const Arm& arm, const SelfMotion& motion, const Eigen::VectorXd& values, double within);

/// By how much the tip misses the pose at these joint values.
PoseMisfit misfit_of(const Arm& arm, const Eigen::Isometry3d& pose, const Eigen::VectorXd& values);

/// Whether the posture holds the result's pose, missing it by `within` at most (metres and radians;
/// 0: as the pose is accurate, or the set misses it), and is on this set of the result, as far as
/// the set's samples show: a closure beside a set, nearer than the samples are apart, is not told
/// from it.
bool contains(const Arm& arm, const ArmResult& result, const SelfMotion& motion,
              const Eigen::VectorXd& values, double within = 0);

/// Adds whole turns to `values` where that brings a joint between its limits; other turns are in
/// (-pi, pi] then. Returns the joints that are beyond their limits all the same.
std::vector<std::size_t> place_in_limits(const Arm& arm, Eigen::VectorXd& values);

/// With `options.start` automatic, the start is the one that is known to be best here.
/// Throws std::invalid_argument where the pose is not finite or an option is out of range.
ArmResult find_arm_closures(const Arm& arm, const TypedPose& pose, const Tracker& tracker,
                            const SolveOptions& options = {},
                            const std::atomic<bool>& stop = std::atomic<bool>{false});
ArmResult find_arm_closures(const Arm& arm, const Eigen::Isometry3d& pose, const Tracker& tracker,
                            const SolveOptions& options = {},
                            const std::atomic<bool>& stop = std::atomic<bool>{false});

/// The same for many poses, whose results are handed on one by one, in their order, as soon as some
/// hundreds of them are there (thousands with `options.observations`): what is not kept takes no
/// memory. A set `stop` leaves out the poses that are not begun.
void for_each_pose(const Arm& arm, const std::vector<TypedPose>& poses, const Tracker& tracker,
                   const std::function<void(ArmResult&& result)>& take,
                   const SolveOptions& options = {},
                   const std::atomic<bool>& stop = std::atomic<bool>{false});
void for_each_pose(const Arm& arm, const std::vector<Eigen::Isometry3d>& poses,
                   const Tracker& tracker, const std::function<void(ArmResult&& result)>& take,
                   const SolveOptions& options = {},
                   const std::atomic<bool>& stop = std::atomic<bool>{false});

/// The same for many poses, options.threads of them at once. Equations are solved once for the arm;
/// a formula (start.source) or paths (of a family) lead to every pose. A set `stop` leaves out
/// the poses that are not begun, so that the result is shorter. Progress counts poses.
std::vector<ArmResult> find_arm_closures(const Arm& arm, const std::vector<TypedPose>& poses,
                                         const Tracker& tracker, const SolveOptions& options = {},
                                         const std::atomic<bool>& stop = std::atomic<bool>{false});
std::vector<ArmResult> find_arm_closures(const Arm& arm,
                                         const std::vector<Eigen::Isometry3d>& poses,
                                         const Tracker& tracker, const SolveOptions& options = {},
                                         const std::atomic<bool>& stop = std::atomic<bool>{false});

}  // namespace moivre
