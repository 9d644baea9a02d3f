// SPDX-License-Identifier: MIT
// Square systems for others, and their roots judged by the system as given.
#include "squared.h"

#include <algorithm>
#include <optional>

#include "account.h"
#include "drop_solutions.h"
#include "exact_roots.h"
#include "facts.h"
#include "moivre/algebra/local_multiplicity.h"
#include "moivre/algebra/quotient_ring.h"
#include "moivre/certify/certifier.h"
#include "moivre/polynomial/digits.h"
#include "moivre/polynomial/exclusion.h"
#include "moivre/polynomial/patches.h"
#include "moivre/polynomial/square_up.h"
#include "places.h"
#include "refine.h"
#include "solver_sentences.h"

namespace moivre {
namespace {

// A root rounded to double leaves this of an equation, beside its terms; a random system's other
// roots leave far more.
constexpr double kHolds = 1e-11;
// A second at most, some ten nanoseconds each.
constexpr std::uint64_t kTermsOfProof = 5 * kAffordableTerms;
// Of a root at which an equation may yet be off by less than double sees: some hundred digits.
constexpr int kBitsOfRefutation = 512;
// What the root's error makes of it, at most so many times the error.
constexpr double kMargin = 1e3;

/// Of exact numbers: proves that a root of the combinations is none of F, first as well as it is
/// known, then in more digits.
class Refuter {
 public:
  Refuter(const System& f, const System& combinations)
      : f_(f), certifier_(make_certify_program(combinations), {.most_bits = kBitsOfRefutation}) {}

  bool refutes(const Solution& root) {
    if (root.singular) return false;
    const double radius = root.accuracy * std::max(1.0, max_norm(root.x));
    return has_no_root_within(f_, root.x, radius) || refutes_in_more_digits(root);
  }

 private:
  bool refutes_in_more_digits(const Solution& root) {
    Certificate proof = certifier_.certify(root.x);
    if (!proof.holds_root() || !certifier_.sharpen(proof, kBitsOfRefutation)) return false;
    std::vector<Coefficient> midpoint;
    double error = 0;
    for (std::size_t j = 0; j < proof.midpoint.size(); ++j) {
      const Enclosure place = enclosure(proof, j);
      midpoint.push_back(exact_sum(place.middle, place.finer));
      error = std::max(error, place.error);
    }
    return has_no_root_near(f_, midpoint, error);
  }

