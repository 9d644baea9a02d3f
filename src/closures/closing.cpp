// SPDX-License-Identifier: MIT
// Gauss-Newton on all closure polynomials.
#include "closing.h"

#include <Eigen/Core>
#include <cmath>

#include "moivre/factorization/qr.h"

namespace moivre {
namespace {

using Eigen::Index;

Complex power(Complex x, std::uint32_t exponent) {
  Complex product = 1;
  for (std::uint32_t k = 0; k < exponent; ++k) product *= x;
  return product;
}

/// The product of the powers but for number `left_out`; of all where that is their count.
Complex product_of(const Monomial& monomial, std::size_t left_out, const Point& x) {
  Complex product = 1;
  for (std::size_t k = 0; k < monomial.size(); ++k) {
    if (k != left_out) product *= power(x[monomial[k].variable], monomial[k].exponent);
  }
  return product;
}

struct Linearized {
  Eigen::VectorXcd value;
  Eigen::MatrixXcd jacobian;
};

/// Each row by the size of its terms.
Linearized linearized(const System& f, const Point& x) {
  const auto rows = static_cast<Index>(f.polynomials.size());
  const auto columns = static_cast<Index>(x.size());
  Linearized at{Eigen::VectorXcd::Zero(rows), Eigen::MatrixXcd::Zero(rows, columns)};
  for (Index i = 0; i < rows; ++i) {
    double size = 0;
    for (const Term& term : f.polynomials[static_cast<std::size_t>(i)].terms) {
      const Complex c = to_complex(term.coefficient);
      const Complex whole = c * product_of(term.monomial, term.monomial.size(), x);
      at.value[i] += whole;
      size += std::abs(whole);
      for (std::size_t k = 0; k < term.monomial.size(); ++k) {
        const auto [variable, exponent] = term.monomial[k];
        at.jacobian(i, static_cast<Index>(variable)) += c * static_cast<double>(exponent) *
                                                        power(x[variable], exponent - 1) *
                                                        product_of(term.monomial, k, x);
      }
    }
    if (!(size > 0)) continue;
    at.value[i] /= size;
    at.jacobian.row(i) /= size;
  }
  return at;
}

}  // namespace

double residual_when_polished(const Formulation& formulation, Point root) {
  constexpr int kSteps =
      4;  // a root's error is squared each time; beside a near miss they stand still
  for (int k = 0; k < kSteps; ++k) {
    const Linearized at = linearized(formulation.system, root);
    const Eigen::VectorXcd step = PivotedQr<Complex>(at.jacobian).solve(at.value);
    if (!step.allFinite()) break;
    for (Index v = 0; v < step.size(); ++v) root[static_cast<std::size_t>(v)] -= step[v];
  }
  return residual_of_root(formulation, root);
}

}  // namespace moivre
