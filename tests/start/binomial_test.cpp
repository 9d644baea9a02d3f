// SPDX-License-Identifier: MIT
// Are the roots of binomial systems roots, are they distinct, and as many as the determinant says?
#include "moivre/start/binomial.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <set>
#include <stdexcept>

#include "families.h"
#include "moivre/numeric/random.h"
#include "moivre/start/total_degree.h"

namespace moivre {
namespace {

using Matrix = std::vector<std::int64_t>;

std::int64_t random_integer(std::uint64_t index, std::int64_t range) {
  const auto bits = random_bits(2, RandomStream::test, index);
  return static_cast<std::int64_t>(bits % static_cast<std::uint64_t>(2 * range + 1)) - range;
}

std::vector<Complex> random_beta(std::size_t n, std::uint64_t index) {
  std::vector<Complex> beta;
  for (std::size_t i = 0; i < n; ++i) {
    const double modulus = 0.5 + random_unit(3, RandomStream::test, index + i);
    beta.push_back(modulus * random_phase(1, RandomStream::test, index + i));
  }
  return beta;
}

/// Angles of a root in 2^-64 turns, exactly as in the header's formula.
std::vector<std::uint64_t> exact_turns(const BinomialSystem& s, std::uint64_t number) {
  __extension__ typedef unsigned __int128 Wide;
  const std::size_t n = s.radix.size();
  std::vector<std::uint64_t> k;
  for (const std::uint64_t h : s.radix) {
    k.push_back(number % h);
    number /= h;
  }
  std::vector<std::uint64_t> turns;
  for (std::size_t i = 0; i < n; ++i) {
    Wide parts = 0;
    for (std::size_t j = 0; j < n; ++j) parts = (parts + Wide{s.steps[i * n + j]} * k[j]) % s.roots;
    turns.push_back(s.turns[i] + static_cast<std::uint64_t>((parts << 64) / s.roots));
  }
  return turns;
}

/// x^{v_i} = beta_i, the angle to within what n cut numbers of 64 digits times the entries of V can
/// do.
void expect_root(const Matrix& v, const std::vector<Complex>& beta, const BinomialSystem& s,
                 std::uint64_t number) {
  const std::size_t n = beta.size();
  const std::vector<std::uint64_t> turns = exact_turns(s, number);
  for (std::size_t i = 0; i < n; ++i) {
    std::uint64_t sum = 0;
    double log_modulus = 0;
    double entries = 0;
    double terms = 0;
    for (std::size_t j = 0; j < n; ++j) {
      const std::int64_t entry = v[i * n + j];
      sum += static_cast<std::uint64_t>(entry) * turns[j];
      log_modulus += static_cast<double>(entry) * s.log_modulus[j];
      entries += std::abs(static_cast<double>(entry));
      terms += std::abs(static_cast<double>(entry) * s.log_modulus[j]);
    }
    const double angle = std::arg(beta[i]) / (2 * std::numbers::pi);
    const double off = std::remainder(static_cast<double>(sum) * 0x1p-64 - angle, 1);
    const double epsilon = std::numeric_limits<double>::epsilon();
    const double size = static_cast<double>(n);
    EXPECT_LE(std::abs(off), 2 * epsilon + 2 * size * entries * 0x1p-64) << number;
    EXPECT_NEAR(log_modulus, std::log(std::abs(beta[i])), 4 * size * epsilon * (1 + terms));
  }
}

void expect_all_roots(const Matrix& v, const std::vector<Complex>& beta, std::uint64_t expected) {
  const BinomialSystem s = binomial_system(v, beta);
  EXPECT_EQ(s.roots, expected);
  std::set<std::vector<std::uint64_t>> distinct;
  for (std::uint64_t number = 0; number < s.roots; ++number) {
    expect_root(v, beta, s, number);
    distinct.insert(exact_turns(s, number));
    const Point x = binomial_root(s, number);
    const Point z = binomial_root_logarithm(s, number);
    for (std::size_t j = 0; j < x.size(); ++j) {
      EXPECT_LE(std::abs(x[j] - std::exp(z[j])), 1e-14 * std::abs(x[j]));
    }
  }
  EXPECT_EQ(distinct.size(), expected);
}

TEST(Binomial, InOneVariableTheRootsAreDeMoivres) {
  for (const Complex beta : {Complex(1, 2), Complex(-3, 4), Complex(0, -1), Complex(-1, 0)}) {
    const BinomialSystem s = binomial_system(Matrix{5}, std::vector<Complex>{beta});
    ASSERT_EQ(s.roots, 5u);
    for (std::uint64_t number = 0; number < 5; ++number) {
      double nearest = 1;
      for (std::uint64_t k = 0; k < 5; ++k) {
        nearest =
            std::min(nearest, std::abs(binomial_root(s, number)[0] - de_moivre_root(beta, 5, k)));
      }
      EXPECT_LT(nearest, 1e-15 * 8);
    }
  }
}

TEST(Binomial, RandomMatricesHaveAllTheirRoots) {
  std::uint64_t index = 0;
  for (std::size_t n = 1; n <= 6; ++n) {
    for (int repeat = 0; repeat < 20; ++repeat) {
      Matrix v(n * n);
      for (std::int64_t& entry : v) entry = random_integer(index++, 3);
      const std::vector<Complex> beta = random_beta(n, index);
      std::uint64_t roots = 0;
      try {
        roots = binomial_system(v, beta).roots;
      } catch (const std::invalid_argument&) {
        continue;  // singular
      }
      if (roots <= 500) expect_all_roots(v, beta, roots);
    }
  }
}

TEST(Binomial, DiagonalMatricesHaveTheProductOfTheEntries) {
  expect_all_roots({3, 0, 0, 0, -4, 0, 0, 0, 5}, random_beta(3, 7), 60);
  expect_all_roots({2, 0, 0, 0, 2, 0, 0, 0, 2}, random_beta(3, 8), 8);
  expect_all_roots({}, {}, 1);
}

/// L diag(d) U with unit triangular L, U of large entries: det V = the product of d, V as
/// ill-shaped as can be.
Matrix ill_shaped(const std::vector<std::int64_t>& d, std::int64_t range, std::uint64_t index) {
  const std::size_t n = d.size();
  Matrix lower(n * n, 0), upper(n * n, 0), v(n * n, 0);
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t j = 0; j < n; ++j) {
      if (i == j) lower[i * n + j] = upper[i * n + j] = 1;
      if (j < i) lower[i * n + j] = random_integer(index++, range);
      if (j > i) upper[i * n + j] = random_integer(index++, range);
    }
  }
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t k = 0; k < n; ++k) {
      for (std::size_t j = 0; j < n; ++j)
        v[i * n + j] += lower[i * n + k] * d[k] * upper[k * n + j];
    }
  }
  return v;
}

