// SPDX-License-Identifier: MIT
// Which equations does a spatial joint or driver add to Phi? One formula a joint, in q = [x, y, z,
// rotation vector] a body.
//
// Let p = conj(frame_i) conj(q_i) q_j frame_j be the turn of body j's joint frame (z = axis) in
// body i's, a quaternion.
// Rows of the joint's place, then of its turn (joint_type.h):
//   at point     A - B = 0
//   on line      (B - A) . u = (B - A) . w = 0       u, w perpendicular to the axis, fixed in body
//                i
//   in plane     (B - A) . axis = 0
//   at distance  (A - B) . (A - B) - L^2 = 0
//   about axis   p_x = p_y = 0                       a turn about the axis: no reversed axis
//   by thread    p_x = p_y = 0, 2 pi s / P - a = 0 but for whole turns       s slide, a angle, P
//                pitch
//   not at all   p_x = p_y = p_z = 0 for the turned frame
//   about two axes   a_i . a_j = 0
// s = (B - A) . axis, a = 2 atan2(p_z, p_w). Components of p are doubled, so that a row is an angle
// to first order. A driver of a screw's angle prescribes its slide, P / 2 pi times the angle, so
// that whole turns count.
#include <Eigen/Geometry>
#include <algorithm>
#include <map>
#include <numbers>
#include <stdexcept>

#include "dimension_jets.h"
#include "moivre/mechanism/joint_type.h"
#include "moivre/mechanism/spins.h"
#include "spatial_pose.h"

