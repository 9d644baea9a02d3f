// SPDX-License-Identifier: MIT
// A result of solve() made by hand: one real root, one double root, one failed path, one path at
// infinity.
#pragma once

#include "moivre/solver/solve.h"

namespace moivre::test {

inline SolveResult hand_made_result() {
  SolveResult result;
  result.complete = false;
  result.message = "some paths failed";
  result.seed = 7;
  result.system = {{"x", "alpha"}, {2, 3}, 6};
  result.reduced = result.system;
  result.start.paths = 6;
  result.start.why = "the product of the degrees";
  result.tracker = "cvode";
  result.tracker_options = {
      {"method", "bdf_projection"}, {"rtol", 0.01}, {"maximum_steps", std::int64_t{200}}};
  result.paths = {6, 3, 1, 2, 0, 0, 4, 0, 1, 2};
  Solution real;
  real.path = 1;
  real.x = {{0.1, 0}, {-2.5, 0}};
  real.real = true;
  real.residual = 1e-17;
  real.accuracy = 1e-16;
  real.condition = 12.5;
  Solution twofold;
  twofold.path = 3;
  twofold.x = {{1.0 / 3, 1e-20}, {0.5, -0.25}};
  twofold.singular = true;
  twofold.multiplicity = 2;
  twofold.winding = {2};
  twofold.accuracy = 1e-8;
  twofold.condition = 1e15;
  result.solutions = {real, twofold};
  result.failures = {{2, Failure::step_limit, {0.5, 0}}, {5, Failure::jumped, {1, 0}}};
  result.left_out = {{"z eliminated", "a linear equation gives it"}};
  result.work.accepted = 100;
  result.work.rejected = 10;
  result.work.work = {.values = 50, .fine_values = 0, .linearizations = 40, .factorizations = 30};
  result.time.threads = 2;
  result.time.total = 0.25;
  return result;
}

}  // namespace moivre::test
