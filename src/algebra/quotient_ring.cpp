// SPDX-License-Identifier: MIT
// Monomials under a staircase, a random multiplication among them, and the inverse of a determinant
// beside.
#include "moivre/algebra/quotient_ring.h"

#include <utility>
#include <vector>

#include "groebner_basis.h"
#include "modular_jacobian.h"
#include "moivre/numeric/random.h"
#include "moivre/polynomial/modular_line.h"
#include "multiplication.h"

namespace moivre {
namespace {

// In the time of a term, beside each other in memory.
constexpr std::uint64_t kMultiplicationsOfATerm = 2;

// Random numbers: coefficients of the linear form, then of two vectors. Of a form that is known
// beforehand a system can be made in which two roots have one value.
constexpr std::uint64_t kFirstOfVectors = 1000;
Residue random_residue(const PrimeField& field, std::uint64_t i) {
  return random_bits(field.seed(), RandomStream::algebra, i) % field.prime();
}

/// The degree of its minimal polynomial, each root once.
std::uint64_t distinct_eigenvalues(const PrimeField& field, const Multiplication& multiplication) {
  const std::size_t dimension = multiplication.dimension();
  std::vector<Residue> left, right;
  for (std::size_t i = 0; i < dimension; ++i) {
    left.push_back(random_residue(field, kFirstOfVectors + 2 * i));
    right.push_back(random_residue(field, kFirstOfVectors + 2 * i + 1));
  }
  std::vector<Residue> sequence;
  for (std::size_t k = 0; k < 2 * dimension; ++k) {
    sequence.push_back(product(field, left.data(), right));
    right = multiplication.times_vector(right);
  }
  return distinct_roots(field, minimal_polynomial(field, sequence));
}

std::optional<std::uint64_t> points(GroebnerBasis& ideal, const std::vector<LeadingMonomial>& basis,
                                    std::uint64_t most_terms) {
  const std::uint64_t size = basis.size();
  if (size * size * size / kMultiplicationsOfATerm > most_terms) return std::nullopt;
  std::vector<Residue> form;
  for (std::size_t i = 0; i < ideal.unknowns(); ++i)
    form.push_back(random_residue(ideal.field(), i));
  const auto multiplication = multiplication_by(ideal, basis, form);
  if (!multiplication) return std::nullopt;
  return distinct_eigenvalues(ideal.field(), *multiplication);
}

QuotientRing verdict(GroebnerBasis& ideal, const QuotientRingOptions& options) {
  if (!ideal.is_finite()) {
    return {QuotientRing::Verdict::infinite, 0, std::nullopt, std::nullopt};
  }
  const auto basis = ideal.monomials();
  if (!basis) return {};
  QuotientRing ring{QuotientRing::Verdict::finite, basis->size(), std::nullopt, std::nullopt};
  if (options.counts_points) ring.points = points(ideal, *basis, options.most_terms);
  return ring;
}

/// Of f, whose ideal this is; it is then another one.
std::optional<std::uint64_t> simple_roots(GroebnerBasis& ideal,
                                          const std::vector<ModularPolynomial>& f) {
  const std::size_t n = ideal.unknowns();
  const PrimeField& field = ideal.field();
  if (n == DegreeAndExponents::kMostUnknowns) return std::nullopt;
  const auto determinant = jacobian_determinant(field, f, ideal.reducers(), ideal.budget());
  if (!determinant) return std::nullopt;
  DegreeAndExponents z;
  z.at[0] = z.at[1 + n] = 1;
  auto inverse =
      sum(field, {{DegreeAndExponents{}, field.minus(1)}}, 1, z, *determinant, ideal.budget());
  if (!inverse) return std::nullopt;
  ideal.add_unknown();
  if (!ideal.add({std::move(*inverse)}) || !ideal.is_finite()) return std::nullopt;
  const auto basis = ideal.monomials();
  if (!basis) return std::nullopt;
  return basis->size();
}

}  // namespace

QuotientRing quotient_ring(const System& f, const QuotientRingOptions& options) {
  const std::size_t n = f.variables.size();
  if (n == 0 || n > DegreeAndExponents::kMostUnknowns) return {};
  const PrimeField field(f, options.seed);
  auto polynomials = modular_images(field, f);
  if (!polynomials) return {};
  // n of the polynomials of the ideal, of which a simple root is to be one.
  std::vector<ModularPolynomial> rows;
  if (options.square != nullptr) {
    rows = modular_images(field, *options.square).value_or(std::vector<ModularPolynomial>{});
  } else if (polynomials->size() == n) {
    rows = *polynomials;
  }
  GroebnerBasis ideal(field, n, options.most_terms, options.stop, options.known);
  if (!ideal.add(std::move(*polynomials))) return {};
  QuotientRing ring = verdict(ideal, options);
  const bool counts_simple =
      ring.verdict != QuotientRing::Verdict::not_found && !rows.empty() &&
      (ring.verdict == QuotientRing::Verdict::infinite || options.counts_simple);
  if (counts_simple) ring.simple = simple_roots(ideal, rows);
  return ring;
}

}  // namespace moivre
