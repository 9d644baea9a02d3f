// SPDX-License-Identifier: MIT
// A factored modulo p, the digits of x, and the fractions that have them.
#include "lifting.h"

#include <algorithm>
#include <numeric>

#include "moivre/polynomial/prime_field.h"

namespace moivre {
namespace {

using Residues = std::vector<Residue>;

/// P A = L U modulo the prime, L with ones on its diagonal; L and U in one square, row by row.
class Factored {
 public:
  Factored(const std::vector<LinearEquation>& equations, const std::atomic<bool>* stop)
      : size_(equations.size()), rows_(size_, Residues(size_, 0)), origin_(size_) {
    for (std::size_t i = 0; i < size_; ++i) {
      for (const auto& [j, a] : equations[i].terms) rows_[i][j] = field_.residue(a);
    }
    std::iota(origin_.begin(), origin_.end(), std::size_t{0});
    for (std::size_t k = 0; k < size_ && is_regular_; ++k) {
      is_regular_ = eliminate_column(k) && !(stop != nullptr && stop->load());
    }
  }

  bool is_regular() const { return is_regular_; }
  Residue prime() const { return field_.prime(); }

  /// x of A x = b modulo the prime.
  Residues solution(const std::vector<Integer>& b) const {
    Residues x(size_);
    for (std::size_t i = 0; i < size_; ++i) x[i] = less_products(b_at(b, i), i, 0, i, x);
    for (std::size_t i = size_; i-- > 0;) {
      x[i] = field_.times(less_products(x[i], i, i + 1, size_, x), inverses_[i]);
    }
    return x;
  }

 private:
  /// False where no row has a pivot there.
  bool eliminate_column(std::size_t k) {
    std::size_t pivot = k;
    while (pivot < size_ && rows_[pivot][k] == 0) ++pivot;
    if (pivot == size_) return false;
    std::swap(rows_[k], rows_[pivot]);
    std::swap(origin_[k], origin_[pivot]);
    inverses_.push_back(field_.inverse(rows_[k][k]));
    for (std::size_t i = k + 1; i < size_; ++i) {
      Residues& row = rows_[i];
      if (row[k] == 0) continue;
      row[k] = field_.times(row[k], inverses_[k]);
      const Residue share = field_.minus(row[k]);
      for (std::size_t j = k + 1; j < size_; ++j) {
        row[j] = field_.reduced(WideSum{share} * rows_[k][j] + row[j]);
      }
    }
    return true;
  }

  Residue b_at(const std::vector<Integer>& b, std::size_t i) const {
    return field_.residue(b[origin_[i]]);
  }

  /// value - sum of rows_[i][j] x[j], first <= j < end
  Residue less_products(Residue value, std::size_t i, std::size_t first, std::size_t end,
                        const Residues& x) const {
    constexpr std::size_t kTogether = PrimeField::kMostProducts;
    WideSum sum = 0;
    for (std::size_t j = first; j < end; j += kTogether) {
      const std::size_t behind = std::min(j + kTogether, end);
      sum = field_.reduced(sum);
      for (std::size_t k = j; k < behind; ++k) sum += WideSum{rows_[i][k]} * x[k];
    }
    return field_.plus(value, field_.minus(field_.reduced(sum)));
  }

  PrimeField field_;
  std::size_t size_;
  std::vector<Residues> rows_;
  std::vector<std::size_t> origin_;  ///< of each row of P A
  Residues inverses_;                ///< of U's diagonal
  bool is_regular_ = true;
};

/// Bits that no numerator or denominator of x exceeds: by Cramer's rule they are determinants, no
/// larger than the product of their rows' lengths (Hadamard).
std::size_t bits_of_determinants(const std::vector<LinearEquation>& equations) {
  std::size_t bits = 1;
  for (const LinearEquation& equation : equations) {
    Integer square = equation.right * equation.right;
    for (const auto& [j, a] : equation.terms) square += a * a;
    bits += (bit_length(square) + 1) / 2;
  }
  return bits;
}

/// The last digits of the solution to a base of `modulus`, a power of the prime.
struct Lifted {
  std::vector<Integer> x;
  Integer modulus = 1;
};

std::optional<Lifted> lifted(const std::vector<LinearEquation>& equations, const Factored& factored,
                             std::size_t bits, const std::atomic<bool>* stop) {
  Lifted result{std::vector<Integer>(equations.size()), 1};
  std::vector<Integer> left;
  for (const LinearEquation& equation : equations) left.push_back(equation.right);
  while (bit_length(result.modulus) <= bits) {
    if (stop != nullptr && stop->load(std::memory_order_relaxed)) return std::nullopt;
    const Residues digits = factored.solution(left);
    for (std::size_t i = 0; i < equations.size(); ++i) {
      for (const auto& [j, a] : equations[i].terms) left[i] -= a * digits[j];
      left[i] /= factored.prime();
      result.x[i] += result.modulus * digits[i];
    }
    result.modulus *= factored.prime();
  }
  return result;
}

/// In (-modulus / 2, modulus / 2].
Integer balanced(const Integer& a, const Integer& modulus) {
  Integer rest = a % modulus;
  if (rest < 0) rest += modulus;
  return 2 * rest > modulus ? Integer(rest - modulus) : rest;
}

/// The denominator d > 0 of the fraction n / d = a modulo `modulus` with n of at most `bits` bits:
/// Euclid's algorithm, until the remainder is as short [Dixon82].
Integer denominator_of(const Integer& a, const Integer& modulus, std::size_t bits) {
  Integer before = modulus, rest = a < 0 ? Integer(a + modulus) : a;
  Integer cofactor_before = 0, cofactor = 1;
  while (bit_length(rest) > bits) {
    const Integer quotient = before / rest;
    before -= quotient * rest;
    cofactor_before -= quotient * cofactor;
    swap(before, rest);
    swap(cofactor_before, cofactor);
  }
  return abs(cofactor);
}

}  // namespace

std::optional<RationalPoint> lifted_solution(const std::vector<LinearEquation>& equations,
                                             const std::atomic<bool>* stop) {
  const Factored factored(equations, stop);
  if (!factored.is_regular()) return std::nullopt;
  const std::size_t bits = bits_of_determinants(equations);
  const auto digits = lifted(equations, factored, 2 * bits + 1, stop);
  if (!digits) return std::nullopt;
  // Once the denominator so far is that of x_j too, x_j times it is as short as a determinant.
  RationalPoint point;
  std::vector<Integer> denominators;
  for (const Integer& x : digits->x) {
    Integer numerator = balanced(x * point.denominator, digits->modulus);
    if (bit_length(numerator) > bits) {
      const Integer more = denominator_of(numerator, digits->modulus, bits);
      numerator = balanced(numerator * more, digits->modulus);
      point.denominator *= more;
    }
    point.numerators.push_back(std::move(numerator));
    denominators.push_back(point.denominator);
  }
  for (std::size_t j = 0; j < denominators.size(); ++j) {
    point.numerators[j] *= point.denominator / denominators[j];
  }
  return point;
}

}  // namespace moivre
