// SPDX-License-Identifier: MIT
// Does LU solve what Eigen solves, whatever the rows are multiplied by, and does it know how
// singular a matrix is?
#include "moivre/factorization/lu.h"

#include <gtest/gtest.h>

#include <limits>
#include <random>
#include <span>
#include <vector>

#include "moivre/factorization/qr.h"

namespace moivre {
namespace {

using Matrix = Eigen::Matrix<Complex, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
using Vector = Eigen::VectorXcd;
constexpr double kEpsilon = std::numeric_limits<double>::epsilon();
constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr std::size_t kLargest = 12;

class RandomMatrices {
 public:
  Complex number() { return {part_(random_), part_(random_)}; }
  Matrix matrix(std::size_t rows, std::size_t columns) {
    Matrix a(static_cast<Eigen::Index>(rows), static_cast<Eigen::Index>(columns));
    for (Eigen::Index i = 0; i < a.size(); ++i) a.data()[i] = number();
    return a;
  }
  Vector vector(std::size_t n) { return matrix(n, 1); }
  /// Singular values spread evenly on a log scale from 1 to 1/condition.
  Matrix conditioned(std::size_t n, double condition) {
    Eigen::VectorXd values(static_cast<Eigen::Index>(n));
    for (Eigen::Index k = 0; k < values.size(); ++k) {
      values(k) = std::pow(condition, -static_cast<double>(k) / static_cast<double>(n - 1));
    }
    return unitary(n) * values.asDiagonal() * unitary(n);
  }

 private:
  Matrix unitary(std::size_t n) {
    return PivotedQr<Complex>(matrix(n, n)).last_columns_of_Q(static_cast<Eigen::Index>(n));
  }

