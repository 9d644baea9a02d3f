// SPDX-License-Identifier: MIT
// Many poses of one arm, by its family where that answers, one by one where not, on all threads.
#include <functional>
#include <future>
#include <mutex>
#include <thread>

#include "moivre/arms/arm_closures.h"
#include "moivre/expression/refusal.h"
#include "moivre/numeric/stopwatch.h"
#include "pose_family.h"
#include "random_values.h"
#include "read_closures.h"

namespace moivre {
namespace {

/// Learning a family costs as much as two poses.
constexpr std::size_t kWorthAFamily = 6;
/// Poses whose paths are followed together, a thread: their roots are kept until they are read back.
constexpr std::size_t kTogether = 128;

void on_threads(std::size_t threads, const std::function<void()>& work) {
  std::vector<std::future<void>> helpers;
  for (std::size_t k = 1; k < threads; ++k) {
    helpers.push_back(std::async(std::launch::async, work));
  }
  work();
  for (std::future<void>& helper : helpers) helper.get();
}

/// The family, with the number of closures that its poses have.
std::optional<PoseFamily> family_of(const Arm& arm, const Tracker& tracker,
                                    const SolveOptions& options, const std::atomic<bool>& stop) {
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
  if (!roots.complete) return std::nullopt;
  ArmResult result;
  result.complete = true;
  result.seed = seed;
  result.pose = pose;
  result.tracker = tracker.kind();
  result.tracker_options = tracker.options_in_force();
  result.start.kind = "family";
  result.start.paths = result.paths.tracked = result.paths.finite = roots.roots.size();
  result.start.why = "the " + std::to_string(roots.roots.size()) + " roots of a generic member";
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
  std::optional<PoseFamily> family;
  std::vector<ArmResult> results;
  std::mutex telling;
  std::uint64_t done = 0;

  void tell() {
    const std::lock_guard lock(telling);
    ++done;
    if (!options.progress) return;
    Progress progress;
    progress.done = done;
    progress.total = poses.size();
    progress.finite = done;
    options.progress(progress);
  }
};

/// Paths to all members, and once more, with more care, to those where one was lost.
std::vector<MemberRoots> followed(const Poses& all, const std::vector<Point>& members,
                                  std::size_t threads) {
  SolveOptions options = all.of_one;
  options.threads = static_cast<int>(threads);
  options.certify = false;  // Newton's method on the arm itself judges every closure
  const Family& family = all.family->family;
  std::vector<MemberRoots> roots = follow_members(family, members, all.tracker, options, all.stop);
  std::vector<std::size_t> lost;
  std::vector<Point> again;
  for (std::size_t k = 0; k < members.size(); ++k) {
    if (roots[k].complete) continue;
    lost.push_back(k);
    again.push_back(members[k]);
  }
  ++options.care;
  std::vector<MemberRoots> better = follow_members(family, again, all.tracker, options, all.stop);
  for (std::size_t k = 0; k < lost.size(); ++k) roots[lost[k]] = std::move(better[k]);
  return roots;
}

/// Poses from `begin` to `end`; without a family `roots` is empty.
void solve_range(Poses& all, std::size_t begin, std::size_t end, std::size_t threads) {
  std::vector<MemberRoots> roots;
  double share = 0;
  if (all.family) {
    const Stopwatch watch;
    std::vector<Point> members;
    for (std::size_t k = begin; k < end; ++k) {
      members.push_back(member_of(*all.family, loop_at(*all.family, all.poses[k])));
    }
    roots = followed(all, members, threads);
    share = watch.total() / static_cast<double>(members.size());
  }
  std::atomic<std::size_t> next = begin;
  on_threads(std::min(threads, end - begin), [&] {
    for (std::size_t k = next++; k < end && !all.stop; k = next++) {
      const Stopwatch watch;
      std::optional<ArmResult> result;
      if (all.family) {
        result = result_of(all.arm, *all.family, all.poses[k], roots[k - begin], all.tracker,
                           all.of_one.seed);
      }
      if (!result) {
        result = find_arm_closures(all.arm, all.poses[k], all.tracker, all.of_one, all.stop);
      }
      all.results[k] = std::move(*result);
      all.results[k].time_s.total = watch.total() + share;
      all.tell();
    }
  });
}

}  // namespace

std::vector<ArmResult> find_arm_closures(const Arm& arm,
                                         const std::vector<Eigen::Isometry3d>& poses,
                                         const Tracker& tracker, const SolveOptions& options,
                                         const std::atomic<bool>& stop) {
  for (const Eigen::Isometry3d& pose : poses) require_finite(pose);
  require_unbroken(validate(options));
  const auto cores = std::max<std::size_t>(1, std::thread::hardware_concurrency());
  const std::size_t threads = std::min(
      poses.size(), options.threads > 0 ? static_cast<std::size_t>(options.threads) : cores);
  SolveOptions of_one = options;
  of_one.threads = 1;
  of_one.progress = nullptr;
  Poses all{arm, poses, tracker, of_one, options, stop, {}, std::vector<ArmResult>(poses.size()),
            {},  0};
  const bool may_be_family = options.start == StartKind::automatic && poses.size() >= kWorthAFamily;
  if (may_be_family) all.family = family_of(arm, tracker, of_one, stop);
  const std::size_t block = all.family ? kTogether * threads : poses.size();
  for (std::size_t begin = 0; begin < poses.size() && !stop; begin += block) {
    solve_range(all, begin, std::min(begin + block, poses.size()), threads);
  }
  std::erase_if(all.results, [](const ArmResult& result) { return result.time_s.total == 0; });
  return std::move(all.results);
}

}  // namespace moivre
