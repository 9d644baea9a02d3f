// SPDX-License-Identifier: MIT
// Blocks in turn: known values substituted, lone linear equations solved exactly, the rest by
// homotopy continuation.
#include "moivre/closures/stages.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <stdexcept>
#include <utility>

#include "block_sources.h"
#include "closure_sentences.h"
#include "lone_equation.h"
#include "moivre/formulation/exact.h"
#include "moivre/numeric/near_points.h"
#include "moivre/polynomial/eliminate.h"
#include "quadratic_block.h"
#include "shared_above.h"

namespace moivre {
namespace {

// A simple root is known far better than this, a multiple one just so: what is larger beside its
// terms does not vanish.
constexpr double kNearExclusion = 1e-6;

// Beside its size a root that rounding has moved from a real pose is not so far from real.
constexpr double kClearlyComplex = 0.1;

// Where nothing is proved: a simple root is known to rounding, and what vanishes there does so to
// 1e-14.
constexpr double kVanishes = 1e-13;

/// Above all roots that have the values in its equations in common.
struct BlockSolve {
  BlockRoots result;
  std::vector<std::vector<KnownValue>> values;  ///< of each solution, by the block's variables
};

/// Two paths that are led to one root prove one.
void drop_repeated_proofs(std::vector<PartialRoot>& children) {
  std::vector<KnownProof> proofs;
  for (const PartialRoot& child : children) proofs.push_back(child.proof);
  const std::vector<bool> is_new = RootProver::are_new(proofs);
  for (std::size_t k = 0; k < children.size(); ++k) {
    if (!is_new[k]) children[k].proof = nullptr;
  }
}

/// Whether as many roots are proved as the block's degrees allow, or, where nothing put into it was
/// rounded in double, as its start has paths.
bool has_proved_bound(const BlockRoots& result, const std::vector<PartialRoot>& children,
                      std::uint64_t by_degrees, bool is_exact) {
  const bool all_proved =
      std::all_of(children.begin(), children.end(),
                  [](const PartialRoot& child) { return child.proof != nullptr; });
  if (!result.complete || !all_proved) return false;
  if (by_degrees > 0 && children.size() == by_degrees) return true;
  if (!is_exact) return false;
  if (result.bound) return result.bound->value == children.size();
  const bool is_bound = result.start.source == StartSource::total_degree ||
                        result.start.source == StartSource::multihomogeneous;
  return is_bound && result.paths.tracked == children.size();
}

class Stages {
 public:
  Stages(const Formulation& formulation, const std::vector<Block>& blocks,
         const BlockSolving& solving, RootProver& prover, PartialRoot begun,
         const Formulation* whole)
      : formulation_(formulation),
        whole_(whole),
        blocks_(blocks),
        solving_(solving),
        prover_(prover) {
    begun.value.resize(formulation.system.variables.size());
    run_.roots.push_back(std::move(begun));
    if (whole == nullptr) return;
    unasked_.resize(whole->system.polynomials.size());
    std::iota(unasked_.begin(), unasked_.end(), std::size_t{0});
  }

  StageRun run() && {
    for (const Block& block : blocks_) {
      solve_block(block);
      if (whole_ != nullptr) reject_what_fails();
    }
    return std::move(*this).take();
  }

 private:
  void solve_block(const Block& block) {
    if (run_.roots.empty()) return;
    if (LoneEquation::is_one(formulation_.system, block)) return solve_lone(block);
    prover_.add(block);
    prover_.close();
    const QuadraticBlock formula(formulation_, block);
    BlockSources sources(formulation_, block, solving_, formula, proved_poses_of(block));
    SharedAbove<BlockSolve> solves(formulation_.system, block);
    Stage stage;
    stage.group = group_name(block);
    const Before before{run_.is_proved, run_.complete, run_.failures.size()};
    std::vector<PartialRoot> next;
    for (const PartialRoot& root : run_.roots) {
      if (solving_.stop) run_.complete = false;
      if (solving_.stop) break;
      bool is_new = false;
      const BlockSolve& solve = solves.above(root, [&] {
        is_new = true;
        return solved(sources.roots_above(root));
      });
      if (!is_new) ++shared_;
      add_roots(block, formula.bound(), solve, root, stage, next);
    }
    if (const auto bound = bound_of(formulation_, block); bound && run_.roots.size() == 1) {
      settle_by_bound(*bound, before, next, stage);
    }
    run_.paths += stage.paths;
    run_.stages.push_back(std::move(stage));
    run_.roots = std::move(next);
  }

