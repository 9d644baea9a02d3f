// SPDX-License-Identifier: MIT
// Exact algebra at the price of machine words: numbers modulo a prime. Which prime?
//
//   p = 2^61 - c, c < 2^30; 1 modulo 4, so that -1 has a square root and Gaussian rationals have
//   images
//
// What is independent modulo p is independent. The converse, and that an image 0 comes from 0,
// fails for the few primes that divide some number met on the way. Of a prime that is known
// beforehand, systems can be made for which it fails. So it is drawn after the system is known, by
// a hash of all its numbers, from some ten million primes, and divides none of these numbers: then
// it fails with probability about 1e-18 for each number met, unless somebody searches for a system
// that draws the prime it is made for.
// Private to the module. Source: primality by twelve bases [SorensonWebster17].
#pragma once

#include <cstdint>
#include <optional>

#include "moivre/polynomial/integer_polynomial.h"
#include "moivre/polynomial/system.h"

namespace moivre {

/// In [0, p).
using Residue = std::uint64_t;

__extension__ using WideSum = unsigned __int128;

class PrimeField {
 public:
  /// 2^61 - 31: where a prime that divides too much makes work and no error.
  constexpr PrimeField() = default;
  /// Its prime divides no numerator and no denominator of f, nor maps a number other than 0 to 0.
  /// seed: another one draws another prime.
  explicit PrimeField(const System& f, std::uint64_t seed = 1);

  /// So many products of residues and one residue are no more than a sum holds.
  static constexpr int kMostProducts = 63;

  constexpr Residue prime() const { return kPower - offset_; }
  /// Drawn with the prime: what else is to be random for this system begins with it.
  constexpr std::uint64_t seed() const { return seed_; }
  constexpr Residue times(Residue a, Residue b) const { return reduced_product(WideSum{a} * b); }
  constexpr Residue plus(Residue a, Residue b) const {
    const Residue sum = a + b;
    return sum < prime() ? sum : sum - prime();
  }
  constexpr Residue minus(Residue a) const { return a == 0 ? 0 : prime() - a; }
  constexpr Residue power(Residue a, std::uint64_t exponent) const {
    Residue result = 1;
    for (; exponent != 0; exponent >>= 1) {
      if (exponent & 1) result = times(result, a);
      a = times(a, a);
    }
    return result;
  }
  /// Of a nonzero residue, by Fermat: a^(p-2) a = 1.
  constexpr Residue inverse(Residue a) const { return power(a, prime() - 2); }
  // 2^61 is c modulo the prime: a sum is folded three times, a product twice.
  constexpr Residue reduced(WideSum a) const {
    return reduced_product((a & kLow) + (a >> 61) * offset_);
  }

  Residue residue(const Integer& a) const;
  Residue residue(const GaussianInteger& a) const;
  /// Throws std::invalid_argument where the prime divides a denominator.
  Residue residue(const Coefficient& a) const;

 private:
  static constexpr Residue kPower = Residue{1} << 61;
  static constexpr Residue kLow = kPower - 1;

  explicit constexpr PrimeField(std::uint64_t offset) : offset_(offset) {}

  /// Of less than 2^122: then the first sum is less than 2^92, the second less than twice the
  /// prime.
  constexpr Residue reduced_product(WideSum a) const {
    const WideSum once = (a & kLow) + WideSum{static_cast<Residue>(a >> 61)} * offset_;
    const Residue twice =
        (static_cast<Residue>(once) & kLow) + static_cast<Residue>(once >> 61) * offset_;
    return twice < prime() ? twice : twice - prime();
  }

  bool is_prime() const;
  bool is_faithful_to(const System& f) const;
  void find_root_of_minus_one();
  Residue residue(const Rational& a) const;

  std::uint64_t offset_ = 31;
  std::uint64_t seed_ = 1;
  Residue root_of_minus_one_ = 583529827753931384;
};

}  // namespace moivre
