// SPDX-License-Identifier: MIT
// Which random number is this? One that depends on nothing but (seed, stream, index): the same on
// every machine and thread.
//
// A counter is hashed by SplitMix64's finalizer; there is no state to share, so the k-th number of
// path i is the same for every caller, at any time.
#pragma once

#include <cmath>
#include <cstdint>
#include <numbers>

#include "moivre/numeric/complex.h"

namespace moivre {

/// What a stream of random numbers is for; each purpose has numbers of its own.
enum class RandomStream : std::uint64_t {
  start_system = 1,
  slice = 2,
  test = 3,
  lifting = 4,
  mark = 5,
  generic_member = 6,
  leading_forms = 7,
  linear_product = 8,
  square_up = 9,
  patch = 10,
  section = 11,
  coefficient_lifting = 12,
  certify = 13,
  cluster = 14,
  check = 15,
  formulation = 17,
  family = 20,
  arm = 21,
  algebra = 22
};

namespace detail {

inline constexpr std::uint64_t kGoldenGamma = 0x9E3779B97F4A7C15;

/// SplitMix64's finalizer: a bijection of 64-bit words that keeps 0.
inline std::uint64_t mix(std::uint64_t z) {
  z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9;
  z = (z ^ (z >> 27)) * 0x94D049BB133111EB;
  return z ^ (z >> 31);
}

}  // namespace detail

/// 64 bits from (seed, stream, index).
inline std::uint64_t random_bits(std::uint64_t seed, RandomStream stream, std::uint64_t index) {
  // The seed is hashed too: counted like the index, seed 2 would give seed 1's numbers moved by
  // one.
  std::uint64_t z =
      detail::mix(seed - 1) + detail::kGoldenGamma + static_cast<std::uint64_t>(stream);
  for (const std::uint64_t word : {index, index >> 32}) {
    z = detail::mix(z + detail::kGoldenGamma * (word + 1));
  }
  return z;
}

/// Uniform in [0, 1).
inline double random_unit(std::uint64_t seed, RandomStream stream, std::uint64_t index) {
  return static_cast<double>(random_bits(seed, stream, index) >> 11) * 0x1p-53;
}

/// Uniform on the unit circle.
inline Complex random_phase(std::uint64_t seed, RandomStream stream, std::uint64_t index) {
  return std::polar(1.0, 2 * std::numbers::pi * random_unit(seed, stream, index));
}

}  // namespace moivre
