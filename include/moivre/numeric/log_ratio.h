// SPDX-License-Identifier: MIT
// How is log(a / b) of two doubles found in a real type of more digits?
//
//   a / b = 2^e m, 1 / sqrt 2 < m < sqrt 2;  log m = 2 z (1 + z^2 (1/3 + z^2 (1/5 + ...))), z = (m
//                                            - 1) / (m + 1)
//
// |z| < (sqrt 2 - 1) / (sqrt 2 + 1) = 0.1716, so each term adds a digit and a half, and more where
// a / b is near a power of two.
// A division takes as long as several terms: 1/3, 1/5, ... are made once.
// Edges: a, b > 0 and finite. S: the complex scalar whose real type it is (numeric/scalar.h).
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <vector>

#include "moivre/numeric/scalar.h"

namespace moivre {

template <class S>
class LogRatio {
  using Real = typename Scalar<S>::Real;

 public:
  LogRatio() {
    for (std::size_t k = 0; k < terms_for(kLargest); ++k) {
      odd_reciprocals_.push_back(Real(1.0) / Real(static_cast<double>(2 * k + 1)));
    }
    const Real half = log_of(7, 5);
    log2_ = half + half + log_of(50, 49);
  }

  Real operator()(double a, double b) const {
    int ea = 0;
    int eb = 0;
    double ma = std::frexp(a, &ea);
    double mb = std::frexp(b, &eb);
    if (ma > std::numbers::sqrt2 * mb) {
      mb *= 2;
      --eb;
    } else if (mb > std::numbers::sqrt2 * ma) {
      ma *= 2;
      --ea;
    }
    return Real(static_cast<double>(ea - eb)) * log2_ + log_of(ma, mb);
  }

 private:
  static constexpr double kLargest = 0.172;  // |z|, rounded up

  /// Of the series, to the last digit.
  static std::size_t terms_for(double z) {
    return static_cast<std::size_t>(std::log(Scalar<S>::epsilon) / std::log(z * z)) + 2;
  }

  /// log(p / q), 1 / sqrt 2 <= p / q <= sqrt 2.
  Real log_of(double p, double q) const {
    std::size_t k = std::min(terms_for((p - q) / (p + q)), odd_reciprocals_.size()) - 1;
    const Real z = (Real(p) - Real(q)) / (Real(p) + Real(q));
    const Real square = z * z;
    Real sum = odd_reciprocals_[k];
    while (k-- > 0) sum = odd_reciprocals_[k] + square * sum;
    return (z + z) * sum;
  }

  std::vector<Real> odd_reciprocals_;
  Real log2_;
};

}  // namespace moivre
