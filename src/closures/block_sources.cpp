// SPDX-License-Identifier: MIT
// The sources, and the order in which they are asked.
#include "block_sources.h"

#include <algorithm>
#include <utility>

#include "closure_sentences.h"
#include "linear_block.h"
#include "moivre/formulation/exact.h"
#include "moivre/numeric/random.h"
#include "moivre/polynomial/eliminate.h"
#include "moivre/polynomial/patches.h"
#include "moivre/solver/member_start.h"

namespace moivre {
namespace {

// Few paths are followed by one thread: starting others takes longer.
constexpr std::uint64_t kPathsForOneThread = 8;

// So few paths are followed before a better start is found: closure polynomials have hardly more of
// them than roots.
constexpr std::uint64_t kPathsWithoutSearch = 32;

/// A block and with what it is solved.
struct BlockTask {
  const Formulation& formulation;
  const Block& block;
  const BlockSolving& solving;

  System system_above(const PartialRoot& root) const {
    return system_at(formulation.system, block, root);
  }
  bool is_start_free() const { return solving.options.start == StartKind::automatic; }
};

/// The theorem speaks of this block, which then is the first.
bool is_of_theorem(const Formulation& formulation, const Block& block) {
  const auto& theorem = formulation.theorem;
  return theorem && block.variables.size() == theorem->unknowns &&
         block.variables.back() + 1 == theorem->unknowns &&
         block.equations.back() + 1 == theorem->unknowns;
}

void add_effort(const SolveResult& result, BlockRoots& roots) {
  roots.work += result.work;
  roots.time.threads = std::max(roots.time.threads, result.time.threads);
  add_solving(result.time, roots.time);
}

void take(SolveResult&& result, BlockSourceKind by, BlockRoots& roots) {
  add_effort(result, roots);
  roots.by = by;
  roots.complete = result.complete;
  roots.solutions = std::move(result.solutions);
  roots.on_sets = std::move(result.on_sets);
  roots.paths = result.paths;
  roots.start = std::move(result.start);
  roots.reduced = std::move(result.reduced);
  roots.bound = result.bound;
  roots.failures = std::move(result.failures);
  roots.left_out = std::move(result.left_out);
}

/// Known without a path.
void take_known(std::vector<Solution>&& solutions, BlockSourceKind by, BlockRoots& roots) {
  roots.by = by;
  roots.complete = true;
  roots.start.source = StartSource::formula;
  roots.paths.tracked = roots.paths.finite = solutions.size();
  roots.solutions = std::move(solutions);
}

/// Where that is clear and no start was asked for.
class FormulaSource : public BlockSource {
 public:
  FormulaSource(const BlockTask& task, const QuadraticBlock& formula)
      : task_(task), formula_(formula) {}

  bool answer(const PartialRoot& root, BlockRoots& roots) override {
    if (!task_.is_start_free()) return false;
    auto solutions = formula_.roots(root.value);
    if (!solutions) return false;
    roots.reduced =
        solutions->size() == 1 ? SystemFacts{{}, {}, 1, 0} : SystemFacts{{"y"}, {2}, 2, 0};
    take_known(std::move(*solutions), BlockSourceKind::formula, roots);
    return true;
  }

 private:
  BlockTask task_;
  const QuadraticBlock& formula_;
};

/// What linear equations that contradict each other leave least of: it misses them when all
/// equations are checked.
class LeastSquaresSource : public BlockSource {
 public:
  explicit LeastSquaresSource(const BlockTask& task)
      : linear_(task.formulation.system, task.block) {}

  bool answer(const PartialRoot& root, BlockRoots& roots) override {
    auto x = linear_.least_squares(root);
    if (!x) return false;
    std::vector<Solution> least(1);
    least.front().x = std::move(*x);
    least.front().condition = 1;
    roots.reduced.total_degree = 1;
    take_known(std::move(least), BlockSourceKind::least_squares, roots);
    return true;
  }

 private:
  LinearBlock linear_;
};

/// Paths from a start that is known, as far as they decide everything.
class GivenStartSource : public BlockSource {
 public:
  GivenStartSource(const BlockTask& task, BlockSourceKind kind) : task_(task), kind_(kind) {}

  bool answer(const PartialRoot& root, BlockRoots& roots) override {
    if (!may_know_a_start()) return false;
    const System f = task_.system_above(root);
    auto start = start_of(f, root);
    if (!start) return false;
    const BlockSolving& solving = task_.solving;
    SolveOptions options = solving.options;
    if (start->plan.paths <= kPathsForOneThread) options.threads = 1;
    SolveResult result = solve_from(f, std::move(*start), solving.tracker, options, solving.stop);
    if (result.complete || solving.stop) {
      take(std::move(result), kind_, roots);
      return true;
    }
    add_effort(result, roots);
    return false;
  }

 protected:
  const BlockTask& task() const { return task_; }

 private:
  /// Above any root.
  virtual bool may_know_a_start() const = 0;
  virtual std::optional<GivenStart> start_of(const System& f, const PartialRoot& root) const = 0;

  BlockTask task_;
  BlockSourceKind kind_;
};

class FamilySource : public GivenStartSource {
 public:
  explicit FamilySource(const BlockTask& task) : GivenStartSource(task, BlockSourceKind::family) {}

