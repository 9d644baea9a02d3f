// SPDX-License-Identifier: MIT
// What lies between two places where a function, its slope and its bend are known? The polynomial
// of degree five that has all six.
//
//   p(x) = a f(0) + slope_a f'(0) + bend_a f''(0) + b f(h) + slope_b f'(h) + bend_b f''(h)
// h in the unit of x, h != 0, x on either side of 0 and h. x may be a Taylor number
// (mechanism/jet.h), then so are the weights.
// a and b have no unit, slope_a and slope_b that of x, bend_a and bend_b its square.
#pragma once

namespace moivre {

template <class S>
struct QuinticWeights {
  S a, slope_a, bend_a;
  S b, slope_b, bend_b;
};

template <class S>
QuinticWeights<S> quintic_weights(const S& x, double h) {
  const S s = (1 / h) * x;
  const S r = 1 - s;
  const S s3 = s * s * s;
  const S r3 = r * r * r;
  return {r3 * (1 + 3 * s + 6 * s * s), h * s * r3 * (1 + 3 * s),  h * h / 2 * s * s * r3,
          s3 * (1 + 3 * r + 6 * r * r), -h * r * s3 * (1 + 3 * r), h * h / 2 * r * r * s3};
}

}  // namespace moivre
