// SPDX-License-Identifier: MIT
// Do discs enclose what they should? Random products and sums against exact rational arithmetic, at
// all sizes.
#include "ball.h"

#include <gtest/gtest.h>

#include "moivre/numeric/random.h"

namespace moivre::test {
namespace {

constexpr std::uint64_t kSeeds = 3;
constexpr int kDraws = 150;

/// The logarithms of sizes lie between these two.
struct Sizes {
  double least, most;
};

class Draw {
 public:
  Draw(std::uint64_t seed, Sizes sizes) : seed_(seed), sizes_(sizes) {}
  double unit() { return random_unit(seed_, RandomStream::test, next_++); }
  double real() {
    return (2 * unit() - 1) *
           std::exp2(std::floor(sizes_.least + (sizes_.most - sizes_.least) * unit()));
  }
  Complex complex() { return {real(), real()}; }

 private:
  std::uint64_t seed_;
  Sizes sizes_;
  std::uint64_t next_ = 0;
};

Coefficient exact(const Complex& z) { return {Rational(z.real()), Rational(z.imag())}; }
Coefficient exact(const ComplexDoubleDouble& z) {
  return {Rational(z.re.hi) + Rational(z.re.lo), Rational(z.im.hi) + Rational(z.im.lo)};
}

bool contains(const Coefficient& middle, double radius, const Coefficient& z) {
  const Coefficient d = z - middle;
  return d.re * d.re + d.im * d.im <= Rational(radius) * Rational(radius);
}
bool contains(const Ball& b, const Coefficient& z) {
  return contains(exact(b.middle()), b.radius, z);
}
bool contains(const FineBall& b, const Coefficient& z) {
  return contains(exact(b.middle), b.radius, z);
}

/// A point of the disc's edge, nearly.
Coefficient edge(const Complex& middle, double radius, double turn) {
  const Complex offset = std::polar(radius * (1 - 0x1p-40), 6.283185307179586 * turn);
  return exact(middle) + exact(offset);
}

// Besides sizes that sums of squares can hold, those that fall below the smallest number.
class BallsOfSize : public testing::TestWithParam<Sizes> {};

TEST_P(BallsOfSize, ProductsAndSumsEnclose) {
  for (std::uint64_t seed = 1; seed <= kSeeds; ++seed) {
    Draw draw(seed, GetParam());
    for (int k = 0; k < kDraws; ++k) {
      const Complex m = draw.complex(), w = draw.complex();
      const double r = k % 2 == 0 ? 0 : std::abs(draw.real()),
                   s = k % 3 == 0 ? 0 : std::abs(draw.real());
      const Ball a(m, r), b(w, s);
      const Coefficient x = edge(m, r, draw.unit()), y = edge(w, s, draw.unit());
      ASSERT_TRUE(contains(product(a, b), x * y)) << seed << ' ' << k;
      Ball sum = a;
      sum += b;
      ASSERT_TRUE(contains(sum, x + y)) << seed << ' ' << k;
      const CoefficientBall<Complex> c{m, r, raised(size_bound(m) + r), false};
      ASSERT_TRUE(contains(product(c, b), x * y)) << seed << ' ' << k;
    }
  }
}

TEST_P(BallsOfSize, FineProductsAndSumsEnclose) {
  for (std::uint64_t seed = 1; seed <= kSeeds; ++seed) {
    Draw draw(seed, GetParam());
    const auto fine = [&] {
      const Complex hi = draw.complex();
      const auto part = [&](double x) {
        return DoubleDouble(x) + DoubleDouble(x * 0x1p-54 * draw.unit());
      };
      return ComplexDoubleDouble(part(hi.real()), part(hi.imag()));
    };
    for (int k = 0; k < kDraws; ++k) {
      const FineBall a(fine(), 0), b(fine(), 0);
      const FineBall ab = product(a, b);
      ASSERT_TRUE(contains(ab, exact(a.middle) * exact(b.middle))) << seed << ' ' << k;
      FineBall sum = a;
      sum += b;
      ASSERT_TRUE(contains(sum, exact(a.middle) + exact(b.middle))) << seed << ' ' << k;
      // Tight as well: what encloses everything proves nothing.
      EXPECT_LE(ab.radius, 0x1p-98 * size_bound(a.middle.re.hi, a.middle.im.hi) *
                                   size_bound(b.middle.re.hi, b.middle.im.hi) +
                               0x1p-1050);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Sizes, BallsOfSize,
                         testing::Values(Sizes{-1, 1}, Sizes{-40, 40}, Sizes{-490, 490},
                                         Sizes{-560, -480}, Sizes{-1060, -20}));

TEST(Upward, SizesAreBoundsAndTight) {
  for (std::uint64_t seed = 1; seed <= kSeeds; ++seed) {
    Draw draw(seed, {-500, 500});
    for (int k = 0; k < kDraws; ++k) {
      const Complex z = draw.complex();
      const double bound = size_bound(z);
      const Coefficient c = exact(z);
      EXPECT_GE(Rational(bound) * Rational(bound), c.re * c.re + c.im * c.im);
      EXPECT_LE(bound, 1.09 * std::hypot(z.real(), z.imag()) + 0x1p-1050);
    }
  }
  EXPECT_EQ(size_bound(0, 0), 0);
  EXPECT_EQ(size_bound(-0.0, 0), 0);
  EXPECT_GE(size_bound(0x1p-1074, 0x1p-1074), 0x1p-1073);
  EXPECT_TRUE(std::isnan(size_bound(NAN, 1)));
  EXPECT_TRUE(std::isnan(size_bound(NAN, 0)));
  EXPECT_TRUE(std::isnan(size_bound(1, NAN)));
}

}  // namespace
}  // namespace moivre::test