  const System& f_;
  Certifier certifier_;
};

bool holds(Refiner& refiner, const Solution& root) {
  const std::vector<Complex>& values = refiner.relative_values(root.x);
  const double allowed = kHolds + kMargin * root.accuracy;
  return std::all_of(values.begin(), values.end(),
                     [&](const Complex& value) { return std::abs(value) <= allowed; });
}

void drop_excess(const System& f, const System& combinations, SolveResult& result) {
  const auto program = make_refiner_program(f, std::vector<double>(f.variables.size(), 1.0));
  const bool is_exact = program->error.empty();
  Refiner refiner(program);
  std::optional<Refuter> refuter;
  if (is_exact && !f.variables.empty()) refuter.emplace(f, combinations);
  const auto is_excess = [&](const Solution& root) {
    return !holds(refiner, root) || (refuter && refuter->refutes(root));
  };
  result.excess += drop_solutions_where(result, is_excess);
}

/// Of what was said where elimination left no unknown, only what holds of all equations stays.
void tell_of_eliminated(const System& f, SolveResult& result) {
  const bool was_eliminated =
      result.complete && result.paths.tracked > 0 && result.reduced.variables.empty();
  if (!was_eliminated) return;
  using enum SolveVerdict;
  const bool is_root = !result.solutions.empty();
  if (f.variables.empty()) {
    result.message =
        solve_message(is_root ? without_unknowns_holds : without_unknowns_contradictory);
  } else if (!is_root) {
    result.message = solve_message(eliminated_by_combining);
  }
}

/// All equations of f vanish at fractions within what is known of the root.
bool is_exact_root(const System& f, const Solution& root) {
  const auto near = fractions_near(root.x, root.accuracy);
  return std::any_of(near.begin(), near.end(),
                     [&](const auto& x) { return local_ring(f, x).has_value(); });
}

/// The roots told that are simple ones of the combinations, but for those of which it is known
/// exactly that they are roots of f.
std::vector<Solution*> unknown_roots(const System& f, SolveResult& result) {
  std::vector<Solution*> unknown;
  for (Solution& root : result.solutions) {
    if (!is_exact_root(f, root)) unknown.push_back(&root);
  }
  return unknown;
}

/// A root of the combinations at which the other equations all but vanish is a root of the file
/// where exact algebra says so. Where roots lie on curves it counts those that are simple ones of
/// the combinations; each root told that is none of them is one too many.
void require_proofs(const System& f, const System& combinations, const QuotientRing& ring,
                    SolveResult& result) {
  if (!result.complete || ring.points || result.solutions.empty()) return;
  const std::vector<Solution*> unknown = unknown_roots(f, result);
  if (unknown.empty()) return;
  const auto simple = static_cast<std::uint64_t>(
      std::count_if(result.solutions.begin(), result.solutions.end(),
                    [](const Solution& root) { return !root.singular; }));
  const bool are_simple = std::none_of(unknown.begin(), unknown.end(),
                                       [](const Solution* root) { return root->singular; });
  const auto counted_roots = quotient_ring(f, {.most_terms = kTermsOfProof,
                                               .seed = result.seed,
                                               .counts_simple = true,
                                               .square = &combinations})
                                 .simple;
  if (are_simple && counted_roots == simple) return;
  if (counted_roots == 0U && are_simple && simple == result.solutions.size()) {
    result.excess +=
        drop_solutions_where(result, [](const Solution& root) { return !root.singular; });
    return;
  }
  put_in_doubt(result, other_equations_undecided(unknown.size()));
}

/// Where exact algebra counts the different roots of all equations: they are those that are told,
/// and none is a cluster.
void compare_with_algebra(const QuotientRing& ring, SolveResult& result) {
  if (!result.complete || !ring.points) return;
  if (*ring.points == result.solutions.size()) {
    for (Solution& root : result.solutions) root.cluster = false;
    return;
  }
  put_in_doubt(result, algebra_doubt(AlgebraCount::different_of_the_file, *ring.points,
                                     result.solutions.size()));
}

/// Combinations may have a root more often than all equations together.
void tell_of_multiplicities(const QuotientRing& ring, SolveResult& result) {
  std::uint64_t sum = 0;
  for (const Solution& root : result.solutions) sum += root.multiplicity;
  const bool is_finite = ring.verdict == QuotientRing::Verdict::finite;
  if (sum == result.solutions.size() || (is_finite && ring.dimension == sum)) return;
  result.left_out.push_back(
      multiplicities_left_out(is_finite ? std::optional(ring.dimension) : std::nullopt));
}

QuotientRing ring_of(const System& f, std::uint64_t seed) {
  return quotient_ring(f, {.counts_points = true, .seed = seed});
}

/// A proof is of the square system. Beside slices and patches its roots are roots of F;
/// combinations prove nothing of F's equations.
void tell_of_squared(bool is_overdetermined, bool are_told, SolveResult& result) {
  if (!result.completeness) return;
  result.bound.reset();
  if (!is_overdetermined) {
    if (result.completeness == RootCompleteness::proved)
      result.completeness = RootCompleteness::shown;
    return;
  }
  result.completeness.reset();
  for (Solution& root : result.solutions) root.certified.reset();
  if (!are_told) return;
  result.left_out.push_back(combined_certificates_left_out());
}

}  // namespace

System squared(const System& f, const SolveOptions& options) {
  System g = has_homogeneous_groups(f) ? with_patches(f, options.seed) : f;
  if (g.polynomials.size() > g.variables.size()) return square_up(g, options.seed);
  if (g.polynomials.size() < g.variables.size() && options.slice) {
    return with_slices(g, options.seed);
  }
  require_square(g);
  return g;
}

void take_back(const System& f, const SolveOptions& options, SolveResult& result) {
  const bool has_patches = has_homogeneous_groups(f);
  const System g = has_patches ? with_patches(f, result.seed) : f;
  const std::size_t m = g.polynomials.size();
  const std::size_t n = g.variables.size();
  result.system = facts_of(f);
  if (m > n) {
    const System combinations = squared(f, options);
    drop_excess(g, combinations, result);
    result.left_out.push_back(combined_equations_left_out(m, n, result.excess));
    tell_of_eliminated(g, result);
    const bool is_exact = coefficient_errors(g).empty();
    const QuotientRing ring = is_exact ? ring_of(g, result.seed) : QuotientRing{};
    compare_with_algebra(ring, result);
    if (is_exact) require_proofs(g, combinations, ring, result);
    tell_of_multiplicities(ring, result);
  }
  tell_of_squared(m > n, options.certify, result);
  if (m < n) result.left_out.push_back(cut_sets_left_out(n - m));
  if (!has_patches) return;
  for (auto* const points : {&result.solutions, &result.on_sets}) {
    for (Solution& root : *points) root.x = normalized(f.groups, std::move(root.x));
  }
  result.left_out.push_back(patches_left_out());
}

}  // namespace moivre
