// SPDX-License-Identifier: MIT
// How are rigid displacements multiplied, whatever their numbers are? As dual quaternions:
// integers, rationals, polynomials, doubles.
//
//   X = q + eps g,  eps^2 = 0;  a turn q and a shift d behind it:  g = d q / 2,  d = 2 g conj(q) /
//                               |q|^2.
// X is a displacement where q . g = 0 and q != 0, and k X is the same one for every number k != 0:
// Study's quadric in P^7. So nothing has to be of norm 1, and rational displacements stay rational.
// Products are in the order of transforms: X Y does Y first.
// Symbols: q, g four numbers each, the first the real part; conj turns the signs of the other
// three; X[k] number k of the eight, q first.
// Sources: [HustySchroecker10], [HustyPfurnerSchroecker07].
#pragma once

#include <array>
#include <cstddef>

namespace moivre {

template <class T>
using Quaternion = std::array<T, 4>;

template <class T>
struct DualQuaternion {
  static constexpr std::size_t size() { return 8; }
  static DualQuaternion identity() { return {{T(1), T(0), T(0), T(0)}, {}}; }

  T& operator[](std::size_t k) { return k < 4 ? q[k] : g[k - 4]; }
  const T& operator[](std::size_t k) const { return k < 4 ? q[k] : g[k - 4]; }

  Quaternion<T> q{};
  Quaternion<T> g{};
};

template <class S, class T>
auto product(const Quaternion<S>& a, const Quaternion<T>& b) {
  return Quaternion<decltype(a[0] * b[0])>{a[0] * b[0] - a[1] * b[1] - a[2] * b[2] - a[3] * b[3],
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

template <class S, class T>
auto operator*(const DualQuaternion<S>& a, const DualQuaternion<T>& b) {
  return DualQuaternion<decltype(a.q[0] * b.q[0])>{product(a.q, b.q),
                                                   sum(product(a.q, b.g), product(a.g, b.q))};
}

template <class T>
DualQuaternion<T> operator+(const DualQuaternion<T>& a, const DualQuaternion<T>& b) {
  return {sum(a.q, b.q), sum(a.g, b.g)};
}

template <class T>
DualQuaternion<T> operator*(const T& k, const DualQuaternion<T>& a) {
  return {scaled(k, a.q), scaled(k, a.g)};
}

/// The displacement back, up to a factor.
template <class T>
DualQuaternion<T> conjugate(const DualQuaternion<T>& a) {
  return {conjugate(a.q), conjugate(a.g)};
}

/// f of each of the eight numbers.
template <class T, class F>
auto mapped(const DualQuaternion<T>& a, const F& f) {
  DualQuaternion<decltype(f(a[0]))> image;
  for (std::size_t k = 0; k < a.size(); ++k) image[k] = f(a[k]);
  return image;
}

/// The sum of the parts of a linear form times those of a displacement.
template <class T>
T value(const DualQuaternion<T>& form, const DualQuaternion<T>& a) {
  return dot(form.q, a.q) + dot(form.g, a.g);
}

/// d, behind a first number that is 0.
template <class T>
Quaternion<T> shift_of(const DualQuaternion<T>& a) {
  return scaled(T(2) / dot(a.q, a.q), product(a.g, conjugate(a.q)));
}

}  // namespace moivre
