// SPDX-License-Identifier: MIT
// A Krylov sequence in the quotient ring, its recurrence, and the numerators of its generating
// functions.
#include "moivre/algebra/ring_image.h"

#include "groebner_basis.h"
#include "moivre/numeric/random.h"
#include "moivre/polynomial/modular_line.h"
#include "multiplication.h"

namespace moivre {
namespace {

// A product in the time of half a term (quotient_ring.cpp).
constexpr std::uint64_t kProductsOfATerm = 2;
// Coefficients of the forms: as small as they may be and yet different, since m's coefficients grow
// with them.
constexpr std::uint64_t kCoefficients = 1024;
constexpr std::uint64_t kFirstOfForm = 2000, kFirstOfFunctional = 3000;

/// 1 .. kCoefficients, the same for every prime.
Residue small_number(std::uint64_t seed, std::uint64_t i) {
  return 1 + random_bits(seed, RandomStream::algebra, i) % kCoefficients;
}

std::vector<Residue> small_numbers(std::uint64_t seed, std::uint64_t first, std::size_t count) {
  std::vector<Residue> numbers;
  for (std::size_t i = 0; i < count; ++i) numbers.push_back(small_number(seed, first + i));
  return numbers;
}

Fingerprint fingerprint_of(const std::vector<LeadingMonomial>& basis) {
  FingerprintMaker maker;
  for (const LeadingMonomial& m : basis) {
    for (const std::uint8_t exponent : m.at) maker.add(std::uint64_t{exponent});
  }
  return maker.fingerprint();
}

/// The part without negative powers of m(z) sum_k s_k z^(-k-1).
Line numerator_of(const PrimeField& field, const Line& m, const std::vector<Residue>& s) {
  const std::size_t d = m.size() - 1;
  Line n(d, 0);
  for (std::size_t i = 0; i < d; ++i) {
    for (std::size_t k = 0; i + k + 1 <= d; ++k) {
      n[i] = field.plus(n[i], field.times(m[i + k + 1], s[k]));
    }
  }
  return n;
}

/// 1, x_1, ... x_n by the basis.
std::optional<std::vector<std::vector<Residue>>> one_and_unknowns(
    GroebnerBasis& ideal, const std::vector<LeadingMonomial>& basis) {
  std::vector<std::vector<Residue>> vectors;
  for (std::size_t j = 0; j <= ideal.unknowns(); ++j) {
    LeadingMonomial m;
    if (j > 0) m.at[0] = m.at[j] = 1;
    const auto form = ideal.normal_form({{m, 1}});
    if (!form) return std::nullopt;
    vectors.push_back(by_basis(basis, *form));
  }
  return vectors;
}

/// l(u^k v) for each of the vectors v, k = 0 .. 2 D - 1.
std::vector<std::vector<Residue>> sequences(const PrimeField& field, const Multiplication& by_u,
                                            const std::vector<std::vector<Residue>>& vectors,
                                            std::vector<Residue> l) {
  std::vector<std::vector<Residue>> s(vectors.size());
  for (std::size_t k = 0; k < 2 * by_u.dimension(); ++k) {
    for (std::size_t j = 0; j < vectors.size(); ++j) {
      s[j].push_back(product(field, l.data(), vectors[j]));
    }
    l = by_u.vector_times(l);
  }
  return s;
}

}  // namespace

std::optional<RingImage> ring_image(const System& f, const RingImageOptions& options) {
  const std::size_t n = f.variables.size();
  if (n == 0 || n > DegreeAndExponents::kMostUnknowns || !is_real(f)) return std::nullopt;
  const PrimeField field(f, options.seed + 1 + options.prime);
  auto polynomials = modular_images(field, f);
  if (!polynomials) return std::nullopt;
  GroebnerBasis ideal(field, n, options.most_terms, options.stop, 0);
  if (!ideal.add(std::move(*polynomials)) || !ideal.is_finite()) return std::nullopt;
  const auto basis = ideal.monomials();
  if (!basis || basis->empty() || basis->size() > options.most_dimension) return std::nullopt;
  const std::uint64_t size = basis->size();
  ideal.budget().spend(2 * size * size * size / kProductsOfATerm);
  const std::uint64_t seed = PrimeField(f, options.seed).seed();
  const auto by_u = multiplication_by(ideal, *basis, small_numbers(seed, kFirstOfForm, n));
  const auto vectors = one_and_unknowns(ideal, *basis);
  if (!by_u || !vectors || ideal.budget().is_used_up()) return std::nullopt;

  const auto s =
      sequences(field, *by_u, *vectors, small_numbers(seed, kFirstOfFunctional, basis->size()));
  RingImage image;
  image.prime = field.prime();
  image.terms = options.most_terms - ideal.budget().left();
  image.staircase = fingerprint_of(*basis);
  image.minimal = minimal_polynomial(field, s.front());
  for (const auto& sequence : s) {
    image.numerators.push_back(numerator_of(field, image.minimal, sequence));
  }
  return image;
}

}  // namespace moivre
