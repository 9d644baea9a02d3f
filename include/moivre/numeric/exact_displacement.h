// SPDX-License-Identifier: MIT
// Which linear forms vanish on some displacements of integers, and which tell coordinates among
// them? Exactly, without fractions.
//
// A factor changes no displacement: rational ones become integers. A form is an element of the dual
// space (value() of dual_quaternion.h).
// Which forms: multiples of rows that are 1 in a column of their own, 0 in those of the others. The
// other columns are those of the largest pivots, lengths counting in units of `length`, so that no
// form is nearly the sum of others.
#pragma once

#include <vector>

#include "moivre/numeric/dual_quaternion.h"
#include "moivre/numeric/integer.h"

namespace moivre {

using ExactDisplacement = DualQuaternion<Integer>;

/// Without the factor that all eight share.
ExactDisplacement reduced(ExactDisplacement g);
/// The least number that makes all of them whole; and one of them times that.
Integer common_denominator(const std::vector<DualQuaternion<Rational>>& all);
ExactDisplacement whole(const DualQuaternion<Rational>& g, const Integer& common);
/// The largest of the eight, as a modulus.
Integer largest_part(const ExactDisplacement& g);
/// Numbers as doubles, relative to the largest; one is not 0.
DualQuaternion<double> rounded(const ExactDisplacement& g);

/// A basis of the forms that vanish on all `vectors`; 8 less their rank.
std::vector<ExactDisplacement> vanishing_forms(const std::vector<ExactDisplacement>& vectors,
                                               double length = 1);

/// Values on the span of linearly independent vectors: `factor` times the coordinates of a
/// displacement among them.
struct CoordinateForms {
  std::vector<ExactDisplacement> forms;
  Integer factor;
};
CoordinateForms coordinate_forms(const std::vector<ExactDisplacement>& vectors, double length = 1);

}  // namespace moivre
