// SPDX-License-Identifier: MIT
// Chinese remainders and rational numbers from them by FLINT; roots and values by Arb.
#include "moivre/certify/ring_points.h"

#include <flint/fmpq.h>
#include <flint/fmpq_poly.h>
#include <flint/ulong_extras.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "arb_polynomial.h"
#include "moivre/algebra/ring_image.h"
#include "moivre/certify/certifier.h"

namespace moivre {
namespace {

class RationalPolynomial {
 public:
  RationalPolynomial() { fmpq_poly_init(value_); }
  RationalPolynomial(const RationalPolynomial&) = delete;
  RationalPolynomial& operator=(const RationalPolynomial&) = delete;
  RationalPolynomial(RationalPolynomial&& other) noexcept : RationalPolynomial() {
    fmpq_poly_swap(value_, other.value_);
  }
  ~RationalPolynomial() { fmpq_poly_clear(value_); }

  fmpq_poly_struct* get() { return value_; }

  /// The numerators alone: a multiple.
  void set_integers(FlintPolynomial& result) const {
    fmpq_poly_get_numerator(result.get(), value_);
  }
  void evaluate(ArbBall& result, acb_srcptr z, slong bits) const {
    FlintPolynomial integers;
    set_integers(integers);
    arb_fmpz_poly_evaluate_acb(result.get(), integers.get(), z, bits);
    acb_div_fmpz(result.get(), result.get(), fmpq_poly_denref(value_), bits);
  }

 private:
  fmpq_poly_t value_;
};

/// m, N_0, N_1 ...
using Representation = std::vector<RationalPolynomial>;

/// One coefficient: what is known of it modulo the product of the primes.
class Remainder {
 public:
  Remainder() { fmpz_init(value_); }
  Remainder(const Remainder& other) : Remainder() { fmpz_set(value_, other.value_); }
  Remainder& operator=(const Remainder&) = delete;
  ~Remainder() { fmpz_clear(value_); }
  fmpz* get() { return value_; }

 private:
  fmpz_t value_;
};

/// m without its leading 1, N_0, N_1 ... in one row.
std::vector<ulong> coefficients_of(const RingImage& image) {
  std::vector<ulong> row(image.minimal.begin(), image.minimal.end() - 1);
  for (const auto& numerator : image.numerators) {
    row.insert(row.end(), numerator.begin(), numerator.end());
  }
  return row;
}

/// Images of one representation, put together.
class Lifting {
 public:
  explicit Lifting(const RingImage& first)
      : degree_(first.minimal.size() - 1), remainders_(coefficients_of(first).size()) {
    fmpz_init_set_ui(modulus_, 1);
    add(first);
  }
  Lifting(const Lifting&) = delete;
  Lifting& operator=(const Lifting&) = delete;
  ~Lifting() { fmpz_clear(modulus_); }

  void add(const RingImage& image) {
    const std::vector<ulong> row = coefficients_of(image);
    for (std::size_t i = 0; i < row.size(); ++i) {
      fmpz_CRT_ui(remainders_[i].get(), remainders_[i].get(), modulus_, row[i], image.prime, 0);
    }
    fmpz_mul_ui(modulus_, modulus_, image.prime);
  }

  /// nullopt where the primes are too few.
  std::optional<Representation> rationals() {
    Representation result(remainders_.size() / degree_);
    fmpq_t c;
    fmpq_init(c);
    bool is_found = true;
    for (std::size_t i = 0; i < remainders_.size() && is_found; ++i) {
      is_found = fmpq_reconstruct_fmpz(c, remainders_[i].get(), modulus_) != 0;
      fmpq_poly_set_coeff_fmpq(result[i / degree_].get(), static_cast<slong>(i % degree_), c);
    }
    fmpq_clear(c);
    if (!is_found) return std::nullopt;
    fmpq_poly_set_coeff_si(result.front().get(), static_cast<slong>(degree_), 1);
    return result;
  }

