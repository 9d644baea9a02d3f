// SPDX-License-Identifier: MIT
// Are the products of inner loops those of std::complex on finite numbers, and does a NaN stay a
// NaN?
#include "moivre/numeric/complex.h"

#include <gtest/gtest.h>

#include <limits>
#include <random>

namespace moivre {
namespace {

using Double = std::numeric_limits<double>;
// Two products and a sum for each part: at most 2 units in the last place of |a||b|.
constexpr double kProductError = 2 * Double::epsilon();
constexpr double kNaN = Double::quiet_NaN();

class RandomComplex {
 public:
  Complex operator()() { return {part_(random_), part_(random_)}; }

 private:
  std::mt19937_64 random_{1};
  std::uniform_real_distribution<double> part_{-1, 1};
};

TEST(ComplexProduct, IsThatOfTheStandardLibraryOnFiniteNumbers) {
  RandomComplex next;
  for (int k = 0; k < 1000; ++k) {
    const Complex a = next();
    const Complex b = next();
    const double error = kProductError * std::abs(a) * std::abs(b);
    EXPECT_LE(std::abs(product(a, b) - a * b), error);
    EXPECT_LE(std::abs(conjugate_product(a, b) - std::conj(a) * b), error);
    EXPECT_EQ(product(a, b.real()), a * b.real());
    EXPECT_EQ(product(b.real(), a), a * b.real());
  }
}

TEST(ComplexProduct, KeepsANaNWhereverItStands) {
  const Complex b(3, -2);
  for (const Complex& a : {Complex(kNaN, 1), Complex(1, kNaN), Complex(kNaN, kNaN)}) {
    for (const Complex& c : {product(a, b), product(b, a), conjugate_product(a, b)}) {
      EXPECT_TRUE(std::isnan(c.real()) && std::isnan(c.imag())) << a;
    }
  }
}

TEST(ComplexProduct, DoesNotMendInfinitiesAsAnnexGDoes) {
  const Complex infinite(Double::infinity(), Double::infinity());
  EXPECT_TRUE(std::isnan(product(infinite, infinite).real()));
  EXPECT_FALSE(is_finite(product(infinite, Complex(1, 0))));
}

TEST(ComplexReciprocal, TimesItsNumberIsOne) {
  RandomComplex next;
  for (int k = 0; k < 1000; ++k) {
    const Complex a = next();
    EXPECT_LE(std::abs(product(a, reciprocal(a)) - 1.0), 4 * Double::epsilon());
  }
}

TEST(Magnitude1, LiesBetweenTheModulusAndRootTwoTimesIt) {
  RandomComplex next;
  for (int k = 0; k < 1000; ++k) {
    const Complex a = next();
    EXPECT_GE(magnitude1(a) * (1 + Double::epsilon()), std::abs(a));
    EXPECT_LE(magnitude1(a), std::sqrt(2.0) * std::abs(a) * (1 + 2 * Double::epsilon()));
  }
}

TEST(Norms, AreThoseOfAPythagoreanTripleAndOrdered) {
  const Point x{{3, 4}, {0, -12}, {0, 0}};
  EXPECT_EQ(max_norm(x), 12);
  EXPECT_EQ(max_norm({Complex(1e200), Complex(0, -3e200)}), 3e200);
  EXPECT_EQ(euclidean_norm(x), 13);
}

TEST(Norms, AreNaNWhereverACoordinateIs) {
  for (std::size_t place = 0; place < 3; ++place) {
    Point x{1.0, 2.0, 3.0};
    x[place] = {0, kNaN};
    EXPECT_TRUE(std::isnan(max_norm(x))) << place;
    EXPECT_TRUE(std::isnan(euclidean_norm(x))) << place;
    EXPECT_FALSE(is_finite(x[place]));
  }
}

}  // namespace
}  // namespace moivre
