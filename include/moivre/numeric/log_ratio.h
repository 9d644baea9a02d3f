// SPDX-License-Identifier: MIT
// log(a / b) of two doubles in a real type of more digits than double.
//
//   a / b = 2^e m_a / m_b, m in [1/2, 1);  log(m_a / m_b) = 2 (z + z^3 / 3 + z^5 / 5 + ...), z = (m_a - m_b) / (m_a + m_b)
//
// |z| <= 1/3, so each term adds a digit. Edges: a, b > 0 and finite. S: the complex scalar whose real type it is (numeric/scalar.h).
#pragma once

#include <cmath>

#include "moivre/numeric/scalar.h"

namespace moivre {

template <class S>
class LogRatio {
  using Real = typename Scalar<S>::Real;

 public:
  LogRatio() : log2_(log_of(Real(2.0), Real(1.0))) {}

  Real operator()(double a, double b) const {
    int ea = 0;
    int eb = 0;
    const Real ma(std::frexp(a, &ea));
    const Real mb(std::frexp(b, &eb));
    return Real(static_cast<double>(ea - eb)) * log2_ + log_of(ma, mb);
  }

 private:
  /// log(p / q), 1/2 <= p / q <= 2.
  static Real log_of(const Real& p, const Real& q) {
    constexpr double kRatio = 9;
    const Real z = (p - q) / (p + q);
    const Real square = z * z;
    Real power = z + z;
    Real sum = power;
    double odd = 1;
    for (double size = 1; size > Scalar<S>::epsilon; size /= kRatio) {
      power = power * square;
      odd += 2;
      sum = sum + power / Real(odd);
    }
    return sum;
  }

  Real log2_;
};

}  // namespace moivre