  /// No real pose is near: nothing above the root is one that closes, or that tells what it misses
  /// by.
  bool fails(const PartialRoot& root, const ResidualOfRoots& residual) const {
    const double most = root.singular ? kHoldsSingular : kHolds;
    return distance_from_image(formulation_, root) > kClearlyComplex &&
           residual(known_values(root)) > most;
  }

  /// What is solved above a root at which an equation fails, though it was none of those that were
  /// solved, is no pose. Each equation is asked once, as soon as its unknowns are known.
  void reject_what_fails() {
    if (run_.roots.empty()) return;
    const auto known = of_known_alone(*whole_, run_.roots.front(), unasked_);
    if (known.empty()) return;
    std::erase_if(unasked_,
                  [&](std::size_t e) { return std::binary_search(known.begin(), known.end(), e); });
    const ResidualOfRoots residual(*whole_, known);
    std::erase_if(run_.roots, [&](const PartialRoot& root) {
      if (!fails(root, residual)) return false;
      run_.rejected += root.multiplicity;
      return true;
    });
  }

  StageRun take() && {
    prove_all();
    run_.time.threads = std::max(1, run_.time.threads);
    std::vector<LeftOut>& left_out = run_.left_out;
    if (lone_ > 0) left_out.push_back(lone_equations_left_out(lone_));
    if (shared_ > 0) left_out.push_back(shared_paths_left_out(shared_));
    if (run_.rejected > 0) left_out.push_back(blocks_above_rejected_left_out(run_.rejected));
    if (formulas_ > 0) left_out.push_back(paths_of_formulas_left_out(formulas_));
    return std::move(run_);
  }

  /// What was so before a block.
  struct Before {
    bool is_proved;
    bool is_complete;
    std::size_t failures;
  };

  /// Where as many poses are proved as a theorem allows, paths in doubt lead to none.
  void settle_by_bound(const Formulation::Bound& bound, const Before& before,
                       const std::vector<PartialRoot>& poses, Stage& stage) {
    if (poses.size() < bound.most) return;
    const bool all_proved = std::all_of(
        poses.begin(), poses.end(), [](const PartialRoot& root) { return root.proof != nullptr; });
    if (!all_proved) return;
    if (poses.size() > bound.most) {
      throw std::logic_error(std::to_string(poses.size()) + " poses are proved, but " + bound.of +
                             " has no more than " + std::to_string(bound.most));
    }
    run_.is_proved = before.is_proved;
    if (run_.complete == before.is_complete) return;
    stage.paths.not_needed += std::exchange(stage.paths.failed, 0);
    run_.left_out.push_back(doubtful_paths_left_out_by_bound(run_.failures.size() - before.failures,
                                                             bound.most, bound.of));
    run_.failures.resize(before.failures);
    run_.complete = before.is_complete;
  }

  /// The block has a set of roots of positive dimension above the root.
  void note_set(const PartialRoot& root) {
    run_.moves = true;
    run_.may_move = run_.may_move || may_be_real(formulation_, root);
  }

  /// The exclusions in which an unknown of the block stands: what the others say of a root is known
  /// from the blocks before.
  std::vector<const Formulation::Exclusion*> exclusions_of(const Block& block) const {
    std::vector<const Formulation::Exclusion*> found;
    const auto is_of_block = [&](const Power& power) {
      return std::binary_search(block.variables.begin(), block.variables.end(), power.variable);
    };
    for (const Formulation::Exclusion& exclusion : formulation_.exclusions) {
      const auto& terms = exclusion.of.terms;
      const bool is_told = std::any_of(terms.begin(), terms.end(), [&](const Term& term) {
        return std::any_of(term.monomial.begin(), term.monomial.end(), is_of_block);
      });
      if (is_told) found.push_back(&exclusion);
    }
    return found;
  }

