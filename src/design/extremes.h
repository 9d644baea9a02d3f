// SPDX-License-Identifier: MIT
// Where along a branch is a function of its samples least and largest, between the samples too?
#pragma once

#include <functional>

#include "moivre/design/readings.h"

namespace moivre {

/// A function along a branch: its values at the samples and the events, and anywhere.
struct Series {
  std::vector<double> times;         ///< increasing
  std::vector<double> values;        ///< NaN where there is none
  std::function<double(double)> at;  ///< in between; NaN where not known
};

/// `sign` 1: the largest value; -1: the least.
Extreme extreme_of(const Series& curve, int sign);

}  // namespace moivre
