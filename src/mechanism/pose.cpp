// SPDX-License-Identifier: MIT
// How are points, orientations and joint coordinates read off q?
#include "moivre/mechanism/pose.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "moivre/mechanism/nearest.h"
#include "pose_jets.h"

namespace moivre {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;
using Eigen::VectorXd;

/// 0 x is 0 for finite x, and NaN for others; a sum of them is several numbers at a time.
bool are_finite(const VectorXd& x) { return (0 * x).sum() == 0; }

void require_numbers(Eigen::Index least, const VectorXd& q, const char* name) {
  if (q.size() < least) {
    throw InvalidInput(std::string(name) + " has " + std::to_string(least) +
                       " numbers, one for each coordinate, not " + std::to_string(q.size()));
  }
  if (!are_finite(q)) throw InvalidInput(std::string(name) + " has a number that is not finite");
}

void require_coordinates(const Mechanism& mechanism, const VectorXd& q) {
  const Eigen::Index each = mechanism.space == Space::planar ? 3 : 6;
  require_numbers(each * (static_cast<Eigen::Index>(mechanism.bodies.size()) - 1), q, "q");
}

std::vector<Jet> jets_at_rest(const Mechanism& mechanism, const VectorXd& q) {
  require_coordinates(mechanism, q);
  return {q.begin(), q.end()};
}

std::vector<Jet> jets_of(const Mechanism& mechanism, const VectorXd& q, const VectorXd& qdot,
                         const VectorXd& qddot) {
  require_coordinates(mechanism, q);
  require_numbers(q.size(), qdot, "q'");
  require_numbers(q.size(), qddot, "q''");
  std::vector<Jet> jets;
  jets.reserve(static_cast<std::size_t>(q.size()));
  for (Eigen::Index k = 0; k < q.size(); ++k) jets.emplace_back(q[k], qdot[k], qddot[k]);
  return jets;
}

PointState point_at(const Mechanism& mechanism, const PointOf& point, const At<Jet>& at) {
  if (point.body >= mechanism.bodies.size() ||
      point.point >= mechanism.bodies[point.body].points.size()) {
    throw InvalidInput("there is no point " + std::to_string(point.point) + " of body " +
                       std::to_string(point.body) + ", both counted from 0");
  }
  const auto r = position_jet(mechanism, point, at);
  return {{r.x.f, r.y.f, r.z.f}, {r.x.d, r.y.d, r.z.d}, {r.x.dd, r.y.dd, r.z.dd}};
}

void require_ends(const Mechanism& mechanism, const Joint& joint) {
  const bool has_points = traits(joint.type).place != JointPlace::anywhere;
  for (const PointOf& end : joint.at) {
    const bool is_there = end.body < mechanism.bodies.size() &&
                          (!has_points || end.point < mechanism.bodies[end.body].points.size());
    if (!is_there) throw InvalidInput("joint '" + joint.name + "' has an end that is not there");
  }
}

ScalarState state_of(const Jet& jet) { return {jet.f, jet.d, jet.dd}; }

}  // namespace

PointState point_state(const Mechanism& mechanism, const PointOf& point, const VectorXd& q,
                       const VectorXd& qdot, const VectorXd& qddot) {
  const std::vector<Jet> jets = jets_of(mechanism, q, qdot, qddot);
  return point_at(mechanism, point, {jets, Jet(0)});
}

std::vector<PointState> point_states(const Mechanism& mechanism, const VectorXd& q,
                                     const VectorXd& qdot, const VectorXd& qddot) {
  const std::vector<Jet> jets = jets_of(mechanism, q, qdot, qddot);
  std::vector<PointState> states;
  for (std::size_t body = 1; body < mechanism.bodies.size(); ++body) {
    for (std::size_t k = 0; k < mechanism.bodies[body].points.size(); ++k) {
      states.push_back(point_at(mechanism, {body, k}, {jets, Jet(0)}));
    }
  }
  return states;
}

Vector3d point_position(const Mechanism& mechanism, const PointOf& point, const VectorXd& q) {
  const std::vector<Jet> jets = jets_at_rest(mechanism, q);
  return point_at(mechanism, point, {jets, Jet(0)}).position;
}

