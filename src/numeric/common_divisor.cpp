// SPDX-License-Identifier: MIT
// How is the greatest common divisor of long integers found fast? Euclid's algorithm on their leading digits.
#include <algorithm>
#include <cstdint>
#include <limits>
#include <numeric>

#include "moivre/numeric/integer.h"

namespace moivre {
namespace {

using Limb = boost::multiprecision::limb_type;
static_assert(std::numeric_limits<Limb>::digits == 64, "the leading digits are read limb by limb");

// So many leading bits that sums of two of them and a cofactor fit a signed word.
constexpr std::size_t kLeading = 62;

/// The 64 bits of n from bit `first` on; n >= 0.
std::uint64_t bits_from(const Integer& n, std::size_t first) {
  constexpr std::size_t kBits = std::numeric_limits<Limb>::digits;
  const Limb* limbs = n.backend().limbs();
  const std::size_t size = n.backend().size();
  const std::size_t k = first / kBits;
  const std::size_t offset = first % kBits;
  if (k >= size) return 0;
  const std::uint64_t low = limbs[k] >> offset;
  return offset == 0 || k + 1 >= size ? low : low | (limbs[k + 1] << (kBits - offset));
}

/// (a, b) -> (A a + B b, C a + D b): several steps of Euclid's.
struct Steps {
  std::int64_t A = 1;
  std::int64_t B = 0;
  std::int64_t C = 0;
  std::int64_t D = 1;
};

/// The steps that the leading digits x of a and y of b tell without doubt.
Steps certain_steps(std::int64_t x, std::int64_t y) {
  Steps s;
  while (y + s.C != 0 && y + s.D != 0) {
    const std::int64_t quotient = (x + s.A) / (y + s.C);
    if (quotient != (x + s.B) / (y + s.D)) break;
    s = {s.C, s.D, s.A - quotient * s.C, s.B - quotient * s.D};
    const std::int64_t rest = x - quotient * y;
    x = y;
    y = rest;
  }
  return s;
}

/// a >= b > 0, both odd.
Integer of_odd(Integer a, Integer b) {
  constexpr std::size_t kWord = std::numeric_limits<std::uint64_t>::digits;
  while (!b.is_zero()) {
    const std::size_t length = msb(a) + 1;
    if (length <= kWord) {
      return std::gcd(static_cast<std::uint64_t>(a), static_cast<std::uint64_t>(b));
    }
    const std::size_t first = length - kLeading;
    const Steps s = certain_steps(static_cast<std::int64_t>(bits_from(a, first)),
                                  static_cast<std::int64_t>(bits_from(b, first)));
    if (s.B == 0) {
      a %= b;
      swap(a, b);
      continue;
    }
    Integer next = a * s.A + b * s.B;
    b = a * s.C + b * s.D;
    a = std::move(next);
  }
  return a;
}

}  // namespace

// Powers of two are told apart first: where a rational was a double its denominator is one.
Integer common_divisor(Integer a, Integer b) {
  a = abs(a);
  b = abs(b);
  if (a.is_zero() || b.is_zero()) return a + b;
  if (a == 1 || b == 1) return 1;
  const auto twos_of_a = lsb(a);
  const auto twos_of_b = lsb(b);
  a >>= twos_of_a;
  b >>= twos_of_b;
  if (a < b) swap(a, b);
  Integer odd = b == 1 ? b : of_odd(std::move(a), std::move(b));
  return odd << std::min(twos_of_a, twos_of_b);
}

}  // namespace moivre
