// SPDX-License-Identifier: MIT
// One pose, and lists of poses: the arm is prepared once, the poses of a list are solved in blocks.
#include "moivre/arms/arm_closures.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <mutex>
#include <span>
#include <variant>

#include "moivre/arms/rules.h"
#include "moivre/expression/counted.h"
#include "moivre/numeric/invalid_input.h"
#include "moivre/numeric/stopwatch.h"
#include "moivre/numeric/threads.h"
#include "observed_results.h"
#include "pair_formula.h"
#include "pose_closures.h"
#include "pose_family.h"

namespace moivre {
namespace {

/// Searches from random postures as a witness of a pose alone. Of a list every kWitnessed-th pose
/// has one.
constexpr std::uint64_t kAsWitness = 4, kWitnessed = 8;
/// Poses from which on a family pays, and those that are followed together, a thread.
constexpr std::size_t kWorthAFamily = 8, kTogether = 128;
/// Of poses that are kept or shared: those that are drawn together, a thread, and those of a list.
constexpr std::size_t kDrawnTogether = 16, kOfAList = 4096;

/// Another pose of a list: nothing was solved for it, its closures came from the regular pose.
void tell_followed(const PreparedArm& prepared, const KnownOfPose& known, ArmResult& result) {
  std::uint64_t roots = 0;
  for (const ArmBeginning& beginning : prepared.beginnings) roots += beginning.regular.roots.size();
  result.start.source = known.by_formula ? StartSource::formula
                        : known.is_any() ? StartSource::family
                                         : StartSource::approach;
  result.start.why = known.by_formula ? "a formula proposes them; as many as a regular pose has"
                                      : "the " + counted(roots, "closure") + " of a regular pose";
  result.start.paths = roots;
  result.paths = {};
  result.paths.tracked = result.paths.finite = roots;
  result.work = {};
  result.time_s = {};
}

/// A rotation that is rounded is the nearest one. Throws InvalidInput where it is no pose.
TypedPose workable(const TypedPose& pose, const std::string& name) {
  if (!(pose.accuracy >= 0) || !std::isfinite(pose.accuracy)) {
    throw InvalidInput("the accuracy of " + name + " is finite and not negative");
  }
  return {workable_pose(pose.pose, name), pose.accuracy};
}

/// What proposes the closures of a pose.
struct PoseFormula {
  std::variant<GroupFormula, PairFormula> formula;
  bool is_as_typed = false;  ///< not only for the geometry that the file's digits stand for
};

/// An arm whose poses are many: prepared once, with a family where that pays.
struct PreparedList {
  PreparedArm prepared;
  std::optional<PoseFormula> formula;  ///< of an arm with one beginning, tried at its regular pose
  std::optional<PoseFamily> family;
  double share = 0;  ///< seconds that each pose has of it
};

/// All closures of a pose, where the formula leads to as many as the regular pose has.
std::optional<FoundClosures> closures_by(const PoseFormula& formula, const ArmBeginning& beginning,
                                         const Eigen::Isometry3d& pose) {
  const auto proposed = std::visit(
      [&](const auto& of_arm) { return proposed_closures(of_arm, pose); }, formula.formula);
  auto found = closures_proposed(proposed, beginning.six.arm, pose, beginning.regular.roots.size());
  if (found) found->are_all = formula.is_as_typed;
  return found;
}

/// Where it finds all closures of the regular pose.
std::optional<PoseFormula> formula_of(const ArmBeginning& beginning, std::uint64_t seed) {
  constexpr double kRounding = 1e-9;
  const Arm& six = beginning.six.arm;
  std::optional<PoseFormula> formula;
  if (beginning.formula) {
    formula = PoseFormula{*beginning.formula};
  } else if (auto pair = pair_formula(six, seed)) {
    formula = PoseFormula{std::move(*pair)};
  }
  if (!formula) return std::nullopt;
  const auto found = closures_by(*formula, beginning, beginning.regular.pose);
  if (!found) return std::nullopt;
  formula->is_as_typed = found->moved <= kRounding;
  return formula;
}

PreparedList prepare_list(const Arm& arm, std::size_t poses, const Tracker& tracker,
                          const SolveOptions& options, const std::atomic<bool>& stop) {
  const Stopwatch watch;
  PreparedList list{prepare(arm, tracker, options, stop), std::nullopt, std::nullopt, 0};
  const PreparedArm& prepared = list.prepared;
  const bool has_one_count = options.start == StartKind::automatic && !prepared.is_always_moving &&
                             prepared.is_complete && prepared.beginnings.front().regular.far == 0;
  if (has_one_count) list.formula = formula_of(prepared.beginnings.front(), options.seed);
  if (has_one_count && !list.formula && poses >= kWorthAFamily) {
    const Arm& six = prepared.beginnings.front().six.arm;
    list.family = learn_pose_family(six, tracker, prepared.options, stop);
  }
  list.share = watch.total() / static_cast<double>(std::max<std::size_t>(1, poses));
  return list;
}

/// Solves poses in blocks, on all threads, and hands on what was begun in the order of the poses.
class PoseList {
 public:
  PoseList(PreparedList list, const std::vector<TypedPose>& poses, const Tracker& tracker,
           const SolveOptions& options, const std::atomic<bool>& stop)
      : list_(std::move(list)), poses_(poses), tracker_(tracker), options_(options), stop_(stop) {
    progress_.total = poses.size();
    list_.prepared.options.observations = nullptr;  // whole results are kept
  }