  std::mt19937_64 random_{1};
  std::uniform_real_distribution<double> part_{-1, 1};
};

Lu factored(const Matrix& a, std::span<const double> weights = {}) {
  Lu lu(static_cast<std::size_t>(a.rows()));
  std::copy(a.data(), a.data() + a.size(), lu.matrix().begin());
  const bool is_regular = lu.factor(weights);
  EXPECT_EQ(is_regular, !lu.is_singular());
  return lu;
}

Vector solve(Lu& lu, Vector b) {
  lu.solve({b.data(), static_cast<std::size_t>(b.size())});
  return b;
}
Vector solve_adjoint(Lu& lu, Vector b) {
  lu.solve_adjoint({b.data(), static_cast<std::size_t>(b.size())});
  return b;
}

double infinity_norm(const Matrix& a) { return a.cwiseAbs().rowwise().sum().maxCoeff(); }
Matrix inverse(const Matrix& a) {
  const PivotedQr<Complex> qr(a);
  Matrix columns(a.rows(), a.cols());
  for (Eigen::Index j = 0; j < a.cols(); ++j) columns.col(j) = qr.solve(Vector::Unit(a.rows(), j));
  return columns;
}
double true_condition(const Matrix& a) { return infinity_norm(a) * infinity_norm(inverse(a)); }

/// The rows by 2^-e, each then of largest |re| + |im| in [1/2, 1).
Matrix row_scaled(Matrix a) {
  for (Eigen::Index i = 0; i < a.rows(); ++i) {
    double largest = 0;
    for (Eigen::Index j = 0; j < a.cols(); ++j) largest = std::max(largest, magnitude1(a(i, j)));
    a.row(i) *= std::ldexp(1.0, -std::ilogb(largest) - 1);
  }
  return a;
}

/// Within a factor of 3 below, as [Higham88] finds; above by the root of two that |re| + |im| may
/// add to a norm.
void expect_estimates(double estimate, double condition) {
  EXPECT_LE(estimate, std::sqrt(2.0) * condition * (1 + 1e3 * kEpsilon * condition));
  EXPECT_GE(estimate * (1 + 1e3 * kEpsilon * condition), condition / 3);
}

TEST(Lu, SolvesWhatEigenSolves) {
  RandomMatrices random;
  for (std::size_t n = 1; n <= kLargest; ++n) {
    for (int k = 0; k < 20; ++k) {
      const Matrix a = random.matrix(n, n);
      const Vector b = random.vector(n);
      Lu lu = factored(a);
      const Vector wanted = PivotedQr<Complex>(a).solve(b);
      const double bound = 10 * static_cast<double>(n) * kEpsilon * true_condition(a);
      EXPECT_LE((solve(lu, b) - wanted).norm(), bound * wanted.norm()) << n;
    }
  }
}

TEST(Lu, ZerosOfLargeMatricesChangeNothing) {
  RandomMatrices random;
  for (const Eigen::Index n : {16, 40, 150}) {
    for (const Eigen::Index apart : {1, 5, 9}) {
      Matrix a = Matrix::Zero(n, n);
      for (Eigen::Index i = 0; i < n; ++i) {
        a(i, (i * 7 + 3) % n) = 4.0 + random.number();
        for (Eigen::Index j = i % apart; j < n; j += apart) a(i, j) += random.number() / 4.0;
      }
      const Vector x = random.vector(static_cast<std::size_t>(n));
      Lu lu = factored(a);
      EXPECT_LT((solve(lu, a * x) - x).norm(), 1e-10 * x.norm()) << n << ' ' << apart;
      const Vector last = Vector::Unit(n, n - 1);
      EXPECT_LT((a * solve(lu, last) - last).norm(), 1e-10) << n << ' ' << apart;
    }
  }
}

// Bit for bit: zeros, of which a third and then two thirds of the matrix are made, are passed over.
TEST(Lu, InvertsAsSolvesOfUnitVectorsDo) {
  RandomMatrices random;
  for (std::size_t n = 0; n <= 24; ++n) {
    for (const std::size_t kept : {3U, 2U, 1U}) {
      SCOPED_TRACE(n);
      Lu lu(n);
      const std::span<Complex> a = lu.matrix();
      for (std::size_t k = 0; k < n * n; ++k) {
        const bool stays = (k * 7 + k / 5) % 3 < kept || k / n == k % n;
        a[k] = stays ? random.number() : Complex(0);
      }
      if (!lu.factor()) continue;
      std::vector<Complex> inverse(n * n);
      lu.invert(inverse);
      for (std::size_t k = 0; k < n; ++k) {
        std::vector<Complex> column(n);
        column[k] = 1;
        lu.solve(column);
        for (std::size_t j = 0; j < n; ++j) EXPECT_EQ(inverse[k * n + j], column[j]) << k << j;
      }
    }
  }
}

TEST(Lu, AdjointSolveIsTheAdjointOfTheSolve) {
  RandomMatrices random;
  for (std::size_t n = 1; n <= kLargest; ++n) {
    const Matrix a = random.matrix(n, n);
    const Vector b = random.vector(n);
    Lu lu = factored(a);
    const double bound = 10 * static_cast<double>(n) * kEpsilon * true_condition(a);
    const Vector wanted = PivotedQr<Complex>(a.adjoint()).solve(b);
    EXPECT_LE((solve_adjoint(lu, b) - wanted).norm(), bound * wanted.norm()) << n;
    // <c, J^-1 b> = <J^-H c, b>
    const Vector c = random.vector(n);
    const Complex left = c.dot(solve(lu, b));
    EXPECT_LE(std::abs(left - solve_adjoint(lu, c).dot(b)), bound * c.norm() * solve(lu, b).norm())
        << n;
  }
}

TEST(Lu, AFactorOfTwoOnARowChangesNoBit) {
  RandomMatrices random;
  Matrix a = random.matrix(7, 7);
  Vector b = random.vector(7);
  Lu plain = factored(a);
  const Vector x = solve(plain, b);
  for (Eigen::Index i = 0; i < 7; ++i) {
    const double factor = std::ldexp(1.0, static_cast<int>(100 * i - 300));
    a.row(i) *= factor;
    b(i) *= factor;
  }
  Lu scaled = factored(a);
  EXPECT_EQ(solve(scaled, b), x);
  EXPECT_EQ(scaled.condition(), plain.condition());
}

TEST(Lu, AnyFactorOnARowLeavesSolutionAndScaledCondition) {
  RandomMatrices random;
  Matrix a = random.matrix(6, 6);
  Vector b = random.vector(6);
  Lu plain = factored(a);
  const Vector x = solve(plain, b);
  a.row(2) *= Complex(3e-40, 1e-40);
  b(2) *= Complex(3e-40, 1e-40);
  Lu scaled = factored(a);
  EXPECT_LE((solve(scaled, b) - x).norm(), 1e2 * kEpsilon * plain.condition() * x.norm());
  // A row may come out smaller or larger by 2 under its power of two.
  EXPECT_LE(std::abs(std::log(scaled.condition() / plain.condition())), std::log(6.0));
  EXPECT_GT(scaled.unscaled_condition(), 1e35);
}

TEST(Lu, WeightsGuideThePivotsAndLeaveTheSolution) {
  RandomMatrices random;
  const Matrix a = random.matrix(5, 5);
  const Vector b = random.vector(5);
  const std::vector<double> weights{1, 1e-6, 1e3, 1, 1e-2};
  Lu lu = factored(a, weights);
  const Vector wanted = PivotedQr<Complex>(a).solve(b);
  EXPECT_LE((solve(lu, b) - wanted).norm(), 1e2 * kEpsilon * true_condition(a) * wanted.norm());
}

TEST(Lu, WeightsKeepARowThatMattersToASmallUnknown) {
  // Row 0 is large only in front of the small unknown: without weights it is scaled down to lose
  // the pivot.
  const Matrix a = (Matrix(2, 2) << 1, 1e20, 1, 1).finished();
  const std::vector<double> weights{1, 1e-20};
  const Vector exact = (Vector(2) << 1, 1e-20).finished();
  Lu lu = factored(a, weights);
  const Vector x = solve(lu, (Vector(2) << 2, 1).finished());
  EXPECT_LE(std::abs(x(0) - exact(0)), 4 * kEpsilon);
  EXPECT_LE(std::abs(x(1) - exact(1)), 4 * kEpsilon * std::abs(exact(1)));
}

TEST(Lu, EstimatesTheConditionOfRandomAndOfIllConditionedMatrices) {
  RandomMatrices random;
  for (std::size_t n = 2; n <= kLargest; ++n) {
    for (const double condition : {1.0, 1e3, 1e6, 1e9}) {
      const Matrix a = random.conditioned(n, condition);
      Lu lu = factored(a);
      expect_estimates(lu.unscaled_condition(), true_condition(a));
      expect_estimates(lu.condition(), true_condition(row_scaled(a)));
    }
  }
}

TEST(Lu, AVanishingRowShowsInTheUnscaledConditionAlone) {
  RandomMatrices random;
  const Matrix a = random.matrix(5, 5);
  Matrix vanishing = a;
  vanishing.row(3) *= std::ldexp(1.0, -30);
  Lu before = factored(a);
  Lu after = factored(vanishing);
  EXPECT_EQ(after.condition(), before.condition());
  expect_estimates(after.unscaled_condition(), true_condition(vanishing));
  EXPECT_GT(after.unscaled_condition(), 1e8 * before.condition());
}

TEST(Lu, TellsSingularMatrices) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const std::vector<Matrix> singular{
      Matrix::Zero(3, 3),
      (Matrix(2, 2) << 1, 1, 1, 1).finished(),
      (Matrix(2, 2) << 0, 1, 0, 2).finished(),
      (Matrix(3, 3) << 1, 2, 4, 2, 4, 8, 1, 0, 0).finished(),
      (Matrix(2, 2) << 1, 0, 0, nan).finished(),
      (Matrix(2, 2) << kInfinity, 0, 0, 1).finished(),
  };
  for (const Matrix& a : singular) {
    Lu lu = factored(a);
    EXPECT_TRUE(lu.is_singular()) << a;
    EXPECT_EQ(lu.condition(), kInfinity);
    EXPECT_EQ(lu.unscaled_condition(), kInfinity);
  }
}

TEST(Lu, IsReadyForTheNextMatrixAfterASingularOne) {
  Lu lu = factored(Matrix::Zero(2, 2));
  const Matrix identity = Matrix::Identity(2, 2);
  std::copy(identity.data(), identity.data() + 4, lu.matrix().begin());
  EXPECT_TRUE(lu.factor());
  EXPECT_FALSE(lu.is_singular());
  const Vector b = (Vector(2) << 3, Complex(0, 4)).finished();
  EXPECT_EQ(solve(lu, b), b);
}

TEST(Lu, OfNothingIsRegular) {
  Lu lu(0);
  EXPECT_TRUE(lu.factor());
  EXPECT_EQ(lu.condition(), 1);
}

}  // namespace
}  // namespace moivre