  static std::vector<std::optional<Complex>> rounded_values(const PartialRoot& root) {
    std::vector<std::optional<Complex>> values;
    for (const KnownValue& value : root.value) {
      values.push_back(value ? std::optional(value->rounded) : std::nullopt);
    }
    return values;
  }

  /// That the root is no pose, as the block's unknowns say; nullptr where it may be one.
  const Formulation::Exclusion* exclusion_at(const PartialRoot& root, const Block& block) {
    if (&block != block_of_exclusions_) {
      exclusions_ = exclusions_of(block);
      block_of_exclusions_ = &block;
    }
    if (exclusions_.empty()) return nullptr;
    const std::vector<std::optional<Complex>> values = rounded_values(root);
    for (const Formulation::Exclusion* const exclusion : exclusions_) {
      const auto share = share_left(*exclusion, values);
      if (!share || !(*share <= kNearExclusion)) continue;
      const std::optional<bool> proved = prover_.vanishes(root.proof, *exclusion);
      if (proved.value_or(root.singular || *share <= kVanishes)) return exclusion;
    }
    return nullptr;
  }

  /// Whether the root is no pose; counted where so.
  bool is_excluded(const PartialRoot& root, const Block& block) {
    const Formulation::Exclusion* const exclusion = exclusion_at(root, block);
    if (!exclusion) return false;
    // Rounding that moves the root as far as it likes may have made it no pose.
    if (root.condition >= kUndetermined) run_.is_proved = false;
    run_.excluded[exclusion->reason] += root.multiplicity;
    return true;
  }

  /// Whether all unknowns of a block's lone equation are known above the root, but its own.
  bool is_lone_above(const PartialRoot& root, const Block& block) const {
    if (!LoneEquation::is_one(formulation_.system, block)) return false;
    const auto& terms = formulation_.system.polynomials[block.equations.front()].terms;
    return std::all_of(terms.begin(), terms.end(), [&](const Term& term) {
      return std::all_of(term.monomial.begin(), term.monomial.end(), [&](const Power& power) {
        return power.variable == block.variables.front() || root.value[power.variable];
      });
    });
  }

  /// Whether a point on a set of the block's roots is no pose: as the block's unknowns say, or one
  /// that a linear equation of a later block gives alone. A dyad's half angles and slides come
  /// after its coordinates.
  bool is_excluded_from_sets(PartialRoot point, const Block& block) {
    if (is_excluded(point, block)) return true;
    for (const Block& later : blocks_) {
      if (point.value[later.variables.front()] || !is_lone_above(point, later)) continue;
      const KnownValue x = LoneEquation(formulation_.system, later).above(point).x;
      if (!x) continue;
      point.value[later.variables.front()] = x;
      if (is_excluded(point, later)) return true;
    }
    return false;
  }

  /// Its x put in above every root so far.
  void solve_lone(const Block& block) {
    ++lone_;
    prover_.add(block);
    LoneEquation equation(formulation_.system, block);
    std::vector<PartialRoot> next;
    for (PartialRoot& root : run_.roots) {
      const LoneEquation::Answer& answer = equation.above(root);
      if (answer.x) {
        root.value[block.variables.front()] = answer.x;
        next.push_back(std::move(root));
        continue;
      }
      if (answer.is_free) note_set(root);
      run_.is_proved = false;
    }
    run_.roots = std::move(next);
    if (exclusions_of(block).empty()) return;
    prove_all();
    std::erase_if(run_.roots, [&](const PartialRoot& root) { return is_excluded(root, block); });
  }

  BlockSolve solved(BlockRoots&& roots) {
    BlockSolve solve{std::move(roots), {}};
    for (const Solution& solution : solve.result.solutions) {
      solve.values.push_back(values_of(solution));
    }
    if (solve.result.by == BlockSourceKind::formula) ++formulas_;
    if (solve.result.by == BlockSourceKind::least_squares) run_.is_proved = false;
    run_.work += solve.result.work;
    run_.time.threads = std::max(run_.time.threads, solve.result.time.threads);
    add_solving(solve.result.time, run_.time);
    return solve;
  }

