// SPDX-License-Identifier: MIT
// From closure polynomials to their isolated roots, by the way that their block structure allows.
#include "closure_roots.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <stdexcept>
#include <string>
#include <utility>

#include "closure_poses.h"
#include "closure_sentences.h"
#include "moivre/closures/stages.h"
#include "moivre/factorization/qr.h"
#include "moivre/formulation/exact.h"
#include "moivre/kinematics/newton.h"
#include "moivre/numeric/near_points.h"
#include "moivre/polynomial/digits.h"
#include "moivre/polynomial/square_up.h"
#include "moivre/polynomial/tape.h"
#include "moivre/polynomial/value.h"
#include "moving_pose.h"

namespace moivre {
namespace {

/// A root that is off by rounded lengths is no farther than this from a real pose.
double near_real(const ClosureSearch& search) {
  constexpr double kRounded = 1e-2;
  // Where all constraints miss by so much at least squares, those that are met leave several times
  // that to the others.
  constexpr double kOfFit = 20;
  // At a fold two closures part by the square root of what lengths are off, into real or complex
  // ones, and above a fold by the root of that.
  constexpr double kOfFold = 3;
  const double fit = search.mechanism.fit.value_or(0) / search.phi.length();
  return std::max({kRounded, kOfFit * fit, kOfFold * std::sqrt(std::sqrt(fit))});
}

// What a root's own rounding leaves behind Newton's method, with lengths of the file typed to
// twelve digits.
constexpr double kRounding = 1e-12;

/// How far two roots are apart, directions beside 1 and lengths beside the mechanism's: at the
/// origin a length has no size of its own.
double apart(const Formulation& formulation, const Point& a, const Point& b) {
  double direction = 1;
  double length = formulation.length;
  for (std::size_t v = 0; v < a.size(); ++v) {
    double& size = formulation.is_direction[v] ? direction : length;
    size = std::max({size, std::abs(a[v]), std::abs(b[v])});
  }
  if (length == 0) length = 1;
  double largest = 0;
  for (std::size_t v = 0; v < a.size(); ++v) {
    const double size = formulation.is_direction[v] ? direction : length;
    largest = std::max(largest, std::abs(a[v] - b[v]) / size);
  }
  return largest;
}

double tolerance_of(const Solution& solution) {
  return solution.singular ? kHoldsSingular : kHolds;
}

/// residual_of_root behind a few steps of Gauss-Newton, in complex numbers, on every equation: a
/// residual above rounding and still small is either the root's own error, which these take away,
/// or a pose that closes to nine digits only, where least squares stops.
double residual_when_polished(const Formulation& formulation, Point root) {
  // A root's error is squared each time; beside a near miss they stand still.
  constexpr int kSteps = 4;
  const System& f = formulation.system;
  const Tape tape = make_tape(f);
  const std::vector<Complex> c = complex_coefficients(tape, f);
  Point registers(tape.register_count());
  Point value(tape.equations);
  Point entries(tape.jacobian.size());
  for (int k = 0; k < kSteps; ++k) {
    evaluate<Complex, Complex>(tape, c, root, registers, value, entries);
    // Each row by the size of its terms.
    Eigen::VectorXd scale(tape.equations);
    for (std::uint32_t i = 0; i < tape.equations; ++i) {
      const double size = term_size(f.polynomials[i], root);
      scale[i] = size > 0 ? 1 / size : 1;
    }
    Eigen::MatrixXcd J = Eigen::MatrixXcd::Zero(tape.equations, tape.variables);
    for (std::size_t e = 0; e < entries.size(); ++e) {
      J(tape.jacobian[e].row, tape.jacobian[e].column) = entries[e];
    }
    const Eigen::Map<const Eigen::VectorXcd> F(value.data(), tape.equations);
    const Eigen::VectorXcd step =
        PivotedQr<Complex>(scale.asDiagonal() * J).solve(scale.asDiagonal() * F);
    if (!step.allFinite()) break;
    Eigen::Map<Eigen::VectorXcd>(root.data(), step.size()) -= step;
  }
  return residual_of_root(formulation, root);
}

bool has_spare_equations(const Formulation& formulation) {
  return formulation.system.polynomials.size() > formulation.system.variables.size();
}

/// Whether the root satisfies every equation. Spare ones that hold to nine digits do not hold.
bool holds(const Formulation& formulation, const Solution& solution) {
  if (solution.residual > tolerance_of(solution)) return false;
  if (!has_spare_equations(formulation) || solution.singular || solution.residual <= kRounding)
    return true;
  return residual_when_polished(formulation, solution.x) <= kRounding;
}

void take_account(ClosureResult& result, const StageRun& run) {
  result.stages = run.stages;
  result.paths = run.paths;
  result.failures = run.failures;
  result.work = run.work;
  result.time_s = run.time;
  result.complete = run.complete;
  result.start.source = run.largest_start.source;
  result.start.paths = run.paths.tracked;
  result.left_out.insert(result.left_out.end(), run.left_out.begin(), run.left_out.end());
  result.counts.rejected += run.rejected;
  for (const auto& [reason, count] : run.excluded) {
    result.counts.rejected += count;
    result.left_out.push_back(excluded_roots_left_out(count, reason));
  }
  for (const Stage& stage : run.stages) append(stage.reduced, result.reduced);
  result.reduced.total_degree = total_degree(result.reduced.degrees);
}

/// Whether rounding may have made one closure, or none, of several: by Kantorovich's theorem a root
/// is alone, whatever is rounded, where the square of its condition times rounding is small.
bool may_be_several(const Solution& root) {
  constexpr double kStandsAlone = 1e7;
  return !root.singular && root.condition >= kStandsAlone;
}

/// A root that may have a real pose beside it. Under a fit every root may: beside a fold of a small
/// curvature the real parts are right, however far roots are from real.
void note_near_miss(ClosureSearch& search, const Solution& root, bool is_rejected) {
  const bool is_near = distance_from_real(search.formulation, root.x) <= near_real(search);
  if (is_near || search.mechanism.fit) search.near_misses.push_back({root, is_rejected, is_near});
}

/// Enters the root, or counts it as rejected where it does not satisfy every equation.
void take_root(ClosureSearch& search, const PartialRoot& root, const ResidualOfRoots& residual,
               RootProver& prover) {
  Solution solution;
  solution.path = root.path;
  for (const auto& value : root.value) solution.x.push_back(value->rounded);
  solution.singular = root.singular;
  solution.multiplicity = root.multiplicity;
  solution.cluster = root.cluster;
  solution.winding = {static_cast<int>(root.multiplicity)};
  solution.accuracy = root.accuracy;
  std::optional<ProvedRoot> proved;
  if (root.proof) {
    proved = prover.root(root.proof);
    solution.x = proved->x;
    solution.accuracy = proved->accuracy;
  }
  solution.condition = root.condition;
  solution.residual = residual(solution.x);
  if (!holds(search.formulation, solution)) {
    ++search.result.counts.rejected;
    note_near_miss(search, solution, true);
    return;
  }
  const bool is_near_real =
      distance_from_real(search.formulation, solution.x) <= tolerance_of(solution);
  // Where there are spare equations the proof is one of those that were solved: of numbers that
  // contradict each other by rounding it may say that a closure is not real.
  const bool has_spare = has_spare_equations(search.formulation);
  solution.real = proved && !has_spare ? proved->real.value_or(is_near_real) : is_near_real;
  if (!solution.real && search.mechanism.fit) note_near_miss(search, solution, false);
  if (search.has_proofs()) solution.certified = proved && proved->real == solution.real;
  search.result.solutions.push_back(std::move(solution));
}

/// What is proved of two roots near each other is proved of the polynomials that were solved. Where
/// their coefficients are right to rounding only, and rounding moves a root as far as to the other,
/// it is none of the mechanism as typed: both may be real, complex or one.
void drop_proofs_within_rounding(const Formulation& formulation, RootProver& prover,
                                 std::vector<PartialRoot>& roots) {
  // Rounding moves roots that lie farther apart by less, however ill they are conditioned: by its
  // square root at most.
  constexpr double kFarApart = 1e-4;
  if (!prover.is_on() || !formulation.has_rounded_frames) return;
  const auto size_of = [](const PartialRoot& root) {
    double size = 1;
    for (const KnownValue& value : root.value) size = std::max(size, std::abs(value->rounded));
    return size;
  };
  const auto gap = [](const PartialRoot& a, const PartialRoot& b, std::size_t v) {
    return std::abs(a.value[v]->rounded - b.value[v]->rounded);
  };
  const auto is_near = [&](const PartialRoot& a, const PartialRoot& b, double most) {
    for (std::size_t v = 0; v < a.value.size(); ++v) {
      if (gap(a, b, v) > most) return false;
    }
    return true;
  };
  // Unknown by unknown: rounding moves a platform at 1e6 by more than a leg of it can turn.
  using Moved = std::optional<std::vector<double>>;
  const auto may_meet = [&](const PartialRoot& a, const PartialRoot& b, const Moved& moved) {
    for (std::size_t v = 0; moved && v < moved->size(); ++v) {
      if (gap(a, b, v) > 2 * (*moved)[v]) return false;
    }
    return true;
  };
  std::vector<bool> is_unsure(roots.size());
  for (std::size_t i = 0; i < roots.size(); ++i) {
    if (!roots[i].proof) continue;
    const double near = kFarApart * size_of(roots[i]);
    std::optional<Moved> moved;
    for (std::size_t j = i + 1; j < roots.size(); ++j) {
      if (!roots[j].proof || !is_near(roots[i], roots[j], near)) continue;
      if (!moved) moved = prover.moved_by_rounding(roots[i].proof);
      if (may_meet(roots[i], roots[j], *moved)) is_unsure[i] = is_unsure[j] = true;
    }
  }
  for (std::size_t k = 0; k < roots.size(); ++k) {
    if (is_unsure[k]) roots[k].proof = nullptr;
  }
}

/// The pose beside a root, as the mechanism is typed; nothing where it does not close there.
std::optional<Eigen::VectorXd> pose_beside(const ClosureSearch& search, const Point& root) {
  const NewtonResult pose =
      newton(search.phi, coordinates_of_root(search.formulation, root), search.options.time);
  if (!closes(search, pose)) return std::nullopt;
  return search.phi.canonical(pose.q);
}

/// Whether the mechanism, as it is typed, closes in the root's pose and stands still there.
bool stands_still(const ClosureSearch& search, const Point& root) {
  const auto pose = pose_beside(search, root);
  return pose && !moves_at(search.phi, *pose, search.options.time, search.options.solve.seed);
}

Point midpoint_of(const Point& a, const Point& b) {
  Point midpoint(a.size());
  for (std::size_t v = 0; v < a.size(); ++v) midpoint[v] = 0.5 * (a[v] + b[v]);
  return midpoint;
}

/// Whether the midpoint of two roots is a root but for rounding: then rounding may have made them
/// of one, or of none, by what it does to a double root; or of a set.
bool has_root_between(const ClosureSearch& search, const ResidualOfRoots& residual, const Point& a,
                      const Point& b) {
  // Farther apart than the square root of rounding by far.
  constexpr double kFarApart = 1e-4;
  if (apart(search.formulation, a, b) > kFarApart) return false;
  return residual(midpoint_of(a, b)) <= rounding_left(search.formulation);
}

bool may_be_real_between(const Formulation& formulation, const Point& a, const Point& b) {
  return distance_from_real(formulation, midpoint_of(a, b)) <= kHoldsSingular;
}

void merge(const Formulation& formulation, const Solution& other, Solution& into) {
  const double gap = apart(formulation, into.x, other.x);
  into.radius = std::max(into.radius, max_distance(into.x, other.x));
  into.x = midpoint_of(into.x, other.x);
  into.multiplicity += other.multiplicity;
  into.winding = {static_cast<int>(into.multiplicity)};
  into.singular = into.cluster = true;
  into.accuracy = std::max(into.accuracy, gap);
  into.real = distance_from_real(formulation, into.x) <= kHoldsSingular;
}

/// Roots that rounding may have made of a double root, none of them proved of the mechanism as
/// typed, are a cluster: two closures, or none, or one as often. At a dead point rounding alone
/// says whether two roots are real: that of the solution, of which the condition tells, or that of
/// frames, and in redundant equations that of the file's numbers. Where the mechanism moves at the
/// double root they are no closures: a dyad's two roots are parted, and between them its lines are
/// one, along which the next dyad slides. Of complex roots there is no pose to ask.
void merge_unproved(ClosureSearch& search, const ResidualOfRoots& residual) {
  std::vector<Solution>& roots = search.result.solutions;
  const auto is_unproved = [&](const Solution& root) {
    if (root.certified == true) return false;
    if (root.singular) return root.cluster;
    // Where proofs are made every simple root has one, unless another is within rounding of the
    // values above which it was solved: of a block of one equation the condition does not tell.
    return search.has_proofs() || is_rounded(search.formulation) || may_be_several(root);
  };
  const auto erase = [&](std::size_t k) {
    roots.erase(roots.begin() + static_cast<std::ptrdiff_t>(k));
  };
  for (std::size_t i = 0; i < roots.size(); ++i) {
    for (std::size_t j = i + 1; j < roots.size();) {
      const bool may_meet = is_unproved(roots[i]) && is_unproved(roots[j]) &&
                            has_root_between(search, residual, roots[i].x, roots[j].x);
      if (may_meet && !may_be_real_between(search.formulation, roots[i].x, roots[j].x)) {
        merge(search.formulation, roots[j], roots[i]);
        erase(j);
        continue;
      }
      const auto pose =
          may_meet ? pose_beside(search, midpoint_of(roots[i].x, roots[j].x)) : std::nullopt;
      if (!pose) {
        ++j;
        continue;
      }
      auto moves = moves_at(search.phi, *pose, search.options.time, search.options.solve.seed);
      if (moves) {
        if (!search.result.moves) search.result.moves = std::move(moves);
        erase(j);
        erase(i);
        j = i + 1;
        continue;
      }
      merge(search.formulation, roots[j], roots[i]);
      erase(j);
    }
  }
}

RootCompleteness completeness(const Formulation& formulation, const RootProver& prover,
                              const StageRun& run, const ClosureResult& result) {
  const auto& roots = result.solutions;
  const bool all_certified = std::all_of(roots.begin(), roots.end(), [](const Solution& root) {
    return root.singular || root.certified == true;
  });
  if (!run.complete || run.moves || result.moves || !all_certified) return RootCompleteness::open;
  const bool is_proved =
      run.is_proved && !formulation.lacks_typed_terms && prover.knows_terms() &&
      std::none_of(roots.begin(), roots.end(), [](const auto& root) { return root.singular; });
  return is_proved ? RootCompleteness::proved : RootCompleteness::shown;
}

bool shows_motion(ClosureSearch& search) {
  auto moves =
      moving_pose(search.mechanism, search.phi, search.options.time, search.options.solve.seed);
  if (!moves) return false;
  search.result.moves = std::move(moves);
  return true;
}

/// Whether there is no closure, whatever the paths lead to: they tell near misses, and only a fit
/// asks for all of these.
bool is_refuted_alone(const ClosureSearch& search) {
  return !search.formulation.contradictions.empty() && !search.mechanism.fit;
}

StageRun solve_blocks(const ClosureSearch& search, const Formulation& formulation,
                      const std::vector<Block>& blocks, RootProver& prover) {
  SolveOptions options = search.options.solve;
  const bool is_free = options.precision == Precision::automatic;
  if (is_free && is_refuted_alone(search)) options.precision = Precision::double_precision;
  const Formulation* const whole = search.mechanism.fit ? nullptr : &search.formulation;
  const BlockSolving solving{search.tracker, options, search.options.starts, search.stop,
                             search.is_as_typed};
  return solve_blocks(formulation, blocks, solving, prover, {}, whole);
}

/// Paths in doubt lead to no closure where there is none.
void settle_refuted(ClosureSearch& search) {
  ClosureResult& result = search.result;
  if (!is_refuted_alone(search) || search.stop) return;
  search.undecided_motion = false;
  if (result.complete) return;
  result.complete = true;
  result.paths.not_needed += std::exchange(result.paths.failed, 0);
  for (Stage& stage : result.stages) {
    stage.paths.not_needed += std::exchange(stage.paths.failed, 0);
  }
  if (result.failures.empty()) return;
  result.left_out.push_back(doubtful_paths_left_out_by_contradiction(result.failures.size()));
  result.failures.clear();
}

/// Takes away the roots of a part that fail an equation of it that was spare; no unknown that is
/// free can mend that. Poses may be near them.
void reject_what_fails(ClosureSearch& search, const std::vector<std::size_t>& spare,
                       std::vector<PartialRoot>& roots) {
  if (roots.empty() || spare.empty()) return;
  const ResidualOfRoots residual(search.formulation,
                                 of_known_alone(search.formulation, roots.front(), spare));
  std::erase_if(roots, [&](const PartialRoot& root) {
    Solution solution;
    solution.path = root.path;
    solution.singular = root.singular;
    solution.x = known_values(root);
    solution.residual = residual(solution.x);
    if (solution.residual <= tolerance_of(solution)) return false;
    ++search.result.counts.rejected;
    note_near_miss(search, solution, true);
    return true;
  });
}

/// With fewer equations than unknowns no closure is isolated. What no free unknown has a say in is
/// solved first: where it does not close, or in complex numbers only, so does the whole.
void solve_free(ClosureSearch& search, const BlockStructure& structure) {
  std::vector<Block> determined;
  std::copy_if(structure.blocks.begin(), structure.blocks.end(), std::back_inserter(determined),
               [](const Block& block) { return block.is_determined; });
  RootProver prover(search.formulation, search.has_proofs());
  StageRun run = solve_blocks(search, search.formulation, determined, prover);
  take_account(search.result, run);
  const bool has_roots = !run.roots.empty() || run.rejected > 0;
  reject_what_fails(search, structure.spare_equations, run.roots);
  if (run.complete && !run.moves) {
    if (has_roots && run.roots.empty()) return;
    search.part_is_complex = std::none_of(
        run.roots.begin(), run.roots.end(),
        [&](const PartialRoot& root) { return may_be_real(search.formulation, root); });
  }
  if (search.part_is_complex || shows_motion(search)) return;
  search.result.complete = false;
  search.undecided_motion = true;
}

/// Of a root and others beside it that make a multiple root of its condition: the others.
std::vector<std::size_t> parted_from(const Formulation& formulation,
                                     const std::vector<PartialRoot>& roots, std::size_t i) {
  // Farther apart than a fourth root of rounding by no more than some.
  constexpr double kFarApart = 1e-3;
  std::vector<std::pair<double, std::size_t>> others;
  for (std::size_t j = i + 1; j < roots.size(); ++j) {
    if (roots[j].singular || roots[j].condition < kUndetermined) continue;
    const double gap = apart(formulation, known_values(roots[i]), known_values(roots[j]));
    if (gap <= kFarApart) others.emplace_back(gap, j);
  }
  std::sort(others.begin(), others.end());
  double condition = roots[i].condition;
  std::vector<std::size_t> parted;
  for (const auto& [gap, j] : others) {
    parted.push_back(j);
    condition = std::max(condition, roots[j].condition);
    if (is_of_parted(condition, std::pow(gap, static_cast<double>(parted.size())))) return parted;
  }
  return {};
}

/// Roots beside each other have a condition that is large as they are near: at a dead point whose
/// roots rounding has parted by next to nothing it says no more than that. They are a cluster.
void merge_parted(const Formulation& formulation, std::vector<PartialRoot>& roots) {
  for (std::size_t i = 0; i < roots.size(); ++i) {
    if (roots[i].singular || roots[i].condition < kUndetermined) continue;
    std::vector<std::size_t> parted = parted_from(formulation, roots, i);
    if (parted.empty()) continue;
    std::sort(parted.begin(), parted.end());
    const double share = 1.0 / static_cast<double>(parted.size() + 1);
    for (std::size_t v = 0; v < roots[i].value.size(); ++v) {
      KnownValue& value = roots[i].value[v];
      Complex sum = value->rounded;
      bool is_shared = true;
      for (const std::size_t j : parted) {
        sum += roots[j].value[v]->rounded;
        is_shared = is_shared && roots[j].value[v] == value;
      }
      if (!is_shared) value = std::make_shared<const Known>(exactly(share * sum));
    }
    for (const std::size_t j : parted) {
      const double gap = apart(formulation, known_values(roots[i]), known_values(roots[j]));
      roots[i].multiplicity += roots[j].multiplicity;
      roots[i].accuracy = std::max({roots[i].accuracy, roots[j].accuracy, 2 * gap});
    }
    roots[i].singular = roots[i].cluster = true;
    roots[i].isolated = false;
    roots[i].proof = nullptr;
    for (auto j = parted.rbegin(); j != parted.rend(); ++j) {
      roots.erase(roots.begin() + static_cast<std::ptrdiff_t>(*j));
    }
  }
}

/// Roots that rounding moves as far as it likes are points of a set: rounding of the coefficients,
/// or of the roots of the blocks before, where no proof knows these exactly. A multiple root has
/// its own judges, or its pose judges: at a dead point in space it stands still.
void take_off_sets(const ClosureSearch& search, const Formulation& formulation, StageRun& run) {
  merge_parted(formulation, run.roots);
  std::erase_if(run.roots, [&](const PartialRoot& root) {
    const bool is_known =
        formulation.is_exact && (root.proof != nullptr || root.isolated || root.singular);
    if (root.condition < kUndetermined || is_known) return false;
    const bool may_be_pose = root.singular && may_be_real(search.formulation, root);
    if (may_be_pose && stands_still(search, known_values(root))) return false;
    run.moves = true;
    run.may_move = run.may_move || may_be_real(formulation, root);
    return true;
  });
}

/// The equations that were solved have a set of roots that the spare ones may cut to isolated ones,
/// also where part of it moves.
StageRun solve_combined(const ClosureSearch& search, const StageRun& first) {
  Formulation combined = search.formulation;
  combined.system = square_up(search.formulation.system, search.options.solve.seed);
  RootProver prover(combined, false);
  StageRun run = solve_blocks(search, combined, block_structure(combined.system).blocks, prover);
  take_off_sets(search, combined, run);
  for (Stage& stage : run.stages) stage.group = group_with_equations_combined(stage.group);
  run.stages.insert(run.stages.begin(), first.stages.begin(), first.stages.end());
  run.paths += first.paths;
  run.work += first.work;
  add_solving(first.time, run.time);
  return run;
}

void solve_determined(ClosureSearch& search, const BlockStructure& structure) {
  ClosureResult& result = search.result;
  if (!structure.spare_equations.empty()) {
    result.left_out.push_back(spare_equations_left_out(
        structure.spare_equations.size(), search.formulation.system.polynomials.size()));
  }
  RootProver prover(search.formulation, search.wants_proofs());
  StageRun run;
  if (!search.is_combined) {
    run = solve_blocks(search, search.formulation, structure.blocks, prover);
    take_off_sets(search, search.formulation, run);
  }
  const bool is_motion_shown = run.moves && run.may_move && shows_motion(search);
  const bool has_spare = !structure.spare_equations.empty();
  if (has_spare && !search.stop && (run.moves || search.is_combined)) {
    run = solve_combined(search, run);
  }
  const bool has_unseen_sets = run.moves && !is_motion_shown;
  take_account(result, run);
  drop_proofs_within_rounding(search.formulation, prover, run.roots);
  const ResidualOfRoots residual(search.formulation);
  for (const PartialRoot& root : run.roots) take_root(search, root, residual, prover);
  merge_unproved(search, residual);
  search.unproved = static_cast<std::uint64_t>(
      std::count_if(result.solutions.begin(), result.solutions.end(), [](const Solution& solution) {
        return solution.certified == false && may_be_several(solution);
      }));
  if (search.has_proofs())
    result.completeness = completeness(search.formulation, prover, run, result);
  if (!has_unseen_sets) return;
  if (run.may_move) {
    result.complete = false;
    search.undecided_motion = true;
  } else {
    result.left_out.push_back(complex_sets_left_out());
    search.part_is_complex = result.solutions.empty();
  }
}

/// The image of an isolated root is a root: one that is not there was lost.
std::uint64_t lost_images(const Formulation& formulation, const std::vector<Solution>& roots) {
  std::vector<double> numbers;
  for (const Solution& root : roots) numbers.push_back(number_of(root.x));
  const NearNumbers near(numbers);
  const auto is_lost = [&](const Solution& root) {
    if (root.real || root.singular) return false;
    const Point image = mirrored(formulation, root.x);
    const double most = kHolds * std::max(1.0, max_norm(image));
    bool is_there = false;
    near.visit_near(number_of(image), static_cast<double>(image.size()) * most, [&](auto k) {
      is_there = is_there || max_distance(image, roots[k].x) <= most;
    });
    return !is_there;
  };
  return static_cast<std::uint64_t>(std::count_if(roots.begin(), roots.end(), is_lost));
}

/// Whether equations without unknowns alone contradict each other: the roots of all others may miss
/// by little.
bool may_miss_by_little(const Formulation& formulation) {
  const auto& equations = formulation.system.polynomials;
  const auto constant = std::count_if(equations.begin(), equations.end(),
                                      [](const Polynomial& p) { return degree(p) == 0; });
  return static_cast<std::size_t>(constant) == formulation.contradictions.size();
}

}  // namespace

void append(const SystemFacts& part, SystemFacts& whole) {
  whole.variables.insert(whole.variables.end(), part.variables.begin(), part.variables.end());
  whole.degrees.insert(whole.degrees.end(), part.degrees.begin(), part.degrees.end());
}

void find_roots(ClosureSearch& search) {
  const BlockStructure structure = block_structure(search.formulation.system);
  const bool is_refuted = !search.formulation.contradictions.empty();
  const bool is_solved = may_miss_by_little(search.formulation) && structure.free_variables.empty();
  if (is_refuted && !is_solved) return;
  if (!structure.free_variables.empty()) {
    solve_free(search, structure);
  } else {
    solve_determined(search, structure);
    settle_refuted(search);
  }
  search.lost_images = lost_images(search.formulation, search.result.solutions);
}

}  // namespace moivre
