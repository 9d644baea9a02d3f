// SPDX-License-Identifier: MIT
// Along which curve in the complex t-plane is a path followed? t(s) for s in [0, 1]: a segment or a
// spiral.
//
//   segment:  t(s) = a + (b - a) s
//   spiral:   t(s) = 1 - r e^{lambda s}     lambda = 2 pi i m: m turns round t = 1;
//                                           lambda = -log q: straight towards t = 1, q times nearer
// A spiral towards t = 1 is how an endgame approaches: functions of (1 - t)^{1/m} are smooth in
// log(1 - t). Near t = 1 the homotopy depends on its weight 1 - t. So contours give 1 - t with all
// its digits, besides t.
#pragma once

#include <cmath>

#include "moivre/homotopy/time.h"

namespace moivre {

class Contour {
 public:
  static Contour segment(Complex from, Complex to) {
    return Contour(Kind::segment, from, 1.0 - from, to - from, to);
  }
  /// Straight from t = 1 - rest to t = 1.
  static Contour landing(Complex rest) { return Contour(Kind::segment, 1.0 - rest, rest, rest, 1); }
  /// About t = 1, from t = 1 - rest.
  static Contour spiral(Complex rest, Complex lambda) {
    return Contour(Kind::spiral, 1.0 - rest, rest, lambda, 1);
  }

  PathTime at(double s) const {
    if (kind_ == Kind::segment) {
      if (s == 1) return {to_, 1.0 - to_};
      return {from_ + rate_ * s, rest_ - rate_ * s};
    }
    const Complex rest = product(rest_, std::exp(rate_ * s));
    return {1.0 - rest, rest};
  }
  /// The point s = 1 - left, with all the digits of `left`.
  PathTime before_end(double left) const {
    if (kind_ == Kind::segment) return {to_ - rate_ * left, (1.0 - to_) + rate_ * left};
    return at(1 - left);
  }
  /// The point s, given left = 1 - s too: with all the digits of the smaller one.
  PathTime at(double s, double left) const { return s < 0.5 ? at(s) : before_end(left); }
  /// A segment to t = 1.
  bool ends_at_one() const { return kind_ == Kind::segment && to_ == 1.0; }
  /// dt/ds.
  Complex dt(double s) const {
    if (kind_ == Kind::segment) return rate_;
    return -product(rest_, product(rate_, std::exp(rate_ * s)));
  }
  /// The same, where t(s) is known.
  Complex dt(const PathTime& t) const {
    return kind_ == Kind::segment ? rate_ : -product(rate_, t.rest);
  }

 private:
  enum class Kind { segment, spiral };
  Contour(Kind kind, Complex from, Complex rest, Complex rate, Complex to)
      : kind_(kind), from_(from), rest_(rest), rate_(rate), to_(to) {}

  Kind kind_;
  Complex from_;  // t(0)
  Complex rest_;  // 1 - t(0)
  Complex rate_;  // b - a, or lambda
  Complex to_;    // b of a segment
};

}  // namespace moivre