  /// How many of the solutions above a root are proved to be poses; empty where nothing is proved.
  ProvedPoses proved_poses_of(const Block& block) {
    if (!prover_.is_on()) return {};
    return [this, &block](const PartialRoot& root, const std::vector<Solution>& solutions) {
      return std::count_if(solutions.begin(), solutions.end(), [&](const Solution& solution) {
        const PartialRoot child = child_of(root, block, solution, values_of(solution));
        return child.proof && !exclusion_at(child, block);
      });
    };
  }

  static std::vector<KnownValue> values_of(const Solution& solution) {
    std::vector<KnownValue> values;
    for (const Complex& xi : solution.x)
      values.push_back(std::make_shared<const Known>(exactly(xi)));
    return values;
  }

  /// The roots of its solve above this one, accounted as if nothing else stood above it.
  void add_roots(const Block& block, std::uint64_t bound, const BlockSolve& solve,
                 const PartialRoot& root, Stage& stage, std::vector<PartialRoot>& next) {
    const BlockRoots& result = solve.result;
    const std::uint64_t first_path = stage.paths.tracked;
    std::vector<PartialRoot> children;
    for (std::size_t k = 0; k < result.solutions.size(); ++k) {
      children.push_back(child_of(root, block, result.solutions[k], solve.values[k]));
      children.back().path = first_path + result.solutions[k].path;
    }
    drop_repeated_proofs(children);
    run_.is_proved = run_.is_proved && prover_.is_on() &&
                     has_proved_bound(result, children, bound,
                                      root.proof == nullptr && prover_.has_general_numbers());
    if (has_blocks_above(block)) merge_parted(block, root, result.solutions, children);
    for (PartialRoot& child : children) {
      if (!is_excluded(child, block)) next.push_back(std::move(child));
    }
    for (FailedPath failure : result.failures) {
      failure.path += first_path;
      run_.failures.push_back(failure);
    }
    if (stage.solves++ == 0) {
      stage.reduced = result.reduced;
      run_.left_out.insert(run_.left_out.end(), result.left_out.begin(), result.left_out.end());
    }
    stage.paths += result.paths;
    if (result.start.paths > run_.largest_start.paths) run_.largest_start = result.start;
    run_.complete = run_.complete && result.complete;
    const bool is_dependent = result.paths.tracked == 0 && result.complete &&
                              eliminate(system_at(formulation_.system, block, root)).verdict ==
                                  Reduction::Verdict::dependent;
    const bool has_set =
        std::any_of(result.on_sets.begin(), result.on_sets.end(), [&](const Solution& on_set) {
          return !is_excluded_from_sets(child_of(root, block, on_set, values_of(on_set)), block);
        });
    if (is_dependent || has_set) note_set(root);
  }

  /// Whether others than lone equations come after it.
  bool has_blocks_above(const Block& block) const {
    return std::any_of(blocks_.begin(), blocks_.end(), [&](const Block& later) {
      return &later > &block && !LoneEquation::is_one(formulation_.system, later);
    });
  }

  /// Two simple roots of a block that rounding may have made of a double one are that: a cluster of
  /// two. Else the blocks above part anew, by the square root of what parts these, and what is one
  /// root looks like four. Of the last block poses tell.
  void merge_parted(const Block& block, const PartialRoot& before,
                    const std::vector<Solution>& solutions,
                    std::vector<PartialRoot>& children) const {
    constexpr double kIllConditioned = 1e7;
    std::vector<std::size_t> parted;
    for (std::size_t k = 0; k < children.size(); ++k) {
      const bool is_simple = !solutions[k].singular && children[k].proof == nullptr;
      if (is_simple && solutions[k].condition >= kIllConditioned) parted.push_back(k);
    }
    std::vector<bool> is_merged(children.size());
    for (auto i = parted.begin(); i != parted.end(); ++i) {
      if (is_merged[*i]) continue;
      const auto other = std::find_if(i + 1, parted.end(), [&](std::size_t j) {
        const double gap = max_distance(solutions[*i].x, solutions[j].x);
        const double condition = std::max(solutions[*i].condition, solutions[j].condition);
        return !is_merged[j] && is_of_parted(condition, gap) &&
               merge(block, children[j], gap, children[*i]);
      });
      if (other == parted.end()) continue;
      children[*i].condition = before.condition;
      is_merged[*other] = true;
    }
    std::size_t k = 0;
    std::erase_if(children, [&](const PartialRoot&) { return is_merged[k++]; });
  }

