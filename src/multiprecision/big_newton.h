// SPDX-License-Identifier: MIT
// How near does Newton's method on F come in D digits? With the bound that its last correction
// gives.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "big_complex.h"
#include "moivre/factorization/dense_lu.h"
#include "moivre/polynomial/tape.h"
#include "smale_bound.h"

namespace moivre {

/// F in D digits with the memory for evaluating it; one a thread.
template <unsigned D>
class BigNewton {
 public:
  using Number = BigComplex<D>;
  using Real = BigReal<D>;

  BigNewton(const System& f, const Tape& tape, const RowNorms& norms)
      : tape_(tape),
        norms_(norms),
        n_(tape.variables),
        c_(round_coefficients<Number>(tape, f, [](const Coefficient& c) { return to_big<D>(c); })),
        registers_(tape.register_count()),
        value_(tape.equations),
        jacobian_(tape.jacobian.size()),
        size_registers_(tape.register_count()),
        size_value_(tape.equations),
        lu_(n_) {
    for (const Number& ck : c_) size_c_.push_back(sqrt(norm(ck)));
  }

  /// dx <- -J^{-1} F(x). False where J is singular.
  bool correction(const std::vector<Number>& x, std::vector<Number>& dx) {
    evaluate<Number, Number>(tape_, c_, x, registers_, value_, jacobian_);
    const auto j = lu_.matrix();
    std::fill(j.begin(), j.end(), Number(0.0));
    for (std::size_t k = 0; k < jacobian_.size(); ++k) {
      const Tape::Entry& entry = tape_.jacobian[k];
      j[entry.row * n_ + entry.column] = jacobian_[k];
    }
    if (!lu_.factor()) return false;
    for (std::size_t i = 0; i < n_; ++i) dx[i] = -value_[i];
    lu_.solve(dx);
    return true;
  }

  /// |x - x*|_2 for the x and dx of the last correction; nullopt where they prove nothing.
  std::optional<Real> bound(const std::vector<Number>& x, const std::vector<Number>& dx) {
    const double degree = *std::max_element(norms_.degree.begin(), norms_.degree.end());
    if (degree > kLargestDegree) return std::nullopt;
    const std::vector<Real> rounding = evaluation_errors(x);
    Real size(1);
    for (const Number& xi : x) size += norm(xi);
    size = sqrt(size);
    Real weighted(0);  // |J^{-1} Delta|_F^2, rows of F divided by their norms
    Real lost(0);      // |J^{-1}| times the evaluation's errors
    std::vector<Number> column(n_);
    for (std::size_t i = 0; i < n_; ++i) {
      std::fill(column.begin(), column.end(), Number(0.0));
      column[i] = Number(1.0);
      lu_.solve(column);
      Real squared(0);
      for (const Number& entry : column) squared += norm(entry);
      const Real delta = row_size(i) * sqrt(Real(norms_.degree[i])) *
                         pow(size, static_cast<int>(norms_.degree[i]) - 1);
      weighted += squared * delta * delta;
      lost += sqrt(squared) * rounding[i];
    }
    Real beta = lost;
    beta += sqrt(squared_norm(dx));
    Real mu = sqrt(Real(static_cast<double>(n_)) * weighted);
    if (mu < 1) mu = 1;
    const Real gamma = mu * (degree * std::sqrt(degree) / 2) / size;
    if (!(beta * gamma < kLargestAlpha)) return std::nullopt;
    return 2 * beta;
  }

 private:
  // Below (13 - 3 sqrt 17) / 4 = 0.15767...
  static constexpr double kLargestAlpha = 0.157;
  // Powers of more than an int are not taken.
  static constexpr double kLargestDegree = std::numeric_limits<int>::max();
  // Roundings of one complex product, in units of the last place.
  static constexpr double kProductError = 4;

  static Real squared_norm(const std::vector<Number>& v) {
    Real sum(0);
    for (const Number& vi : v) sum += norm(vi);
    return sum;
  }

  Real row_size(std::size_t i) const { return exp2(Real(norms_.log2_norm[i])); }

  /// Bound on what rounding did to each F_i(x): every term's size times the roundings that it went
  /// through.
  std::vector<Real> evaluation_errors(const std::vector<Number>& x) {
    std::vector<Real> size_x;
    for (const Number& xi : x) size_x.push_back(sqrt(norm(xi)));
    evaluate<Real, Real>(tape_, size_c_, size_x, size_registers_, size_value_);
    const double degree = *std::max_element(norms_.degree.begin(), norms_.degree.end());
    const Real unit =
        std::numeric_limits<Real>::epsilon() * (kProductError * (degree + 2) + norms_.terms);
    std::vector<Real> errors = size_value_;
    for (Real& error : errors) error *= unit;
    return errors;
  }

  const Tape& tape_;
  const RowNorms& norms_;
  std::size_t n_;
  std::vector<Number> c_;
  std::vector<Real> size_c_;
  std::vector<Number> registers_, value_, jacobian_;
  std::vector<Real> size_registers_, size_value_;
  DenseLu<Number> lu_;
};

}  // namespace moivre
