// SPDX-License-Identifier: MIT
// How is a rigid displacement written so that products of displacements are polynomials? As a dual quaternion, up to a factor.
//
// g = q + eps d, eps^2 = 0, eight numbers (q_w, q_x, q_y, q_z, d_w, d_x, d_y, d_z); q turns, d = t q / 2 for a displacement by t after
// it. Every nonzero multiple is the same displacement, and q . d = 0 (Study's quadric). Products are in the order of transforms:
// g h first does h. Numbers may be integers of any length, rationals, double or complex.
// Source: [HustyPfurnerSchroecker07].
#pragma once

#include <array>
#include <cstddef>

namespace moivre {

template <class S>
using DualQuaternion = std::array<S, 8>;

/// out += a b of the quaternions that begin at these places.
template <class S>
void add_quaternion_product(const S* a, const S* b, S* out) {
  out[0] += a[0] * b[0] - a[1] * b[1] - a[2] * b[2] - a[3] * b[3];
  out[1] += a[0] * b[1] + a[1] * b[0] + a[2] * b[3] - a[3] * b[2];
  out[2] += a[0] * b[2] - a[1] * b[3] + a[2] * b[0] + a[3] * b[1];
  out[3] += a[0] * b[3] + a[1] * b[2] - a[2] * b[1] + a[3] * b[0];
}

template <class S>
DualQuaternion<S> operator*(const DualQuaternion<S>& a, const DualQuaternion<S>& b) {
  DualQuaternion<S> c{};
  add_quaternion_product(a.data(), b.data(), c.data());
  add_quaternion_product(a.data(), b.data() + 4, c.data() + 4);
  add_quaternion_product(a.data() + 4, b.data(), c.data() + 4);
  return c;
}

/// The displacement back, up to a factor.
template <class S>
DualQuaternion<S> conjugate(const DualQuaternion<S>& a) {
  return {a[0], -a[1], -a[2], -a[3], a[4], -a[5], -a[6], -a[7]};
}

}  // namespace moivre
