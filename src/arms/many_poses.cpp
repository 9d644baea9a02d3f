// SPDX-License-Identifier: MIT
// Many poses of one arm, by its family where that answers, one by one where not, on all threads.
#include <functional>
#include <mutex>
#include <optional>

#include "moivre/arms/arm_closures.h"
#include "moivre/arms/rules.h"
#include "moivre/expression/counted.h"
#include "moivre/numeric/invalid_input.h"
#include "moivre/numeric/stopwatch.h"
#include "moivre/numeric/threads.h"
#include "pose_family.h"
#include "random_values.h"
#include "read_closures.h"

namespace moivre {
namespace {

/// Learning two families costs as much as four poses.
constexpr std::size_t kWorthAFamily = 8;
/// Poses whose paths are followed together, a thread: their roots are kept until they are read back.
constexpr std::size_t kTogether = 128;

/// The family whose turns are counted from the seed's angles, with the number of closures that its poses have.
std::optional<PoseFamily> family_of(const Arm& arm, const Tracker& tracker, SolveOptions options,
                                    std::uint64_t seed, const std::atomic<bool>& stop) {
  options.seed = seed;
  auto family = learn_pose_family(arm, tracker, options, stop);
  if (!family) return std::nullopt;
  const Eigen::VectorXd anywhere = random_joint_values(arm, options.seed, 0);
  const ArmResult result =
      find_arm_closures(arm, forward_kinematics(arm, anywhere), tracker, options, stop);
  if (!result.complete || result.moves) return std::nullopt;
  family->closures = result.counts.complex;
  return family;
}

/// The pose's closures from the roots of its member; nullopt where they are not all that a pose has that is nothing special.
std::optional<ArmResult> result_of(const Arm& arm, const PoseFamily& family,
                                   const Eigen::Isometry3d& pose, const MemberRoots& roots,
                                   const Tracker& tracker, std::uint64_t seed) {
  ArmResult result;
  result.complete = true;
  result.seed = seed;
  result.pose = pose;
  result.tracker = tracker.kind();
  result.tracker_options = tracker.options_in_force();
  result.start.kind = "family";
  result.start.paths = result.paths.tracked = result.paths.finite = roots.roots.size();
  result.start.why = "the " + counted(roots.roots.size(), "root") + " of a generic member";
  result.stages.push_back({names_of(arm, family.cut.outside), 1, result.paths});
  std::vector<Solution> solutions;
  for (std::size_t k = 0; k < roots.roots.size(); ++k) {
    Solution& solution = solutions.emplace_back();
    solution.path = k;
    solution.x = roots.roots[k].x;
    solution.accuracy = roots.roots[k].accuracy;
  }
  read_closures(arm, loop_at(family, pose), family.cut, solutions, result);
  const bool is_plain = result.complete && !result.moves &&
                        result.counts.complex == family.closures &&
                        std::none_of(result.closures.begin(), result.closures.end(),
                                     [](const ArmClosure& closure) { return closure.singular; });
  return is_plain ? std::optional(std::move(result)) : std::nullopt;
}

/// Everything that the threads share.
struct Poses {
  const Arm& arm;
  const std::vector<Eigen::Isometry3d>& poses;
  const Tracker& tracker;
  SolveOptions of_one;
  const SolveOptions& options;
  const std::atomic<bool>& stop;
  std::vector<PoseFamily> families;
  std::vector<std::optional<ArmResult>> results;  ///< of a block; none of a pose that was not begun
  std::mutex telling;
  std::uint64_t done = 0;
  std::atomic<bool> has_thrown{false};  ///< the callback: no other pose begins

