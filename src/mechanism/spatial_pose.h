// SPDX-License-Identifier: MIT
// Where is a point of a spatial body? Pose q_b = [x, y, z, rotation vector], by a unit quaternion
// inside.
//
// The rotation vector v turns by |v| about v; its quaternion (cos |v|/2, v sin(|v|/2)/|v|) has norm
// 1 by construction and is smooth at v = 0. The map is singular at |v| = 2 pi only; Phi::canonical
// keeps |v| <= pi.
#pragma once

#include <Eigen/Core>
#include <array>

#include "constraint.h"

namespace moivre::spatial {

inline constexpr std::size_t kSize = 6;  ///< coordinates a body

template <class S>
struct Vector {
  S x, y, z;
};

inline Vector<Jet> constant(const Eigen::Vector3d& v) { return {v.x(), v.y(), v.z()}; }

template <class S>
Vector<S> in_scalar(const Vector<Jet>& v) {
  return {moivre::in_scalar<S>(v.x), moivre::in_scalar<S>(v.y), moivre::in_scalar<S>(v.z)};
}

template <class S>
Vector<S> operator+(const Vector<S>& a, const Vector<S>& b) {
  return {a.x + b.x, a.y + b.y, a.z + b.z};
}
template <class S>
Vector<S> operator-(const Vector<S>& a, const Vector<S>& b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}
template <class S>
Vector<S> operator*(const S& k, const Vector<S>& a) {
  return {k * a.x, k * a.y, k * a.z};
}
template <class S>
S dot(const Vector<S>& a, const Vector<S>& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}
template <class S>
Vector<S> cross(const Vector<S>& a, const Vector<S>& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

/// w + v, of norm 1 where it is a rotation.
template <class S>
struct Quaternion {
  S w;
  Vector<S> v;
};

template <class S>
Quaternion<S> operator*(const Quaternion<S>& a, const Quaternion<S>& b) {
  return {a.w * b.w - dot(a.v, b.v), a.w * b.v + b.w * a.v + cross(a.v, b.v)};
}

template <class S>
Quaternion<S> conjugate(const Quaternion<S>& a) {
  return {a.w, S(-1) * a.v};
}

/// s turned by the unit quaternion: s + 2 v x (v x s + w s).
template <class S>
Vector<S> turned(const Quaternion<S>& a, const Vector<S>& s) {
  return s + S(2) * cross(a.v, cross(a.v, s) + a.w * s);
}

/// sin(r)/r and its first two derivatives in u = r^2: an even function of r, so smooth at u = 0.
std::array<double, 3> sine_quotient(double u);

/// Quaternion of the rotation vector v.
template <class S>
Quaternion<S> quaternion(const Vector<S>& v) {
  const S u = S(0.25) * dot(v, v);  // (|v| / 2)^2
  const auto [g, dg, ddg] = sine_quotient(u.f);
  const S w = chain(u, std::cos(std::sqrt(u.f)), -0.5 * g, -0.5 * dg);
  return {w, S(0.5) * chain(u, g, dg, ddg) * v};
}

template <class S>
Quaternion<S> orientation(const At<S>& at, std::size_t body) {
  if (body == 0) return {S(1), {S(0), S(0), S(0)}};
  const std::size_t k = kSize * (body - 1) + 3;
  return quaternion(Vector<S>{at.q[k], at.q[k + 1], at.q[k + 2]});
}

/// A direction fixed in the body, seen from the ground.
template <class S>
Vector<S> direction(const At<S>& at, std::size_t body, const Vector<Jet>& s) {
  if (body == 0) return in_scalar<S>(s);
  return turned(orientation(at, body), in_scalar<S>(s));
}
template <class S>
Vector<S> direction(const At<S>& at, std::size_t body, const Eigen::Vector3d& s) {
  return direction(at, body, constant(s));
}

/// r + R s
template <class S>
Vector<S> position(const At<S>& at, std::size_t body, const Vector<Jet>& s) {
  const Vector<S> offset = direction(at, body, s);
  if (body == 0) return offset;
  const std::size_t k = kSize * (body - 1);
  return Vector<S>{at.q[k], at.q[k + 1], at.q[k + 2]} + offset;
}

/// A joint's frame in a body: z along the axis, x by a fixed rule (so equal axes make equal
/// frames).
Eigen::Matrix3d axis_frame(const Eigen::Vector3d& axis);

}  // namespace moivre::spatial
