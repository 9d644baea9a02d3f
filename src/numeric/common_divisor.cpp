// SPDX-License-Identifier: MIT
// How is the greatest common divisor of long integers found fast? Euclid's algorithm on their
// leading digits.
#include <algorithm>
#include <cstdint>
#include <limits>
#include <numeric>

#include "moivre/numeric/integer.h"

namespace moivre {
namespace {

using Limb = boost::multiprecision::limb_type;
constexpr std::size_t kWord = std::numeric_limits<Limb>::digits;
static_assert(kWord == 64, "the leading digits are read limb by limb");
__extension__ using Wide = __int128;

// So many leading bits that cofactors, which are shorter than half of them, and sums of two
// products fit two words.
constexpr std::size_t kLeading = 62;

/// The 64 bits of n from bit `first` on; n >= 0.
std::uint64_t bits_from(const Integer& n, std::size_t first) {
  const Limb* limbs = n.backend().limbs();
  const std::size_t size = n.backend().size();
  const std::size_t k = first / kWord;
  const std::size_t offset = first % kWord;
  if (k >= size) return 0;
  const std::uint64_t low = limbs[k] >> offset;
  return offset == 0 || k + 1 >= size ? low : low | (limbs[k + 1] << (kWord - offset));
}

/// (a, b) -> (A a + B b, C a + D b): several steps of Euclid's.
struct Steps {
  std::int64_t A = 1;
  std::int64_t B = 0;
  std::int64_t C = 0;
  std::int64_t D = 1;
};

/// The steps that the leading digits x of a and y of b tell without doubt, whatever digits follow:
/// remainders have to exceed what these can change, the cofactors, which alternate in sign
/// [Jebelean93].
Steps certain_steps(std::int64_t x, std::int64_t y) {
  Steps s;
  bool is_even = false;
  while (y != 0) {
    const std::int64_t quotient = x / y;
    const std::int64_t rest = x - quotient * y;
    const Steps next{s.C, s.D, s.A - quotient * s.C, s.B - quotient * s.D};
    const bool is_certain = is_even ? rest >= -next.C && y - rest >= next.D - next.B
                                    : rest >= -next.D && y - rest >= next.C - next.A;
    if (!is_certain) break;
    s = next;
    x = y;
    y = rest;
    is_even = !is_even;
  }
  return s;
}

/// In place, limb by limb: both results are not negative and no longer than a was.
void take(const Steps& s, Integer& a, Integer& b) {
  // Of the type that this release of Boost counts limbs in.
  const auto size = a.backend().size();
  const auto size_of_b = b.backend().size();
  b.backend().resize(size, size);
  Limb* p = a.backend().limbs();
  Limb* q = b.backend().limbs();
  std::fill(q + size_of_b, q + size, Limb{0});
  Wide carry_a = 0;
  Wide carry_b = 0;
  for (std::size_t k = 0; k < size; ++k) {
    const Wide ak = p[k];
    const Wide bk = q[k];
    carry_a += s.A * ak + s.B * bk;
    carry_b += s.C * ak + s.D * bk;
    p[k] = static_cast<Limb>(carry_a);
    q[k] = static_cast<Limb>(carry_b);
    carry_a >>= kWord;
    carry_b >>= kWord;
  }
  a.backend().normalize();
  b.backend().normalize();
}

/// a >= b > 0, both odd.
Integer of_odd(Integer a, Integer b) {
  while (!b.is_zero()) {
    const std::size_t length = msb(a) + 1;
    if (length <= kWord) return std::gcd(*a.backend().limbs(), *b.backend().limbs());
    const std::size_t first = length - kLeading;
    const Steps s = certain_steps(static_cast<std::int64_t>(bits_from(a, first)),
                                  static_cast<std::int64_t>(bits_from(b, first)));
    if (s.B == 0) {
      a %= b;
      swap(a, b);
    } else {
      take(s, a, b);
    }
  }
  return a;
}

}  // namespace

// Powers of two are told apart first: where a rational was a double its denominator is one.
Integer common_divisor(Integer a, Integer b) {
  if (a < 0) a.backend().negate();
  if (b < 0) b.backend().negate();
  if (a.is_zero()) return b;
  if (b.is_zero()) return a;
  if (a.backend().size() == 1 && b.backend().size() == 1) {
    return std::gcd(*a.backend().limbs(), *b.backend().limbs());
  }
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
