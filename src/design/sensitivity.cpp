// SPDX-License-Identifier: MIT
// Rates of everything that a closure tells, by every dimension, and the spreads that tolerances
// make of them.
#include "moivre/design/sensitivity.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "moivre/closures/idle_joints.h"
#include "moivre/kinematics/newton.h"
#include "moivre/kinematics/sensitivity.h"
#include "moivre/mechanism/dimension_rates.h"
#include "moivre/mechanism/joint_type.h"
#include "moivre/mechanism/pose.h"
#include "moivre/numeric/invalid_input.h"

namespace moivre {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::RowVectorXd;
using Eigen::VectorXd;

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

void add_points(const Mechanism& mechanism, std::vector<SensitiveQuantity>& all) {
  const int axes = mechanism.space == Space::planar ? 2 : 3;
  for (std::size_t body = 1; body < mechanism.bodies.size(); ++body) {
    for (std::size_t k = 0; k < mechanism.bodies[body].points.size(); ++k) {
      const std::string name =
          mechanism.bodies[body].name + "." + mechanism.bodies[body].points[k].name;
      for (int axis = 0; axis < axes; ++axis) {
        all.push_back(
            {SensitiveGroup::point, name, CoordinateKind::length, PointOf{body, k}, axis, 0});
      }
    }
  }
}

/// Those that have one coordinate, in any pose.
void add_joints(const Mechanism& mechanism, std::vector<SensitiveQuantity>& all) {
  const VectorXd rest = VectorXd::Zero(static_cast<Index>(coordinates(mechanism).size()));
  for (std::size_t k = 0; k < mechanism.joints.size(); ++k) {
    const Joint& joint = mechanism.joints[k];
    if (!joint_coordinate(mechanism, joint, rest)) continue;
    const bool turns = is_angular(joint.type);
    all.push_back({SensitiveGroup::joint, joint.name,
                   turns ? CoordinateKind::angle : CoordinateKind::length, PointOf{}, 0, k});
  }
}

std::vector<SensitiveQuantity> quantities_of(const Mechanism& mechanism) {
  std::vector<SensitiveQuantity> all;
  for (const Coordinate& coordinate : coordinates(mechanism)) {
    all.push_back({SensitiveGroup::coordinate, coordinate.name, coordinate.kind, {}, 0, 0});
  }
  add_points(mechanism, all);
  add_joints(mechanism, all);
  return all;
}

/// How everything moves with q and with the dimensions, at one pose.
class Rates {
 public:
  Rates(const Mechanism& mechanism, const Sensitivities& told, const VectorXd& q)
      : mechanism_(mechanism), told_(told), q_(q), coordinates_(coordinates(mechanism)) {}

  /// dx/dq, a row.
  RowVectorXd by_pose(std::size_t quantity) const;
  /// dx/dp at a pose that stands, a row.
  RowVectorXd by_dimensions(std::size_t quantity) const;

 private:
  double rate(const SensitiveQuantity& quantity, const VectorXd& qdot,
              const Dimension* dimension) const;
  bool moves_with(const SensitiveQuantity& quantity, std::size_t body) const;
  bool reads(const SensitiveQuantity& quantity, const Dimension& dimension) const;

