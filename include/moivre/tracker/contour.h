// SPDX-License-Identifier: MIT
// Along which curve in the complex t-plane is a path followed? t(s) for s in [0, 1]: a segment or a spiral.
//
//   segment:  t(s) = a + (b - a) s
//   spiral:   t(s) = c + (a - c) e^{lambda s}     lambda = 2 pi i m: m turns round c;
//                                                 lambda = -log q: straight towards c, q times nearer
// A spiral towards t = 1 is how an endgame approaches: functions of (1 - t)^{1/m} are smooth in log(1 - t).
#pragma once

#include <cmath>

#include "moivre/numeric/complex.h"

namespace moivre {

class Contour {
 public:
  static Contour segment(Complex from, Complex to) {
    return Contour(Kind::segment, from, to - from, to);
  }
  static Contour spiral(Complex centre, Complex from, Complex lambda) {
    return Contour(Kind::spiral, from, lambda, centre);
  }

  Complex t(double s) const {
    if (kind_ == Kind::segment) return s == 1 ? to_ : from_ + rate_ * s;
    return to_ + (from_ - to_) * std::exp(rate_ * s);
  }
  /// dt/ds.
  Complex dt(double s) const {
    if (kind_ == Kind::segment) return rate_;
    return (from_ - to_) * rate_ * std::exp(rate_ * s);
  }

 private:
  enum class Kind { segment, spiral };
  Contour(Kind kind, Complex from, Complex rate, Complex to)
      : kind_(kind), from_(from), rate_(rate), to_(to) {}

  Kind kind_;
  Complex from_;  // a
  Complex rate_;  // b - a, or lambda
  Complex to_;    // b, or c
};

}  // namespace moivre