 private:
  bool may_know_a_start() const override { return task().solving.starts != nullptr; }
  std::optional<GivenStart> start_of(const System& f, const PartialRoot&) const override {
    const BlockSolving& solving = task().solving;
    if (!is_square(f)) return std::nullopt;
    return solving.starts->start_of(f, solving.tracker, solving.options, solving.stop);
  }
};

/// The coefficients of the general member are real: a complex factor keeps the line to this member
/// away from those with fewer poses.
class TheoremSource : public GivenStartSource {
 public:
  explicit TheoremSource(const BlockTask& task)
      : GivenStartSource(task, BlockSourceKind::theorem) {}

 private:
  bool may_know_a_start() const override {
    return task().is_start_free() && is_of_theorem(task().formulation, task().block);
  }
  std::optional<GivenStart> start_of(const System& f, const PartialRoot& root) const override {
    if (eliminate(f).verdict != Reduction::Verdict::square) return std::nullopt;
    const auto& theorem = task().formulation.theorem;
    const Formulation::GeneralMember member = theorem->general();
    System general = system_at(member.system, task().block, root);
    const Coefficient factor =
        exactly(random_phase(task().solving.options.seed, RandomStream::generic_member, 0));
    for (Polynomial& p : general.polynomials) p = factor * p;
    std::vector<Point> known;
    for (const Point& pose : member.roots) {
      Point& x = known.emplace_back();
      for (const std::size_t v : task().block.variables) x.push_back(pose[v]);
    }
    GivenStart start = start_from_member(f, general, known);
    start.why = start_from_general_member(known.size(), theorem->of);
    return start;
  }
};

/// Any paths: always an answer. Where a theorem bounds the poses and as many are proved, paths in
/// doubt need no more digits than double's.
class SolveSource : public BlockSource {
 public:
  SolveSource(const BlockTask& task, ProvedPoses proved_poses)
      : task_(task), proved_poses_(std::move(proved_poses)) {}

  bool answer(const PartialRoot& root, BlockRoots& roots) override {
    const System f = task_.system_above(root);
    const auto& [tracker, asked, starts, stop, is_fine] = task_.solving;
    SolveOptions options = asked;
    const auto paths = total_degree(degrees(f));
    if (paths && *paths <= kPathsForOneThread) options.threads = 1;
    const bool are_few = paths && *paths <= kPathsWithoutSearch;
    if (task_.is_start_free() && are_few) options.start = StartKind::total_degree;
    if (is_worth_a_try_in_double(options)) {
      options.precision = Precision::double_precision;
      SolveResult result = solve(f, tracker, options, stop);
      if (result.complete || stop || are_all_proved(root, result)) {
        take(std::move(result), BlockSourceKind::solve, roots);
        return true;
      }
      add_effort(result, roots);
      options.precision = asked.precision;
    }
    take(solve(f, tracker, options, stop), BlockSourceKind::solve, roots);
    return true;
  }

 private:
  bool is_worth_a_try_in_double(const SolveOptions& options) const {
    return options.precision == Precision::automatic && proved_poses_ &&
           bound_of(task_.formulation, task_.block);
  }
  bool are_all_proved(const PartialRoot& root, const SolveResult& result) const {
    const auto bound = bound_of(task_.formulation, task_.block);
    return static_cast<std::uint64_t>(proved_poses_(root, result.solutions)) >= bound->most;
  }

  BlockTask task_;
  ProvedPoses proved_poses_;
};

}  // namespace

System system_at(const System& all, const Block& block, const PartialRoot& root) {
  System f;
  std::vector<std::uint32_t> place(all.variables.size());
  for (const std::size_t v : block.variables) {
    place[v] = static_cast<std::uint32_t>(f.variables.size());
    f.variables.push_back(all.variables[v]);
  }
  for (const std::size_t e : block.equations) {
    f.polynomials.push_back(substituted(all.polynomials[e], root.value, place));
  }
  return f;
}

std::optional<Formulation::Bound> bound_of(const Formulation& formulation, const Block& block) {
  const auto& theorem = formulation.theorem;
  if (is_of_theorem(formulation, block)) return Formulation::Bound{theorem->of, {}, theorem->most};
  const auto& bounds = formulation.bounds;
  const auto at = std::find_if(bounds.begin(), bounds.end(), [&](const auto& bound) {
    return bound.unknowns == block.variables;
  });
  return at == bounds.end() ? std::nullopt : std::optional(*at);
}

BlockSources::BlockSources(const Formulation& formulation, const Block& block,
                           const BlockSolving& solving, const QuadraticBlock& formula,
                           ProvedPoses proved_poses) {
  const BlockTask task{formulation, block, solving};
  sources_.push_back(std::make_unique<FormulaSource>(task, formula));
  sources_.push_back(std::make_unique<LeastSquaresSource>(task));
  sources_.push_back(std::make_unique<FamilySource>(task));
  sources_.push_back(std::make_unique<TheoremSource>(task));
  sources_.push_back(std::make_unique<SolveSource>(task, std::move(proved_poses)));
}

BlockRoots BlockSources::roots_above(const PartialRoot& root) {
  BlockRoots roots;
  for (const auto& source : sources_) {
    if (source->answer(root, roots)) break;
  }
  return roots;
}

}  // namespace moivre
