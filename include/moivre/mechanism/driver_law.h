// SPDX-License-Identifier: MIT
// What does a driver prescribe at time t? A value with two derivatives, from a parabola, a table or
// a typed expression.
//
//   parabola    f(t) = start + velocity t + acceleration t^2 / 2
//   table       natural cubic spline through (t_k, f_k), continued by its end tangents (twice
//               continuously differentiable)
//   expression  typed in t, differentiated by Taylor arithmetic
// Angles in radians, lengths in the file's unit, t in seconds.
#pragma once

#include <variant>
#include <vector>

#include "moivre/mechanism/formula.h"

namespace moivre {

struct Parabola {
  double start = 0;
  double velocity = 0;
  double acceleration = 0;
};

/// Natural cubic spline: second derivative 0 at both ends. Made by `natural_spline`.
struct Spline {
  std::vector<double> t;
  std::vector<double> value;
  std::vector<double> curvature;  ///< second derivative at each t_k
};

/// Requires two or more points, t strictly increasing (std::invalid_argument).
Spline natural_spline(std::vector<double> t, std::vector<double> value);

/// A periodic cubic spline, twice continuously differentiable from one period to the next: the last
/// value is the first. Requires four or more points, t strictly increasing (std::invalid_argument).
Spline periodic_spline(std::vector<double> t, std::vector<double> value);

/// `unit` * formula(t): the formula speaks in the file's unit.
struct TypedLaw {
  Formula formula;
  double unit = 1;
};

using DriverLaw = std::variant<Parabola, Spline, TypedLaw>;

/// f(t), f'(t), f''(t).
struct DriverState {
  double value = 0;
  double velocity = 0;
  double acceleration = 0;
};

DriverState driver_state(const DriverLaw& law, double t);

/// Throws InvalidInput where the law has no value at any time: a table without two rows of three
/// numbers, a formula that lacks an operand.
void require_law(const DriverLaw& law);

/// Of a periodic spline, any number of periods away.
DriverState periodic_state(const Spline& spline, double t);

}  // namespace moivre
