// SPDX-License-Identifier: MIT
// Does the tape give the values and derivatives of the polynomials as written, in every scalar?
#include "moivre/polynomial/tape.h"

#include <gtest/gtest.h>

#include <array>
#include <limits>

#include "build.h"
#include "moivre/numeric/integer.h"
#include "moivre/numeric/scalar.h"

namespace moivre {
namespace {

constexpr double kEpsilon = std::numeric_limits<double>::epsilon();
// Random polynomials here have at most a few hundred operations on their largest term.
constexpr double kOperations = 100;

Complex nearest(const Coefficient& c) { return to_complex(c); }

/// A random system of n equations with exponents up to 4, complex or real.
System random_system(std::uint32_t n, bool real, std::mt19937_64& random) {
  std::uniform_int_distribution<std::uint32_t> exponent(0, 4);
  std::vector<Polynomial> equations;
  for (std::uint32_t i = 0; i < n; ++i) {
    TermMap terms;
    for (int k = 0; k < 6; ++k) {
      Monomial m;
      for (std::uint32_t j = 0; j < n; ++j) {
        if (const std::uint32_t e = exponent(random); e > 0) m.push_back({j, e});
      }
      Coefficient c = build::random_number(random);
      if (real) c.im = 0;
      terms[m] = c;
    }
    equations.push_back(to_polynomial(terms));
  }
  return build::system(n, equations);
}

/// dp/dx_j, by the rule for powers.
Polynomial derivative(const Polynomial& p, std::uint32_t j) {
  TermMap terms;
  for (const Term& term : p.terms) {
    for (std::size_t k = 0; k < term.monomial.size(); ++k) {
      if (term.monomial[k].variable != j) continue;
      const Rational e = term.monomial[k].exponent;
      Monomial m = term.monomial;
      if (--m[k].exponent == 0) m.erase(m.begin() + static_cast<std::ptrdiff_t>(k));
      terms[m] = Coefficient{e, 0} * term.coefficient;
    }
  }
  return to_polynomial(terms);
}

/// Sum of |terms|: what rounding errors are measured by.
double size(const Polynomial& p, const build::Point& x) {
  double sum = 0;
  for (const Term& term : p.terms) sum += std::abs(nearest(build::value({{term}}, x)));
  return sum;
}

template <class S>
struct Evaluated {
  std::vector<S> value;
  std::vector<S> jacobian;  ///< dense, row-major
};

template <class S, class C>
Evaluated<S> run(const Tape& tape, const std::vector<C>& c, const std::vector<S>& x) {
  std::vector<S> registers(tape.register_count());
  std::vector<S> entries(tape.jacobian.size());
  Evaluated<S> result{std::vector<S>(tape.equations),
                      std::vector<S>(tape.equations * tape.variables, S(0.0))};
  evaluate<S, C>(tape, std::span<const C>(c), std::span<const S>(x), std::span<S>(registers),
                 std::span<S>(result.value), std::span<S>(entries));
  for (std::size_t k = 0; k < entries.size(); ++k) {
    result.jacobian[tape.jacobian[k].row * tape.variables + tape.jacobian[k].column] = entries[k];
  }
  return result;
}

std::vector<Complex> rounded(const build::Point& x) {
  std::vector<Complex> result;
  for (const Coefficient& xi : x) result.push_back(nearest(xi));
  return result;
}

struct Case {
  System f;
  build::Point x;
};

std::vector<Case> cases(bool real) {
  std::vector<Case> result;
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    std::mt19937_64 random(seed);
    for (std::uint32_t n = 1; n <= 4; ++n) {
      result.push_back({random_system(n, real, random), {}});
      // Points whose parts are exact in double, so that rounding x is no error of the tape's.
      for (std::uint32_t j = 0; j < n; ++j) {
        const Coefficient q = build::random_integer(random, false);
        result.back().x.push_back({q.re / 8, q.im / 8});
      }
    }
  }
  return result;
}

void expect_exact_to_rounding(const Case& c, const Evaluated<Complex>& evaluated) {
  const std::size_t n = c.f.variables.size();
  for (std::size_t i = 0; i < n; ++i) {
    const Polynomial& p = c.f.polynomials[i];
    EXPECT_LE(std::abs(evaluated.value[i] - nearest(build::value(p, c.x))),
              kOperations * kEpsilon * size(p, c.x));
    for (std::uint32_t j = 0; j < n; ++j) {
      const Polynomial d = derivative(p, j);
      EXPECT_LE(std::abs(evaluated.jacobian[i * n + j] - nearest(build::value(d, c.x))),
                kOperations * kEpsilon * size(d, c.x));
    }
  }
}

TEST(Tape, GivesTheExactValuesAndDerivativesOfComplexSystemsToRounding) {
  for (const Case& c : cases(false)) {
    const Tape tape = make_tape(c.f);
    expect_exact_to_rounding(c, run(tape, complex_coefficients(tape, c.f), rounded(c.x)));
  }
}

TEST(Tape, GivesHighPowersAndTheirDerivatives) {
  for (std::uint32_t e = 1; e <= 70; ++e) {
    SCOPED_TRACE(e);
    const Polynomial p{{{Coefficient{3, 1}, {{0, e}, {1, 2}}}, {Coefficient{1, 0}, {{1, e}}}}};
    Case c{build::system(2, {p, p}), {}};
    c.x = {{Rational(3, 4), Rational(1, 2)}, {Rational(-7, 8), Rational(1, 4)}};
    const Tape tape = make_tape(c.f);
    expect_exact_to_rounding(c, run(tape, complex_coefficients(tape, c.f), rounded(c.x)));
  }
}

TEST(Tape, TakesRealCoefficientsOfRealSystems) {
  for (const Case& c : cases(true)) {
    const Tape tape = make_tape(c.f);
    expect_exact_to_rounding(c, run(tape, real_coefficients(tape, c.f), rounded(c.x)));
  }
}

TEST(Tape, RefusesRealCoefficientsOfAComplexSystem) {
  const System f = build::system(1, {build::variable(0) - build::constant(0, 1)});
  EXPECT_THROW(real_coefficients(make_tape(f), f), std::invalid_argument);
}

TEST(Tape, JacobianIsTheLimitOfDifferenceQuotients) {
  // Central differences: error h^2 / 6 times a third derivative, which is at most 12 * 4 * |terms|
  // / min(|x|, 1)^3.
  const double h = 1e-4;
  std::mt19937_64 random(1);
  for (std::uint32_t n = 1; n <= 4; ++n) {
    const System f = random_system(n, false, random);
    const Tape tape = make_tape(f);
    const std::vector<Complex> c = complex_coefficients(tape, f);
    const std::vector<Complex> x(n, Complex(0.6, 0.8));
    const Evaluated<Complex> at = run(tape, c, x);
    for (std::size_t j = 0; j < n; ++j) {
      std::vector<Complex> above = x;
      std::vector<Complex> below = x;
      above[j] += h;
      below[j] -= h;
      const Evaluated<Complex> up = run(tape, c, above);
      const Evaluated<Complex> down = run(tape, c, below);
      for (std::size_t i = 0; i < n; ++i) {
        double terms = 0;
        for (const Term& term : f.polynomials[i].terms)
          terms += std::abs(nearest(term.coefficient));
        const Complex quotient = (up.value[i] - down.value[i]) / (2 * h);
        EXPECT_LE(std::abs(quotient - at.jacobian[i * n + j]), 8 * h * h * terms);
      }
    }
  }
}

TEST(Tape, ValuesAloneAreTheValuesBesideTheJacobian) {
  for (const Case& c : cases(false)) {
    const Tape tape = make_tape(c.f);
    const std::vector<Complex> coefficients = complex_coefficients(tape, c.f);
    const std::vector<Complex> x = rounded(c.x);
    std::vector<Complex> registers(tape.register_count());
    std::vector<Complex> values(tape.equations);
    evaluate<Complex, Complex>(tape, coefficients, x, registers, values);
    EXPECT_EQ(values, run(tape, coefficients, x).value);
  }
}

TEST(Tape, GivesTwiceTheDigitsInDoubleDouble) {
  // 2^-100: a few bits less than one operation keeps.
  const Rational bound = ratio(1, Integer(1) << 94U);
  const auto exact = [](DoubleDouble a) { return Rational(a.hi) + Rational(a.lo); };
  for (const Case& c : cases(false)) {
    const Tape tape = make_tape(c.f);
    const auto coefficients =
        round_coefficients<ComplexDoubleDouble>(tape, c.f, Scalar<ComplexDoubleDouble>::round);
    std::vector<ComplexDoubleDouble> x;
    for (const Coefficient& xi : c.x) x.push_back(to_complex_double_double(xi));
    const Evaluated<ComplexDoubleDouble> evaluated = run(tape, coefficients, x);
    const std::size_t n = c.f.variables.size();
    const auto expect_near = [&](const ComplexDoubleDouble& computed, const Polynomial& p) {
      const Coefficient wanted = build::value(p, c.x);
      const Rational error = bound * Rational(size(p, c.x));
      EXPECT_LE(abs(exact(computed.re) - wanted.re), error);
      EXPECT_LE(abs(exact(computed.im) - wanted.im), error);
    };
    for (std::size_t i = 0; i < n; ++i) {
      expect_near(evaluated.value[i], c.f.polynomials[i]);
      for (std::uint32_t j = 0; j < n; ++j) {
        expect_near(evaluated.jacobian[i * n + j], derivative(c.f.polynomials[i], j));
      }
    }
  }
}

/// Power series in s, cut off behind s^3.
struct Series {
  std::array<Complex, 4> terms{};

