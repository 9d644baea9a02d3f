// SPDX-License-Identifier: MIT
// From the mechanism to its closures: polynomials, blocks, roots, checks on every equation, poses by Newton-Raphson.
#include "moivre/closures/closures.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "canonical_order.h"
#include "closure_id.h"
#include "exact.h"
#include "moivre/expression/refusal.h"
#include "moivre/kinematics/newton.h"
#include "moivre/mechanism/pose.h"
#include "moivre/numeric/stopwatch.h"
#include "moving_pose.h"
#include "squared_up.h"
#include "stages.h"

namespace moivre {
namespace {

// Newton-Raphson polishes a pose; it does not look for another.
constexpr double kPolish = 1e-4;

double tolerance_of(const Solution& solution) {
  return solution.singular ? kHoldsSingular : kHolds;
}

class Search {
 public:
  Search(const Mechanism& mechanism, const Tracker& tracker, const ClosureOptions& options,
         const std::atomic<bool>& stop)
      : mechanism_(mechanism),
        tracker_(tracker),
        options_(options),
        stop_(stop),
        phi_(mechanism),
        isotropic_(isotropic_system(mechanism, options.time)) {}

  ClosureResult run();

 private:
  void describe();
  void solve_stages();
  void solve_free(const std::vector<Block>& blocks);
  bool shows_motion();
  StageRun solve_combined(StageRun first);
  void take_run(const StageRun& run);
  void take_branch(const PartialRoot& branch);
  void check_images();
  bool lies_on_motion(const Eigen::VectorXd& q);
  bool is_isolated_pose(const Solution& solution);
  void pose_all();
  void take_pose(const Solution& solution, const NewtonResult& polished);
  void tell_limits();
  void name_closures();
  std::string shortfall() const;
  void conclude();

