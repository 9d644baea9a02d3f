// SPDX-License-Identifier: MIT
// Random joint values, the loop of their pose, its roots, put right on the arm itself.
#include "regular_pose.h"

#include <algorithm>

#include "equations.h"
#include "moivre/factorization/svd.h"
#include "random_values.h"
#include "read_back.h"

namespace moivre {
namespace {

/// Radians: what the special geometry that a file's digits stand for may move a closure of a
/// regular pose.
constexpr double kMovedByMeaning = 0.2;
/// Imaginary parts of angles: sines are thousands, and products of them have no digit left.
constexpr double kFar = 7;
/// Closures of a regular pose that are nearer are one.
constexpr double kSameRoot = 1e-6;

SolveResult solve_outside(const System& system, const Tracker& tracker, SolveOptions options,
                          const std::atomic<bool>& stop) {
  options.eliminate = false;  // multilinear equations have nothing that pays
  options.progress = nullptr;
  if (options.start == StartKind::automatic) options.start = StartKind::multihomogeneous;
  return solve(system, tracker, options, stop);
}

template <class Closure>
bool is_among(const Arm& arm, const JointVector<Complex>& values,
              const std::vector<Closure>& closures) {
  return std::any_of(closures.begin(), closures.end(), [&](const Closure& closure) {
    return distance_of(arm, closure.values, values) < kSameRoot;
  });
}

/// Of turns alone: a slide may go anywhere, and double knows where.
bool is_far(const Arm& arm, const JointVector<Complex>& values) {
  for (Eigen::Index k = 0; k < values.size(); ++k) {
    const bool is_slide = arm.joints[static_cast<std::size_t>(k)].is_slide;
    if (!is_slide && std::abs(values[k].imag()) > kFar) return true;
  }
  return false;
}

/// The closures that the solutions of a pose mean, put right on the arm.
SolvedPose read_closures(const Arm& arm, const Eigen::Isometry3d& pose, const Loop& loop,
                         const Cut& cut, const SolveResult& solved) {
  /// Roots that are nearer to real than this are tried as closures: double ones leave the real line
  /// by rounding.
  constexpr double kNearlyReal = 0.1;
  const Placement<Complex> wanted = complex_placement(pose);
  SolvedPose at;
  at.complete = solved.complete;
  at.are_right = true;
  for (const Solution& solution : solved.solutions) {
    const ReadBack read = read_back(loop, cut, solution.x, solution.accuracy);
    if (read.roots.empty()) {
      at.rejected += solution.multiplicity;
      continue;
    }
    if (read.moves || solution.multiplicity > 1) at.are_right = false;
    for (const LoopRoot& root : read.roots) {
      ApproachEnd end;
      end.values = values_of(loop, root);
      const bool is_nearly_real = end.values.imag().cwiseAbs().maxCoeff() < kNearlyReal;
      if (is_nearly_real) at.nearly_real.push_back(end.values.real());
      if (is_far(arm, end.values)) {
        ++at.far;
        continue;
      }
      if (!correct_at(arm, wanted, end.values, kMovedByMeaning, end.accuracy) ||
          is_among(arm, end.values, at.closures)) {
        at.are_right = false;
        continue;
      }
      end.kind = ApproachKind::regular;
      end.remaining = 0;
      end.path = solution.path;
      at.closures.push_back(std::move(end));
    }
  }
  return at;
}

RegularPose closures_of_values(const Arm& arm, const Eigen::VectorXd& own, const Tracker& tracker,
                               const SolveOptions& options, const std::atomic<bool>& stop) {
  RegularPose regular;
  regular.pose = forward_kinematics(arm, own);
  const Loop loop = make_loop(arm, regular.pose, options.seed);
  regular.cut = choose_cut(loop);
  regular.solved =
      solve_outside(cut_equations(loop, regular.cut, options.seed), tracker, options, stop);
  const SolvedPose at = read_closures(arm, regular.pose, loop, regular.cut, regular.solved);
  for (const ApproachEnd& end : at.closures) regular.roots.push_back({end.values, end.path});
  regular.far = at.far;
  regular.rejected = at.rejected;
  std::uint64_t roots = 0;
  for (const Solution& solution : regular.solved.solutions) roots += solution.multiplicity;
  regular.solved.solutions.clear();
  // Every form of a general arm has two false roots for a true one at most: where there are more,
  // true ones were not read back.
  const bool are_read = 3 * regular.rejected <= 2 * roots;
  regular.complete =
      at.complete && at.are_right && are_read && is_among(arm, own.cast<Complex>(), regular.roots);
  return regular;
}

/// Of random postures the one that is farthest from singular.
Eigen::VectorXd regular_values(const Arm& arm, std::uint64_t seed, std::uint64_t trial) {
  constexpr std::uint64_t kPostures = 30, kBehindOthers = 20000;
  Eigen::VectorXd best;
  double largest = -1;
  for (std::uint64_t k = 0; k < kPostures; ++k) {
    const Eigen::VectorXd values =
        random_joint_values(arm, seed, kBehindOthers + trial * kPostures + k);
    const double least = singular_values(tip_motion<double>(arm, values).screws).minCoeff();
    if (least > largest) largest = least, best = values;
  }
  return best;
}

}  // namespace

SolvedPose solve_at(const Arm& arm, const Eigen::Isometry3d& pose, const Tracker& tracker,
                    const SolveOptions& options, const std::atomic<bool>& stop) {
  const Loop loop = make_loop(arm, pose, options.seed);
  const Cut cut = choose_cut(loop);
  return read_closures(
      arm, pose, loop, cut,
      solve_outside(cut_equations(loop, cut, options.seed), tracker, options, stop));
}

RegularPose find_regular_pose(const Arm& arm, const Tracker& tracker, const SolveOptions& options,
                              const std::atomic<bool>& stop) {
  constexpr std::uint64_t kTries = 6, kInDouble = 2, kForFar = 3;
  RegularPose best;
  const auto is_wanted = [&](std::uint64_t trial) {
    return !best.complete || (best.far > 0 && trial < kForFar);
  };
  for (std::uint64_t k = 0; k < kTries && !stop && is_wanted(k); ++k) {
    SolveOptions here = options;
    if (k < kInDouble && options.precision == Precision::automatic) {
      here.precision = Precision::double_precision;
    }
    RegularPose regular =
        closures_of_values(arm, regular_values(arm, options.seed, k), tracker, here, stop);
    const bool has_more = regular.roots.size() > best.roots.size();
    const bool is_better =
        regular.complete > best.complete || (regular.complete == best.complete && has_more);
    if (k == 0 || is_better) best = std::move(regular);
  }
  return best;
}

}  // namespace moivre
