// SPDX-License-Identifier: MIT
// How is integer arithmetic exact and fast at once? In words of 64 or 128 bits while bounds show
// that nothing overflows.
//
// A kernel works on whole vectors. Before it runs, a bound on everything it will form is computed
// in double, from the largest magnitudes; `require_room` throws WordTooShort where the bound comes
// near the word's range. The caller then begins again with the next longer word: std::int64_t,
// Int128, Integer (any length, no bound). The bounds are rounded sums and products of a few hundred
// terms at most: a factor 2 of the range is far more than their rounding.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <type_traits>
#include <vector>

#include "moivre/numeric/integer.h"

namespace moivre {

__extension__ typedef __int128 Int128;
__extension__ typedef unsigned __int128 UInt128;

/// Never leaves the module: the longest word has room for everything.
struct WordTooShort : std::runtime_error {
  WordTooShort() : std::runtime_error("an integer does not fit into the word in use") {}
};

template <class Word>
inline constexpr bool is_machine_word = !std::is_same_v<Word, Integer>;

inline void require_room(std::int64_t /*word*/, double bound) {
  if (!(bound < 0x1p62)) throw WordTooShort();
}
inline void require_room(Int128 /*word*/, double bound) {
  if (!(bound < 0x1p126)) throw WordTooShort();
}
inline void require_room(const Integer& /*word*/, double /*bound*/) {}

inline double approximate(std::int64_t a) { return static_cast<double>(a); }
inline double approximate(Int128 a) { return static_cast<double>(a); }
inline double approximate(const Integer& a) { return a.convert_to<double>(); }

template <class Word>
int sign(const Word& a) {
  return a > 0 ? 1 : a < 0 ? -1 : 0;
}

/// A bound on all magnitudes, less than twice the largest; 0 for Integer, where nothing asks for
/// it.
template <class Word>
double magnitude(const Word* begin, std::size_t count) {
  if constexpr (is_machine_word<Word>) {
    const int sign_bit = 8 * sizeof(Word) - 1;
    Word bits = 0;  // of |x| or |x| - 1, united: quicker than a maximum
    for (std::size_t k = 0; k < count; ++k) bits |= begin[k] ^ (begin[k] >> sign_bit);
    return approximate(bits) + 1;
  } else {
    return 0;
  }
}

template <class Word>
double magnitude(const std::vector<Word>& v) {
  return magnitude(v.data(), v.size());
}

inline Integer to_integer(std::int64_t a) { return Integer(a); }
inline Integer to_integer(Int128 a) { return Integer(a); }
inline Integer to_integer(const Integer& a) { return a; }

/// The number as a word that has room for it.
template <class Word>
Word as_word(Int128 a) {
  if constexpr (is_machine_word<Word>)
    return static_cast<Word>(a);
  else
    return to_integer(a);
}

/// Sign of p/q - r/s for q, s > 0.
inline int compare_fractions(std::int64_t p, std::int64_t q, std::int64_t r, std::int64_t s) {
  return sign(static_cast<Int128>(p) * s - static_cast<Int128>(r) * q);
}
template <class Word>
int compare_fractions(const Word& p, const Word& q, const Word& r, const Word& s) {
  return sign<Integer>(to_integer(p) * to_integer(s) - to_integer(r) * to_integer(q));
}

/// Division of multiples of d > 0 by d.
template <class Word>
class ExactDivisor {
 public:
  explicit ExactDivisor(const Word& d) : divisor_(d) {}
  Word quotient(const Word& multiple) const { return multiple / divisor_; }
  bool equals(const Word& d) const { return divisor_ == d; }

 private:
  Word divisor_;
};

/// By the inverse of the odd part modulo 2^bits: a product instead of a division.
template <class Word, class Unsigned>
class ExactMachineDivisor {
 public:
  explicit ExactMachineDivisor(Word d) : divisor_(d) {
    while ((d & 1) == 0) {
      d >>= 1;
      ++shift_;
    }
    const auto odd = static_cast<Unsigned>(d);
    inverse_ = odd;  // right to 3 bits; each step of Newton's iteration doubles them
    for (std::size_t bits = 3; bits < 8 * sizeof(Word); bits *= 2) inverse_ *= 2 - odd * inverse_;
  }
  Word quotient(Word multiple) const {
    return static_cast<Word>(static_cast<Unsigned>(multiple >> shift_) * inverse_);
  }
  bool equals(Word d) const { return divisor_ == d; }

 private:
  Word divisor_;
  Unsigned inverse_ = 1;
  int shift_ = 0;
};

template <>
class ExactDivisor<std::int64_t> : public ExactMachineDivisor<std::int64_t, std::uint64_t> {
  using ExactMachineDivisor::ExactMachineDivisor;
};
template <>
class ExactDivisor<Int128> : public ExactMachineDivisor<Int128, UInt128> {
  using ExactMachineDivisor::ExactMachineDivisor;
};

/// x <- (p x - q y) / d, element by element, where that is a vector of integers; p > 0.
template <class Word>
void eliminate(const Word& p, Word* x, const Word* y, const Word& q, std::size_t count,
               const ExactDivisor<Word>& d) {
  if (q == 0 && d.equals(p)) return;
  require_room(Word(), approximate(p) * magnitude(x, count) +
                           std::abs(approximate(q)) * magnitude(y, count));
  for (std::size_t k = 0; k < count; ++k) x[k] = d.quotient(p * x[k] - q * y[k]);
}

/// The result of task(Word()) in the shortest word that has room for it.
template <class Task>
auto in_shortest_word(const Task& task) {
  try {
    return task(std::int64_t{});
  } catch (const WordTooShort&) {
  }
  try {
    return task(Int128{});
  } catch (const WordTooShort&) {
  }
  return task(Integer{});
}

}  // namespace moivre
