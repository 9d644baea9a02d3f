// SPDX-License-Identifier: MIT
// Which equations hold for the joints outside the cut? Polynomials in their tangents, one for each.
//
// The product of the rest of the loop, backwards, must lie in the cut's space W. Where there are
// more equations than unknowns, random combinations of them; roots that fail one are found out when
// they are read back.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "cut.h"
#include "moivre/numeric/exact_displacement.h"
#include "moivre/numeric/random.h"
#include "moivre/polynomial/system.h"

namespace moivre {

/// The product of the tangents of bits that are set: t_k+1 for bit k.
Monomial multilinear(std::size_t bits);

/// As large as the largest: a combination of forms of different sizes would be the largest alone.
std::vector<ExactDisplacement> of_one_size(std::vector<ExactDisplacement> forms);

/// `count` random combinations of the forms, with whole numbers.
template <class S>
std::vector<DualQuaternion<S>> combinations(const std::vector<DualQuaternion<S>>& forms,
                                            std::size_t count, std::uint64_t seed) {
  constexpr double kLargestWeight = 1 << 16;
  // Numbers of joints come before these in the stream.
  std::uint64_t number = 1000;
  std::vector<DualQuaternion<S>> mixed(count);
  for (DualQuaternion<S>& sum : mixed) {
    for (const DualQuaternion<S>& form : forms) {
      const double weight = random_unit(seed, RandomStream::arm, number++) - 0.5;
      sum = sum + S(static_cast<std::int64_t>(weight * kLargestWeight)) * form;
    }
  }
  return mixed;
}

/// t1, t2, ...: of the joints outside.
std::vector<std::string> tangent_names(const Cut& cut);

/// Unknowns t1, t2, ...: the tangents s/c of cut.outside, in that order; none where all joints are
/// inside.
System cut_equations(const Loop& loop, const Cut& cut, std::uint64_t seed);

}  // namespace moivre
