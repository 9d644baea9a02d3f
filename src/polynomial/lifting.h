// SPDX-License-Identifier: MIT
// Which rational point solves n linear equations in n unknowns, where the numbers on the way of an
// elimination would be long?
//
//   A x = b   A: n x n integers, regular modulo p = 2^61 - 31; b: n integers
//   A is factored once, modulo p. Each digit of x to the base p then is the solution for what is
//   left of b, which stays as short as A. So many digits that only one fraction with numerator and
//   denominator within Hadamard's bound has them are lifted, and that fraction is x
//   [Dixon82].
//
// n^3 / 3 operations of words, and n^2 for a digit; A is factored as a dense one.
// Edges: none where A is singular modulo p, and where `stop` is set meanwhile. n = 0 has the empty
// point.
// Private to the module.
#pragma once

#include <atomic>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

#include "moivre/numeric/integer.h"

namespace moivre {

/// sum_k a_k x_place_k = right
struct LinearEquation {
  std::vector<std::pair<std::size_t, Integer>> terms;
  Integer right;
};

/// x_j = numerators[j] / denominator, which is positive.
struct RationalPoint {
  std::vector<Integer> numerators;
  Integer denominator = 1;
};

/// Of as many equations as unknowns, whose places are less than that.
std::optional<RationalPoint> lifted_solution(const std::vector<LinearEquation>& equations,
                                             const std::atomic<bool>* stop);

}  // namespace moivre
