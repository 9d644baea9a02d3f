// SPDX-License-Identifier: MIT
// How does a formula change along a line? Second-order Taylor arithmetic, and its twin that sums
// magnitudes of terms.
//
// A Jet is (f, f', f'') of a function of one parameter s. A formula written once for a scalar type
// S gives
//   S = Jet along e_k        -> one column of the Jacobian (f'); S = Gradient (gradient.h) has
//                            several at once
//   S = Jet along (q', 1)    -> (Phi_q q')_q q' + 2 Phi_qt q' + Phi_tt (f''), the acceleration
//                            terms at once
//   S = Magnitude            -> the sum of |terms|, the scale against which |Phi_i| is small or
//                            not.
// Both take plain doubles as constants. Where a function is not defined (sqrt(-1)) the result is
// NaN.
#pragma once

#include <cmath>
#include <utility>

namespace moivre {

struct Jet {
  double f = 0;
  double d = 0;   ///< first derivative along the line
  double dd = 0;  ///< second derivative along the line

  Jet() = default;
  Jet(double value)
      : f(value) {}  // NOLINT(google-explicit-constructor): a number is a constant jet
  Jet(double value, double first, double second) : f(value), d(first), dd(second) {}
};

inline Jet operator+(const Jet& a, const Jet& b) { return {a.f + b.f, a.d + b.d, a.dd + b.dd}; }
inline Jet operator-(const Jet& a, const Jet& b) { return {a.f - b.f, a.d - b.d, a.dd - b.dd}; }
inline Jet operator-(const Jet& a) { return {-a.f, -a.d, -a.dd}; }
inline Jet operator*(const Jet& a, const Jet& b) {
  return {a.f * b.f, a.d * b.f + a.f * b.d, a.dd * b.f + 2 * a.d * b.d + a.f * b.dd};
}

/// g(a), given g, g' and g'' at a.f (Faa di Bruno to second order).
inline Jet chain(const Jet& a, double g, double dg, double ddg) {
  return {g, dg * a.d, ddg * a.d * a.d + dg * a.dd};
}

/// Value and sum of the magnitudes of the terms it was added up from.
struct Magnitude {
  double f = 0;
  double sum = 0;

  Magnitude() = default;
  Magnitude(double value)
      : f(value), sum(std::abs(value)) {}  // NOLINT(google-explicit-constructor)
  Magnitude(double value, double magnitude) : f(value), sum(magnitude) {}
};

inline Magnitude operator+(const Magnitude& a, const Magnitude& b) {
  return {a.f + b.f, a.sum + b.sum};
}
inline Magnitude operator-(const Magnitude& a, const Magnitude& b) {
  return {a.f - b.f, a.sum + b.sum};
}
inline Magnitude operator-(const Magnitude& a) { return {-a.f, a.sum}; }
inline Magnitude operator*(const Magnitude& a, const Magnitude& b) {
  return {a.f * b.f, a.sum * b.sum};
}

/// The magnitude of a function is its value plus what its argument's terms contribute to first
/// order. So near a zero of sin(a) the scale is that of a, not zero.
inline Magnitude chain(const Magnitude& a, double g, double dg, double) {
  return {g, std::abs(g) + std::abs(dg) * a.sum};
}

template <class S>
S sin(const S& a) {
  const double s = std::sin(a.f);
  return chain(a, s, std::cos(a.f), -s);
}

template <class S>
S cos(const S& a) {
  const double c = std::cos(a.f);
  return chain(a, c, -std::sin(a.f), -c);
}

/// cos(a) and sin(a).
template <class S>
std::pair<S, S> cosine_and_sine(const S& a) {
  const double c = std::cos(a.f);
  const double s = std::sin(a.f);
  return {chain(a, c, -s, -c), chain(a, s, c, -s)};
}

template <class S>
S tan(const S& a) {
  const double g = std::tan(a.f);
  const double slope = 1 + g * g;
  return chain(a, g, slope, 2 * g * slope);
}

template <class S>
S asin(const S& a) {
  const double w = 1 / std::sqrt(1 - a.f * a.f);
  return chain(a, std::asin(a.f), w, a.f * w * w * w);
}

template <class S>
S acos(const S& a) {
  const double w = 1 / std::sqrt(1 - a.f * a.f);
  return chain(a, std::acos(a.f), -w, -a.f * w * w * w);
}

template <class S>
S atan(const S& a) {
  const double w = 1 / (1 + a.f * a.f);
  return chain(a, std::atan(a.f), w, -2 * a.f * w * w);
}

template <class S>
S sqrt(const S& a) {
  const double g = std::sqrt(a.f);
  return chain(a, g, 0.5 / g, -0.25 / (g * a.f));
}

template <class S>
S exp(const S& a) {
  const double g = std::exp(a.f);
  return chain(a, g, g, g);
}

template <class S>
S log(const S& a) {
  return chain(a, std::log(a.f), 1 / a.f, -1 / (a.f * a.f));
}

template <class S>
S reciprocal(const S& a) {
  const double g = 1 / a.f;
  return chain(a, g, -g * g, 2 * g * g * g);
}

/// a^p for a constant p. The derivatives that vanish (p = 0, p = 1) are zero at a = 0 too.
template <class S>
S power(const S& a, double p) {
  const double slope = p == 0 ? 0 : p * std::pow(a.f, p - 1);
  const double bend = p == 0 || p == 1 ? 0 : p * (p - 1) * std::pow(a.f, p - 2);
  return chain(a, std::pow(a.f, p), slope, bend);
}

/// The angle of (x, y), smooth along a curve that avoids the origin.
inline Jet atan2(const Jet& y, const Jet& x) {
  const double square = x.f * x.f + y.f * y.f;
  const double first = (x.f * y.d - y.f * x.d) / square;
  const double second = (x.f * y.dd - y.f * x.dd - 2 * first * (x.f * x.d + y.f * y.d)) / square;
  return {std::atan2(y.f, x.f), first, second};
}
inline Magnitude atan2(const Magnitude& y, const Magnitude& x) {
  const double g = std::atan2(y.f, x.f);
  const double square = x.f * x.f + y.f * y.f;
  return {g, std::abs(g) + (std::abs(x.f) * y.sum + std::abs(y.f) * x.sum) / square};
}

/// a minus the whole turns nearest to it: an angle in [-pi, pi]. The turns count as a term.
template <class S>
S within_half_turn(const S& a) {
  constexpr double kTurn = 6.283185307179586476925286766559;
  return a - S(kTurn * std::round(a.f / kTurn));
}

}  // namespace moivre
