// SPDX-License-Identifier: MIT
// What do the errors of a file's numbers change in something computed from them? To first order a
// sum over the numbers a,
//
//   dc = sum_a (dc/da) error(a),
//
// kept apart by number: where a number enters twice, its effects may cancel, and bounds on each
// would not know.
// Edges: no change at all is the empty list; a bound is a bound to first order only.
// Source: [Wilkinson63].
#pragma once

#include <cstdint>
#include <vector>

#include "moivre/numeric/complex.h"

namespace moivre {

/// (dc/da) error(a) of number a.
struct NumberError {
  std::uint32_t number = 0;  ///< a, counted over the file's rounded numbers
  Complex change = 0;
};

/// Of one quantity, by ascending number.
using NumberErrors = std::vector<NumberError>;

/// sum += factor * errors.
void add(NumberErrors& sum, const Complex& factor, const NumberErrors& errors);

/// sum_a |change|: no system that the file may mean has more.
double bound(const NumberErrors& errors);

}  // namespace moivre
