// SPDX-License-Identifier: MIT
// A hash of a system's numbers, and the next prime from there on.
#include "moivre/polynomial/prime_field.h"

#include <algorithm>
#include <array>
#include <bit>

#include "moivre/numeric/integer.h"
#include "moivre/numeric/invalid_input.h"
#include "moivre/numeric/random.h"

namespace moivre {
namespace {

static_assert(PrimeField().times(583529827753931384, 583529827753931384) ==
                  PrimeField().prime() - 1,
              "not a root of -1");

constexpr std::uint64_t kOffsets = std::uint64_t{1} << 30;
// Strong probable primes to all of them are primes, below 3e23.
constexpr std::array<Residue, 12> kBases{2, 3, 5, 7, 11, 13, 17, 19, 23, 29, 31, 37};

void add_to_hash(std::uint64_t& hash, const Integer& a) {
  constexpr std::uint64_t kChunk = 0xFFFF'FFFF'FFFF'FFC5;  // the largest prime of 64 bits
  const auto chunk = static_cast<std::uint64_t>(Integer(abs(a) % kChunk));
  hash = random_bits(hash, RandomStream::algebra, a < 0 ? ~chunk : chunk);
}

std::uint64_t hash_of(const System& f, std::uint64_t seed) {
  std::uint64_t hash = seed;
  for (const Polynomial& p : f.polynomials) {
    for (const Term& term : p.terms) {
      for (const Rational* part : {&term.coefficient.re, &term.coefficient.im}) {
        add_to_hash(hash, numerator(*part));
        add_to_hash(hash, denominator(*part));
      }
    }
  }
  return hash;
}

}  // namespace

PrimeField::PrimeField(const System& f, std::uint64_t seed) {
  // 1 modulo 4 is 2^61 - c for c = 3, 7, 11, ...
  constexpr std::uint64_t kStep = 4;
  seed_ = hash_of(f, seed);
  offset_ = seed_ % kOffsets / kStep * kStep + kStep - 1;
  for (;; offset_ += kStep) {
    if (!is_prime()) continue;
    find_root_of_minus_one();
    if (is_faithful_to(f)) return;
  }
}

// For p prime a root of -1 is a^((p-1)/4) for each a that is no square.
void PrimeField::find_root_of_minus_one() {
  for (Residue a = 2; times(root_of_minus_one_, root_of_minus_one_) != prime() - 1; ++a) {
    root_of_minus_one_ = power(a, (prime() - 1) / 4);
  }
}

// Miller's and Rabin's test.
bool PrimeField::is_prime() const {
  const int twos = std::countr_zero(prime() - 1);
  return std::all_of(kBases.begin(), kBases.end(), [&](Residue base) {
    Residue a = power(base, (prime() - 1) >> twos);
    if (a == 1) return true;
    for (int k = 1; k < twos && a != prime() - 1; ++k) a = times(a, a);
    return a == prime() - 1;
  });
}

bool PrimeField::is_faithful_to(const System& f) const {
  const auto is_faithful = [&](const Term& term) {
    const Coefficient& c = term.coefficient;
    for (const Rational* part : {&c.re, &c.im}) {
      if (denominator(*part) % prime() == 0) return false;
    }
    return c == Coefficient{} || residue(c) != 0;
  };
  return std::all_of(f.polynomials.begin(), f.polynomials.end(), [&](const Polynomial& p) {
    return std::all_of(p.terms.begin(), p.terms.end(), is_faithful);
  });
}

Residue PrimeField::residue(const Integer& a) const {
  const auto size = static_cast<Residue>(Integer(abs(a) % prime()));
  return a < 0 ? minus(size) : size;
}

Residue PrimeField::residue(const Rational& a) const {
  if (a.is_zero()) return 0;
  const Residue below = residue(denominator(a));
  if (below == 0) throw InvalidInput("a denominator that the prime divides");
  return times(residue(numerator(a)), inverse(below));
}

Residue PrimeField::residue(const GaussianInteger& a) const {
  return plus(residue(a.re), times(root_of_minus_one_, residue(a.im)));
}

Residue PrimeField::residue(const Coefficient& a) const {
  return plus(residue(a.re), times(root_of_minus_one_, residue(a.im)));
}

}  // namespace moivre
