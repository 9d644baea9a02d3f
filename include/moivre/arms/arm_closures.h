// SPDX-License-Identifier: MIT
// In which joint values does a serial arm hold its tip in a given pose? All of them, none missing, by homotopy continuation.
//
// The loop B_1 J_1 ... J_n T (pose)^-1 = 1 is cut open into a few neighbouring joints, which are eliminated linearly, and the others,
// whose half-angle tangents t are the unknowns of a small multilinear system (docs/decisions/0021-inverse-kinematics.md):
//   two joints            4 equations in 4 unknowns, 24 paths, 16 closures of a general arm and 8 roots that are none
//   a wrist, or parallel  three joints whose axes meet, or are parallel: 3 unknowns, 6 paths, then two ways each
// Each real root is read back to joint values and put right by Newton's method on the product of transforms, which knows no
// polynomial. Closures outside a joint's limits are kept and marked. With fewer than six joints a pose must be one that they
// can reach; closures miss it by kReach at most.
// Roots that are no closures (a tangent of +-i turns nothing) are counted as `rejected`.
// Edges: at a pose that can be held while joints move (a straight wrist), the closures are no points: `moves` has one of them.
#pragma once

#include <Eigen/Geometry>
#include <atomic>
#include <optional>
#include <string>
#include <vector>

#include "moivre/arms/arm.h"
#include "moivre/solver/solve.h"

namespace moivre {

/// By how much forward kinematics of a closure may miss the pose: radians, and lengths beside the arm's.
inline constexpr double kReach = 1e-10;

/// One way to hold the pose.
struct ArmClosure {
  std::string id;  ///< A, B, ... by values: the same for every seed, tracker and thread count
  Eigen::VectorXd values;  ///< turns in (-pi, pi], slides in the file's unit
  /// The same with whole turns added where limits ask for them; a joint that no turns bring inside keeps its value.
  Eigen::VectorXd in_limits;
  std::vector<std::size_t> beyond;  ///< joints outside their limits
  double residual = 0;  ///< by how much it misses the pose: radians, and lengths beside the arm's
  int newton_iterations = 0;
  double smallest_singular_value = 0;  ///< of the Jacobian, lengths beside the arm's
  std::uint64_t path = 0;
  std::uint64_t multiplicity = 1;
  bool singular = false;
};

/// What is solved together.
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

/// The tip stands while the joints move.
struct ArmMoves {
  Eigen::VectorXd values;   ///< of one closure
  Eigen::VectorXd tangent;  ///< unit: how its joints may move
};

struct ArmResult {
  bool complete = false;
  std::string message = "find_arm_closures() was not run";
  std::uint64_t seed = 0;
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  StartFacts start;
  std::string tracker;
  std::vector<std::pair<std::string, std::string>> tracker_options;
  PathCounts paths;
  std::vector<ArmStage> stages;
  ArmCounts counts;
  std::vector<ArmClosure> closures;  ///< by id
  std::optional<ArmMoves> moves;
  std::vector<FailedPath> failures;
  std::vector<LeftOut> left_out;
  StepCount work;
  SolveTime time_s;
};

/// `options.start` automatic: the start system is the one that is known to be good here.
/// Throws std::invalid_argument where the pose is not finite or an option is out of range.
ArmResult find_arm_closures(const Arm& arm, const Eigen::Isometry3d& pose, const Tracker& tracker,
                            const SolveOptions& options = {},
                            const std::atomic<bool>& stop = std::atomic<bool>{false});

/// The same for many poses, options.threads of them at once. Where there are more than a few, and options.start is automatic, what they
/// have in common is solved once, and paths lead from there to every pose (start.kind "family"); one where that does not give as
/// many closures, all simple, as a random pose has is solved as above. A set `stop` leaves those out that are not begun: the
/// result is shorter. Progress counts poses.
std::vector<ArmResult> find_arm_closures(const Arm& arm,
                                         const std::vector<Eigen::Isometry3d>& poses,
                                         const Tracker& tracker, const SolveOptions& options = {},
                                         const std::atomic<bool>& stop = std::atomic<bool>{false});

}  // namespace moivre
