// SPDX-License-Identifier: MIT
// Presolve, start system and homotopy of a solve, and the maps between their coordinates.
#include "prepare.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "moivre/numeric/invalid_input.h"
#include "moivre/start/choose_start.h"
#include "solver_sentences.h"

namespace moivre {
namespace {

// Fewer are followed in less time than another start is looked for.
constexpr std::uint64_t kPathsInAnyUnknowns = 256;
// Complex coefficients, and more terms, cost something: so many times fewer paths it has to be.
constexpr double kIsotropicGain = 2;

Reduction keep_everything(const System& f) {
  Reduction whole;
  whole.system = f;
  whole.errors = coefficient_errors(f);
  whole.kept.resize(f.variables.size());
  std::iota(whole.kept.begin(), whole.kept.end(), std::size_t{0});
  if (f.variables.empty()) whole.verdict = Reduction::Verdict::solved;
  return whole;
}

/// log2 of the sizes of the smallest and the largest coefficient; zeros of the zero polynomial.
std::pair<double, double> size_range_log2(const Polynomial& p) {
  if (p.terms.empty()) return {0, 0};
  double least = std::numeric_limits<double>::infinity();
  double largest = -least;
  for (const Term& term : p.terms) {
    least = std::min(least, log2_size(term.coefficient));
    largest = std::max(largest, log2_size(term.coefficient));
  }
  return {least, largest};
}

double spread_log2(const System& f) {
  double spread = 0;
  for (const Polynomial& p : f.polynomials) {
    const auto [least, largest] = size_range_log2(p);
    spread = std::max(spread, largest - least);
  }
  return spread;
}

void take_start(const System& f, const SolveOptions& options, const std::atomic<bool>& stop,
                Prepared& prepared) {
  StartChoiceOptions choice{options.start, options.seed, &stop, {}};
  if (options.progress) {
    choice.progress = [&](const CellSearchProgress& search) {
      Progress progress;
      progress.cells = search.cells;
      progress.search = search.fraction;
      options.progress(progress);
    };
  }
  ChosenStart chosen = choose_start(f, choice);
  prepared.interrupted = !chosen.plan;
  prepared.start.counts = chosen.counts;
  if (!chosen.plan) return;
  prepared.start.source = chosen.plan->source;
  prepared.start.paths = chosen.plan->paths;
  prepared.start.why = chosen.why;
  prepared.plan = std::move(chosen.plan);
}

}  // namespace

Scaling unit_rows(const System& f) {
  Scaling rows{std::vector<int>(f.variables.size()), {}};
  for (const Polynomial& p : f.polynomials) {
    rows.equation_log2.push_back(-static_cast<int>(std::floor(size_range_log2(p).second)));
  }
  return rows;
}

namespace {

Prepared prepare_reduced(Reduction reduction, const SolveOptions& options,
                         const std::atomic<bool>& stop) {
  Prepared prepared;
  prepared.reduction = std::move(reduction);
  for (const Omission& omission : prepared.reduction.left_out) {
    prepared.left_out.push_back({omission.what, omission.why});
  }
  prepared.interrupted = stop;
  if (prepared.interrupted || prepared.reduction.verdict != Reduction::Verdict::square) {
    return prepared;
  }
  const System& reduced = prepared.reduction.system;
  prepared.scaling = options.scale ? choose_scaling(reduced)
                                   : Scaling{std::vector<int>(reduced.variables.size()),
                                             std::vector<int>(reduced.polynomials.size())};
  if (!is_identity(prepared.scaling)) {
    prepared.left_out.push_back(scaling_left_out(prepared.scaling));
  }
  const System scaled = scale(reduced, prepared.scaling);
  const System tracked = scale(scaled, unit_rows(scaled));
  prepared.spread_log2 = spread_log2(tracked);
  take_start(tracked, options, stop, prepared);
  if (prepared.plan) prepared.plan->stages.back().set_coefficient_errors(prepared.reduction.errors);
  return prepared;
}

/// Substituted linear equations fill the others with monomials, so that there may be fewer paths
/// without it.
bool may_have_fewer_paths_whole(const Prepared& prepared, const SolveOptions& options) {
  if (!prepared.plan || prepared.reduction.substitutions.empty()) return false;
  switch (options.start) {
    case StartKind::polyhedral:
      return true;
    case StartKind::automatic:
      return prepared.start.counts.mixed_volume.paths != prepared.start.counts.total_degree.paths;
    case StartKind::total_degree:
    case StartKind::multihomogeneous:
      return false;
  }
  return false;
}

double expected_cost(const Prepared& prepared) {
  const auto n = static_cast<double>(prepared.plan->last().coordinates());
  const auto stages = static_cast<double>(prepared.plan->stages.size());
  return static_cast<double>(prepared.plan->paths) * stages * n * n * n;
}

Prepared with_or_without_elimination(const System& f, const SolveOptions& options,
                                     const std::atomic<bool>& stop) {
  Prepared reduced =
      prepare_reduced(options.eliminate ? eliminate(f, &stop) : keep_everything(f), options, stop);
  if (!may_have_fewer_paths_whole(reduced, options)) return reduced;
  Prepared whole = prepare_reduced(keep_everything(f), options, stop);
  if (whole.interrupted) return whole;
  if (whole.start.source != StartSource::polyhedral ||
      expected_cost(whole) >= expected_cost(reduced)) {
    return reduced;
  }
  whole.left_out.push_back(elimination_left_out(whole.plan->paths, reduced.plan->paths));
  return whole;
}

/// Where others wait for many paths a second search for cells costs little.
bool may_have_fewer_paths_isotropic(const Prepared& prepared, const SolveOptions& options) {
  const bool is_free =
      options.start == StartKind::automatic || options.start == StartKind::polyhedral;
  return is_free && prepared.plan && !prepared.interrupted &&
         prepared.plan->paths > kPathsInAnyUnknowns && prepared.reduction.system.groups.empty();
}

}  // namespace

Prepared prepare(const System& f, const SolveOptions& options, const std::atomic<bool>& stop) {
  Prepared prepared = with_or_without_elimination(f, options, stop);
  if (!may_have_fewer_paths_isotropic(prepared, options)) return prepared;
  const auto pairs = isotropic_pairs(prepared.reduction.system);
  if (pairs.empty()) return prepared;
  Prepared isotropic = prepare_reduced(in_isotropic(prepared.reduction, pairs), options, stop);
  const bool is_better = !isotropic.interrupted && isotropic.plan &&
                         kIsotropicGain * expected_cost(isotropic) < expected_cost(prepared);
  if (!is_better) return prepared;
  isotropic.left_out.push_back(
      isotropic_pairs_left_out(pairs.size(), isotropic.plan->paths, prepared.plan->paths));
  return isotropic;
}

Prepared prepare_given(const System& f, GivenStart start) {
  Prepared prepared;
  prepared.reduction = start.reduction ? std::move(*start.reduction) : keep_everything(f);
  prepared.scaling = std::move(start.scaling);
  prepared.spread_log2 = spread_log2(scale(prepared.reduction.system, prepared.scaling));
  prepared.start.source = start.plan.source;
  prepared.start.paths = start.plan.paths;
  prepared.start.why = std::move(start.why);
  for (StartCount* count :
       {&prepared.start.counts.total_degree, &prepared.start.counts.multihomogeneous,
        &prepared.start.counts.mixed_volume}) {
    count->missing = why_given_start_has_no_counts();
  }
  prepared.given_bound = std::move(start.bound);
  prepared.leads_to_all = start.is_complete;
  prepared.leaves_out = start.leaves_out;
  prepared.plan = std::move(start.plan);
  return prepared;
}

void require_paths(const Prepared& prepared) {
  if (prepared.plan) return;
  if (prepared.interrupted) throw InvalidInput("interrupted: no path was followed");
  throw InvalidInput("there is no path to follow: elimination alone decides the system");
}

Point to_reduced(const Prepared& prepared, const Point& homogeneous) {
  Point y = prepared.plan->last().chart().affine(homogeneous);
  for (std::size_t j = 0; j < y.size(); ++j) {
    const int e = prepared.scaling.variable_log2[j];
    y[j] = {std::ldexp(y[j].real(), e), std::ldexp(y[j].imag(), e)};
  }
  return y;
}

Point to_original(const Prepared& prepared, const Point& homogeneous) {
  return restore(prepared.reduction, to_reduced(prepared, homogeneous));
}

std::vector<double> natural_sizes(const Prepared& prepared) {
  const Reduction& reduction = prepared.reduction;
  std::vector<double> sizes(reduction.kept.size() + reduction.substitutions.size(), 1.0);
  for (std::size_t j = 0; j < prepared.scaling.variable_log2.size(); ++j) {
    sizes[reduction.kept[j]] = std::ldexp(1.0, prepared.scaling.variable_log2[j]);
  }
  for (const auto& [i, j] : reduction.isotropic) {
    double &a = sizes[reduction.kept[i]], &b = sizes[reduction.kept[j]];
    a = b = std::max(a, b);
  }
  return sizes;
}

}  // namespace moivre
