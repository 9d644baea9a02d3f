// SPDX-License-Identifier: MIT
// Are solutions roots of the system as given, and is the accuracy that is stated true?
#include <gtest/gtest.h>

#include <Eigen/Core>
#include <boost/multiprecision/cpp_complex.hpp>
#include <cmath>

#include "moivre/factorization/qr.h"
#include "moivre/numeric/integer.h"
#include "problem_set.h"

namespace moivre {
namespace {

using test::problem;
using test::system_of;
using test::with_seed;

constexpr double kResidual = 1e-10;
constexpr double kResidualOfSimpleRoot = 1e-14;
constexpr double kUnit = 0x1p-52;

/// Fifty decimal digits: neither Moivre's double-double nor its tape has a part in them.
using Fine = boost::multiprecision::cpp_complex_50;
using FineReal = boost::multiprecision::cpp_bin_float_50;

FineReal to_fine(const Rational& r) { return FineReal(numerator(r)) / FineReal(denominator(r)); }
Fine to_fine(const Coefficient& c) { return Fine(to_fine(c.re), to_fine(c.im)); }

Fine power(const Fine& x, std::uint32_t exponent) {
  Fine result = 1;
  for (std::uint32_t k = 0; k < exponent; ++k) result *= x;
  return result;
}

std::vector<Fine> to_fine(const Point& x) {
  std::vector<Fine> fine;
  for (const Complex& xi : x) fine.emplace_back(xi.real(), xi.imag());
  return fine;
}

Complex to_double(const Fine& z) {
  return {z.real().convert_to<double>(), z.imag().convert_to<double>()};
}

/// F_i(x), term by term.
Fine value_of(const Polynomial& p, const std::vector<Fine>& x) {
  Fine value = 0;
  for (const Term& term : p.terms) {
    Fine product = to_fine(term.coefficient);
    for (const Power& q : term.monomial) product *= power(x[q.variable], q.exponent);
    value += product;
  }
  return value;
}

double size_of(const Polynomial& p, const Point& x) {
  double size = 0;
  for (const Term& term : p.terms) {
    double product = std::abs(to_complex(term.coefficient));
    for (const Power& q : term.monomial) product *= std::pow(std::abs(x[q.variable]), q.exponent);
    size += product;
  }
  return size;
}

Eigen::MatrixXcd jacobian_of(const System& f, const std::vector<Fine>& x) {
  const auto n = static_cast<Eigen::Index>(x.size());
  Eigen::MatrixXcd jacobian = Eigen::MatrixXcd::Zero(n, n);
  for (Eigen::Index i = 0; i < n; ++i) {
    for (const Term& term : f.polynomials[static_cast<std::size_t>(i)].terms) {
      for (const Power& p : term.monomial) {
        Fine slope = to_fine(term.coefficient) * Fine(p.exponent);
        slope *= power(x[p.variable], p.exponent - 1);
        for (const Power& q : term.monomial) {
          if (q.variable != p.variable) slope *= power(x[q.variable], q.exponent);
        }
        jacobian(i, p.variable) += to_double(slope);
      }
    }
  }
  return jacobian;
}

/// |x - x*|_inf / max(1, |x|_inf), x* by Newton steps from x with values of fifty digits.
double error_of(const System& f, const Point& start) {
  constexpr int kSteps = 3;
  std::vector<Fine> x = to_fine(start);
  for (int k = 0; k < kSteps; ++k) {
    Eigen::VectorXcd right(static_cast<Eigen::Index>(x.size()));
    for (std::size_t i = 0; i < x.size(); ++i) {
      right[static_cast<Eigen::Index>(i)] = -to_double(value_of(f.polynomials[i], x));
    }
    const Eigen::VectorXcd dx = PivotedQr<Complex>(jacobian_of(f, x)).solve(right);
    for (std::size_t i = 0; i < x.size(); ++i) {
      const Complex step = dx[static_cast<Eigen::Index>(i)];
      x[i] += Fine(step.real(), step.imag());
    }
  }
  double largest = 0;
  for (std::size_t i = 0; i < x.size(); ++i) {
    largest = std::max(largest, std::abs(to_double(x[i] - to_fine(start)[i])));
  }
  return largest / std::max(1.0, max_norm(start));
}

/// max_i |F_i(x)| / sum |terms of F_i|.
double residual_of(const System& f, const Point& x) {
  double largest = 0;
  for (const Polynomial& p : f.polynomials) {
    const double size = size_of(p, x);
    const double value = std::abs(to_double(value_of(p, to_fine(x))));
    if (size > 0) largest = std::max(largest, value / size);
  }
  return largest;
}

TEST(Accuracy, ThatIsStatedIsTrueBesideAnIndependentNewton) {
  for (const char* name : {"katsura-6", "cyclic-5", "noon-3", "reimer-4", "chandra-5", "eco-6",
                           "two-link-badrows", "puma", "dense-complex-4-3", "near-double"}) {
    SCOPED_TRACE(name);
    const System f = system_of(problem(name));
    const SolveResult result = test::solve_with_cvode(f);
    EXPECT_FALSE(result.solutions.empty());
    for (const Solution& s : result.solutions) {
      EXPECT_LE(error_of(f, s.x), s.accuracy);
      EXPECT_LT(s.accuracy, 1e-12);
    }
  }
}

TEST(Residual, IsOfTheSystemAsGiven) {
  for (const char* name : {"katsura-6", "badvars", "eco-6", "two-link-badrows", "multiplicity-5",
                           "tangent-circle", "one-root", "puma"}) {
    SCOPED_TRACE(name);
    const System f = system_of(problem(name));
    for (const Solution& s : test::solve_with_cvode(f).solutions) {
      const double residual = residual_of(f, s.x);
      EXPECT_LT(residual, s.singular ? kResidual : kResidualOfSimpleRoot);
      EXPECT_NEAR(s.residual, residual, kUnit * kUnit + 1e-6 * residual);
    }
  }
}

TEST(Accuracy, HoldsAtRootsThatAreKnownExactly) {
  for (const problems::Problem& p : test::problem_index()) {
    if (p.points.empty()) continue;
    SCOPED_TRACE(p.name);
    for (std::uint64_t seed = 1; seed <= 2; ++seed) {
      const SolveResult result = test::solve_with_cvode(system_of(p), with_seed(seed));
      if (!result.complete && test::is_beyond_reach(p)) continue;
      for (const problems::KnownPoint& point : p.points) {
        const auto nearest =
            std::min_element(result.solutions.begin(), result.solutions.end(),
                             [&](const Solution& a, const Solution& b) {
                               return test::distance(a.x, point.x) < test::distance(b.x, point.x);
                             });
        ASSERT_NE(nearest, result.solutions.end());
        EXPECT_EQ(nearest->multiplicity, point.multiplicity);
        EXPECT_LE(test::distance(nearest->x, point.x), nearest->accuracy + kUnit);
      }
    }
  }
}

}  // namespace
}  // namespace moivre
