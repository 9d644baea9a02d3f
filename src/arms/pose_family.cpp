// SPDX-License-Identifier: MIT
// Unit displacements in double, coefficients term by term.
#include "pose_family.h"

#include <algorithm>
#include <cmath>

#include "equations.h"
#include "moivre/family/coefficients.h"
#include "moivre/family/learn.h"
#include "random_values.h"
#include "read_back.h"

namespace moivre {
namespace {

/// Coefficients below this, relative to the largest, are zeros of the arm's structure: rounding of
/// sums of numbers near 1.
constexpr double kStructuralZero = 1e-13;

/// The member that the loop is.
Point member_of(const PoseFamily& poses, const Loop& loop) {
  const auto products = outside_product(loop, poses.loop.cut, &LoopJoint::rounded);
  Point member;
  for (std::size_t i = 0; i < poses.forms.size(); ++i) {
    for (const std::size_t bits : poses.terms[i]) {
      member.emplace_back(value(poses.forms[i], products[bits]));
    }
  }
  return member;
}

/// The system of all terms that any pose has, with the coefficients of one that is nothing special.
System typical_system(const Arm& arm, PoseFamily& poses, std::uint64_t seed) {
  constexpr std::uint64_t kTypical = 1000;
  const Eigen::Isometry3d pose = forward_kinematics(arm, random_joint_values(arm, seed, kTypical));
  const auto products =
      outside_product(loop_at(poses.loop, pose), poses.loop.cut, &LoopJoint::rounded);
  System system;
  system.variables = tangent_names(poses.loop.cut);
  for (const RealDisplacement& form : poses.forms) {
    std::vector<double> row;
    for (const RealDisplacement& product : products) row.push_back(value(form, product));
    const double largest =
        Eigen::Map<Eigen::VectorXd>(row.data(), std::ssize(row)).cwiseAbs().maxCoeff();
    TermMap map;
    for (std::size_t k = 0; k < row.size(); ++k) {
      if (std::abs(row[k]) > kStructuralZero * largest) map[multilinear(k)] = exact_value(row[k]);
    }
    system.polynomials.push_back(to_polynomial(std::move(map)));
    std::vector<std::size_t>& terms = poses.terms.emplace_back();
    for (const Term& term : system.polynomials.back().terms) {
      std::size_t bits = 0;
      for (const Power& power : term.monomial) bits |= std::size_t{1} << power.variable;
      terms.push_back(bits);
    }
  }
  return system;
}

/// The closures that the roots of one pose mean; empty where one could not be put right on the arm.
std::vector<ApproachEnd> ends_of(const PoseFamily& poses, const Arm& arm,
                                 const Eigen::Isometry3d& pose, const Loop& loop,
                                 const MemberRoots& roots) {
  constexpr double kMovedByMeaning = 0.2;
  std::vector<ApproachEnd> ends;
  const Placement<Complex> wanted = complex_placement(pose);
  for (const auto& solution : roots.roots) {
    for (const LoopRoot& root :
         read_back(loop, poses.loop.cut, solution.x, solution.accuracy).roots) {
      ApproachEnd& end = ends.emplace_back();
      end.values = values_of(loop, root);
      if (!correct_at(arm, wanted, end.values, kMovedByMeaning, end.accuracy)) return {};
      end.kind = ApproachKind::regular;
      end.remaining = 0;
    }
  }
  return ends;
}

}  // namespace

std::optional<PoseFamily> learn_pose_family(const Arm& arm, const Tracker& tracker,
                                            const SolveOptions& options,
                                            const std::atomic<bool>& stop) {
  PoseFamily poses;
  poses.loop = pose_loop(arm, options.seed);
  const Cut& cut = poses.loop.cut;
  if (cut.kind != CutKind::two && cut.kind != CutKind::three) return std::nullopt;
  for (const ExactDisplacement& form : cut.forms) poses.forms.push_back(unit(rounded(form)));
  const std::size_t unknowns = cut.outside.size();
  if (unknowns < poses.forms.size()) {
    poses.forms = combinations(poses.forms, unknowns, options.seed);
    for (RealDisplacement& form : poses.forms) form = unit(form);
  }
  const System typical = typical_system(arm, poses, options.seed);
  SolveOptions learning = options;
  learning.start = StartKind::multihomogeneous;
  learning.eliminate = false;
  learning.progress = nullptr;
  poses.family = learn(coefficient_family(typical), tracker, learning, stop);
  if (!poses.family.learning.complete) return std::nullopt;
  return poses;
}

std::vector<std::vector<ApproachEnd>> follow_poses(const PoseFamily& poses, const Arm& arm,
                                                   std::span<const TypedPose> wanted,
                                                   std::size_t closures, const Tracker& tracker,
                                                   const SolveOptions& options,
                                                   const std::atomic<bool>& stop) {
  std::vector<Loop> loops;
  std::vector<Point> members;
  for (const TypedPose& pose : wanted) {
    loops.push_back(loop_at(poses.loop, pose.pose));
    members.push_back(member_of(poses, loops.back()));
  }
  SolveOptions plain = options;
  plain.certify = false;  // Newton's method on the arm itself judges every closure
  plain.progress = nullptr;
  const auto roots = follow_members(poses.family, members, tracker, plain, stop);
  std::vector<std::vector<ApproachEnd>> all(wanted.size());
  for (std::size_t k = 0; k < wanted.size(); ++k) {
    std::vector<ApproachEnd> ends = ends_of(poses, arm, wanted[k].pose, loops[k], roots[k]);
    const bool is_plain =
        ends.size() == closures && are_different(arm, ends) && without_conjugate(arm, ends).empty();
    if (is_plain) all[k] = std::move(ends);
  }
  return all;
}

}  // namespace moivre
