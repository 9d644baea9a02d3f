// SPDX-License-Identifier: MIT
// De Moivre's theorem in n variables: angles in 64 binary digits of a turn, classes of roots by
// Hermite's form.
#include "moivre/start/binomial.h"

#include <cmath>
#include <numbers>
#include <stdexcept>
#include <string>

#include "exact_inverse.h"
#include "exact_word.h"
#include "moivre/numeric/invalid_input.h"
#include "moivre/start/cell_geometry.h"

namespace moivre {

namespace {

constexpr double kTurn = 0x1p64;  // units of a turn

/// floor and remainder for d > 0.
template <class Word>
std::pair<Word, Word> floor_division(const Word& a, const Word& d) {
  Word quotient = a / d;
  Word remainder = a % d;
  if (remainder < 0) {
    remainder += d;
    quotient -= 1;
  }
  return {quotient, remainder};
}

/// a modulo 2^64.
std::uint64_t low_bits(std::int64_t a) { return static_cast<std::uint64_t>(a); }
std::uint64_t low_bits(Int128 a) { return static_cast<std::uint64_t>(a); }
std::uint64_t low_bits(const Integer& a) {
  return static_cast<std::uint64_t>(floor_division<Integer>(a, Integer(1) << 64).second);
}

/// arg z in units of 2^-64 turns.
std::uint64_t turns_of(Complex z) {
  const double angle = std::arg(z) / (2 * std::numbers::pi);  // in [-1/2, 1/2]
  const double units = std::abs(angle) * kTurn;
  const auto whole = static_cast<std::uint64_t>(units);
  return angle < 0 ? 0 - whole : whole;
}

std::uint64_t product_modulo(std::uint64_t a, std::uint64_t b, std::uint64_t m) {
  return static_cast<std::uint64_t>(UInt128{a} * b % m);
}

/// u a + v b = gcd(a, b) modulo m, coefficients reduced to [0, m).
struct Bezout {
  std::uint64_t gcd;
  std::uint64_t u;
  std::uint64_t v;
};

std::uint64_t modulo(Int128 a, std::uint64_t m) {
  return static_cast<std::uint64_t>(floor_division<Int128>(a, Int128{m}).second);
}

Bezout bezout(std::uint64_t a, std::uint64_t b, std::uint64_t m) {
  Int128 r0 = a, r1 = b, u0 = 1, u1 = 0, v0 = 0, v1 = 1;
  while (r1 != 0) {
    const Int128 q = r0 / r1;
    r0 = std::exchange(r1, r0 - q * r1);
    u0 = std::exchange(u1, u0 - q * u1);
    v0 = std::exchange(v1, v0 - q * v1);
  }
  return {static_cast<std::uint64_t>(r0), modulo(u0, m), modulo(v0, m)};
}

/// (x, y) <- (u x + v y, s y - t x) modulo m, column by column.
void combine_columns(std::vector<std::uint64_t>& matrix, std::size_t n, std::size_t x,
                     std::size_t y, const std::array<std::uint64_t, 4>& uvst, std::uint64_t m) {
  for (std::size_t row = 0; row < n; ++row) {
    std::uint64_t& a = matrix[row * n + x];
    std::uint64_t& b = matrix[row * n + y];
    const auto sum = UInt128{product_modulo(uvst[0], a, m)} + product_modulo(uvst[1], b, m);
    const auto other = UInt128{product_modulo(uvst[2], b, m)} + (m - product_modulo(uvst[3], a, m));
    a = static_cast<std::uint64_t>(sum % m);
    b = static_cast<std::uint64_t>(other % m);
  }
}

/// The diagonal of the column Hermite form of V: row by row from the top, modulo what is left of
/// the determinant.
std::vector<std::uint64_t> hermite_diagonal(std::span<const std::int64_t> v, std::size_t n,
                                            std::uint64_t determinant) {
  std::uint64_t m = determinant;
  std::vector<std::uint64_t> matrix;
  for (const std::int64_t entry : v) matrix.push_back(modulo(entry, m));
  std::vector<std::uint64_t> diagonal;
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t j = i + 1; j < n; ++j) {
      const std::uint64_t a = matrix[i * n + i] % m;
      const std::uint64_t b = matrix[i * n + j] % m;
      if (b == 0) continue;
      const Bezout c = bezout(a, b, m);
      combine_columns(matrix, n, i, j, {c.u, c.v, a / c.gcd, b / c.gcd}, m);
    }
    diagonal.push_back(bezout(matrix[i * n + i] % m, m, m).gcd);
    m /= diagonal.back();
  }
  return diagonal;
}

