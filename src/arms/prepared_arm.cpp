// SPDX-License-Identifier: MIT
// The arm of six joints, its regular pose, and the account of what was solved there.
#include "prepared_arm.h"

#include <algorithm>
#include <string>

#include "moivre/expression/counted.h"
#include "moivre/expression/joined.h"
#include "random_values.h"
#include "self_motion.h"

namespace moivre {
namespace {

/// Joints that were added have no names, and are counted.
std::string names_of(const Arm& arm, const std::vector<std::size_t>& joints) {
  std::vector<std::string> names;
  for (const std::size_t k : joints) {
    if (!arm.joints[k].name.empty()) names.push_back(arm.joints[k].name);
  }
  const std::size_t added = joints.size() - names.size();
  if (added > 0) names.push_back(counted(added, "added joint"));
  return joined(names, ", ");
}

/// What was done instead of following paths in all joints.
LeftOut cut_told(const Arm& arm, const Cut& cut) {
  const std::string inside = names_of(arm, cut.inside);
  if (cut.kind == CutKind::two) {
    return {"unknowns of " + inside, "what two neighbours can do is given by linear equations"};
  }
  if (cut.kind == CutKind::two_in_quadric) {
    return {"unknowns of " + inside,
            "their axes meet or are parallel, or nearly: linear equations and a quadratic one"};
  }
  return {
      "paths of " + inside,
      "their axes meet in a point or are parallel: a group of motions, given by linear equations; "
      "its joints are then roots of a quadratic"};
}

ArmResult account_of(const PreparedArm& prepared, const Tracker& tracker) {
  ArmResult result;
  result.message.clear();
  result.seed = prepared.seed;
  result.tracker = tracker.kind();
  result.tracker_options = tracker.options_in_force();
  for (const ArmBeginning& beginning : prepared.beginnings) {
    const SolveResult& solved = beginning.regular.solved;
    result.start = solved.start;
    result.paths += solved.paths;
    result.failures.insert(result.failures.end(), solved.failures.begin(), solved.failures.end());
    result.work += solved.work;
    result.time_s.start += solved.time.start;
    result.time_s.track += solved.time.track;
    result.time_s.track_cpu += solved.time.track_cpu;
    result.time_s.refine += solved.time.refine;
    result.time_s.threads = solved.time.threads;
    result.counts.rejected += beginning.regular.rejected;
    const Arm& six = beginning.six.arm;
    result.stages.push_back({names_of(six, beginning.regular.cut.outside), 1, solved.paths});
  }
  if (prepared.beginnings.empty()) return result;
  const ArmBeginning& first = prepared.beginnings.front();
  result.left_out.push_back(cut_told(first.six.arm, first.regular.cut));
  return result;
}

}  // namespace

PreparedArm prepare(const Arm& arm, const Tracker& tracker, const SolveOptions& options,
                    const std::atomic<bool>& stop) {
  constexpr std::uint64_t kBehindOthers = 900, kCurvedTries = 4;
  constexpr double kIdleWithin = 1e-9, kDigits = 10;
  PreparedArm prepared{arm, options.seed, options, {}, false, true, {}};
  prepared.options.threads = 1;
  prepared.options.progress = nullptr;
  const auto idle =
      idle_in_every_posture(arm, options.seed, std::max(kIdleWithin, kDigits * arm.rounding));
  prepared.is_always_moving = !idle.empty();
  // A plane of joint space has a posture for any value of a joint that is held; a curved set may
  // have none.
  std::uint64_t tries = 1;
  if (prepared.is_always_moving) {
    const Eigen::VectorXd any = random_joint_values(arm, options.seed, kBehindOthers);
    const auto set = trace_set(arm, forward_kinematics(arm, any), any,
                               {std::max(kReach, kDigits * arm.rounding), options.seed});
    if (!set || set->motion.relations.empty()) tries = kCurvedTries;
  }
  for (std::uint64_t k = 0; k < tries && !stop; ++k) {
    const Eigen::VectorXd held = random_joint_values(arm, options.seed, kBehindOthers + 1 + k);
    ArmBeginning beginning{six_joints(arm, idle, held, options.seed), {}, {}};
    beginning.regular = find_regular_pose(beginning.six.arm, tracker, options, stop);
    beginning.formula = group_formula(beginning.six.arm, beginning.regular.cut);
    prepared.is_complete = prepared.is_complete && beginning.regular.complete;
    prepared.beginnings.push_back(std::move(beginning));
  }
  prepared.is_complete = prepared.is_complete && !stop;
  prepared.account = account_of(prepared, tracker);
  return prepared;
}

}  // namespace moivre
