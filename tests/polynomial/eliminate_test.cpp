// SPDX-License-Identifier: MIT
// Does elimination keep what its header promises?
// The numbered properties at random exact points, and each verdict on a tiny problem.
#include "moivre/polynomial/eliminate.h"

#include <gtest/gtest.h>
#include <sys/time.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <csignal>
#include <ctime>
#include <limits>
#include <numeric>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include "build.h"
#include "moivre/numeric/integer.h"
#include "moivre/polynomial/read.h"
#include "moivre/polynomial/scale.h"

namespace moivre {
namespace {

using namespace build;
using Point = build::Point;
using Verdict = Reduction::Verdict;

const Polynomial x = variable(0);
const Polynomial y = variable(1);
const Polynomial z = variable(2);
const Polynomial one = build::constant(1);

Point restored(const Reduction& r, const Point& at) {
  return restore(r, at, [](const Coefficient& c) { return c; });
}

/// Property (2): at more random points than there are equations, the values of F on restore(y) and
/// those of R span the same space of rows.
void expect_same_span(const System& f, const Reduction& r, std::uint64_t seed) {
  std::mt19937_64 random(seed);
  std::vector<Point> given(f.polynomials.size());
  std::vector<Point> left(r.system.polynomials.size());
  for (std::size_t sample = 0; sample < f.polynomials.size() + 2; ++sample) {
    const Point at = random_point(r.kept.size(), random);
    const Point full = restored(r, at);
    ASSERT_EQ(full.size(), f.variables.size());
    for (std::size_t i = 0; i < r.kept.size(); ++i) ASSERT_EQ(full[r.kept[i]], at[i]);
    for (std::size_t i = 0; i < given.size(); ++i) {
      given[i].push_back(value(f.polynomials[i], full));
    }
    for (std::size_t i = 0; i < left.size(); ++i) {
      left[i].push_back(value(r.system.polynomials[i], at));
    }
  }
  std::vector<Point> both = given;
  both.insert(both.end(), left.begin(), left.end());
  EXPECT_EQ(rank(left), left.size()) << "seed " << seed;
  EXPECT_EQ(rank(given), left.size()) << "seed " << seed;
  EXPECT_EQ(rank(both), left.size()) << "seed " << seed;
}

std::vector<std::uint64_t> sorted_degrees(const System& f) {
  std::vector<std::uint64_t> result = degrees(f);
  std::sort(result.begin(), result.end());
  return result;
}

/// What was left out and why, an entry each.
using Told = std::vector<std::string>;

Told told(const Reduction& r) {
  Told all;
  for (const Omission& omission : r.left_out) all.push_back(omission.what + ": " + omission.why);
  return all;
}

/// Random linear combinations of the equations: an invertible matrix with probability one, checked.
System mixed(const System& f, std::mt19937_64& random) {
  const std::size_t m = f.polynomials.size();
  std::uniform_int_distribution<int> entry(-3, 3);
  std::vector<Point> matrix(m, Point(m));
  do {
    for (Point& row : matrix) {
      for (Coefficient& c : row) c = {entry(random), 0};
    }
  } while (rank(matrix) < m);
  System g = f;
  for (std::size_t i = 0; i < m; ++i) {
    g.polynomials[i] = {};
    for (std::size_t k = 0; k < m; ++k) {
      g.polynomials[i] = g.polynomials[i] + matrix[i][k] * f.polynomials[k];
    }
  }
  return g;
}

TEST(Elimination, TwoCirclesNeedTwoPaths) {
  const System f = system(2, {x * x + y * y - one, power(x - one, 2) + y * y - one});
  const Reduction r = eliminate(f);
  EXPECT_EQ(r.verdict, Verdict::square);
  EXPECT_EQ(degrees(r.system), (std::vector<std::uint64_t>{2}));
  EXPECT_EQ(r.system.variables, (std::vector<std::string>{"x2"}));
  EXPECT_EQ(told(r), (Told{"1 quadratic equation combined to 1 linear one: their highest terms "
                           "cancel: total degree 4 -> 2",
                           "x1 eliminated: a linear equation gives it"}));
  const Point at = restored(r, {Coefficient{5, 0}});
  EXPECT_EQ(at[0], (Coefficient{Rational(1, 2), 0}));
  expect_same_span(f, r, 1);
}

TEST(Elimination, ParallelLinesContradictEachOther) {
  const Reduction r = eliminate(system(2, {x + y - one, x + y - build::constant(2)}));
  EXPECT_EQ(r.verdict, Verdict::inconsistent);
  EXPECT_EQ(told(r), (Told{"1 linear equation combined to 1 constant one: their highest terms "
                           "cancel: total degree 1 -> 1",
                           "all paths: equation 2 contradicts the others: no root"}));
}

TEST(Elimination, ConcentricCirclesContradictEachOther) {
  EXPECT_EQ(eliminate(system(2, {x * x + y * y - one, x * x + y * y - build::constant(2)})).verdict,
            Verdict::inconsistent);
}

TEST(Elimination, AContradictionBehindASubstitutionIsFound) {
  const System f = system(2, {x - y, x * x - y * y - one});
  EXPECT_EQ(eliminate(f).verdict, Verdict::inconsistent);
}

TEST(Elimination, ADuplicatedEquationIsDependent) {
  const Polynomial circle = x * x + y * y - one;
  const Reduction r = eliminate(system(2, {circle, Rational(-7, 3) * circle}));
  EXPECT_EQ(r.verdict, Verdict::dependent);
  EXPECT_EQ(r.dependent_equations, 1U);
  EXPECT_EQ(told(r), (Told{"1 quadratic equation combined to 1 constant one: their highest terms "
                           "cancel: total degree 4 -> 2",
                           "equation 2: it follows from the others (0 = 0): it is redundant"}));
}

TEST(Elimination, ADependenceBehindASubstitutionIsFound) {
  const Reduction r = eliminate(system(2, {x - y, x * x - y * y}));
  EXPECT_EQ(r.verdict, Verdict::dependent);
  EXPECT_EQ(r.dependent_equations, 1U);
}

TEST(Elimination, AnUnknownThatNoEquationHoldsIsNamed) {
  const Reduction r = eliminate(system(2, {x * x - one, x * x * x - one}));
  EXPECT_EQ(r.verdict, Verdict::dependent);
  EXPECT_EQ(r.dependent_equations, 0U);
  EXPECT_EQ(told(r), (Told{"x2: no remaining equation contains it"}));
}

TEST(Elimination, FewerEquationsThanUnknownsAreUnderdetermined) {
  EXPECT_EQ(eliminate(system(2, {x * x + y * y - one})).verdict, Verdict::underdetermined);
}

TEST(Elimination, MoreEquationsThanUnknownsAreOverdetermined) {
  EXPECT_EQ(eliminate(system(1, {x * x - one, x * x * x - one})).verdict, Verdict::overdetermined);
}

TEST(Elimination, ARepeatedEquationTooManyLeavesASquareSystem) {
  const Polynomial a = x * x + y * y - one;
  const Polynomial b = x * x - Rational(2) * y * y;
  const Reduction r = eliminate(system(2, {a, b, a + b}));
  EXPECT_EQ(r.verdict, Verdict::square);
  EXPECT_EQ(r.dependent_equations, 1U);
}

TEST(Elimination, ALinearSystemIsSolvedOutright) {
  const System f =
      system(3, {x + Rational(2) * y - z - one, x - y, x + y + z - build::constant(6)});
  const Reduction r = eliminate(f);
  EXPECT_EQ(r.verdict, Verdict::solved);
  EXPECT_TRUE(r.system.polynomials.empty());
  const Point root = restored(r, {});
  for (const Coefficient& v : value(f, root)) EXPECT_TRUE(is_zero(v));
}

TEST(Elimination, EmptyZeroAndConstantSystemsHaveAVerdict) {
  EXPECT_EQ(eliminate(System{}).verdict, Verdict::solved);
  EXPECT_EQ(eliminate(system(1, {Polynomial{}})).verdict, Verdict::dependent);
  EXPECT_EQ(eliminate(system(1, {build::constant(5)})).verdict, Verdict::inconsistent);
  EXPECT_EQ(eliminate(system(0, {build::constant(5)})).verdict, Verdict::inconsistent);
  EXPECT_EQ(eliminate(system(0, {Polynomial{}})).verdict, Verdict::solved);
  EXPECT_EQ(eliminate(system(2, {Polynomial{}, x * y - one})).verdict, Verdict::dependent);
  const Reduction single = eliminate(system(1, {Rational(3) * x - one}));
  EXPECT_EQ(single.verdict, Verdict::solved);
  EXPECT_EQ(restored(single, {})[0], (Coefficient{Rational(1, 3), 0}));
}

TEST(Elimination, EveryVerdictHasAName) {
  EXPECT_EQ(to_string(Verdict::square), "square");
  EXPECT_EQ(to_string(Verdict::overdetermined), "overdetermined");
}

TEST(Elimination, IndependentEquationsStayAsTheyWereGiven) {
  const System f = noon(5);
  const Reduction r = eliminate(f);
  EXPECT_EQ(r.system, f);
  EXPECT_TRUE(r.left_out.empty());
}

TEST(Elimination, ComplexPivotsDivideExactly) {
  const Polynomial i_x = Coefficient{2, 3} * x;
  const System f = system(2, {i_x - y - one, x * x + y * y - build::constant(0, 1)});
  const Reduction r = eliminate(f);
  EXPECT_EQ(r.system.variables.size(), 1U);
  expect_same_span(f, r, 7);
}

TEST(Elimination, ATinyPivotIsNotDividedByThoughItsUnknownFillsLeast) {
  const Rational tiny(1, 1000000000);
  const Reduction r = eliminate(system(3, {tiny * x + y + z - one, x + y * y * z + z * z - one,
                                           y * y + z * z + y * z - build::constant(2)}));
  ASSERT_EQ(r.substitutions.size(), 1U);
  EXPECT_NE(r.substitutions[0].variable, 0U);
}

TEST(Elimination, ATinyCoefficientOfALargeUnknownIsAGoodPivot) {
  const Rational size(1000000);
  const Polynomial u = variable(2), v = variable(3);
  const System f =
      system(4, {x * x + y * y - build::constant(size * size),
                 u * u + v * v - build::constant(1 / (size * size)),
                 x * u - y * v - build::constant(Rational(1, 2)),
                 Rational(1 / size) * x - size * u - build::constant(Rational(3, 10))});
  const Reduction r = eliminate(f);
  EXPECT_EQ(r.substitutions.size(), 1U);
  expect_same_span(f, r, 3);
}

TEST(Elimination, Property2TheEquationItselfEntersOnce) {
  const Polynomial sparse = Rational(2) * x * x * x + x * y;
  const Polynomial long_one = Rational(3) * x * x * x + y * y - one;
  const Reduction r = eliminate(system(2, {long_one, sparse}));
  EXPECT_EQ(r.system.polynomials[0], long_one - Rational(3, 2) * sparse);
  EXPECT_EQ(r.system.polynomials[1], sparse);
  EXPECT_EQ(r.equation_origin, (std::vector<std::size_t>{0, 1}));

  const System line = system(2, {Rational(3) * x - y - one, x * x * x - y * y});
  const Reduction substituted = eliminate(line);
  ASSERT_EQ(substituted.equation_origin, (std::vector<std::size_t>{1}));
  const Point at{Coefficient{Rational(2, 7), 1}};
  EXPECT_EQ(value(substituted.system.polynomials[0], at),
            value(line.polynomials[1], restored(substituted, at)));
}

TEST(Elimination, KnownSystemsKeepTheirTotalDegreeAndTheirRoots) {
  for (const System& f : {katsura(4), katsura(7), cyclic(4), cyclic(6), eco(5), eco(7)}) {
    const Reduction r = eliminate(f);
    EXPECT_EQ(r.verdict, Verdict::square);
    EXPECT_LE(*total_degree(degrees(r.system)), *total_degree(degrees(f)));
    for (std::uint64_t seed = 1; seed <= 3; ++seed) expect_same_span(f, r, seed);
  }
}

TEST(Elimination, FourBarLoopsCombineAndSubstitute) {
  // Coupler point on two cranks: |P|^2 = 4, |P - A|^2 = 9, |Q|^2 = 1, |Q - P|^2 = 2: the first two
  // make a line.
  const Polynomial u = variable(2), v = variable(3);
  const System f =
      system(4, {x * x + y * y - build::constant(4),
                 power(x - build::constant(3), 2) + power(y - one, 2) - build::constant(9),
                 u * u + v * v - one, power(u - x, 2) + power(v - y, 2) - build::constant(2)});
  const Reduction r = eliminate(f);
  EXPECT_EQ(*total_degree(degrees(r.system)), 8U);
  for (std::uint64_t seed = 1; seed <= 5; ++seed) expect_same_span(f, r, seed);
}

/// Quadrics in 40 unknowns and linear equations, all through `root`, hidden by random combinations.
System forty_equations(std::uint32_t quadrics, const Point& root, bool is_real,
                       std::mt19937_64& random) {
  const auto unknowns = static_cast<std::uint32_t>(root.size());
  System f = system(unknowns, {});
  for (std::uint32_t i = 0; i < unknowns; ++i) {
    Polynomial p;
    for (std::uint32_t j = 0; j < unknowns; ++j) {
      p = p + random_integer(random, is_real) * variable(j);
      if (i >= quadrics) continue;
      p = p + random_integer(random, is_real) * (variable(j) * variable((j + i) % unknowns));
    }
    f.polynomials.push_back(through(p, root));
  }
  return mixed(f, random);
}

TEST(Elimination, FortyEquationsHideSixQuadrics) {
  constexpr std::uint32_t kUnknowns = 40;
  constexpr std::uint32_t kQuadrics = 6;
  for (bool is_real : {true, false}) {
    std::mt19937_64 random(1);
    Point root;
    for (std::uint32_t j = 0; j < kUnknowns; ++j) root.push_back(random_integer(random, is_real));
    const System f = forty_equations(kQuadrics, root, is_real, random);
    EXPECT_EQ(sorted_degrees(f), std::vector<std::uint64_t>(kUnknowns, 2));
    const Reduction r = eliminate(f);
    EXPECT_EQ(r.verdict, Verdict::square);
    EXPECT_EQ(degrees(r.system), std::vector<std::uint64_t>(kQuadrics, 2));
    EXPECT_EQ(*total_degree(degrees(r.system)), 64U);
    ASSERT_EQ(told(r).size(), 2U);
    EXPECT_EQ(told(r)[0],
              "34 quadratic equations combined to 34 linear ones: their highest terms cancel: "
              "total degree 1099511627776 -> 64");
    EXPECT_EQ(r.substitutions.size(), 34U);
    Point kept;
    for (std::size_t place : r.kept) kept.push_back(root[place]);
    EXPECT_EQ(restored(r, kept), root);
    for (const Coefficient& v : value(r.system, kept)) EXPECT_TRUE(is_zero(v));
  }
}

TEST(Elimination, AKnownRootStaysARoot) {
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    std::mt19937_64 random(seed);
    const Point root = random_point(5, random);
    System f = system(5, {});
    for (int degree : {1, 1, 2, 2, 2}) {
      f.polynomials.push_back(through(random_polynomial(5, degree, random), root));
    }
    f = mixed(f, random);
    const Reduction r = eliminate(f);
    EXPECT_EQ(*total_degree(degrees(r.system)), 8U);
    Point kept;
    for (std::size_t place : r.kept) kept.push_back(root[place]);
    EXPECT_EQ(restored(r, kept), root);
    for (const Coefficient& v : value(r.system, kept)) EXPECT_TRUE(is_zero(v));
    expect_same_span(f, r, seed);
  }
}

/// Sum of the unknowns = 1, and powers of neighbours.
System chain(std::uint32_t unknowns, std::uint32_t exponent) {
  Polynomial sum = build::constant(-1);
  for (std::uint32_t j = 0; j < unknowns; ++j) sum = sum + variable(j);
  System f = system(unknowns, {sum});
  for (std::uint32_t j = 0; j + 1 < unknowns; ++j) {
    const Polynomial powers{
        {Term{Coefficient{1, 0}, {{j, exponent}}}, Term{Coefficient{1, 0}, {{j + 1, exponent}}}}};
    f.polynomials.push_back(powers - build::constant(j + 1));
  }
  return f;
}

const Told kNotWorthIt{
    "the elimination of 1 linear equation: substitution would make the other equations longer than "
    "an unknown fewer is worth"};

TEST(Elimination, ALongFormInAHighPowerIsNotMultipliedOut) {
  const System f = chain(12, 400);
  const Reduction r = eliminate(f);
  EXPECT_EQ(r.system, f);
  EXPECT_EQ(told(r), kNotWorthIt);
}

TEST(Elimination, ASubstitutionThatDoesNotPayIsUndone) {
  for (const System& f : {chain(8, 3), katsura(10)}) {
    const Reduction r = eliminate(f);
    EXPECT_EQ(r.system, f);
    EXPECT_TRUE(r.substitutions.empty());
    EXPECT_EQ(told(r), kNotWorthIt);
  }
}

TEST(Elimination, ASubstitutionThatDoesNotPayIsMadeWhereItProvesADependence) {
  System f = chain(10, 4);
  f.polynomials[1] = x * f.polynomials[0];
  f.polynomials[2] = f.polynomials[2] + power(x, 4);
  const Reduction r = eliminate(f);
  EXPECT_EQ(r.verdict, Verdict::dependent);
  EXPECT_EQ(r.dependent_equations, 1U);
}

TEST(Elimination, CoefficientsOfThousandsOfDigitsAreNotMade) {
  constexpr unsigned kDigits = 600;
  const Integer huge = pow(Integer(10), kDigits);
  const Polynomial curve = power(x, 6) + power(y, 6) + x * y - one;
  const System f = system(2, {ratio(huge + 7, huge + 1) * x + y - one, curve});
  EXPECT_EQ(eliminate(f).system, f);
  EXPECT_EQ(eliminate(system(2, {Rational(2) * x + y - one, curve})).system.variables.size(), 1U);
}

/// The file with each rounded number moved by half a unit of its last digit, some up, some down.
System moved(System f, const CoefficientErrors& errors, unsigned which) {
  unsigned k = 0;
  for (std::size_t i = 0; i < f.polynomials.size(); ++i) {
    for (std::size_t j = 0; j < f.polynomials[i].terms.size(); ++j, ++k) {
      Coefficient& c = f.polynomials[i].terms[j].coefficient;
      const double factor = (which >> k & 1 ? 1 : -1) * bound(errors[i][j]);
      c = c * Coefficient{Rational(1) + Rational(factor), 0};
    }
  }
  return f;
}

TEST(Elimination, ErrorsOfRoundedNumbersAreCarriedToWhatIsLeft) {
  const System f = read_system({"test", R"(3
    x^2*z^2 + 12*x*z + 35.99999999992;
    2*x - 9*z - 2.00000000003;
    -x^2*z + 7*x*y*z - 2*x*z^2 - 3*x^2 - 5*x*z - 8*x + 42*y - 12*z - 27.99999999994;)"});
  const Reduction reduction = eliminate(f);
  ASSERT_EQ(reduction.system.variables.size(), 2);
  ASSERT_EQ(reduction.errors.size(), 2);
  std::vector<std::vector<double>> largest(2);
  for (unsigned which = 0; which < 1U << 15; which += 7) {
    const Reduction other = eliminate(moved(f, coefficient_errors(f), which));
    for (std::size_t i = 0; i < 2; ++i) {
      const std::vector<Term>& terms = reduction.system.polynomials[i].terms;
      ASSERT_EQ(other.system.polynomials[i].terms.size(), terms.size());
      largest[i].resize(terms.size());
      for (std::size_t k = 0; k < terms.size(); ++k) {
        const Coefficient difference =
            other.system.polynomials[i].terms[k].coefficient - terms[k].coefficient;
        if (is_zero(difference)) continue;
        const double relative = std::exp2(log2_size(difference) - log2_size(terms[k].coefficient));
        largest[i][k] = std::max(largest[i][k], relative);
      }
    }
  }
  for (std::size_t i = 0; i < 2; ++i) {
    for (std::size_t k = 0; k < largest[i].size(); ++k) {
      const double expected = bound(reduction.errors[i][k]);
      EXPECT_NEAR(largest[i][k], expected, 1e-3 * expected) << i << ' ' << k;
    }
  }
}

TEST(Elimination, EffectsOfOneNumberOnSeveralTermsCancelWhereTheyDo) {
  const System f =
      read_system({"test", "2\n x^2*z^2 + 12*x*z + 36;\n 2*x - 9*z - 2.00000000003;\n"});
  const Reduction reduction = eliminate(f);
  ASSERT_EQ(reduction.system.variables, std::vector<std::string>{"x"});
  // ((2 x - a) x / 9 + 6)^2 does not change with a where it is 0.
  const double a = 2.00000000003;
  const Complex root = (a + std::sqrt(Complex(a * a - 8 * 54))) / 4.0;
  const Polynomial& p = reduction.system.polynomials.at(0);
  NumberErrors effect;
  double apart = 0;
  for (std::size_t k = 0; k < p.terms.size(); ++k) {
    const auto e = static_cast<int>(degree(p.terms[k].monomial));
    const Complex term = to_complex(p.terms[k].coefficient) * std::pow(root, e);
    add(effect, term, reduction.errors.at(0).at(k));
    apart += std::abs(term) * bound(reduction.errors[0][k]);
  }
  EXPECT_GT(apart, 1e-12);
  EXPECT_LT(bound(effect), 1e-12 * apart);
}

TEST(Elimination, CombinedEquationsHaveTheErrorsOfBoth) {
  const System f = read_system(
      {"test", "2\n x^2*y^2 + x - 0.5;\n 2*x^2*y^2 + y^2 - 1.25 - 0.1234567890123*x;\n"});
  const Reduction reduction = eliminate(f);
  ASSERT_EQ(reduction.errors.size(), 2);
  double largest = 0;
  for (const auto& own : reduction.errors) {
    for (const NumberErrors& errors : own) largest = std::max(largest, bound(errors));
  }
  EXPECT_NEAR(largest / (0.5e-13 / 2.1234567890123), 1, 1e-3);
}

TEST(Elimination, ExactNumbersLeaveNoErrors) {
  EXPECT_TRUE(eliminate(read_system({"test", "2\n x^2 + 3*y;\n x - y/3 + 0.7;\n"})).errors.empty());
}

TEST(Elimination, RestoreInDoubleAgreesWithTheExactOne) {
  const System f = katsura(5);
  const Reduction r = eliminate(f);
  std::mt19937_64 random(11);
  const Point at = random_point(r.kept.size(), random);
  std::vector<std::complex<double>> rounded;
  for (const Coefficient& c : at) rounded.push_back(to_complex(c));
  const auto back = restore(r, rounded);
  const Point exact = restored(r, at);
  ASSERT_EQ(back.size(), exact.size());
  // A sum of at most ten numbers below 10 times coefficients below 2, each rounded twice.
  constexpr double kRounding = 10 * 10 * 2 * 2 * std::numeric_limits<double>::epsilon();
  for (std::size_t j = 0; j < back.size(); ++j) {
    EXPECT_LE(std::abs(back[j] - to_complex(exact[j])), kRounding);
  }
}

/// The choice of one unknown among 300 dense equations looks at 300^3 places.
TEST(Elimination, EndsWithinASecondOfAStopHoweverDenseTheEquationsAre) {
  std::string text = "300\n";
  for (int i = 0; i < 300; ++i) {
    for (int j = 0; j < 300; ++j) {
      text += '+' + std::to_string(1 + (37 * i * i + 101 * i * j + 59 * j * j * j) % 997) + "*x" +
              std::to_string(j);
    }
    text += "-1;\n";
  }
  const System f = read_system({"dense", text});
  // The stop comes and the end is seen in processor time: a busy machine changes neither.
  static std::atomic<bool> stop{false};
  std::signal(SIGPROF, [](int) { stop = true; });
  constexpr struct itimerval kHalfASecond {
    {0, 0}, { 0, 500'000 }
  };
  ASSERT_EQ(::setitimer(ITIMER_PROF, &kHalfASecond, nullptr), 0);
  const std::clock_t begin = std::clock();
  eliminate(f, &stop);
  const std::clock_t worked = std::clock() - begin;
  EXPECT_TRUE(stop) << "it ended by itself";
  constexpr struct itimerval kNone {};
  ::setitimer(ITIMER_PROF, &kNone, nullptr);
  std::signal(SIGPROF, SIG_DFL);
  EXPECT_LT(worked, CLOCKS_PER_SEC / 2 + CLOCKS_PER_SEC);
}

TEST(Elimination, AStopLeavesAReduction) {
  const std::atomic<bool> stop{true};
  const System f = katsura(5);
  const Reduction r = eliminate(f, &stop);
  EXPECT_EQ(r.verdict, Verdict::square);
  expect_same_span(f, r, 3);
}

// Four equations each hold an unknown: the work of a step is that of these four.
TEST(Elimination, ALongChainOfLinearEquationsIsShortWork) {
  constexpr int kLength = 3000;
  std::string text = std::to_string(kLength) + "\nx1 - 1;\n";
  for (int k = 2; k <= kLength; ++k) {
    text += "x" + std::to_string(k) + " - x" + std::to_string(k - 1) + " - 1;\n";
  }
  const Reduction r = eliminate(read_system({"test", text}));
  ASSERT_EQ(r.verdict, Verdict::solved);
  const Point point = restored(r, {});
  EXPECT_EQ(point.back().re, Rational(kLength));
}

/// n linear equations, the i-th of x_i and others, so many in all, with random integers of up to
/// 99, or of that many digits more.
System linear_equations(std::size_t n, std::size_t terms, std::mt19937_64& random,
                        const std::string& digits = "") {
  std::uniform_int_distribution<int> number(1, 99);
  std::vector<std::size_t> places(n);
  std::iota(places.begin(), places.end(), std::size_t{0});
  std::string text = std::to_string(n) + "\n";
  for (std::size_t i = 0; i < n; ++i) {
    std::shuffle(places.begin(), places.end(), random);
    std::swap(places.front(), *std::find(places.begin(), places.end(), i));
    for (std::size_t k = 0; k < terms; ++k) {
      text += (number(random) % 2 == 0 ? "+" : "-") + std::to_string(number(random)) + digits +
              "*x" + std::to_string(places[k]);
    }
    text += " - " + std::to_string(number(random)) + ";\n";
  }
  return read_system({"linear", text});
}

void expect_root(const System& f, const Point& root) {
  for (const Polynomial& p : f.polynomials) {
    const Coefficient at = value(p, root);
    EXPECT_EQ(at.re, Rational(0));
    EXPECT_EQ(at.im, Rational(0));
  }
}

/// Dense, and sparse ones that fill.
TEST(Elimination, AsManyLinearEquationsAsUnknownsAreSolvedExactly) {
  for (const auto& [n, terms] : {std::pair(40U, 40U), std::pair(80U, 6U)}) {
    for (std::uint64_t seed = 1; seed <= 5; ++seed) {
      SCOPED_TRACE(std::to_string(n) + " unknowns, seed " + std::to_string(seed));
      std::mt19937_64 random(seed);
      const System f = linear_equations(n, terms, random);
      const Reduction r = eliminate(f);
      ASSERT_EQ(r.verdict, Verdict::solved);
      expect_root(f, restored(r, {}));
    }
  }
}

TEST(Elimination, LinearEquationsOfLongNumbersLeaveTheOtherOnesAtTheirPoint) {
  std::mt19937_64 random(7);
  System f = linear_equations(9, 8, random, "12345678901234567890123");
  f.variables.push_back("y");
  const Polynomial last = variable(9);
  f.polynomials.push_back(last * last - x * y + z - one);
  const Reduction r = eliminate(f);
  ASSERT_EQ(r.verdict, Verdict::square);
  EXPECT_EQ(r.kept, std::vector<std::size_t>{9});
  expect_same_span(f, r, 8);
}

TEST(Elimination, OfAsManyLinearEquationsAsUnknownsThatDependOnEachOtherOneIsNothing) {
  std::mt19937_64 random(9);
  System f = linear_equations(30, 30, random);
  f.polynomials.back() = f.polynomials[0] + f.polynomials[1];
  const Reduction r = eliminate(f);
  EXPECT_EQ(r.verdict, Verdict::dependent);
  EXPECT_EQ(r.dependent_equations, 1U);
}

/// One by one the substitutions multiply and divide integers of up to three thousand bits: 17 s,
/// against 0.4 s.
TEST(Elimination, FourHundredEquationsThatFillAreShortWork) {
  std::mt19937_64 random(1);
  const System f = linear_equations(400, 7, random);
  const std::clock_t begin = std::clock();
  const Reduction r = eliminate(f);
  EXPECT_LT(std::clock() - begin, 6 * CLOCKS_PER_SEC);
  ASSERT_EQ(r.verdict, Verdict::solved);
  expect_root(f, restored(r, {}));
}

}  // namespace
}  // namespace moivre