  const Mechanism& mechanism_;
  const Sensitivities& told_;
  const VectorXd& q_;
  std::vector<Coordinate> coordinates_;
};

double Rates::rate(const SensitiveQuantity& quantity, const VectorXd& qdot,
                   const Dimension* dimension) const {
  if (quantity.group == SensitiveGroup::point) {
    return point_rate(mechanism_, quantity.point, q_, qdot, dimension)[quantity.axis];
  }
  return joint_rate(mechanism_, mechanism_.joints[quantity.joint], q_, qdot, dimension)
      .value_or(kNone);
}

bool Rates::moves_with(const SensitiveQuantity& quantity, std::size_t body) const {
  if (quantity.group == SensitiveGroup::point) return quantity.point.body == body;
  const auto& ends = mechanism_.joints[quantity.joint].at;
  return ends[0].body == body || ends[1].body == body;
}

bool Rates::reads(const SensitiveQuantity& quantity, const Dimension& dimension) const {
  if (dimension.kind != DimensionKind::point) return false;
  const auto is_at = [&](const PointOf& point) {
    return dimension.point.body == point.body && dimension.point.point == point.point;
  };
  if (quantity.group == SensitiveGroup::point) return is_at(quantity.point);
  const auto& ends = mechanism_.joints[quantity.joint].at;
  return is_at(ends[0]) || is_at(ends[1]);
}

RowVectorXd Rates::by_pose(std::size_t number) const {
  const SensitiveQuantity& quantity = told_.quantities[number];
  // Coordinates are the first quantities, in the order of q.
  if (quantity.group == SensitiveGroup::coordinate) {
    return RowVectorXd::Unit(q_.size(), static_cast<Index>(number));
  }
  RowVectorXd row = RowVectorXd::Zero(q_.size());
  for (Index k = 0; k < q_.size(); ++k) {
    const std::size_t body = coordinates_[static_cast<std::size_t>(k)].group + 1;
    if (moves_with(quantity, body)) {
      row[k] = rate(quantity, VectorXd::Unit(q_.size(), k), nullptr);
    }
  }
  return row;
}

RowVectorXd Rates::by_dimensions(std::size_t number) const {
  const SensitiveQuantity& quantity = told_.quantities[number];
  RowVectorXd row = RowVectorXd::Zero(static_cast<Index>(told_.dimensions.size()));
  if (quantity.group == SensitiveGroup::coordinate) return row;
  const VectorXd rest = VectorXd::Zero(q_.size());
  for (std::size_t k = 0; k < told_.dimensions.size(); ++k) {
    if (reads(quantity, told_.dimensions[k])) {
      row[static_cast<Index>(k)] = rate(quantity, rest, &told_.dimensions[k]);
    }
  }
  return row;
}

/// Whether the quantity moves though no dimension does, as what spins freely. `unit`: the
/// mechanism's length, or a radian.
bool is_free(const RowVectorXd& by_pose, const MatrixXd& free, double unit) {
  // Of what the freedom can do to something of the mechanism's size: poses are known to about
  // 1e-13.
  constexpr double kStandsStill = 1e-7;
  for (Index k = 0; k < free.cols(); ++k) {
    const double moved = std::abs(by_pose.dot(free.col(k)));
    if (moved > kStandsStill * unit * free.col(k).cwiseAbs().maxCoeff()) return true;
  }
  return false;
}

void add_spreads(const std::vector<double>& tolerances, ClosureSensitivity& closure) {
  const Index count = closure.rates.rows();
  closure.worst_case = VectorXd::Zero(count);
  closure.root_sum_square = VectorXd::Zero(count);
  for (std::size_t k = 0; k < tolerances.size(); ++k) {
    if (tolerances[k] == 0) continue;
    const VectorXd share = closure.rates.col(static_cast<Index>(k)).cwiseAbs() * tolerances[k];
    closure.worst_case += share;
    closure.root_sum_square += share.cwiseAbs2();
  }
  closure.root_sum_square = closure.root_sum_square.cwiseSqrt();
}

/// The point's coordinate with the largest worst case; nullopt where none has one.
std::optional<std::size_t> furthest(const Sensitivities& told, const ClosureSensitivity& closure) {
  // Points that two bodies share go equally far, except for rounding: the first of them.
  constexpr double kFurther = 1 + 1e-9;
  std::optional<std::size_t> found;
  for (std::size_t i = 0; i < told.quantities.size(); ++i) {
    const double spread = closure.worst_case[static_cast<Index>(i)];
    if (told.quantities[i].group != SensitiveGroup::point || !(spread > 0)) continue;
    if (!found || spread > kFurther * closure.worst_case[static_cast<Index>(*found)]) found = i;
  }
  return found;
}

/// How far the quantity goes with every dimension off to one side; nullopt where Newton-Raphson
/// finds no closure.
std::optional<double> solved_at_corner(const Mechanism& mechanism, const Sensitivities& told,
                                       const ClosureSensitivity& closure, std::size_t quantity,
                                       double side, const VectorXd& q, double time) {
  Mechanism changed = mechanism;
  VectorXd guess = q;
  for (std::size_t k = 0; k < told.dimensions.size(); ++k) {
    const auto column = closure.rates.col(static_cast<Index>(k));
    if (told.tolerances[k] == 0) continue;
    const bool falls = column[static_cast<Index>(quantity)] < 0;
    const double off = (falls ? -side : side) * told.tolerances[k];
    set_dimension(changed, told.dimensions[k], told.values[k] + off);
    // Coordinates are the first quantities; those that spin freely stay.
    guess += off * column.head(q.size()).unaryExpr([](double x) { return std::isnan(x) ? 0 : x; });
  }
  const NewtonResult solved = newton(Phi(changed), guess, time);
  if (solved.status != NewtonStatus::converged) return std::nullopt;
  const SensitiveQuantity& at = told.quantities[quantity];
  return point_position(changed, at.point, solved.q)[at.axis] -
         point_position(mechanism, at.point, q)[at.axis];
}

/// Why a closure has no rates; empty where it has.
std::string missing_rates(const Closure& closure, bool is_singular) {
  if (closure.is_fitted) return "it closes by least squares only";
  if (!is_singular) return "";
  return "it is a dead point, where sensitivities have no bound";
}

/// Whether the mechanism does not close once the dimension has changed by a small step, though to
/// first order it would: a crank of three parallel ones grows by the square of what its pin is
/// moved aside.
bool breaks_beyond_first_order(const Mechanism& mechanism, const Dimension& dimension,
                               const VectorXd& rate, const VectorXd& q, double time) {
  // Of a radian or the mechanism's length; its square is far above rounding. Where the pose moves
  // fast the step is smaller.
  constexpr double kStep = 1e-3;
  const double length = Phi(mechanism).length();
  const double unit = dimension.is_angle ? 1 : length;
  const double swiftness = rate.cwiseAbs().maxCoeff() * unit / std::min(1.0, length);
  const double step = kStep * unit / std::max(1.0, swiftness);
  Mechanism changed = mechanism;
  set_dimension(changed, dimension, dimension_value(mechanism, dimension, time) + step);
  return newton(Phi(changed), q + step * rate, time).status == NewtonStatus::no_solution;
}

ClosureSensitivity sensitivity_of(const Mechanism& mechanism, const Phi& phi,
                                  const Closure& closure, double time, Index spins,
                                  const Sensitivities& told) {
  const MatrixXd partial = partial_dimensions(mechanism, told.dimensions, closure.q, time);
  const bool is_multiple = closure.singular || closure.multiplicity > 1;
  PoseSensitivity pose =
      pose_sensitivity(phi, closure.q, time, partial, PoseKind{spins, is_multiple});
  ClosureSensitivity result;
  result.id = closure.id;
  result.missing = missing_rates(closure, pose.is_singular);
  for (Index k = 0; k < partial.cols(); ++k) {
    const bool is_missing = !result.missing.empty() && !partial.col(k).isZero(0);
    if (is_missing) pose.rates.col(k).setConstant(kNone);
    if (is_missing) continue;
    const auto number = static_cast<std::size_t>(k);
    bool breaks = pose.breaks_closure[number];
    if (!breaks && pose.has_spare_rows && !partial.col(k).isZero(0)) {
      breaks = breaks_beyond_first_order(mechanism, told.dimensions[number], pose.rates.col(k),
                                         closure.q, time);
      if (breaks) pose.rates.col(k).setConstant(kNone);
    }
    if (breaks) result.breaking.push_back(number);
  }
  const Rates rates(mechanism, told, closure.q);
  result.rates.resize(static_cast<Index>(told.quantities.size()), partial.cols());
  for (std::size_t i = 0; i < told.quantities.size(); ++i) {
    const RowVectorXd by_pose = rates.by_pose(i);
    auto row = result.rates.row(static_cast<Index>(i));
    row = by_pose * pose.rates + rates.by_dimensions(i);
    const bool is_length = told.quantities[i].kind == CoordinateKind::length;
    if (is_free(by_pose, pose.free, is_length ? phi.length() : 1)) row.setConstant(kNone);
  }
  add_spreads(told.tolerances, result);
  if (const auto quantity = furthest(told, result)) {
    const auto solved = [&](double side) {
      return solved_at_corner(mechanism, told, result, *quantity, side, closure.q, time);
    };
    result.corner = SolvedCorner{*quantity, solved(1), solved(-1)};
  }
  return result;
}

}  // namespace

bool Sensitivities::has_tolerances() const {
  return std::any_of(tolerances.begin(), tolerances.end(), [](double x) { return x > 0; });
}

void require_dimensions(const Mechanism& mechanism) {
  if (!is_typed(mechanism)) return;
  throw InvalidInput(
      "typed equations have no dimensions to vary: sensitivities are of mechanisms with bodies and "
      "joints");
}

Sensitivities closure_sensitivities(const Mechanism& mechanism, const ClosureResult& result) {
  require_dimensions(mechanism);
  Sensitivities told;
  told.dimensions = dimensions(mechanism);
  for (const Dimension& dimension : told.dimensions) {
    told.values.push_back(dimension_value(mechanism, dimension, result.time));
    told.tolerances.push_back(dimension_tolerance(mechanism, dimension));
  }
  told.quantities = quantities_of(mechanism);
  Mechanism held = hold_idle(mechanism).mechanism;
  // What spins has no derivative, however it is held.
  const auto spins = static_cast<Index>(std::exchange(held.held_spins, {}).size());
  const Phi phi(held);
  for (const Closure& closure : result.closures) {
    told.closures.push_back(sensitivity_of(held, phi, closure, result.time, spins, told));
  }
  return told;
}

}  // namespace moivre
