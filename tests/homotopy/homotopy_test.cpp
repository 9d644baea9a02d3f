// SPDX-License-Identifier: MIT
// Is H = t F + (1 - t) G at complex t, with derivatives that are limits of differences, in both
// scalars?
#include <gtest/gtest.h>

#include <stdexcept>

#include "moivre/homotopy/evaluator.h"
#include "moivre/numeric/double_double.h"
#include "moivre/polynomial/read.h"

namespace moivre {
namespace {

// Coefficients and coordinates are near 1, terms fewer than ten.
constexpr double kRounding = 1e-14;
const Complex kTime(0.3, 0.4);
const Point kPoint{{0.5, -0.2}, {-0.7, 0.1}, {0.9, 0.3}};

System system(const std::string& text) { return read_system({"test", text}); }
Homotopy scene() {
  return Homotopy(system("2\nx^2*y - 3*x + i; y^2 + x*y - 2;\n"), system("2\nx^3 - 1; y^2 - i;\n"));
}

template <class S>
struct Linearization {
  Linearization(const Homotopy& homotopy, const std::vector<S>& x, const Time<S>& t)
      : h(2), hx(6), ht(2) {
    HomotopyEvaluator<S>(homotopy).linearization(x, t, h, hx, ht);
  }
  std::vector<S> h, hx, ht;
};

Point value(const Homotopy& homotopy, const Point& x, const PathTime& t) {
  Point h(2);
  HomotopyEvaluator<Complex>(homotopy).value(x, t, h);
  return h;
}

TEST(Homotopy, IsTheTargetAtOneTheStartAtZeroAndTheirBlendBetween) {
  const Homotopy homotopy = scene();
  const auto [x, y, z] = std::array<Complex, 3>{kPoint[0], kPoint[1], kPoint[2]};
  const Complex i(0, 1);
  const Point f{x * x * y - 3.0 * x * z * z + i * z * z * z, y * y + x * y - 2.0 * z * z};
  const Point g{x * x * x - z * z * z, y * y - i * z * z};
  for (std::size_t k = 0; k < 2; ++k) {
    EXPECT_LT(std::abs(value(homotopy, kPoint, Complex(1))[k] - f[k]), kRounding);
    EXPECT_LT(std::abs(value(homotopy, kPoint, Complex(0))[k] - g[k]), kRounding);
    EXPECT_LT(std::abs(value(homotopy, kPoint, kTime)[k] - (kTime * f[k] + (1.0 - kTime) * g[k])),
              kRounding);
  }
}

TEST(Homotopy, BringsBothSidesToOneDegreeAnEquation) {
  const Homotopy homotopy(system("2\nx + y; y^2 - x;\n"), system("2\nx^3 - 1; y - 1;\n"));
  EXPECT_EQ(degrees(homotopy.support()), (std::vector<std::uint64_t>{3, 2}));
  for (const Polynomial& p : homotopy.support().polynomials) EXPECT_TRUE(is_homogeneous(p));
  EXPECT_EQ(homotopy.coordinates(), 3u);
  EXPECT_THROW(Homotopy(system("1\nx;\n"), system("2\nx; y;\n")), std::invalid_argument);
}

TEST(Homotopy, OfAToricLawDecaysTermByTermAndIsTheStartAtOne) {
  const System g = system("2\nx*y - 3*x + i; y^2 + x*y - 2;\n");
  const Homotopy homotopy = Homotopy::toric(g);
  PathFrame frame{{0, 0, 0}, std::vector<double>(6, 1.0), {0, 0, 1.5, 0, 2, 0}};
  HomotopyEvaluator<Complex> evaluator(homotopy);
  evaluator.set_frame(&frame);
  const auto [x, y, z] = std::array<Complex, 3>{kPoint[0], kPoint[1], kPoint[2]};
  const Complex i(0, 1);
  for (const Complex t : {Complex(0), Complex(0.7), kTime, Complex(1)}) {
    Point h(2);
    evaluator.value(kPoint, t, h);
    const Complex first = x * y - 3.0 * x * z + std::exp(-1.5 * (1.0 - t)) * i * z * z;
    EXPECT_LT(std::abs(h[0] - first), kRounding) << t;
    // Terms in canonical order: x y, y^2, 1.
    const Complex second = x * y + std::exp(-2.0 * (1.0 - t)) * y * y - 2.0 * z * z;
    EXPECT_LT(std::abs(h[1] - second), kRounding) << t;
  }
}

TEST(Homotopy, OfParametersIsTheFamilysMemberAtEveryTime) {
  // x^2 + a b x - b^2 with (a, b) from (1, 2) to (i, 3).
  const System family = read_system({"test", "1 3\nx^2 + a*b*x - b^2;\n"});
  const Homotopy homotopy = Homotopy::parameters(family, {1.0, 2.0}, {Complex(0, 1), 3.0});
  HomotopyEvaluator<Complex> evaluator(homotopy);
  const Point point{kPoint[0], kPoint[2]};
  const auto value_at = [&](Complex t) {
    Point h(1);
    evaluator.value(point, t, h);
    return h[0];
  };
  for (const Complex t : {Complex(0), kTime, Complex(1)}) {
    const Complex a = (1.0 - t) + t * Complex(0, 1);
    const Complex b = 2.0 * (1.0 - t) + 3.0 * t;
    const Complex expected =
        point[0] * point[0] + a * b * point[0] * point[1] - b * b * point[1] * point[1];
    EXPECT_LT(std::abs(value_at(t) - expected), kRounding);
    Point h(1), hx(2), ht(1);
    evaluator.linearization(point, t, h, hx, ht);
    const double step = 1e-5;
    const Complex quotient = (value_at(t + step) - value_at(t - step)) / (2 * step);
    EXPECT_LT(std::abs(quotient - ht[0]), 4 * step * step + kRounding / step);
  }
}

TEST(Homotopy, InAFrameHasTheSameZeros) {
  const System f = system("2\nx*y - 3*x + i; y^2 + x*y - 2;\n");
  const Homotopy plain(f, f);
  const Homotopy framed = Homotopy::framed(f, f);
  const auto frame = std::make_shared<const PathFrame>(frame_at(framed, {1e8, 1e-5, 1.0}));
  EXPECT_EQ(frame->log2, (std::vector<int>{27, -17, 0}));
  HomotopyEvaluator<Complex> evaluator(framed);
  evaluator.set_frame(frame.get());
  const Point x{3e7, 2e-5, 0.5};
  Point in_frame(2);
  evaluator.value(inside(frame, x), Complex(0.25), in_frame);
  const Point outside_frame = value(plain, x, Complex(0.25));
  for (std::size_t i = 0; i < 2; ++i) {
    const Complex ratio = in_frame[i] / outside_frame[i];
    EXPECT_LT(std::abs(ratio.imag()), kRounding);
    EXPECT_NEAR(std::log2(ratio.real()), std::round(std::log2(ratio.real())), kRounding);
  }
  EXPECT_EQ(outside(frame, inside(frame, x)), x);
}

TEST(Homotopy, DerivativesAreLimitsOfDifferences) {
  const Homotopy homotopy = scene();
  const Linearization<Complex> at(homotopy, kPoint, kTime);
  const double h = 1e-5;
  // h^2 / 6 times third derivatives of at most 20, and rounding over h.
  const double bound = 4 * h * h + kRounding / h;
  EXPECT_EQ(at.h, value(homotopy, kPoint, kTime));
  for (std::size_t i = 0; i < 2; ++i) {
    for (std::size_t j = 0; j < 3; ++j) {
      Point above = kPoint;
      Point below = kPoint;
      above[j] += h;
      below[j] -= h;
      const Complex quotient =
          (value(homotopy, above, kTime)[i] - value(homotopy, below, kTime)[i]) / (2 * h);
      EXPECT_LT(std::abs(quotient - at.hx[3 * i + j]), bound);
    }
    const Complex quotient =
        (value(homotopy, kPoint, kTime + h)[i] - value(homotopy, kPoint, kTime - h)[i]) / (2 * h);
    EXPECT_LT(std::abs(quotient - at.ht[i]), bound);
  }
}

TEST(Homotopy, InDoubleDoubleRoundsToTheSameAtComplexTime) {
  const Homotopy homotopy = scene();
  const std::vector<ComplexDoubleDouble> x(kPoint.begin(), kPoint.end());
  const Linearization<ComplexDoubleDouble> fine(homotopy, x, ComplexDoubleDouble(kTime));
  const Linearization<Complex> coarse(homotopy, kPoint, kTime);
  for (std::size_t k = 0; k < 6; ++k) {
    EXPECT_LT(std::abs(to_complex(fine.hx[k]) - coarse.hx[k]), kRounding);
    EXPECT_LT(std::abs(to_complex(fine.h[k % 2]) - coarse.h[k % 2]), kRounding);
    EXPECT_LT(std::abs(to_complex(fine.ht[k % 2]) - coarse.ht[k % 2]), kRounding);
  }
}

TEST(PathTime, KeepsTheDigitsOfOneMinusTWhereTRoundsToOne) {
  // F vanishes at x = y, so H there is (1 - t) G.
  const Homotopy homotopy(system("2\nx - y; y - x;\n"), system("2\nx^2 + 1; y^2 + 1;\n"));
  const Complex rest = 1e-20;
  const Point h = value(homotopy, {1.0, 1.0, 1.0}, {1.0 - rest, rest});
  EXPECT_EQ(h[0], 2e-20);
  EXPECT_EQ(PathTime(0.25).rest, 0.75);
}

}  // namespace
}  // namespace moivre
