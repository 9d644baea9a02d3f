// SPDX-License-Identifier: MIT
// How are poses multiplied, whatever their numbers are? Dual quaternions over rationals, polynomials or doubles.
//
//   X = q + eps g,  eps^2 = 0;  a turn q and a shift d:  g = d q / 2,  d = 2 g conj(q) / |q|^2.
// X is a pose where q . g = 0 and q != 0, and k X is the same pose for every number k != 0: Study's quadric in P^7. So nothing
// has to be of norm 1, and rational poses stay rational.
// Symbols: q, g four numbers each, the first the real part; conj turns the signs of the other three.
// Source: [HustySchroecker10].
#pragma once

#include <array>
#include <cstddef>

namespace moivre {

template <class T>
using Quaternion = std::array<T, 4>;

template <class T>
struct DualQuaternion {
  Quaternion<T> q{};
  Quaternion<T> g{};
};

template <class T>
Quaternion<T> product(const Quaternion<T>& a, const Quaternion<T>& b) {
  return {a[0] * b[0] - a[1] * b[1] - a[2] * b[2] - a[3] * b[3],
          a[0] * b[1] + a[1] * b[0] + a[2] * b[3] - a[3] * b[2],
          a[0] * b[2] - a[1] * b[3] + a[2] * b[0] + a[3] * b[1],
          a[0] * b[3] + a[1] * b[2] - a[2] * b[1] + a[3] * b[0]};
}

template <class T>
Quaternion<T> sum(const Quaternion<T>& a, const Quaternion<T>& b) {
  return {a[0] + b[0], a[1] + b[1], a[2] + b[2], a[3] + b[3]};
}

template <class T>
Quaternion<T> scaled(const T& k, const Quaternion<T>& a) {
  return {k * a[0], k * a[1], k * a[2], k * a[3]};
}

template <class T>
T dot(const Quaternion<T>& a, const Quaternion<T>& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2] + a[3] * b[3];
}

template <class T>
Quaternion<T> conjugate(const Quaternion<T>& a) {
  return {a[0], -a[1], -a[2], -a[3]};
}

template <class T>
DualQuaternion<T> operator*(const DualQuaternion<T>& a, const DualQuaternion<T>& b) {
  return {product(a.q, b.q), sum(product(a.q, b.g), product(a.g, b.q))};
}

template <class T>
DualQuaternion<T> operator+(const DualQuaternion<T>& a, const DualQuaternion<T>& b) {
  return {sum(a.q, b.q), sum(a.g, b.g)};
}

template <class T>
DualQuaternion<T> operator*(const T& k, const DualQuaternion<T>& a) {
  return {scaled(k, a.q), scaled(k, a.g)};
}

/// The inverse pose, up to a factor.
template <class T>
DualQuaternion<T> conjugate(const DualQuaternion<T>& a) {
  return {conjugate(a.q), conjugate(a.g)};
}

/// d, behind a first number that is 0.
template <class T>
Quaternion<T> shift_of(const DualQuaternion<T>& a) {
  return scaled(T(2) / dot(a.q, a.q), product(a.g, conjugate(a.q)));
}

/// Number k of the eight: q, then g.
template <class T>
T& entry(DualQuaternion<T>& a, std::size_t k) {
  return k < 4 ? a.q[k] : a.g[k - 4];
}
template <class T>
const T& entry(const DualQuaternion<T>& a, std::size_t k) {
  return k < 4 ? a.q[k] : a.g[k - 4];
}

inline constexpr std::size_t kEntries = 8;

}  // namespace moivre
