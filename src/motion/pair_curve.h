// SPDX-License-Identifier: MIT
// Where do two closures that are not real become real, and for how long?
//
// The curve of a pair (pair_equations.h) is followed by arc length, and s is watched along it:
//   s changes sign      two real roots begin, or end
//   s has a maximum     it is located; above zero two real roots live for a while, however short
// A step is so short that s is known within it: its second-order prediction and that of its slope
// miss by a small part only. A maximum that all but touches zero is decided in double-double.
// Edges: a curve ends at `from`, at `to`, where the roots stay real, where they go to infinity, and
// where it cannot be followed, as where three roots meet.
#pragma once

#include <atomic>
#include <functional>

#include "pair_equations.h"

namespace moivre {

/// Of the motion's duration: real roots that live no longer than this are looked for on the curve
/// itself.
inline constexpr double kBriefest = 1e-6;

/// Two real roots that live from one time to another.
struct RealWhile {
  std::array<double, 2> times{};  ///< s = 0; seconds, ascending
  double at = 0;                  ///< in between
  std::array<Point, 2> roots;     ///< there
  std::array<Point, 2> meetings;  ///< at `times`, where both are one
};

struct PairCurve {
  bool is_lost = false;  ///< it could not be followed to its end
  double last = 0;       ///< time of its end
  std::vector<double>
      borders;  ///< times at which the roots meet or go to infinity, or the curve turns back
  std::vector<RealWhile> short_lives;
  /// Times at which the curve goes back while its roots are real: three are, and one of them
  /// between the dead points of the others.
  std::vector<double> fold_backs;
  std::vector<double> undecided;  ///< times of maxima at which s is zero but for rounding
};

/// Told of each of the times that the curve passes; returns whether to go on.
using PassingPair = std::function<bool(std::size_t number, const Point& x)>;

/// Follows the pair of x from `time`, forwards or backwards at first, between tau = 0 and 1.
/// `times`: at which `passing` is called.
PairCurve follow_pair(const PairEquations& equations, const Point& x, double time, bool forwards,
                      const std::vector<double>& times, const PassingPair& passing,
                      const std::atomic<bool>& stop);

}  // namespace moivre