 private:
  std::size_t degree_;
  std::vector<Remainder> remainders_;
  fmpz_t modulus_;
};

/// The image of each coefficient is the prime's.
bool agree(Representation& representation, const RingImage& image) {
  const std::vector<ulong> row = coefficients_of(image);
  const std::size_t degree = image.minimal.size() - 1;
  fmpq_t c;
  fmpq_init(c);
  bool is_same = true;
  for (std::size_t i = 0; i < row.size() && is_same; ++i) {
    fmpq_poly_get_coeff_fmpq(c, representation[i / degree].get(), static_cast<slong>(i % degree));
    const ulong above = fmpz_fdiv_ui(fmpq_numref(c), image.prime);
    const ulong below = fmpz_fdiv_ui(fmpq_denref(c), image.prime);
    is_same = above == n_mulmod2(below, row[i], image.prime);
  }
  fmpq_clear(c);
  return is_same;
}

bool are_of_one_ring(const RingImage& a, const RingImage& b) {
  return a.staircase == b.staircase && a.minimal.size() == b.minimal.size();
}

/// Looked for after 2, 3, 4, 6, 9 ... primes.
std::optional<Representation> representation_of(const System& f, const RingPointsOptions& options,
                                                std::uint64_t most_dimension) {
  RingImageOptions asked{options.most_terms, most_dimension, options.stop, options.seed, 0};
  auto image = ring_image(f, asked);
  if (!image) return std::nullopt;
  const RingImage first = *image;
  Lifting lifting(first);
  std::optional<Representation> found;
  std::set<std::uint64_t> primes{first.prime};
  std::uint64_t next_look = 2;
  while (asked.most_terms > image->terms) {
    asked.most_terms -= image->terms;
    ++asked.prime;
    image = ring_image(f, asked);
    if (!image || !are_of_one_ring(first, *image)) return std::nullopt;
    // Two numbers may draw one prime, whose image neither adds anything nor confirms it.
    if (!primes.insert(image->prime).second) continue;
    if (found && agree(*found, *image)) return found;
    lifting.add(*image);
    if (asked.prime + 1 < next_look) continue;
    found = lifting.rationals();
    next_look += next_look / 2;
  }
  return std::nullopt;
}

/// x_j = N_j(z) / N_0(z); empty where a coordinate is not known to `bits`.
std::vector<std::vector<Complex>> point_at(const Representation& representation, acb_srcptr z,
                                           int bits, slong working_bits) {
  std::vector<ArbBall> x(representation.size() - 1);
  for (std::size_t j = 0; j < x.size(); ++j) {
    representation[j + 1].evaluate(x[j], z, working_bits);
    if (j > 0) acb_div(x[j].get(), x[j].get(), x[0].get(), working_bits);
  }
  std::vector<std::vector<Complex>> point;
  double size = 1;
  double error = 0;
  for (std::size_t j = 1; j < x.size(); ++j) {
    if (!acb_is_finite(x[j].get())) return {};
    SumOfDoubles sum = sum_of_doubles(x[j].get(), bits);
    size = std::max(size, std::abs(sum.parts.front()));
    error = std::max(error, sum.error);
    point.push_back(std::move(sum.parts));
  }
  if (!(error <= std::ldexp(size, -bits / 2))) return {};
  return point;
}

/// Of one squarefree factor; nullopt where no number of bits is enough.
std::optional<std::vector<std::vector<std::vector<Complex>>>> points_on(
    const Representation& representation, fmpz_poly_struct* factor, int bits) {
  const slong count = fmpz_poly_degree(factor);
  for (slong working = bits; working <= 8 * kMostArbBits; working *= 2) {
    acb_ptr const values = _acb_vec_init(count);
    arb_fmpz_poly_complex_roots(values, factor, 0, working);
    std::vector<std::vector<std::vector<Complex>>> points;
    for (slong k = 0; k < count; ++k) {
      points.push_back(point_at(representation, values + k, bits, 2 * working));
    }
    _acb_vec_clear(values, count);
    const bool are_known =
        std::none_of(points.begin(), points.end(), [](const auto& x) { return x.empty(); });
    if (are_known) return points;
  }
  return std::nullopt;
}

/// Over the rationals: i is one more unknown, the last, with i^2 + 1 = 0. Its roots are those of f
/// with i, and those of the conjugate of f with -i.
System with_i_as_unknown(const System& f) {
  const Polynomial i = unknown(static_cast<std::uint32_t>(f.variables.size()));
  System result;
  result.variables = f.variables;
  result.variables.emplace_back("i");
  for (const Polynomial& p : f.polynomials) {
    Polynomial real, imaginary;
    for (const Term& term : p.terms) {
      const auto& [re, im] = term.coefficient;
      if (!re.is_zero()) real.terms.push_back({{re, 0}, term.monomial});
      if (!im.is_zero()) imaginary.terms.push_back({{im, 0}, term.monomial});
    }
    result.polynomials.push_back(real + imaginary * i);
  }
  result.polynomials.push_back(i * i + 1);
  return result;
}

/// Leaves the roots of f itself.
void take_i_out(std::vector<RingPoint>& points) {
  std::erase_if(points, [](const RingPoint& point) { return point.x.back().front().imag() < 0; });
  for (RingPoint& point : points) point.x.pop_back();
}

std::optional<std::vector<RingPoint>> real_ring_points(const System& f,
                                                       const RingPointsOptions& options,
                                                       std::uint64_t most_dimension) {
  const auto representation = representation_of(f, options, most_dimension);
  if (!representation) return std::nullopt;
  FlintPolynomial minimal;
  representation->front().set_integers(minimal);
  SquarefreeFactors factors(minimal);
  std::vector<RingPoint> result;
  for (slong k = 0; k < factors.count(); ++k) {
    if (fmpz_poly_degree(factors.factor(k)) == 0) continue;
    auto points = points_on(*representation, factors.factor(k), options.bits);
    if (!points) return std::nullopt;
    for (auto& x : *points) result.push_back({std::move(x), factors.exponent(k)});
  }
  return result;
}

}  // namespace

bool are_multiplicities(const std::vector<RingPoint>& points, std::uint64_t dimension) {
  std::uint64_t sum = 0;
  for (const RingPoint& point : points) sum += point.exponent;
  return sum == dimension;
}

std::optional<std::vector<RingPoint>> ring_points(const System& f,
                                                  const RingPointsOptions& options) {
  thread_local const FlintCaches caches;
  if (is_real(f)) return real_ring_points(f, options, kMostRingPoints);
  auto points = real_ring_points(with_i_as_unknown(f), options, 2 * kMostRingPoints);
  if (points) take_i_out(*points);
  return points;
}

}  // namespace moivre
