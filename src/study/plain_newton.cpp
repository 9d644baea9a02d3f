// SPDX-License-Identifier: MIT
// Newton's method in double, stopped where rounding stops it.
#include "plain_newton.h"

#include <Eigen/LU>
#include <cmath>
#include <limits>

namespace moivre {
namespace {

// From an error of 0.1 six doublings of the digits reach double's; the rest is for slow starts.
constexpr int kMaximumIterations = 20;
// Corrections that do not shrink by this any more are made of rounding errors.
constexpr double kShrinking = 0.5;

}  // namespace

PlainNewton::PlainNewton(const System& f)
    : tape_(make_tape(f)), coefficients_(complex_coefficients(tape_, f)) {}

Point PlainNewton::polish(Point x) const {
  const auto n = static_cast<Eigen::Index>(x.size());
  std::vector<Complex> registers(tape_.register_count());
  std::vector<Complex> entries(tape_.jacobian.size());
  Eigen::VectorXcd value(n);
  double previous = std::numeric_limits<double>::infinity();
  for (int k = 0; k < kMaximumIterations; ++k) {
    evaluate<Complex, Complex>(tape_, coefficients_, x, registers,
                               {value.data(), static_cast<std::size_t>(n)}, entries);
    Eigen::MatrixXcd jacobian = Eigen::MatrixXcd::Zero(n, n);
    for (std::size_t e = 0; e < entries.size(); ++e) {
      jacobian(tape_.jacobian[e].row, tape_.jacobian[e].column) = entries[e];
    }
    const Eigen::VectorXcd dx = jacobian.partialPivLu().solve(value);
    const double size = dx.cwiseAbs().maxCoeff();
    if (!std::isfinite(size) || size > kShrinking * previous) return x;
    for (Eigen::Index i = 0; i < n; ++i) x[static_cast<std::size_t>(i)] -= dx[i];
    if (size == 0) return x;
    previous = size;
  }
  return x;
}

}  // namespace moivre
