// SPDX-License-Identifier: MIT
// How does a formula change along several directions at once? First-order arithmetic with a few
// partial derivatives.
//
// A formula written once for a scalar type S (jet.h) gives with S = Gradient up to `kDirections`
// columns of a Jacobian at the cost of one evaluation of its functions. Each partial is computed as
// a Jet's first derivative is.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>

namespace moivre {

struct Gradient {
  /// The coordinates of two planar bodies, or of one spatial body.
  static constexpr std::size_t kDirections = 6;

  /// Partial derivatives, in whole registers: read otherwise than they were written, they would
  /// wait for each other.
  alignas(16) std::array<double, kDirections> d{};
  double f = 0;

  Gradient() = default;
  Gradient(double value)
      : f(value) {}  // NOLINT(google-explicit-constructor): a number is a constant gradient
};

inline Gradient operator+(Gradient a, const Gradient& b) {
  a.f += b.f;
  for (std::size_t k = 0; k < Gradient::kDirections; ++k) a.d[k] += b.d[k];
  return a;
}
inline Gradient operator-(Gradient a, const Gradient& b) {
  a.f -= b.f;
  for (std::size_t k = 0; k < Gradient::kDirections; ++k) a.d[k] -= b.d[k];
  return a;
}
inline Gradient operator-(Gradient a) {
  a.f = -a.f;
  for (double& d : a.d) d = -d;
  return a;
}
inline Gradient operator*(Gradient a, const Gradient& b) {
  for (std::size_t k = 0; k < Gradient::kDirections; ++k) a.d[k] = a.d[k] * b.f + a.f * b.d[k];
  a.f *= b.f;
  return a;
}
inline Gradient operator*(double c, Gradient a) {
  for (double& d : a.d) d *= c;
  a.f *= c;
  return a;
}

/// g(a), given g and g' at a.f.
inline Gradient chain(Gradient a, double g, double dg, double) {
  for (double& d : a.d) d *= dg;
  a.f = g;
  return a;
}

/// The angle of (x, y), smooth along a curve that avoids the origin.
inline Gradient atan2(Gradient y, const Gradient& x) {
  const double square = x.f * x.f + y.f * y.f;
  for (std::size_t k = 0; k < Gradient::kDirections; ++k) {
    y.d[k] = (x.f * y.d[k] - y.f * x.d[k]) / square;
  }
  y.f = std::atan2(y.f, x.f);
  return y;
}

}  // namespace moivre
