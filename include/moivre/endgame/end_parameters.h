// SPDX-License-Identifier: MIT
// By which numbers is the end of a path judged, and why may it stay open? All numbers, and where
// each comes from.
//
// docs/algorithms/end-of-path.md shows the decisions that they stand in. No verdict hangs on the
// exact value of any:
// bench/end_parameters changes each by a factor of four (docs/results/end-parameters.md).
//
//   s = 1 - t; u = 2^-53, the rounding of double
//   Edges: a path that the rules with these numbers do not decide has failed; nothing is guessed.
// Sources: [MSW91] for the circles, [HuberVerschelde98] for valuations.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace moivre {

struct EndParameters {
  // Circles in s.
  /// From here on a path is watched, for where to turn back to: the branch points of most
  /// homotopies lie nearer to t = 1.
  double watch_radius = 0.1;
  /// A path that still takes small steps here does not end at a regular point, to which it would
  /// have jumped.
  double creeping_radius = 1e-4;
  /// No first circle is smaller: others of its cycle may have been seen last farther out, and all
  /// radii are this one times a power of `shrink`.
  double first_radius = 1e-4;
  /// No circle is smaller: s = r e^{i theta} moves the coefficients by r, of which this leaves two
  /// digits above u.
  double least_radius = 1e-14;
  /// From one circle to the next: a cycle of m sheets ends (1/4)^{1/m} nearer.
  double shrink = 4;
  /// Points of one turn. The error of their mean falls as (r / r')^{N m}, r' the next branch point:
  /// u at 0.1 of it.
  int samples = 16;
  /// Turns after which a circle counts as not closing. Who has more sheets fails.
  int maximum_winding = 32;
  /// Accepted steps of one path near t = 1; then nothing more is tried.
  std::uint64_t maximum_steps = 6000;

  // How well points are known, relative to their size.
  /// Newton's method at t = 1 in double ends here, u times the operations of a residual; x_0 below
  /// it may be 0.
  double rounding = 1e-13;
  /// Of a sample: the trackers' corrections end below it.
  double sample_error = 1e-10;
  /// Two points are one: a circle closes, two circles have one mean.
  double agreement = 1e-6;

  // The Jacobian, bordered and with its rows scaled.
  /// Up to this condition a point reached at t = 1 is a regular end: Newton's method has half of
  /// double's digits to work with.
  double regular_condition = 1e8;
  /// From this condition on a mean of samples is a singular end: u times it is the square root of
  /// `rounding`.
  double singular_condition = 1e10;

  // Infinity.
  /// A power sum that is no more than so many times its error is 0.
  double zero_sum = 4;
  /// |x| of an end, in the units of the system, from which double does not tell it from infinity: 1
  /// / (10 sample_error).
  double beyond = 1e11;
  /// x_0 of a finite end is more than so many times its error.
  double known_size = 10;
  /// Of a leading exponent, on a circle on which it is steady; the denominators are at most
  /// maximum_winding.
  double valuation_error = 0.03;
  /// Singular values of a face's Jacobian below it, relative to the largest, are the torus' that
  /// acts on its roots.
  double face_threshold = 1e-6;
  /// Where a step on a face changes its value by less than this share `face_threshold` falls by it.
  double face_progress = 0.1;
  /// What vanishes in double-double, relative to its terms: 2^-104 times the operations of a face.
  double fine_rounding = 1e-26;
};

/// Every broken rule as a sentence; empty when the numbers can be used.
std::vector<std::string> validate(const EndParameters& ends);

struct EndgameOptions {
  /// The path is followed towards t = 1 as far as it leads before circles are tried: useful with
  /// many digits.
  bool goes_straight = false;
  bool only_regular = false;  ///< an end that is not regular is a failure: no circle is tried
  /// So many within the creeping radius tell creeping from a step that chanced to end there.
  int creeping_steps = 3;
  bool may_wait = false;   ///< for other paths of its cycle, after each turn
  bool goes_back = false;  ///< from an end that circles have given: PathEnd::sheet
  EndParameters ends;
};

/// Why a path failed.
enum class Failure {
  step_limit,      ///< the budget of steps was used up
  step_too_small,  ///< the path could not be followed any further, far from t = 1
  precision,       ///< the endgame's estimates do not agree in this precision
  bad_start,       ///< Newton does not converge from the start point
  cancelled,       ///< the run was interrupted
  jumped           ///< its end belongs to another path, and tracking it again did not help
};
std::string to_string(Failure failure);

}  // namespace moivre
