// SPDX-License-Identifier: MIT
// The singular values of the equations in units of their own, as real ones of twice the size.
#include "linear_block.h"

#include <algorithm>
#include <cmath>

#include "moivre/factorization/svd.h"

namespace moivre {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

// Beside what they were added from: what a dozen frames leave of rounding.
constexpr double kOfRounding = 1 / kUndetermined;
// Beside rounding, enough to be told from it.
constexpr double kToldFromRounding = 0x1p20;

/// A x + b, and the sums of the moduli that its entries were added from.
struct LinearEquations {
  Eigen::MatrixXcd A;
  Eigen::VectorXcd b;
  MatrixXd of_A;
  VectorXd of_b;
};

/// The number of the block's variable that a term has; the block's size where it has none.
Index unknown_of(const Term& term, const Block& block) {
  const auto& variables = block.variables;
  for (const Power& power : term.monomial) {
    const auto at = std::lower_bound(variables.begin(), variables.end(), power.variable);
    if (at != variables.end() && *at == power.variable) return at - variables.begin();
  }
  return static_cast<Index>(variables.size());
}

bool is_linear_term(const Term& term, const Block& block) {
  std::uint64_t degree = 0;
  for (const Power& power : term.monomial) {
    if (std::binary_search(block.variables.begin(), block.variables.end(), power.variable)) {
      degree += power.exponent;
    }
  }
  return degree <= 1;
}

LinearEquations equations_at(const System& all, const Block& block, const PartialRoot& root) {
  const auto n = static_cast<Index>(block.variables.size());
  LinearEquations e{Eigen::MatrixXcd::Zero(n, n), Eigen::VectorXcd::Zero(n), MatrixXd::Zero(n, n),
                    VectorXd::Zero(n)};
  for (Index i = 0; i < n; ++i) {
    for (const Term& term : all.polynomials[block.equations[static_cast<std::size_t>(i)]].terms) {
      Complex c = to_complex(term.coefficient);
      for (const Power& power : term.monomial) {
        const KnownValue& known = root.value[power.variable];
        for (std::uint32_t k = 0; known && k < power.exponent; ++k) c *= known->rounded;
      }
      const Index j = unknown_of(term, block);
      (j == n ? e.b[i] : e.A(i, j)) += c;
      (j == n ? e.of_b[i] : e.of_A(i, j)) += std::abs(c);
    }
  }
  return e;
}

/// As real ones: [Re -Im; Im Re].
MatrixXd as_real(const Eigen::MatrixXcd& A) {
  MatrixXd real(2 * A.rows(), 2 * A.cols());
  real << A.real(), -A.imag(), A.imag(), A.real();
  return real;
}

/// 1 / x; 1 where x is 0.
VectorXd inverses(const VectorXd& x) {
  return x.unaryExpr([](double xi) { return xi > 0 ? 1 / xi : 1.0; });
}

}  // namespace

LinearBlock::LinearBlock(const System& all, const Block& block) : all_(all), block_(block) {
  for (const std::size_t e : block.equations) {
    for (const Term& term : all.polynomials[e].terms) {
      is_linear_ = is_linear_ && is_linear_term(term, block);
    }
  }
}

std::optional<Point> LinearBlock::least_squares(const PartialRoot& root) const {
  if (!is_linear_) return std::nullopt;
  LinearEquations e = equations_at(all_, block_, root);
  const VectorXd row = inverses(e.of_A.rowwise().maxCoeff());
  e.of_A = row.asDiagonal() * e.of_A;
  const VectorXd column = inverses(e.of_A.colwise().maxCoeff().transpose());
  const Svd of = svd(as_real(row.asDiagonal() * e.A * column.asDiagonal()), SingularVectors::full);
  const Index n = row.size();
  VectorXd b(2 * n);
  b << row.asDiagonal() * e.b.real(), row.asDiagonal() * e.b.imag();

  const double rounding = kOfRounding * static_cast<double>(n);
  const Index rank = (of.sigma.array() > rounding).count();
  const double least = rank > 0 ? of.sigma[rank - 1] : 1;
  if (rank == 2 * n || least <= kToldFromRounding * rounding) return std::nullopt;
  const VectorXd y = -of.V.leftCols(rank) * of.sigma.head(rank).cwiseInverse().cwiseProduct(
                                                of.U.leftCols(rank).transpose() * b);
  const double contradiction = (of.U.rightCols(2 * n - rank).transpose() * b).norm();
  const double size = row.cwiseProduct(e.of_b).norm() + y.norm();
  if (contradiction <= kToldFromRounding * rounding * size / least) return std::nullopt;
  Point x;
  for (Index j = 0; j < n; ++j) x.emplace_back(column[j] * y[j], column[j] * y[n + j]);
  return x;
}

}  // namespace moivre
