// SPDX-License-Identifier: MIT
// Where is a point of a planar body? Pose q_b = [x, y, phi], point r + A(phi) s, in the scalar of
// the coordinates.
#pragma once

#include <Eigen/Core>

#include "constraint.h"

namespace moivre::planar {

inline constexpr std::size_t kSize = 3;  ///< coordinates a body

template <class S>
struct Vector {
  S x;
  S y;
};

template <class S>
Vector<S> operator-(const Vector<S>& a, const Vector<S>& b) {
  return {a.x - b.x, a.y - b.y};
}

/// Angle of a body to the ground; the ground's is 0.
template <class S>
S angle(const At<S>& at, std::size_t body) {
  return body == 0 ? S(0) : at.q[kSize * (body - 1) + 2];
}

/// A(phi) s: a direction fixed in the body, seen from the ground.
template <class S>
Vector<S> direction(const At<S>& at, std::size_t body, const Vector<Jet>& s) {
  const auto x = in_scalar<S>(s.x);
  const auto y = in_scalar<S>(s.y);
  if (body == 0) return {S(x), S(y)};
  const auto [c, k] = cosine_and_sine(angle(at, body));
  return {x * c - y * k, x * k + y * c};
}
template <class S>
Vector<S> direction(const At<S>& at, std::size_t body, const Eigen::Vector3d& s) {
  return direction(at, body, Vector<Jet>{s.x(), s.y()});
}

/// r + A(phi) s
template <class S>
Vector<S> position(const At<S>& at, std::size_t body, const Vector<Jet>& s) {
  const Vector<S> offset = direction(at, body, s);
  if (body == 0) return offset;
  return {at.q[kSize * (body - 1)] + offset.x, at.q[kSize * (body - 1) + 1] + offset.y};
}

}  // namespace moivre::planar
