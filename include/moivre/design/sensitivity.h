// SPDX-License-Identifier: MIT
// How far do the closures move when a dimension is off, and how far when all of them are, within
// their tolerances?
//
//   rates[i][k] = d x_i / d p_k, total: the pose moves with the dimension, and a point may itself
//   be the dimension
//   x   all coordinates of q, the places of the moving bodies' points, the joints' angles and
//       slides (mechanism/pose.h)
//   p   dimensions, by the names of mechanism/dimensions.h
//   worst case       sum_k |rates[i][k]| tolerance_k       every dimension off by all it may, each
//                    to the worse side
//   root sum square  sqrt(sum_k (rates[i][k] tolerance_k)^2)  of dimensions that are off
//                    independently of each other: where the tolerances are standard deviations, or
//                    one multiple of them, so is this
// Both are of first order: they hold while x_i is nearly linear over the tolerances. The furthest
// point of each closure shows whether it is (`corner`): the mechanism is solved again with every
// dimension at its worst sign, up and down.
// NaN is "there is none": at a dead point, by a dimension that cannot change alone
// (kinematics/sensitivity.h), of what spins freely, and of a spread to which such a rate would
// contribute. Dimensions with tolerance 0 contribute nothing.
// Angles in radians, lengths in the file's unit. Idle joints are held, as in closures.
// Not supported: typed equations (std::invalid_argument); closures by least squares, which are told
// to have none.
#pragma once

#include <Eigen/Core>
#include <optional>
#include <string>
#include <vector>

#include "moivre/closures/closures.h"
#include "moivre/mechanism/dimensions.h"

namespace moivre {

enum class SensitiveGroup { coordinate, point, joint };

struct SensitiveQuantity {
  SensitiveGroup group = SensitiveGroup::coordinate;
  std::string name;  ///< "crank.phi", "coupler.P", "A"
  CoordinateKind kind = CoordinateKind::length;
  PointOf point;          ///< point
  int axis = 0;           ///< point: 0 x, 1 y, 2 z
  std::size_t joint = 0;  ///< joint
};

/// The point's coordinate with the largest worst case, and how far it goes when the mechanism is
/// closed there by Newton-Raphson.
struct SolvedCorner {
  std::size_t quantity = 0;
  std::optional<double> up;  ///< none: no closure was found, the tolerances may be too wide for one
  std::optional<double> down;  ///< below 0
};

struct ClosureSensitivity {
  std::string id;
  std::string missing;                ///< why there are no rates, a clause; empty: there are
  std::vector<std::size_t> breaking;  ///< dimensions that cannot change alone
  Eigen::MatrixXd rates;              ///< quantities x dimensions
  Eigen::VectorXd worst_case;         ///< one per quantity
  Eigen::VectorXd root_sum_square;
  std::optional<SolvedCorner> corner;  ///< none where there are no tolerances, or no spread
};

struct Sensitivities {
  std::vector<Dimension> dimensions;
  std::vector<double> values;      ///< one per dimension
  std::vector<double> tolerances;  ///< one per dimension
  std::vector<SensitiveQuantity> quantities;
  std::vector<ClosureSensitivity> closures;  ///< as in the result

  bool has_tolerances() const;
};

/// Throws std::invalid_argument with the reason where the mechanism has no dimensions to vary.
void require_dimensions(const Mechanism& mechanism);

Sensitivities closure_sensitivities(const Mechanism& mechanism, const ClosureResult& result);

}  // namespace moivre