  std::size_t block() const {
    return options_.observations == nullptr ? kTogether * threads() : kOfAList;
  }

  void solve(std::size_t begin, std::size_t count,
             const std::function<void(ArmResult&& result)>& take) {
    ResultJobs jobs;
    if (options_.observations != nullptr) jobs.list = list_of(begin, count);
    jobs.count = count;
    jobs.together = kDrawnTogether * threads();
    jobs.pose = [&](std::size_t job) -> const Eigen::Isometry3d& {
      return poses_[begin + job].pose;
    };
    jobs.solve = [&](std::span<const std::size_t> some) { return solve_some(begin, some); };
    jobs.tell = [&] { tell(); };
    observe_results(jobs, tracker_, options_, stop_, take);
  }

 private:
  std::size_t threads() const {
    return std::max<std::size_t>(
        1, std::min(poses_.size(), static_cast<std::size_t>(thread_count(options_.threads))));
  }

  Fingerprint list_of(std::size_t begin, std::size_t count) const {
    FingerprintMaker maker;
    maker.add(std::string_view("poses"));
    add_to(maker, list_.prepared.arm);
    add_to(maker, tracker_, options_);
    maker.add(std::uint64_t{list_.family.has_value()});
    maker.add(std::uint64_t{begin});
    for (std::size_t k = 0; k < count; ++k) add_to(maker, poses_[begin + k]);
    return maker.fingerprint();
  }

  std::vector<std::optional<ArmResult>> solve_some(std::size_t begin,
                                                   std::span<const std::size_t> some) {
    const auto followed = follow(begin, some);
    std::vector<std::optional<ArmResult>> results(some.size());
    std::atomic<std::size_t> next = 0;
    on_threads(static_cast<int>(std::min(some.size(), threads())), [&] {
      for (std::size_t k = next++; k < some.size() && !stop_ && !has_thrown_; k = next++) {
        const std::size_t pose = begin + some[k];
        results[k] = solve_one(pose, KnownOfPose{followed[k], by_formula(pose)});
        tell();
      }
    });
    return results;
  }

  /// The ends of these poses by the family; empty where it does not answer.
  std::vector<std::vector<ApproachEnd>> follow(std::size_t begin,
                                               std::span<const std::size_t> some) const {
    if (!list_.family) return std::vector<std::vector<ApproachEnd>>(some.size());
    const ArmBeginning& beginning = list_.prepared.beginnings.front();
    SolveOptions together = list_.prepared.options;
    together.threads = static_cast<int>(threads());
    std::vector<TypedPose> poses;
    for (const std::size_t k : some) poses.push_back(poses_[begin + k]);
    return follow_poses(*list_.family, beginning.six.arm, poses, beginning.regular.roots.size(),
                        tracker_, together, stop_);
  }

  std::optional<FoundClosures> by_formula(std::size_t pose) const {
    if (!list_.formula) return std::nullopt;
    return closures_by(*list_.formula, list_.prepared.beginnings.front(), poses_[pose].pose);
  }

