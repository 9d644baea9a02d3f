// SPDX-License-Identifier: MIT
// What values do a designer's quantities take along each branch of a motion, which are the least
// and the largest, and how quick is the return?
//
//   values    of every quantity (design/quantity.h) at every sample; angles that turn go on from
//             (-pi, pi] at the branch's begin
//   extremes  the least and the largest over the branch, refined between the samples by Brent's
//             minimization of the motion itself.
//             If the samples show an extreme, its value is exact to rounding. A spike between two
//             samples is not seen. Events count as samples if the quantity is defined there. At a
//             dead point velocities have no bound; the extreme is then unbounded, at the time of
//             the dead point. An advantage is unbounded where the output stands still for an
//             instant.
//   time ratio  of an output over the first turn of the only driver, an angle at constant speed.
//               The output is at its least at t1
//             and at its largest at t2. The ratio is the longer of the two times between them over
//             the shorter one, >= 1 [Norton12, 3.4]. There is none if the output turns fully, or
//             has not returned after the turn.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "moivre/design/quantity.h"
#include "moivre/motion/motion.h"

namespace moivre {

struct Extreme {
  double value = 0;  ///< NaN: not known; of an unbounded one, infinite with its sign
  double time = 0;
  bool is_refined = false;  ///< between samples; else of a sample or an event
  bool is_unbounded() const;
};

struct Extremes {
  Extreme least;
  Extreme largest;
};

struct TimeRatio {
  std::string output;
  double ratio = 1;       ///< longer / shorter
  double rising_s = 0;    ///< from the least to the largest
  double falling_s = 0;   ///< and back; both together are a turn of the driver
  double from = 0;        ///< the least value
  double to = 0;          ///< the largest
  bool is_angle = false;  ///< of `from` and `to`: radians
};

struct BranchReadings {
  std::string id;
  std::vector<std::vector<double>> values;  ///< [sample][quantity]; NaN where not defined
  std::vector<Extremes> extremes;           ///< one per quantity; none where not asked for
  std::vector<TimeRatio> time_ratios;       ///< of the outputs that have one
};

struct Readings {
  std::vector<Quantity> quantities;      ///< those that are defined somewhere on a branch
  std::vector<BranchReadings> branches;  ///< as in the motion
};

/// Extremes and time ratios take several times as long as the values.
Readings read_motion(const MotionResult& motion, const Mechanism& mechanism,
                     const QuantityReader& reader, bool with_extremes = true);

}  // namespace moivre