TEST(Binomial, IllShapedMatricesOfLargeEntriesHaveAllTheirRoots) {
  // beta of modulus 1: log |x| would be far out of range else, as it truly is.
  for (const std::int64_t range : {10LL, 1000LL, 100000LL, 30000000LL}) {
    for (const std::vector<std::int64_t>& d : std::vector<std::vector<std::int64_t>>{
             {1, 1, 1}, {2, 3, 5, 7}, {1, 1, 1, 60}, {4, 4, 2, 2, 2}}) {
      std::vector<Complex> beta;
      std::uint64_t roots = 1;
      for (std::size_t i = 0; i < d.size(); ++i) {
        beta.push_back(i % 2 == 0 ? Complex(0, 1) : Complex(-1, 0));
        roots *= static_cast<std::uint64_t>(d[i]);
      }
      const Matrix v = ill_shaped(d, range, static_cast<std::uint64_t>(range));
      expect_all_roots(v, beta, roots);
    }
  }
}

TEST(Binomial, ManyRootsAreEnumeratedWithoutBeingStored) {
  const std::int64_t large = 3037000499;  // its square is just below 2^63
  const Matrix v{large, 0, 1, large};
  const std::vector<Complex> beta = random_beta(2, 9);
  const BinomialSystem s = binomial_system(v, beta);
  const auto roots = static_cast<std::uint64_t>(large) * static_cast<std::uint64_t>(large);
  ASSERT_EQ(s.roots, roots);
  for (const std::uint64_t number : {std::uint64_t{0}, std::uint64_t{1}, roots / 3, roots - 1}) {
    expect_root(v, beta, s, number);
  }
  EXPECT_THROW(binomial_root(s, roots), std::out_of_range);
}

TEST(Binomial, EveryCellsRootsSolveItsTwoTermSystem) {
  for (const auto& supports : {cyclic(5), noon(4), katsura(4)}) {
    const MixedSubdivision s = *mixed_cells(supports, 1).subdivision;
    std::vector<Complex> g;
    for (const Support& support : supports) {
      for (std::size_t k = 0; k < support.terms.size(); ++k) {
        g.push_back(random_phase(4, RandomStream::test, g.size()));
      }
    }
    for (const MixedCell& cell : s.cells) {
      const BinomialSystem system = binomial_system(s, cell, g);
      ASSERT_EQ(system.roots, cell.volume);
      for (std::uint64_t number = 0; number < system.roots; ++number) {
        const Point x = binomial_root(system, number);
        std::size_t begin = 0;
        for (std::size_t i = 0; i < supports.size(); ++i) {
          Complex sum = 0;
          for (const std::uint32_t k : cell.edges[i]) {
            Complex term = g[begin + k];
            for (std::size_t j = 0; j < x.size(); ++j) {
              for (std::uint32_t e = 0; e < supports[i].terms[k][j]; ++e) term *= x[j];
            }
            sum += term;
          }
          EXPECT_LT(std::abs(sum), 1e-14);
          begin += supports[i].terms.size();
        }
      }
    }
  }
}

TEST(Binomial, RefusesWhatHasNoRootsOrTooMany) {
  const std::vector<Complex> one{1.0};
  const std::vector<Complex> two{1.0, 1.0};
  EXPECT_THROW(binomial_system(Matrix{1, 2, 2, 4}, two), std::invalid_argument);
  EXPECT_THROW(binomial_system(Matrix{1, 2, 3}, two), std::invalid_argument);
  EXPECT_THROW(binomial_system(Matrix{1}, std::vector<Complex>{0.0}), std::invalid_argument);
  const std::int64_t large = 3037000500;
  EXPECT_THROW(binomial_system(Matrix{large, 0, 0, large}, two), std::overflow_error);
  EXPECT_THROW(binomial_system(Matrix{std::numeric_limits<std::int64_t>::min()}, one),
               std::overflow_error);
}

}  // namespace
}  // namespace moivre