  void tell() {
    const std::lock_guard lock(telling);
    ++done;
    if (!options.progress || has_thrown) return;
    Progress progress;
    progress.done = done;
    progress.total = poses.size();
    progress.finite = done;
    try {
      options.progress(progress);
    } catch (...) {
      has_thrown = true;
      throw;
    }
  }
};

/// The roots of one pose, and the family that has them.
struct Followed {
  const PoseFamily* family = nullptr;
  MemberRoots roots;
};

/// Paths of all poses from `begin` on that have no roots yet.
void follow(Poses& all, const PoseFamily& family, std::size_t begin, std::size_t threads,
            std::vector<Followed>& followed) {
  std::vector<std::size_t> wanted;
  std::vector<Point> members;
  for (std::size_t k = 0; k < followed.size(); ++k) {
    if (followed[k].roots.complete) continue;
    wanted.push_back(k);
    members.push_back(member_of(family, loop_at(family, all.poses[begin + k])));
  }
  SolveOptions options = all.of_one;
  options.threads = static_cast<int>(threads);
  options.certify = false;  // Newton's method on the arm itself judges every closure
  auto roots = follow_members(family.family, members, all.tracker, options, all.stop);
  for (std::size_t k = 0; k < wanted.size(); ++k) {
    followed[wanted[k]] = {&family, std::move(roots[k])};
  }
}

/// Poses from `begin` to `end`.
void solve_range(Poses& all, std::size_t begin, std::size_t end, std::size_t threads) {
  const Stopwatch following;
  std::vector<Followed> followed(end - begin);
  for (const PoseFamily& family : all.families) follow(all, family, begin, threads, followed);
  const double share = following.total() / static_cast<double>(end - begin);
  std::atomic<std::size_t> next = begin;
  on_threads(static_cast<int>(std::min(threads, end - begin)), [&] {
    for (std::size_t k = next++; k < end && !all.stop && !all.has_thrown; k = next++) {
      const Stopwatch watch;
      std::optional<ArmResult> result;
      const Followed& own = followed[k - begin];
      if (own.roots.complete) {
        result =
            result_of(all.arm, *own.family, all.poses[k], own.roots, all.tracker, all.of_one.seed);
      }
      if (!result) {
        result = find_arm_closures(all.arm, all.poses[k], all.tracker, all.of_one, all.stop);
      }
      result->time_s.total = watch.total() + share;
      all.results[k - begin] = std::move(result);
      all.tell();
    }
  });
}

/// Two: a pose for which one family's tangents are nearly infinite has smaller ones in the other.
std::vector<PoseFamily> families_of(const Arm& arm, const Tracker& tracker,
                                    const SolveOptions& options, const std::atomic<bool>& stop) {
  constexpr std::uint64_t kBehindOthers = 3000;
  std::vector<PoseFamily> families;
  for (const std::uint64_t seed :
       {options.seed, random_bits(options.seed, RandomStream::arm, kBehindOthers)}) {
    auto family = family_of(arm, tracker, options, seed, stop);
    if (!family) break;
    families.push_back(std::move(*family));
  }
  return families;
}

}  // namespace

void for_each_pose(const Arm& arm, const std::vector<Eigen::Isometry3d>& given,
                   const Tracker& tracker, const std::function<void(ArmResult&& result)>& take,
                   const SolveOptions& options, const std::atomic<bool>& stop) {
  require_unbroken(arm);
  require_unbroken(validate(options));
  std::vector<Eigen::Isometry3d> poses;
  poses.reserve(given.size());
  for (std::size_t k = 0; k < given.size(); ++k) {
    poses.push_back(workable_pose(given[k], "pose " + std::to_string(k)));
  }
  const auto threads =
      std::min(poses.size(), static_cast<std::size_t>(thread_count(options.threads)));
  SolveOptions of_one = options;
  of_one.threads = 1;
  of_one.progress = nullptr;
  Poses all{arm, poses, tracker, of_one, options, stop, {}, {}, {}, 0, {}};
  const bool may_be_family = options.start == StartKind::automatic && poses.size() >= kWorthAFamily;
  if (may_be_family) all.families = families_of(arm, tracker, of_one, stop);
  const std::size_t block = kTogether * threads;
  for (std::size_t begin = 0; begin < poses.size() && !stop; begin += block) {
    const std::size_t end = std::min(begin + block, poses.size());
    all.results.assign(end - begin, std::nullopt);
    solve_range(all, begin, end, threads);
    for (std::optional<ArmResult>& result : all.results) {
      if (result) take(std::move(*result));
    }
  }
}

std::vector<ArmResult> find_arm_closures(const Arm& arm,
                                         const std::vector<Eigen::Isometry3d>& poses,
                                         const Tracker& tracker, const SolveOptions& options,
                                         const std::atomic<bool>& stop) {
  std::vector<ArmResult> begun;
  begun.reserve(poses.size());
  for_each_pose(
      arm, poses, tracker, [&](ArmResult&& result) { begun.push_back(std::move(result)); }, options,
      stop);
  return begun;
}

}  // namespace moivre
