// SPDX-License-Identifier: MIT
// Which random numbers do the laws take? Plain ones of one generator; a law holds for all of them.
#pragma once

#include <cstdint>
#include <random>

#include "moivre/numeric/complex.h"

namespace moivre::test {

class RandomValues {
 public:
  explicit RandomValues(std::uint64_t seed) : generator_(seed) {}

  double between(double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(generator_);
  }
  /// From 0 to n - 1.
  std::size_t below(std::size_t n) {
    return std::uniform_int_distribution<std::size_t>(0, n - 1)(generator_);
  }
  /// In the square of this half width.
  Complex complex(double half_width) {
    const double re = between(-half_width, half_width);
    return {re, between(-half_width, half_width)};
  }

 private:
  std::mt19937_64 generator_;
};

}  // namespace moivre::test
