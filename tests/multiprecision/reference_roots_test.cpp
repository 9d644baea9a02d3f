// SPDX-License-Identifier: MIT
// Are the digits right that Newton's method in multiprecision gives, and does it refuse those that
// nobody can give?
#include "moivre/multiprecision/reference_roots.h"

#include <gtest/gtest.h>

#include <boost/multiprecision/cpp_bin_float.hpp>
#include <cmath>

#include "moivre/numeric/integer.h"
#include "moivre/polynomial/read.h"

namespace moivre::test {
namespace {

/// Independent of MPFR: Boost's own binary numbers, with more digits than any test asks for.
using Wide = boost::multiprecision::number<boost::multiprecision::cpp_bin_float<1100>,
                                           boost::multiprecision::et_off>;

System system_of(const std::string& text) { return read_system(Source{"test.phc", text}); }

System file(const std::string& name) {
  return read_system(read_source(std::string(MOIVRE_SOURCE_DIR) + "/problems/polynomials/" + name));
}

/// The significant digits of a decimal, without sign, point and exponent.
std::string digits_of(const std::string& decimal) {
  std::string digits;
  for (const char c : decimal.substr(0, decimal.find('e'))) {
    if (c >= '0' && c <= '9' && !(digits.empty() && c == '0')) digits += c;
  }
  return digits;
}

TEST(ReferenceRoots, GiveAThousandDigitsOfTheSquareRootOfTwo) {
  const auto roots = reference_roots(system_of("1\nx^2 - 2;\n"), {{1.4}, {-1.4}}, 1000);
  ASSERT_EQ(roots.size(), 2U);
  const std::string expected = sqrt(Wide(2)).str(1000);
  EXPECT_EQ(roots[0].x[0], (ComplexDecimal{expected, "0"}));
  EXPECT_EQ(roots[1].x[0], (ComplexDecimal{"-" + expected, "0"}));
  EXPECT_EQ(digits_of(expected).size(), 1000U);
}

TEST(ReferenceRoots, ConvergeQuadratically) {
  const auto roots = reference_roots(system_of("1\nx^2 - 2;\n"), {{1.4}}, 1000);
  const std::vector<double>& size = roots[0].corrections_log10;
  // While no precision is exhausted the exponents double, up to what |F''/2F'| adds; from 70 digits
  // on each new precision does.
  ASSERT_GE(size.size(), 7U);
  for (std::size_t k = 1; k < 6; ++k) EXPECT_LT(size[k], 2 * size[k - 1]) << k;
  EXPECT_LT(size[5], -70);
  EXPECT_LE(size.size(), 12U);
}

TEST(ReferenceRoots, MeasureTheErrorOfTheApproximation) {
  const auto roots =
      reference_roots(system_of("1\nx^2 - 2;\n"), {{1.5}, {Complex(1.4142135623730951)}}, 50);
  EXPECT_NEAR(roots[0].forward_error, (1.5 - std::sqrt(2.0)) / std::sqrt(2.0), 1e-15);
  // sqrt(2) = 1.4142135623730950488...: its nearest double is 9.67e-17 off.
  EXPECT_NEAR(roots[1].forward_error, 9.667e-17 / std::sqrt(2.0), 1e-19);
  EXPECT_EQ(roots[1].nearest[0].re.hi, std::sqrt(2.0));
  EXPECT_NEAR(roots[1].nearest[0].re.lo, -9.667293313452913e-17, 1e-31);
}

TEST(ReferenceRoots, AreThoseOfTheExactCoefficients) {
  const System f = system_of("1\nx - 0.1;\n");
  const auto roots = reference_roots(f, {{0.1}}, 30);
  EXPECT_EQ(roots[0].x[0].re, "0.100000000000000000000000000000");
}

TEST(ReferenceRoots, OfWilkinsonsPolynomialsAreTheIntegers) {
  for (const auto& [name, n] :
       {std::pair<const char*, int>{"wilkinson-10.phc", 10}, {"wilkinson-20.phc", 20}}) {
    std::vector<Point> approximations;
    for (int k = 1; k <= n; ++k) approximations.push_back({k + 1e-9});
    const auto roots = reference_roots(file(name), approximations, 60);
    for (int k = 1; k <= n; ++k) {
      const ReferenceRoot& root = roots[static_cast<std::size_t>(k - 1)];
      ASSERT_TRUE(root.converged) << name << ' ' << k;
      EXPECT_EQ(root.x[0].re, std::to_string(k) + "." + std::string(k < 10 ? 59 : 58, '0'));
      EXPECT_EQ(root.x[0].im, "0");
    }
  }
}

TEST(ReferenceRoots, SatisfyTheirEquationsToTheDigitsAskedFor) {
  // The three roots of a cubic, in an order of their own.
  const System f = system_of("3\nx+y+z-3/2;\nx*y+y*z+z*x+1/3;\nx*y*z-1/7;\n");
  const Complex pair(-0.12, 0.26);
  const auto roots = reference_roots(f, {{1.74, pair, std::conj(pair)}}, 200);
  ASSERT_TRUE(roots[0].converged);
  const std::vector<ComplexDecimal>& x = roots[0].x;
  const Wide r(x[0].re), a(x[1].re), b(x[1].im);
  EXPECT_EQ(x[2].re, x[1].re);
  EXPECT_EQ(x[2].im, "-" + x[1].im);
  EXPECT_EQ(x[0].im, "0");
  const Wide tolerance("1e-199");
  EXPECT_LT(abs(Wide(r + 2 * a - Wide(3) / 2)), tolerance);
  EXPECT_LT(abs(Wide(2 * a * r + a * a + b * b + Wide(1) / 3)), tolerance);
  EXPECT_LT(abs(Wide(r * (a * a + b * b) - Wide(1) / 7)), tolerance);
}

/// F_i at decimal parts, term by term.
std::pair<Wide, Wide> value_of(const Polynomial& p, const std::vector<ComplexDecimal>& x) {
  Wide re = 0, im = 0;
  for (const Term& term : p.terms) {
    Wide a(Wide(numerator(term.coefficient.re)) / Wide(denominator(term.coefficient.re))), b = 0;
    for (const Power& power : term.monomial) {
      const Wide u(x[power.variable].re), v(x[power.variable].im);
      for (std::uint32_t k = 0; k < power.exponent; ++k) {
        const Wide next = a * u - b * v;
        b = a * v + b * u;
        a = next;
      }
    }
    re += a;
    im += b;
  }
  return {re, im};
}

TEST(ReferenceRoots, OfKatsuraSatisfyTheirEquationsToAHundredDigits) {
  const System f = file("katsura-5.phc");
  // Newton's method from anywhere: what it reaches is a root, or is not told.
  std::vector<Point> anywhere;
  for (int k = 0; k < 40; ++k) {
    Point x;
    for (int i = 0; i < 6; ++i) x.push_back(0.5 * std::polar(1.0, 1.7 * k + 2.3 * i * (k % 7 + 1)));
    anywhere.push_back(x);
  }
  std::size_t reached = 0;
  for (const ReferenceRoot& root : reference_roots(f, anywhere, 100)) {
    if (!root.converged) continue;
    ++reached;
    for (const Polynomial& p : f.polynomials) {
      const auto [re, im] = value_of(p, root.x);
      EXPECT_LT(abs(re) + abs(im), Wide("1e-98"));
    }
  }
  EXPECT_GT(reached, 10U);
}

TEST(ReferenceRoots, GiveEveryPartOfASmallCoordinate) {
  const auto roots =
      reference_roots(system_of("2\nx - 12345678;\nx*y - 1e-40;\n"), {{12345678, 1e-47}}, 20);
  ASSERT_TRUE(roots[0].converged);
  EXPECT_EQ(digits_of(roots[0].x[1].re), "81000006642000544644");
}

TEST(ReferenceRoots, PrintZeroWhereAPartVanishes) {
  const auto roots =
      reference_roots(system_of("2\nx^2 + 5;\nx*y;\n"), {{Complex(1e-17, 2.236), 1e-18}}, 40);
  ASSERT_TRUE(roots[0].converged);
  EXPECT_EQ(roots[0].x[0].re, "0");
  EXPECT_EQ(roots[0].x[0].im, "2.236067977499789696409173668731276235441");
  EXPECT_EQ(roots[0].x[1], (ComplexDecimal{"0", "0"}));
}

TEST(ReferenceRoots, TellRootsApartThatAgreeIn14Digits) {
  // (x - 1)(x - 1 - 10^-14), expanded with exact coefficients.
  const System f = system_of("1\nx^2 - 2.00000000000001*x + 1.00000000000001;\n");
  const auto roots = reference_roots(f, {{1 - 1e-15}, {1 + 1.1e-14}}, 50);
  for (const ReferenceRoot& root : roots) ASSERT_TRUE(root.converged);
  EXPECT_EQ(roots[0].x[0].re, "1." + std::string(49, '0'));
  EXPECT_EQ(roots[1].x[0].re, "1." + std::string(13, '0') + "1" + std::string(35, '0'));
}

// In 90 and in 180 digits rounding errors hide them.
TEST(ReferenceRoots, OfThirtyWithinAMillionthAreGiven) {
  const auto roots = reference_roots(system_of("1\n(x - 1)^30 - 1e-180;\n"), {{1.000001}}, 20);
  ASSERT_TRUE(roots[0].converged);
  EXPECT_EQ(roots[0].x[0].re, "1.0000010000000000000");
}

TEST(ReferenceRoots, RefuseDigitsOfASingularRoot) {
  const System f = system_of("2\nx^2 - 2*x + 1;\ny - x;\n");
  for (const Point& x : {Point{1, 1}, Point{1 + 1e-8, 1 - 1e-9}}) {
    const auto roots = reference_roots(f, {x}, 20);
    EXPECT_FALSE(roots[0].converged);
    EXPECT_TRUE(roots[0].x.empty());
    EXPECT_TRUE(std::isnan(roots[0].forward_error));
  }
}

TEST(ReferenceRoots, OfDegreesBeyondAnIntAreNotProved) {
  const System f = make_system({"x"}, {pow(unknown(0), 2) - 1});
  System steep = f;
  steep.polynomials[0].terms[0].monomial = {{0, 4'294'967'295U}};
  EXPECT_TRUE(reference_roots(f, {{1.0}}, 20)[0].converged);
  EXPECT_FALSE(reference_roots(steep, {{1.0}}, 20)[0].converged);
}

TEST(ReferenceRoots, DoNotDependOnTheNumberOfThreads) {
  const System f = file("katsura-5.phc");
  std::vector<Point> approximations(7, Point(f.variables.size(), Complex(0.1, 0.2)));
  for (std::size_t k = 0; k < approximations.size(); ++k)
    approximations[k][0] = static_cast<double>(k) / 7;
  const auto one = reference_roots(f, approximations, 50, 1);
  const auto three = reference_roots(f, approximations, 50, 3);
  for (std::size_t k = 0; k < one.size(); ++k) {
    EXPECT_EQ(one[k].x, three[k].x);
    EXPECT_EQ(one[k].corrections_log10, three[k].corrections_log10);
  }
}

TEST(ReferenceRoots, RefuseWhatTheyCannotServe) {
  const System f = system_of("1\nx^2 - 2;\n");
  EXPECT_THROW(reference_roots(f, {{1.4}}, 0), std::invalid_argument);
  EXPECT_THROW(reference_roots(f, {{1.4}}, 1001), std::invalid_argument);
  EXPECT_THROW(reference_roots(f, {{1.4, 2}}, 10), std::invalid_argument);
  EXPECT_THROW(reference_roots(system_of("1 2\nx*y - 1;\n"), {{1, 1}}, 10), std::invalid_argument);
}

}  // namespace
}  // namespace moivre::test