  ArmResult solve_one(std::size_t pose, const KnownOfPose& known) const {
    const Stopwatch watch;
    ArmResult result = closures_at(list_.prepared, poses_[pose], known,
                                   pose % kWitnessed == 0 ? 1 : 0, tracker_, stop_);
    if (pose > 0 || known.is_any()) tell_followed(list_.prepared, known, result);
    result.time_s.total = watch.total() + list_.share;
    return result;
  }

  void tell() {
    const std::lock_guard lock(telling_);
    progress_.finite = ++progress_.done;
    if (!options_.progress || has_thrown_) return;
    try {
      options_.progress(progress_);
    } catch (...) {
      has_thrown_ = true;
      throw;
    }
  }

  PreparedList list_;
  const std::vector<TypedPose>& poses_;
  const Tracker& tracker_;
  const SolveOptions& options_;
  const std::atomic<bool>& stop_;
  std::mutex telling_;
  Progress progress_;
  std::atomic<bool> has_thrown_{false};  // the callback: no other pose begins
};

}  // namespace

ArmResult find_arm_closures(const Arm& arm, const TypedPose& given, const Tracker& tracker,
                            const SolveOptions& options, const std::atomic<bool>& stop) {
  require_unbroken(arm);
  require_unbroken(validate(options));
  const TypedPose pose = workable(given, "the pose");
  const Stopwatch watch;
  const PreparedArm prepared = prepare(arm, tracker, options, stop);
  ArmResult result = closures_at(prepared, pose, KnownOfPose{}, kAsWitness, tracker, stop);
  result.time_s.total = watch.total();
  return result;
}

ArmResult find_arm_closures(const Arm& arm, const Eigen::Isometry3d& pose, const Tracker& tracker,
                            const SolveOptions& options, const std::atomic<bool>& stop) {
  return find_arm_closures(arm, TypedPose{pose}, tracker, options, stop);
}

void for_each_pose(const Arm& arm, const std::vector<TypedPose>& given, const Tracker& tracker,
                   const std::function<void(ArmResult&& result)>& take, const SolveOptions& options,
                   const std::atomic<bool>& stop) {
  require_unbroken(arm);
  require_unbroken(validate(options));
  std::vector<TypedPose> poses;
  poses.reserve(given.size());
  for (std::size_t k = 0; k < given.size(); ++k) {
    poses.push_back(workable(given[k], "pose " + std::to_string(k)));
  }
  PoseList list(prepare_list(arm, poses.size(), tracker, options, stop), poses, tracker, options,
                stop);
  const std::size_t block = list.block();
  for (std::size_t begin = 0; begin < poses.size() && !stop; begin += block) {
    list.solve(begin, std::min(block, poses.size() - begin), take);
  }
}

namespace {

std::vector<TypedPose> as_they_stand(const std::vector<Eigen::Isometry3d>& poses) {
  std::vector<TypedPose> typed;
  typed.reserve(poses.size());
  for (const Eigen::Isometry3d& pose : poses) typed.push_back({pose});
  return typed;
}

}  // namespace

void for_each_pose(const Arm& arm, const std::vector<Eigen::Isometry3d>& poses,
                   const Tracker& tracker, const std::function<void(ArmResult&& result)>& take,
                   const SolveOptions& options, const std::atomic<bool>& stop) {
  for_each_pose(arm, as_they_stand(poses), tracker, take, options, stop);
}

std::vector<ArmResult> find_arm_closures(const Arm& arm, const std::vector<TypedPose>& poses,
                                         const Tracker& tracker, const SolveOptions& options,
                                         const std::atomic<bool>& stop) {
  std::vector<ArmResult> begun;
  begun.reserve(poses.size());
  for_each_pose(
      arm, poses, tracker, [&](ArmResult&& result) { begun.push_back(std::move(result)); }, options,
      stop);
  return begun;
}

std::vector<ArmResult> find_arm_closures(const Arm& arm,
                                         const std::vector<Eigen::Isometry3d>& poses,
                                         const Tracker& tracker, const SolveOptions& options,
                                         const std::atomic<bool>& stop) {
  return find_arm_closures(arm, as_they_stand(poses), tracker, options, stop);
}

}  // namespace moivre
