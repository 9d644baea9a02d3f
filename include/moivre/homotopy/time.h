// SPDX-License-Identifier: MIT
// Where on a path is a point? t together with 1 - t, because near t = 1 the difference would lose
// the digits of 1 - t.
#pragma once

#include "moivre/numeric/complex.h"

namespace moivre {

template <class S>
struct Time {
  Time(const S& value) : t(value), rest(S(1.0) - value) {}
  Time(const S& value, const S& one_minus_value) : t(value), rest(one_minus_value) {}

  S t;
  S rest;
};
using PathTime = Time<Complex>;

}  // namespace moivre
