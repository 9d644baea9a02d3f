// SPDX-License-Identifier: MIT
// Which equations does a spatial joint or driver add to Phi? One formula a joint, in q = [x, y, z, rotation vector] a body.
//
// Let p = conj(frame_i) conj(q_i) q_j frame_j be the turn of body j's joint frame (z = axis) in body i's, a quaternion.
//   spherical    A - B = 0
//   universal    A - B = 0, a_i . a_j = 0
//   revolute     A - B = 0, p_x = p_y = 0           p_x = p_y = 0 means a turn about the axis: no reversed axis
//   cylindrical  (B - A) . u = (B - A) . w = 0, p_x = p_y = 0      u, w perpendicular to the axis, fixed in body i
//   prismatic    as cylindrical, and p_z = 0 for the turned frame
//   weld         A - B = 0, p_x = p_y = p_z = 0
//   rod          (A - B) . (A - B) - L^2 = 0
// Angle of a joint: 2 atan2(p_z, p_w). Components of p are doubled, so that a row is an angle to first order.
#include <Eigen/Geometry>
#include <stdexcept>

#include "dimension_jets.h"
#include "spatial_pose.h"

namespace moivre {
namespace spatial {

// Below the bound the Taylor series of nine terms is exact to rounding; above it the quotients lose no more than a digit.
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

/// The frame turned about its own third column by an angle that grows at `rate`: its columns and its quaternion change with it.
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

template <class S>
void coincide(const At<S>& at, const Ends& ends, S* row) {
  const auto d = position(at, ends.i, ends.a) - position(at, ends.j, ends.b);
  row[0] = d.x;
  row[1] = d.y;
  row[2] = d.z;
}

/// The first `count` components of 2 p.
template <class S>
void no_turn(const At<S>& at, const Ends& ends, int count, S* row) {
  const auto p = relative_turn(at, ends);
  const std::array<S, 3> components{p.v.x, p.v.y, p.v.z};
  for (int k = 0; k < count; ++k) row[k] = S(2) * components[static_cast<std::size_t>(k)];
}

/// Component of B - A along column k of the first joint frame (2: the axis).
template <class S>
S displacement(const At<S>& at, const Ends& ends, std::size_t k) {
  const auto d = position(at, ends.j, ends.b) - position(at, ends.i, ends.a);
  return dot(direction(at, ends.i, ends.frame_i.columns[k]), d);
}

std::vector<std::string> rows_named(const std::string& label, std::vector<std::string> parts) {
  for (std::string& part : parts) part = label + ": " + part;
  return parts;
}

}  // namespace

std::shared_ptr<const Constraint> spatial_joint(const Mechanism& mechanism, const Joint& joint,
                                                const Dimension* moving) {
  const std::string label = to_string(joint.type) + " " + joint.name;
  const Ends ends = ends_of(mechanism, joint, moving);
  const auto coordinates = coordinates_of({ends.i, ends.j}, kSize);
  switch (joint.type) {
    case JointType::spherical:
      return make_constraint(rows_named(label, {"x", "y", "z"}), coordinates,
                             [=](const auto& at, auto* row) { coincide(at, ends, row); });
    case JointType::revolute:
      return make_constraint(rows_named(label, {"x", "y", "z", "tilt 1", "tilt 2"}), coordinates,
                             [=](const auto& at, auto* row) {
                               coincide(at, ends, row);
                               no_turn(at, ends, 2, row + 3);
                             });
    case JointType::weld:
      return make_constraint(rows_named(label, {"x", "y", "z", "tilt 1", "tilt 2", "turn"}),
                             coordinates, [=](const auto& at, auto* row) {
                               coincide(at, ends, row);
                               no_turn(at, ends, 3, row + 3);
                             });
    case JointType::cylindrical:
    case JointType::prismatic: {
      const bool turns = joint.type == JointType::cylindrical;
      std::vector<std::string> parts{"line 1", "line 2", "tilt 1", "tilt 2"};
      if (!turns) parts.emplace_back("turn");
      return make_constraint(rows_named(label, std::move(parts)), coordinates,
                             [=](const auto& at, auto* row) {
                               row[0] = displacement(at, ends, 0);
                               row[1] = displacement(at, ends, 1);
                               no_turn(at, ends, turns ? 2 : 3, row + 2);
                             });
    }
    case JointType::universal:
      return make_constraint(rows_named(label, {"x", "y", "z", "cross"}), coordinates,
                             [=](const auto& at, auto* row) {
                               coincide(at, ends, row);
                               row[3] = dot(direction(at, ends.i, ends.frame_i.columns[2]),
                                            direction(at, ends.j, ends.frame_j.columns[2]));
                             });
    case JointType::rod:
      return make_constraint(
          rows_named(label, {"length"}), coordinates,
          [=, length = length_jet(mechanism, joint, moving)](const auto& at, auto* row) {
            using S = std::remove_reference_t<decltype(*row)>;
            const auto d = position(at, ends.i, ends.a) - position(at, ends.j, ends.b);
            row[0] = dot(d, d) - in_scalar<S>(length * length);
          });
    case JointType::slot:
    case JointType::gear:
      break;
  }
  throw std::logic_error("a spatial mechanism has no " + to_string(joint.type) + " joint");
}

std::shared_ptr<const Constraint> spatial_driver(const Mechanism& mechanism, const Driver& driver,
                                                 const Dimension* moving) {
  const std::string label = "driver " + driver.name + ": " + to_string(driver.kind);
  const Prescription law = prescription(mechanism, driver, moving);
  if (driver.kind == DriverKind::angle || driver.kind == DriverKind::slide) {
    const Ends ends = ends_of(mechanism, mechanism.joints[driver.joint], moving);
    const bool turns = driver.kind == DriverKind::angle;
    return make_constraint({label}, coordinates_of({ends.i, ends.j}, kSize),
                           [law, ends, turns](const auto& at, auto* row) {
                             using S = std::remove_reference_t<decltype(*row)>;
                             if (turns) {
                               const auto p = relative_turn(at, ends);
                               row[0] =
                                   within_half_turn(S(2) * atan2(p.v.z, p.w) - law_at(law, at.t));
                             } else {
                               row[0] = displacement(at, ends, 2) - law_at(law, at.t);
                             }
                           });
  }
  const DriverKind kind = driver.kind;
  const std::size_t body = driver.point.body;
  const Vector<Jet> point = point_jet(mechanism, driver.point, moving);
  return make_constraint(
      {label}, coordinates_of({body}, kSize), [law, body, point, kind](const auto& at, auto* row) {
        const auto r = position(at, body, point);
        const auto coordinate = kind == DriverKind::x ? r.x : kind == DriverKind::y ? r.y : r.z;
        row[0] = coordinate - law_at(law, at.t);
      });
}

}  // namespace moivre