  const Mechanism& mechanism_;
  const Tracker& tracker_;
  const ClosureOptions& options_;
  const std::atomic<bool>& stop_;
  Phi phi_;
  IsotropicSystem isotropic_;
  ClosureResult result_;
  std::map<std::size_t, std::uint64_t> beyond_limits_;  ///< joint -> closures that it filtered
  std::uint64_t lost_images_ = 0;
  std::uint64_t unpolished_ = 0;
  bool undecided_motion_ = false;
  bool part_is_complex_ = false;
};

void Search::describe() {
  const System& f = isotropic_.system;
  result_.seed = options_.solve.seed;
  result_.time = options_.time;
  result_.system = {f.variables, degrees(f), total_degree(degrees(f))};
  result_.start.why =
      "each group of bodies is solved on its own, once a branch of the groups before it";
  result_.tracker = tracker_.kind();
  result_.tracker_options = tracker_.options_in_force();
  result_.coordinates = phi_.dimension();
  result_.constraints = phi_.size() - phi_.driver_size();
  result_.complete = true;
  for (const std::string& name : isotropic_.repetitions) {
    result_.left_out.push_back({name, "it holds an angle that is held already, at the same value"});
  }
}

void Search::take_run(const StageRun& run) {
  result_.stages = run.stages;
  result_.paths = run.paths;
  result_.failures = run.failures;
  result_.work = run.work;
  result_.time_s = run.time;
  result_.complete = run.complete;
  result_.start.paths = run.paths.tracked;
  result_.left_out.insert(result_.left_out.end(), run.left_out.begin(), run.left_out.end());
  for (const Stage& stage : run.stages) {
    auto& all = result_.reduced;
    const auto& of_stage = stage.reduced;
    all.variables.insert(all.variables.end(), of_stage.variables.begin(), of_stage.variables.end());
    all.degrees.insert(all.degrees.end(), of_stage.degrees.begin(), of_stage.degrees.end());
  }
  result_.reduced.total_degree = total_degree(result_.reduced.degrees);
}

bool Search::shows_motion() {
  const auto found = moving_pose(mechanism_, phi_, options_.time, options_.solve.seed);
  if (!found) return false;
  result_.moves =
      Moves{static_cast<std::uint64_t>(found->moves.dimension), found->moves.shown, found->q};
  return true;
}

// With fewer equations than unknowns no closure is isolated. What no free unknown has a say in is solved first: where it
// closes in complex numbers only, so does the whole.
void Search::solve_free(const std::vector<Block>& blocks) {
  std::vector<Block> determined;
  std::copy_if(blocks.begin(), blocks.end(), std::back_inserter(determined),
               [](const Block& block) { return block.is_determined; });
  const StageRun run = solve_blocks(isotropic_, determined, tracker_, options_.solve, stop_);
  take_run(run);
  if (run.complete && !run.moves) {
    part_is_complex_ =
        std::none_of(run.branches.begin(), run.branches.end(),
                     [&](const PartialRoot& branch) { return may_be_real(isotropic_, branch); });
  }
  if (part_is_complex_ || shows_motion()) return;
  result_.complete = false;
  undecided_motion_ = true;
}

// The equations that were solved have a set of roots that the spare ones may cut to isolated ones.
StageRun Search::solve_combined(StageRun first) {
  IsotropicSystem combined = isotropic_;
  combined.system = squared_up(isotropic_.system, options_.solve.seed);
  StageRun run = solve_blocks(combined, block_structure(combined.system).blocks, tracker_,
                              options_.solve, stop_);
  for (Stage& stage : run.stages) stage.group += ", equations combined";
  run.stages.insert(run.stages.begin(), first.stages.begin(), first.stages.end());
  run.paths += first.paths;
  run.work += first.work;
  run.time.start += first.time.start;
  run.time.track += first.time.track;
  run.time.track_cpu += first.time.track_cpu;
  run.time.refine += first.time.refine;
  return run;
}

void Search::solve_stages() {
  const BlockStructure structure = block_structure(isotropic_.system);
  if (!structure.free_variables.empty()) return solve_free(structure.blocks);
  if (!structure.spare_equations.empty()) {
    result_.left_out.push_back(
        {std::to_string(structure.spare_equations.size()) + " of " +
             std::to_string(isotropic_.system.polynomials.size()) + " equations",
         "there are more than unknowns; every root is checked on all of them"});
  }
  StageRun run = solve_blocks(isotropic_, structure.blocks, tracker_, options_.solve, stop_);
  bool has_unseen_sets = run.moves && !(run.may_move && shows_motion());
  if (has_unseen_sets && run.complete && !structure.spare_equations.empty()) {
    run = solve_combined(std::move(run));
    has_unseen_sets = run.moves;
  }
  take_run(run);
  for (const PartialRoot& branch : run.branches) take_branch(branch);
  if (!has_unseen_sets) return;
  if (run.may_move) {
    result_.complete = false;
    undecided_motion_ = true;
  } else {
    result_.left_out.push_back({"closures that form sets of positive dimension",
                                "parts of them close in complex numbers only"});
    part_is_complex_ = result_.solutions.empty();
  }
}

void Search::take_branch(const PartialRoot& branch) {
  Solution solution;
  solution.path = branch.path;
  for (const auto& value : branch.value) solution.x.push_back(to_complex(value.value()));
  solution.singular = branch.singular;
  solution.multiplicity = branch.multiplicity;
  solution.winding = {static_cast<int>(branch.multiplicity)};
  solution.accuracy = branch.accuracy;
  solution.condition = branch.condition;
  solution.residual = residual_of_root(isotropic_, solution.x);
  if (solution.residual > tolerance_of(solution)) {
    ++result_.counts.rejected;
    return;
  }
  solution.real = distance_from_real(isotropic_, solution.x) <= tolerance_of(solution);
  result_.solutions.push_back(std::move(solution));
}

// The image of an isolated root is a root: one that is not there was lost.
void Search::check_images() {
  for (const Solution& solution : result_.solutions) {
    if (solution.real || solution.singular) continue;
    const Point image = mirrored(isotropic_, solution.x);
    const bool found =
        std::any_of(result_.solutions.begin(), result_.solutions.end(), [&](const Solution& other) {
          double distance = 0;
          for (std::size_t v = 0; v < image.size(); ++v) {
            distance = std::max(distance, std::abs(image[v] - other.x[v]));
          }
          return distance <= kHolds * std::max(1.0, max_norm(image));
        });
    if (!found) ++lost_images_;
  }
}

/// Is this pose of a multiple root one of many? Then the root is not isolated.
bool Search::lies_on_motion(const Eigen::VectorXd& q) {
  const LocalDimension local = local_dimension(phi_, q, options_.time, options_.solve.seed);
  if (local.dimension == 0) return false;
  result_.moves = Moves{static_cast<std::uint64_t>(local.dimension), local.shown, q};
  return true;
}

/// Polishes a real root to a pose. False where the pose is one of a set.
bool Search::is_isolated_pose(const Solution& solution) {
  const Eigen::VectorXd guess = coordinates_of_root(isotropic_, solution.x);
  const NewtonResult polished = newton(phi_, guess, options_.time);
  const double moved = (phi_.canonical(polished.q) - phi_.canonical(guess)).cwiseAbs().maxCoeff();
  const double size = std::max(1.0, guess.cwiseAbs().maxCoeff());
  // At half a turn the same angle has two names.
  const bool stayed = moved <= kPolish * size || (polished.q - guess).norm() <= kPolish * size;
  if (polished.status != NewtonStatus::converged || !stayed) {
    ++unpolished_;
    return true;
  }
  if (polished.is_singular && lies_on_motion(phi_.canonical(polished.q))) return false;
  take_pose(solution, polished);
  return true;
}

void Search::take_pose(const Solution& solution, const NewtonResult& polished) {
  const Eigen::VectorXd q = phi_.canonical(polished.q);
  ++result_.counts.real;
  const auto& joints = mechanism_.joints;
  const auto beyond = std::find_if(joints.begin(), joints.end(), [&](const Joint& joint) {
    return !is_within_limits(mechanism_, joint, q);
  });
  if (beyond != joints.end()) {
    ++result_.counts.filtered;
    ++beyond_limits_[static_cast<std::size_t>(beyond - joints.begin())];
    return;
  }
  Closure closure;
  closure.q = q;
  closure.residual = scaled_residual(phi_, q, options_.time);
  closure.newton_iterations = polished.steps();
  closure.smallest_singular_value = polished.smallest_singular_value;
  closure.path = solution.path;
  closure.multiplicity = solution.multiplicity;
  closure.singular = solution.singular;
  result_.closures.push_back(std::move(closure));
}

// A root where motions cross may look isolated to the solver; its pose tells, and its paths are counted anew.
void Search::pose_all() {
  std::vector<Solution> isolated;
  for (Solution& solution : result_.solutions) {
    if (!solution.real || is_isolated_pose(solution)) {
      isolated.push_back(std::move(solution));
    } else {
      result_.paths.on_positive_dimensional += solution.multiplicity;
      result_.stages.back().paths.on_positive_dimensional += solution.multiplicity;
    }
  }
  result_.solutions = std::move(isolated);
  result_.counts.complex = result_.solutions.size();
}

void Search::tell_limits() {
  for (const auto& [joint, count] : beyond_limits_) {
    const Joint& at = mechanism_.joints[joint];
    result_.left_out.push_back({std::to_string(count) + (count == 1 ? " closure" : " closures"),
                                "outside the limits of " + to_string(at.type) + " " + at.name});
  }
}

void Search::name_closures() {
  std::vector<Eigen::VectorXd> poses;
  for (const Closure& closure : result_.closures) poses.push_back(closure.q);
  std::vector<Closure> ordered;
  for (const std::size_t k : canonical_order(poses, coordinates(mechanism_))) {
    ordered.push_back(std::move(result_.closures[k]));
    ordered.back().id = closure_id(ordered.size() - 1);
  }
  result_.closures = std::move(ordered);
}

/// Why the run is not complete.
std::string Search::shortfall() const {
  if (undecided_motion_) {
    return "undecided: no closure is isolated, and Newton-Raphson came to no real pose from " +
           std::to_string(kMovingStarts) + " starts; there may be none: give a guess, or drivers";
  }
  if (lost_images_ > 0) return "a closure's mirror image is missing: a path was lost";
  if (unpolished_ > 0) return "a real root was found that Newton-Raphson does not confirm";
  return stop_ ? "interrupted: what is finished is reported" : "some paths failed";
}

void Search::conclude() {
  const auto& counts = result_.counts;
  if (!result_.complete || lost_images_ > 0 || unpolished_ > 0) {
    result_.complete = false;
    result_.message = shortfall();
  } else if (result_.moves) {
    result_.message =
        "moves: the closures form a set of positive dimension though the drivers stand";
  } else if (part_is_complex_) {
    result_.message = "cannot be assembled: a part of it closes in complex numbers only";
  } else if (counts.complex == 0) {
    result_.message = "cannot be assembled: there is no closure, not even a complex one";
  } else if (counts.real == 0) {
    result_.message =
        "cannot be assembled: every closure is complex (" + std::to_string(counts.complex) + ")";
  } else {
    result_.message = "every path was decided";
  }
}

ClosureResult Search::run() {
  const Stopwatch watch;
  describe();
  if (isotropic_.contradictions.empty()) solve_stages();
  check_images();
  pose_all();
  tell_limits();
  name_closures();
  if (!result_.closures.empty()) {
    result_.mobility = mobility(phi_, result_.closures.front().q, options_.time);
  } else if (result_.moves) {
    result_.mobility = mobility(phi_, result_.moves->pose, options_.time);
  }
  conclude();
  for (const std::string& name : isotropic_.contradictions) {
    result_.message += "; " + name + " holds an angle that is held at another value already";
  }
  result_.time_s.total = watch.total();
  return std::move(result_);
}

}  // namespace

ClosureResult find_closures(const Mechanism& mechanism, const Tracker& tracker,
                            const ClosureOptions& options, const std::atomic<bool>& stop) {
  require_drivers(mechanism, options.time);
  require_unbroken(validate(options.solve));
  return Search(mechanism, tracker, options, stop).run();
}

}  // namespace moivre