namespace moivre {
namespace spatial {

// Below the bound the Taylor series of nine terms is exact to rounding; above it the quotients lose
// no more than a digit.
std::array<double, 3> sine_quotient(double u) {
  constexpr double kSeriesBound = 0.25;
  if (u > kSeriesBound) {
    const double r = std::sqrt(u);
    const double g = std::sin(r) / r;
    const double dg = (std::cos(r) - g) / (2 * u);
    return {g, dg, (-0.5 * g - 3 * dg) / (2 * u)};
  }
  constexpr int kTerms = 9;
  double g = 0, dg = 0, ddg = 0;
  double coefficient = 1;  // (-1)^k / (2k + 1)!
  double power = 1;        // u^k
  double lower = 0;        // k u^(k-1)
  double lowest = 0;       // k (k-1) u^(k-2)
  for (int k = 0; k < kTerms; ++k) {
    g += coefficient * power;
    dg += coefficient * lower;
    ddg += coefficient * lowest;
    lowest = lowest * u + 2 * lower;
    lower = lower * u + power;
    power *= u;
    coefficient /= -((2.0 * k + 2) * (2.0 * k + 3));
  }
  return {g, dg, ddg};
}

Eigen::Matrix3d axis_frame(const Eigen::Vector3d& axis) {
  Eigen::Index smallest = 0;
  axis.cwiseAbs().minCoeff(&smallest);
  const Eigen::Vector3d z = axis.normalized();
  const Eigen::Vector3d x = Eigen::Vector3d::Unit(smallest).cross(z).normalized();
  Eigen::Matrix3d frame;
  frame << x, z.cross(x), z;
  return frame;
}

}  // namespace spatial

namespace {

using spatial::axis_frame;
using spatial::conjugate;
using spatial::direction;
using spatial::dot;
using spatial::kSize;
using spatial::orientation;
using spatial::position;
using spatial::Quaternion;
using spatial::Vector;

/// Fixed in a body: its columns, and the turn that it is.
struct JointFrame {
  std::array<Vector<Jet>, 3> columns;
  Quaternion<Jet> turn;
};

/// The frame turned about its own third column by an angle that grows at `rate`: its columns and
/// its quaternion change with it.
JointFrame joint_frame_jet(const Eigen::Matrix3d& frame, double rate) {
  const Eigen::Vector3d x = frame.col(0), y = frame.col(1), z = frame.col(2);
  const auto moving = [](const Eigen::Vector3d& v, const Eigen::Vector3d& d) {
    return Vector<Jet>{{v.x(), d.x(), 0}, {v.y(), d.y(), 0}, {v.z(), d.z(), 0}};
  };
  const Eigen::Quaterniond turn(frame);
  // q (cos(a/2), 0, 0, sin(a/2)) has the derivative q (0, 0, 0, 1/2) at a = 0.
  const Eigen::Quaterniond change = turn * Eigen::Quaterniond(0, 0, 0, 0.5 * rate);
  return {{moving(x, rate * y), moving(y, -rate * x), moving(z, Eigen::Vector3d::Zero())},
          {{turn.w(), change.w(), 0}, moving(turn.vec(), change.vec())}};
}

/// The two bodies of a joint, its points and the joint's frames in them.
struct Ends {
  std::size_t i = 0;
  std::size_t j = 0;
  Vector<Jet> a, b;
  JointFrame frame_i, frame_j;
};

Ends ends_of(const Mechanism& mechanism, const Joint& joint, const Dimension* moving) {
  const auto& [first, second] = joint.at;
  const Jet turn = turn_jet(mechanism, joint, moving);
  Ends ends;
  ends.i = first.body;
  ends.j = second.body;
  ends.a = point_jet(mechanism, first, moving);
  ends.b = point_jet(mechanism, second, moving);
  ends.frame_i =
      joint_frame_jet(axis_frame(joint.axis[0]) *
                          Eigen::AngleAxisd(turn.f, Eigen::Vector3d::UnitZ()).toRotationMatrix(),
                      turn.d);
  ends.frame_j = joint_frame_jet(axis_frame(joint.axis[1]), 0);
  return ends;
}

template <class S>
Quaternion<S> constant_turn(const JointFrame& frame) {
  return {in_scalar<S>(frame.turn.w), spatial::in_scalar<S>(frame.turn.v)};
}

/// p: the turn of the second joint frame in the first.
template <class S>
Quaternion<S> relative_turn(const At<S>& at, const Ends& ends) {
  const Quaternion<S> first = orientation(at, ends.i) * constant_turn<S>(ends.frame_i);
  return conjugate(first) * (orientation(at, ends.j) * constant_turn<S>(ends.frame_j));
}

/// Component of B - A along column k of the first joint frame (2: the axis).
template <class S>
S displacement(const At<S>& at, const Ends& ends, std::size_t k) {
  const auto d = position(at, ends.j, ends.b) - position(at, ends.i, ends.a);
  return dot(direction(at, ends.i, ends.frame_i.columns[k]), d);
}

/// The joint's angle, in (-2 pi, 2 pi], of p.
template <class S>
S angle_of(const Quaternion<S>& p) {
  return S(2) * atan2(p.v.z, p.w);
}

/// Angle that a screw has turned when it has come to its slide.
template <class S>
S threaded_angle(const At<S>& at, const Ends& ends, double pitch) {
  return S(2 * std::numbers::pi / pitch) * displacement(at, ends, 2);
}

std::vector<RowLabel> spatial_row_labels(const std::string& label, const JointTraits& type) {
  static const std::map<JointPlace, std::vector<RowLabel>> places{
      {JointPlace::at_point, {{"x", 1}, {"y", 1}, {"z", 1}}},
      {JointPlace::on_line, {{"line 1", 1}, {"line 2", 1}}},
      {JointPlace::in_plane, {{"height", 1}}},
      {JointPlace::at_distance, {{"length", 2}}},
      {JointPlace::at_any_distance, {}}};
  static const std::map<JointTurn, std::vector<RowLabel>> turns{
      {JointTurn::about_axis, {{"tilt 1", 0}, {"tilt 2", 0}}},
      {JointTurn::by_thread, {{"tilt 1", 0}, {"tilt 2", 0}, {"thread", 0}}},
      {JointTurn::not_at_all, {{"tilt 1", 0}, {"tilt 2", 0}, {"turn", 0}}},
      {JointTurn::about_two_axes, {{"cross", 0}}},
      {JointTurn::freely, {}}};
  std::vector<RowLabel> labels = places.at(type.place);
  labels.insert(labels.end(), turns.at(type.turn).begin(), turns.at(type.turn).end());
  for (RowLabel& row : labels) row.name = label + ": " + row.name;
  return labels;
}

/// What the rows of a joint are made of.
struct SpatialJoint {
  Ends ends;
  JointPlace place = JointPlace::at_point;
  JointTurn turn = JointTurn::freely;
  Jet length;
  double pitch = 0;
};

/// Writes the rows and moves on behind them.
template <class S>
void place_rows(const At<S>& at, const SpatialJoint& joint, S*& row) {
  const Ends& ends = joint.ends;
  const auto d = position(at, ends.i, ends.a) - position(at, ends.j, ends.b);
  switch (joint.place) {
    case JointPlace::at_point:
      *row++ = d.x;
      *row++ = d.y;
      *row++ = d.z;
      break;
    case JointPlace::on_line:
      *row++ = displacement(at, ends, 0);
      *row++ = displacement(at, ends, 1);
      break;
    case JointPlace::in_plane:
      *row++ = displacement(at, ends, 2);
      break;
    case JointPlace::at_distance:
      *row++ = dot(d, d) - in_scalar<S>(joint.length * joint.length);
      break;
    case JointPlace::anywhere:
    case JointPlace::off_line:
    case JointPlace::at_any_distance:
      break;
  }
}

template <class S>
void turn_rows(const At<S>& at, const SpatialJoint& joint, S* row) {
  const Ends& ends = joint.ends;
  if (joint.turn == JointTurn::about_two_axes) {
    *row = dot(direction(at, ends.i, ends.frame_i.columns[2]),
               direction(at, ends.j, ends.frame_j.columns[2]));
  }
  const bool is_aligned = joint.turn == JointTurn::about_axis ||
                          joint.turn == JointTurn::by_thread || joint.turn == JointTurn::not_at_all;
  if (!is_aligned) return;
  const auto p = relative_turn(at, ends);
  *row++ = S(2) * p.v.x;
  *row++ = S(2) * p.v.y;
  if (joint.turn == JointTurn::not_at_all) *row = S(2) * p.v.z;
  if (joint.turn == JointTurn::by_thread) {
    *row = within_half_turn(threaded_angle(at, ends, joint.pitch) - angle_of(p));
  }
}

std::shared_ptr<const Constraint> actuator_driver(const std::string& label, const Ends& ends,
                                                  const Prescription& law) {
  return make_constraint({{label, 2}}, coordinates_of({ends.i, ends.j}, kSize),
                         [law, ends](const auto& at, auto* row) {
                           const auto d =
                               position(at, ends.i, ends.a) - position(at, ends.j, ends.b);
                           row[0] = dot(d, d) - signed_square(law_at(law, at.t));
                         });
}

}  // namespace

std::shared_ptr<const Constraint> spatial_joint(const Mechanism& mechanism, const Joint& joint,
                                                const Dimension* moving) {
  const std::string label = to_string(joint.type) + " " + joint.name;
  const JointTraits& type = traits(joint.type);
  if (!type.is_spatial) throw std::logic_error("a spatial mechanism has no joint " + label);
  const SpatialJoint parts{ends_of(mechanism, joint, moving), type.place, type.turn,
                           length_jet(mechanism, joint, moving), joint.pitch};
  return make_constraint(spatial_row_labels(label, type),
                         coordinates_of({parts.ends.i, parts.ends.j}, kSize),
                         [parts](const auto& at, auto* row) {
                           place_rows(at, parts, row);
                           turn_rows(at, parts, row);
                         });
}

std::shared_ptr<const Constraint> spin_constraint(const Mechanism& mechanism, const Spin& spin) {
  const PointOf a = spin.line[0];
  const PointOf b = spin.line[1];
  const Vector<Jet> from = point_jet(mechanism, a, nullptr);
  const Vector<Jet> to = point_jet(mechanism, b, nullptr);
  const Vector<Jet> mark = spatial::constant(spin_mark());
  std::vector<std::size_t> bodies{a.body, b.body, spin.body};
  std::sort(bodies.begin(), bodies.end());
  bodies.erase(std::unique(bodies.begin(), bodies.end()), bodies.end());
  return make_constraint(
      {{"spin of " + mechanism.bodies[spin.body].name, 1}}, coordinates_of(bodies, kSize),
      [=, body = spin.body](const auto& at, auto* row) {
        const auto line = position(at, b.body, to) - position(at, a.body, from);
        row[0] = dot(line, cross(direction(at, body, mark), direction(at, 0, mark)));
      });
}

std::shared_ptr<const Constraint> spatial_driver(const Mechanism& mechanism, const Driver& driver,
                                                 const Dimension* moving) {
  const std::string label = "driver " + driver.name + ": " + to_string(driver.kind);
  const Prescription law = prescription(mechanism, driver, moving);
  if (driver.kind == DriverKind::angle || driver.kind == DriverKind::slide) {
    const Joint& joint = mechanism.joints[driver.joint];
    const Ends ends = ends_of(mechanism, joint, moving);
    const bool turns = driver.kind == DriverKind::angle;
    if (!turns && !has_line(joint.type)) return actuator_driver(label, ends, law);
    return make_constraint({{label, turns ? 0 : 1}}, coordinates_of({ends.i, ends.j}, kSize),
                           [law, ends, turns, pitch = joint.pitch](const auto& at, auto* row) {
                             const auto prescribed = law_at(law, at.t);
                             if (turns && pitch != 0) {
                               row[0] = threaded_angle(at, ends, pitch) - prescribed;
                             } else if (turns) {
                               row[0] =
                                   within_half_turn(angle_of(relative_turn(at, ends)) - prescribed);
                             } else {
                               row[0] = displacement(at, ends, 2) - prescribed;
                             }
                           });
  }
  const DriverKind kind = driver.kind;
  const std::size_t body = driver.point.body;
  const Vector<Jet> point = point_jet(mechanism, driver.point, moving);
  return make_constraint(
      {{label, 1}}, coordinates_of({body}, kSize),
      [law, body, point, kind](const auto& at, auto* row) {
        const auto r = position(at, body, point);
        const auto coordinate = kind == DriverKind::x ? r.x : kind == DriverKind::y ? r.y : r.z;
        row[0] = coordinate - law_at(law, at.t);
      });
}

}  // namespace moivre
