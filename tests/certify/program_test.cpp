// SPDX-License-Identifier: MIT
// Do the discs around rounded coefficients hold the exact ones, and no more than they must?
#include "program.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <vector>

namespace moivre {
namespace {

/// Typed numbers, quotients of whole numbers of up to 53 bits, and longer ones.
std::vector<Rational> coefficients() {
  std::vector<Rational> found{Rational(1, 3),
                              Rational(-31, 10),
                              Rational(7),
                              Rational(0.1),
                              Rational(1, 3) + Rational(0x1p-112),
                              Rational(0x1p-700)};
  std::mt19937_64 random(5);
  for (int k = 0; k < 2000; ++k) {
    const auto word = [&](int bits) {
      return 1 + static_cast<std::int64_t>(random() >> (64 - bits));
    };
    const int bits = 1 + static_cast<int>(random() % 53);
    found.emplace_back(k % 2 == 0 ? word(bits) : -word(bits), word(1 + k % 60));
  }
  return found;
}

/// r (x + 1), whose tape has the coefficient r.
CertifyProgram program_of(const Rational& r) {
  System f;
  f.variables = {"x"};
  f.polynomials = {Coefficient{r, 0} * (unknown(0) + constant({1, 0}))};
  return CertifyProgram(f, 0);
}

TEST(CertifyProgram, HasDiscsThatHoldTheCoefficientsWithinTheirRounding) {
  for (const Rational& r : coefficients()) {
    const CertifyProgram program = program_of(r);
    const double size = std::abs(to_double(r));
    for (const auto& disc : program.coefficients) {
      const Rational off = abs(r - Rational(disc.middle.real()));
      EXPECT_LE(off, Rational(disc.radius)) << r;
      EXPECT_LE(disc.radius, 1.1 * to_double(off) + 0x1p-1000) << r;
      EXPECT_GE(disc.size, size) << r;
      EXPECT_TRUE(disc.is_real);
    }
    for (const auto& disc : program.fine_coefficients) {
      const Rational off = abs(r - Rational(disc.middle.re.hi) - Rational(disc.middle.re.lo));
      EXPECT_LE(off, Rational(disc.radius)) << r;
      EXPECT_LE(disc.radius, 1.1 * to_double(off) + 0x1p-1000) << r;
      EXPECT_LE(disc.radius, 0x1p-105 * size) << r;
    }
  }
}

}  // namespace
}  // namespace moivre