  Series() = default;
  explicit Series(double constant) { terms[0] = constant; }

  Series& operator+=(const Series& other) {
    for (std::size_t k = 0; k < terms.size(); ++k) terms[k] += other.terms[k];
    return *this;
  }
};

Series product(const Series& a, const Series& b) {
  Series c;
  for (std::size_t i = 0; i < c.terms.size(); ++i) {
    for (std::size_t j = 0; i + j < c.terms.size(); ++j) c.terms[i + j] += a.terms[i] * b.terms[j];
  }
  return c;
}

Series product(const Complex& a, const Series& b) {
  Series c;
  for (std::size_t k = 0; k < c.terms.size(); ++k) c.terms[k] = a * b.terms[k];
  return c;
}

TEST(Tape, GivesTaylorTermsInPowerSeries) {
  // F(x + s v), as a polynomial in s, has the Taylor terms of s -> F(x + s v): here F is written
  // out in s exactly.
  for (const Case& c : cases(false)) {
    const std::size_t n = c.f.variables.size();
    const Tape tape = make_tape(c.f);
    std::vector<Series> line(n);
    std::vector<Polynomial> exact_line;
    for (std::size_t j = 0; j < n; ++j) {
      const Coefficient v{1, Rational(static_cast<int>(j) + 1, 4)};
      line[j].terms[0] = nearest(c.x[j]);
      line[j].terms[1] = nearest(v);
      exact_line.push_back(c.x[j] * build::constant(1) + v * build::variable(0));
    }
    const Evaluated<Series> evaluated = run(tape, complex_coefficients(tape, c.f), line);
    for (std::size_t i = 0; i < n; ++i) {
      Polynomial in_s;
      double scale = 0;
      for (const Term& term : c.f.polynomials[i].terms) {
        Polynomial p = term.coefficient * build::constant(1);
        double largest = std::abs(nearest(term.coefficient));
        for (const Power& factor : term.monomial) {
          const auto e = static_cast<int>(factor.exponent);
          p = p * build::power(exact_line[factor.variable], e);
          largest *= std::pow(std::abs(nearest(c.x[factor.variable])) + 2, e);
        }
        in_s = in_s + p;
        scale += largest;
      }
      for (std::uint32_t k = 0; k < 4; ++k) {
        Complex wanted = 0;
        for (const Term& term : in_s.terms) {
          if (degree(term.monomial) == k) wanted = nearest(term.coefficient);
        }
        EXPECT_LE(std::abs(evaluated.value[i].terms[k] - wanted), kOperations * kEpsilon * scale);
      }
    }
  }
}

TEST(Tape, SharesProductsBetweenEquationsAndWithTheJacobian) {
  for (const System& f : {build::katsura(6), build::cyclic(6), build::noon(5)}) {
    std::size_t naive = 0;
    for (const Polynomial& p : f.polynomials) {
      for (const Term& term : p.terms) {
        const std::uint64_t d = degree(term.monomial);
        // d - 1 products for the monomial, d - 2 for each derivative.
        if (d > 1) naive += d - 1 + term.monomial.size() * (d - 2);
      }
    }
    EXPECT_LT(make_tape(f).products.size(), naive);
  }
}

TEST(Tape, MultipliesAMonomialOutOnce) {
  const Polynomial xy = build::variable(0) * build::variable(1);
  const System f = build::system(2, {xy - build::constant(1), xy + build::variable(0)});
  EXPECT_EQ(make_tape(f).products.size(), 1u);
}

TEST(Tape, RaisesToAPowerByHalving) {
  const System f = build::system(1, {build::power(build::variable(0), 64) - build::constant(2)});
  EXPECT_EQ(make_tape(f).value_products, 6u);
}

TEST(Tape, OfZeroAndConstantPolynomialsHasNoDerivatives) {
  const System f = build::system(2, {Polynomial{}, build::constant(3)});
  const Tape tape = make_tape(f);
  EXPECT_TRUE(tape.jacobian.empty());
  const Evaluated<Complex> evaluated =
      run(tape, complex_coefficients(tape, f), std::vector<Complex>{5.0, 7.0});
  EXPECT_EQ(evaluated.value, (std::vector<Complex>{0.0, 3.0}));
}

}  // namespace
}  // namespace moivre