/// The parts of the system that need the inverse: everything but the radix.
template <class Word>
BinomialSystem take_apart(std::span<const std::int64_t> v, std::span<const Complex> beta) {
  const std::size_t n = beta.size();
  const auto inverse = scaled_inverse<Word>(v, n);
  if (!inverse) throw InvalidInput("the exponents of the binomials are dependent");
  if (inverse->det > Word(std::numeric_limits<std::int64_t>::max())) {
    throw std::overflow_error("a binomial system with more than 2^63 roots");
  }
  BinomialSystem system;
  system.roots = static_cast<std::uint64_t>(inverse->det);
  std::vector<std::uint64_t> angles;
  for (const Complex& b : beta) angles.push_back(turns_of(b));
  for (std::size_t i = 0; i < n; ++i) {
    double log_modulus = 0;
    std::uint64_t turns = 0;
    for (std::size_t j = 0; j < n; ++j) {
      const Word& entry = inverse->inverse[i * n + j];
      log_modulus += approximate(entry) / approximate(inverse->det) * std::log(std::abs(beta[j]));
      const auto [quotient, remainder] = floor_division<Word>(entry, inverse->det);
      const auto rest = static_cast<std::uint64_t>(remainder);
      turns += low_bits(quotient) * angles[j] +
               static_cast<std::uint64_t>(UInt128{rest} * angles[j] / system.roots);
      system.steps.push_back(rest);
    }
    system.log_modulus.push_back(log_modulus);
    system.turns.push_back(turns);
  }
  return system;
}

}  // namespace

BinomialSystem binomial_system(std::span<const std::int64_t> exponents,
                               std::span<const Complex> beta) {
  if (exponents.size() != beta.size() * beta.size()) {
    throw InvalidInput("the exponents are not a square matrix of the size of beta");
  }
  for (const Complex& b : beta) {
    if (!is_finite(b) || b == 0.0) throw InvalidInput("a binomial without two terms");
  }
  BinomialSystem system =
      in_shortest_word([&](auto word) { return take_apart<decltype(word)>(exponents, beta); });
  system.radix = hermite_diagonal(exponents, beta.size(), system.roots);
  return system;
}

BinomialSystem binomial_system(const MixedSubdivision& subdivision, const MixedCell& cell,
                               std::span<const Complex> coefficients) {
  const std::vector<std::int64_t> v = edge_matrix(subdivision, cell);
  std::vector<Complex> beta;
  std::size_t begin = 0;
  for (std::size_t i = 0; i < cell.edges.size(); ++i) {
    const std::size_t terms = subdivision.supports[i].terms.size();
    if (begin + terms > coefficients.size()) {
      throw InvalidInput("there are fewer coefficients than terms");
    }
    beta.push_back(-coefficients[begin + cell.edges[i][0]] /
                   coefficients[begin + cell.edges[i][1]]);
    begin += terms;
  }
  return binomial_system(v, beta);
}

namespace {

/// Angles of root `number` as fractions of 2 pi, in [-1/2, 1/2).
std::vector<double> angles_of(const BinomialSystem& system, std::uint64_t number) {
  if (number >= system.roots) {
    throw std::out_of_range("root " + std::to_string(number) + " of " +
                            std::to_string(system.roots));
  }
  const std::size_t n = system.radix.size();
  std::vector<std::uint64_t> k;
  for (const std::uint64_t h : system.radix) {
    k.push_back(number % h);
    number /= h;
  }
  std::vector<double> angles;
  for (std::size_t i = 0; i < n; ++i) {
    std::uint64_t parts = 0;  // of `roots` parts of a turn
    for (std::size_t j = 0; j < n; ++j) {
      const UInt128 moved =
          UInt128{parts} + product_modulo(system.steps[i * n + j], k[j], system.roots);
      parts = static_cast<std::uint64_t>(moved % system.roots);
    }
    const auto turns = static_cast<std::uint64_t>((UInt128{parts} << 64) / system.roots);
    angles.push_back(static_cast<double>(static_cast<std::int64_t>(system.turns[i] + turns)) /
                     kTurn);
  }
  return angles;
}

}  // namespace

Point binomial_root(const BinomialSystem& system, std::uint64_t number) {
  Point x;
  const std::vector<double> angles = angles_of(system, number);
  for (std::size_t i = 0; i < angles.size(); ++i) {
    x.push_back(std::polar(std::exp(system.log_modulus[i]), 2 * std::numbers::pi * angles[i]));
  }
  return x;
}

Point binomial_root_logarithm(const BinomialSystem& system, std::uint64_t number) {
  Point z;
  const std::vector<double> angles = angles_of(system, number);
  for (std::size_t i = 0; i < angles.size(); ++i) {
    z.emplace_back(system.log_modulus[i], 2 * std::numbers::pi * angles[i]);
  }
  return z;
}

}  // namespace moivre
