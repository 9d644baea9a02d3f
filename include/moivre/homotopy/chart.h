// SPDX-License-Identifier: MIT
// Which coordinates does a homotopy use? n unknowns and x_0, in one projective space.
//
//   x = (x_1, ..., x_n, x_0), N = n + 1 coordinates;  affine point: x_j / x_0;  x_0 = 0 is infinity
//
// Edges: the affine coordinates of a point at infinity are infinite.
#pragma once

#include <algorithm>
#include <cstddef>
#include <span>

#include "moivre/numeric/complex.h"

namespace moivre {

struct Chart {
  std::size_t unknowns = 0;

  std::size_t coordinates() const { return unknowns + 1; }
  /// Which coordinate is x_0.
  std::size_t homogenizing() const { return unknowns; }
  const Complex& x0(std::span<const Complex> x) const { return x[homogenizing()]; }

  /// |x_0| / |x|_inf: how far the point is from infinity.
  double finiteness(std::span<const Complex> x) const {
    double largest = 0;
    for (const Complex& xi : x) largest = std::max(largest, std::abs(xi));
    return std::abs(x0(x)) / largest;
  }
  /// (x_1 / x_0, ..., x_n / x_0).
  Point affine(std::span<const Complex> x) const {
    Point y(x.begin(), x.begin() + static_cast<std::ptrdiff_t>(unknowns));
    for (Complex& yi : y) yi /= x0(x);
    return y;
  }
  /// The point with x_0 = 1.
  Point homogeneous(std::span<const Complex> y) const {
    Point x(y.begin(), y.end());
    x.push_back(1);
    return x;
  }
};

}  // namespace moivre