  /// False where the block's equations do not vanish between the two.
  bool merge(const Block& block, const PartialRoot& other, double gap, PartialRoot& into) const {
    PartialRoot between = into;
    for (const std::size_t v : block.variables) {
      const Complex mean = 0.5 * (into.value[v]->rounded + other.value[v]->rounded);
      between.value[v] = std::make_shared<const Known>(exactly(mean));
    }
    const ResidualOfRoots residual(formulation_, block.equations);
    if (residual(known_values(between)) > rounding_left(formulation_)) return false;
    into = std::move(between);
    into.multiplicity += other.multiplicity;
    into.singular = into.cluster = true;
    into.isolated = false;
    into.accuracy = std::max({into.accuracy, other.accuracy, gap});
    return true;
  }

  PartialRoot child_of(const PartialRoot& root, const Block& block, const Solution& solution,
                       const std::vector<KnownValue>& values) {
    PartialRoot child = root;
    for (std::size_t k = 0; k < block.variables.size(); ++k) {
      child.value[block.variables[k]] = values[k];
    }
    child.multiplicity *= solution.multiplicity;
    // Above rounded values a multiplicity is one of other equations.
    child.cluster |= solution.multiplicity > 1 &&
                     (solution.cluster || !run_.stages.empty() || !prover_.has_exact_numbers());
    child.isolated = child.isolated && solution.certified == true && run_.stages.empty();
    child.singular |= solution.singular;
    child.accuracy = std::max(child.accuracy, solution.accuracy);
    child.condition = std::max(child.condition, solution.condition);
    prove(child);
    if (solving_.with_fine_values && child.proof) know_finely(block, child);
    return child;
  }

  /// What is above the root may be a set, or none, by less than double rounds it.
  void know_finely(const Block& block, PartialRoot& root) {
    std::vector<Coefficient> fine = prover_.fine_values(root.proof, block.variables);
    for (std::size_t k = 0; k < fine.size(); ++k) {
      root.value[block.variables[k]] = std::make_shared<const Known>(std::move(fine[k]));
    }
  }

  /// Of the prover's last group.
  void prove(PartialRoot& root) {
    if (!prover_.is_on()) return;
    const KnownProof before = std::exchange(root.proof, nullptr);
    if (root.singular) return;
    root.proof = prover_.prove(before, known_values(root));
  }

  /// What waits for its group is one.
  void prove_all() {
    if (!prover_.close()) return;
    for (PartialRoot& root : run_.roots) prove(root);
  }

  std::string group_name(const Block& block) const {
    std::vector<std::string> bodies;
    for (const std::size_t v : block.variables) {
      for (const std::string& owner : formulation_.owners[v]) {
        if (std::find(bodies.begin(), bodies.end(), owner) == bodies.end()) bodies.push_back(owner);
      }
    }
    return group_of_bodies(bodies);
  }

  const Formulation& formulation_;
  const Formulation* const whole_;
  const std::vector<Block>& blocks_;
  const BlockSolving& solving_;
  RootProver& prover_;
  StageRun run_;
  std::vector<std::size_t> unasked_;  ///< equations of the whole, ascending
  const Block* block_of_exclusions_ = nullptr;
  std::vector<const Formulation::Exclusion*> exclusions_;  ///< of that block
  std::size_t lone_ = 0;
  std::uint64_t formulas_ = 0;  ///< solves by formula
  std::uint64_t shared_ = 0;    ///< that another root's was
};

}  // namespace

void add_solving(const SolveTime& part, SolveTime& sum) {
  sum.start += part.start;
  sum.track += part.track;
  sum.track_cpu += part.track_cpu;
  sum.refine += part.refine;
}

StageRun solve_blocks(const Formulation& formulation, const std::vector<Block>& blocks,
                      const BlockSolving& solving, RootProver& prover, PartialRoot begun,
                      const Formulation* whole) {
  return Stages(formulation, blocks, solving, prover, std::move(begun), whole).run();
}

}  // namespace moivre