PointOf point_named(const Mechanism& mechanism, const std::string& name) {
  std::vector<std::string> known;
  for (std::size_t body = 0; body < mechanism.bodies.size(); ++body) {
    const std::vector<BodyPoint>& points = mechanism.bodies[body].points;
    for (std::size_t k = 0; k < points.size(); ++k) {
      known.push_back(mechanism.bodies[body].name + '.' + points[k].name);
      if (known.back() == name) return {body, k};
    }
  }
  throw InvalidInput("there is no point '" + name + "'" + suggestion(name, known));
}

Matrix3d orientation(const Mechanism& mechanism, std::size_t body, const VectorXd& q) {
  const std::vector<Jet> jets = jets_at_rest(mechanism, q);
  if (body >= mechanism.bodies.size()) {
    throw InvalidInput("there is no body " + std::to_string(body) + ", counted from 0");
  }
  const At<Jet> at{jets, Jet(0)};
  Matrix3d R = Matrix3d::Identity();
  for (int k = 0; k < 3; ++k) {
    const Vector3d axis = Vector3d::Unit(k);
    if (mechanism.space == Space::spatial) {
      const auto column = spatial::direction(at, body, axis);
      R.col(k) << column.x.f, column.y.f, column.z.f;
    } else if (k < 2) {
      const auto column = planar::direction(at, body, axis);
      R.col(k) << column.x.f, column.y.f, 0;
    }
  }
  return R;
}

Matrix3d joint_frame(const Vector3d& axis) { return spatial::axis_frame(axis); }

std::optional<double> joint_coordinate(const Mechanism& mechanism, const Joint& joint,
                                       const VectorXd& q) {
  const std::vector<Jet> jets = jets_at_rest(mechanism, q);
  require_ends(mechanism, joint);
  const std::optional<Jet> coordinate = joint_jet(mechanism, joint, {jets, Jet(0)});
  if (!coordinate) return std::nullopt;
  return is_angular(joint.type) ? within_half_turn(Jet(coordinate->f)).f : coordinate->f;
}

std::optional<ScalarState> joint_state(const Mechanism& mechanism, const Joint& joint,
                                       const VectorXd& q, const VectorXd& qdot,
                                       const VectorXd& qddot) {
  const std::vector<Jet> jets = jets_of(mechanism, q, qdot, qddot);
  require_ends(mechanism, joint);
  const std::optional<Jet> coordinate = joint_jet(mechanism, joint, {jets, Jet(0)});
  return coordinate ? std::optional(state_of(*coordinate)) : std::nullopt;
}

ScalarState turn_state(const Mechanism& mechanism, const Joint& joint, const VectorXd& q,
                       const VectorXd& qdot, const VectorXd& qddot) {
  const std::vector<Jet> jets = jets_of(mechanism, q, qdot, qddot);
  require_ends(mechanism, joint);
  return state_of(joint_turn_jet(mechanism, joint, {jets, Jet(0)}));
}

bool is_within_limits(const Mechanism& mechanism, const Joint& joint, const VectorXd& q) {
  // Of the limits: a pose that stands at a stop is known to rounding, and stands there.
  constexpr double kAtStop = 1e-11;
  require_coordinates(mechanism, q);
  const auto value = joint.limits ? joint_coordinate(mechanism, joint, q) : std::nullopt;
  if (!value) return true;
  const auto [lower, upper] = *joint.limits;
  const bool turns = is_angular(joint.type);
  const double rounding = kAtStop * std::max({turns ? 1.0 : 0.0, std::abs(lower), std::abs(upper)});
  double above_lower = *value - lower + rounding;
  if (turns) {
    constexpr double kTurn = 2 * std::numbers::pi;
    above_lower -= kTurn * std::floor(above_lower / kTurn);
  }
  return above_lower >= 0 && above_lower <= upper - lower + 2 * rounding;
}

const Joint* broken_limit(const Mechanism& mechanism, const VectorXd& q) {
  require_coordinates(mechanism, q);
  const auto at =
      std::find_if(mechanism.joints.begin(), mechanism.joints.end(),
                   [&](const Joint& joint) { return !is_within_limits(mechanism, joint, q); });
  return at == mechanism.joints.end() ? nullptr : &*at;
}

}  // namespace moivre
