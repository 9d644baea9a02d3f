// SPDX-License-Identifier: MIT
// Which equations does a planar joint or driver add to Phi? One formula a joint, in q = [x, y, phi]
// a body.
//
// Rows of the joint's place, then of its turn (joint_type.h):
//   at point     r_i + A_i a - r_j - A_j b = 0
//   on line      n . (B - A) = 0               n perpendicular to the line, fixed in body i
//   at distance  (A - B) . (A - B) - L^2 = 0; a driven actuator: L |L|, so that no length is below
//                0
//   not at all   phi_j - phi_i - turn = 0
//   by rack      phi_j - phi_i - phase - s / r = 0, s = e . (B - A)
//   by cam       s - f(phi_i - phi_c - phase) = 0, or phi_j - phi_c - f = 0: f the profile, c the
//                carrier
//   geared       z_i (phi_i - phi_c) - z_j (phi_j - phi_c - phase) = 0, teeth divided by their
//                common factor
#include <numeric>

#include "dimension_jets.h"
#include "moivre/mechanism/joint_type.h"
#include "planar_pose.h"

namespace moivre {
namespace {

using planar::angle;
using planar::direction;
using planar::kSize;
using planar::position;

using Place = planar::Vector<Jet>;

/// The two bodies of a joint, the body that its line is fixed in, and its points in their frames.
struct Ends {
  std::size_t i = 0;
  std::size_t j = 0;
  std::size_t line = 0;
  Place a;
  Place b;
};

Place place_of(const Mechanism& mechanism, const PointOf& point, const Dimension* moving) {
  const auto at = point_jet(mechanism, point, moving);
  return {at.x, at.y};
}

Ends ends_of(const Mechanism& mechanism, const Joint& joint, const Dimension* moving) {
  const auto& [first, second] = joint.at;
  return {first.body, second.body, line_body(joint), place_of(mechanism, first, moving),
          place_of(mechanism, second, moving)};
}

Eigen::Vector3d turned_left(const Eigen::Vector3d& e) { return {-e.y(), e.x(), 0}; }

/// Of bodies that a displacement depends on.
std::vector<std::size_t> coordinates_along(const Ends& ends) {
  if (ends.line == ends.i) return coordinates_of({ends.i, ends.j}, kSize);
  return coordinates_of({ends.i, ends.j, ends.line}, kSize);
}

/// e . (B - A), the displacement of the second point along a direction of the line's body.
template <class S>
S displacement(const At<S>& at, const Ends& ends, const Eigen::Vector3d& along) {
  const auto d = position(at, ends.j, ends.b) - position(at, ends.i, ends.a);
  const auto e = direction(at, ends.line, along);
  return e.x * d.x + e.y * d.y;
}

template <class S>
S relative_angle(const At<S>& at, std::size_t i, std::size_t j, const Jet& offset) {
  return within_half_turn(angle(at, j) - angle(at, i) - in_scalar<S>(offset));
}

std::vector<RowLabel> row_labels(const std::string& label, const JointTraits& type) {
  std::vector<RowLabel> labels;
  if (type.place == JointPlace::at_point) labels = {{label + ": x", 1}, {label + ": y", 1}};
  if (type.place == JointPlace::on_line) labels = {{label + ": line", 1}};
  if (type.place == JointPlace::at_distance) labels = {{label + ": length", 2}};
  if (type.turn == JointTurn::not_at_all) labels.push_back({label + ": turn", 0});
  return labels;
}

std::shared_ptr<const Constraint> rack(const Joint& joint, const Ends& ends,
                                       const std::string& label) {
  return make_constraint(
      {{label + ": turn", 0}}, coordinates_of({ends.i, ends.j}, kSize),
      [ends, along = joint.axis[0], turn = joint.gear.phase_rad, radius = joint.radius](
          const auto& at, auto* row) {
        using S = std::remove_reference_t<decltype(*row)>;
        const S rolled = S(1 / radius) * displacement(at, ends, along);
        row[0] = within_half_turn(angle(at, ends.j) - angle(at, ends.i) - S(turn) - rolled);
      });
}

/// The profile's lift, carried by the scalar of the angle.
template <class S>
S lift_at(const Spline& profile, const S& angle_rad) {
  const DriverState state = periodic_state(profile, angle_rad.f);
  return chain(angle_rad, state.value, state.velocity, state.acceleration);
}

std::shared_ptr<const Constraint> cam(const Joint& joint, const Ends& ends,
                                      const std::string& label) {
  return make_constraint({{label + ": lift", 1}}, coordinates_along(ends),
                         [ends, along = joint.axis[0], profile = joint.profile,
                          phase = joint.gear.phase_rad](const auto& at, auto* row) {
                           using S = std::remove_reference_t<decltype(*row)>;
                           const S turned = angle(at, ends.i) - angle(at, ends.line) - S(phase);
                           row[0] = displacement(at, ends, along) - lift_at(profile, turned);
                         });
}

std::shared_ptr<const Constraint> cam_lever(const Joint& joint, const std::string& label) {
  const std::size_t i = joint.at[0].body;
  const std::size_t j = joint.at[1].body;
  const std::size_t c = joint.gear.carrier;
  return make_constraint(
      {{label + ": turn", 0}}, coordinates_of({i, j, c}, kSize),
      [=, profile = joint.profile, phase = joint.gear.phase_rad](const auto& at, auto* row) {
        using S = std::remove_reference_t<decltype(*row)>;
        const S turned = angle(at, i) - angle(at, c) - S(phase);
        row[0] = within_half_turn(angle(at, j) - angle(at, c) - lift_at(profile, turned));
      });
}

std::shared_ptr<const Constraint> gear(const Joint& joint, const std::string& label) {
  const std::size_t i = joint.at[0].body;
  const std::size_t j = joint.at[1].body;
  const std::size_t c = joint.gear.carrier;
  const int common = std::gcd(joint.gear.teeth[0], joint.gear.teeth[1]);
  // Whole numbers, without their common factor.
  const int wheel_i = joint.gear.teeth[0] / common;
  const int wheel_j = joint.gear.teeth[1] / common;
  const double zi = wheel_i;
  const double zj = wheel_j;
  return make_constraint({{label + ": turn", 0}}, coordinates_of({i, j, c}, kSize),
                         [=, phase = joint.gear.phase_rad](const auto& at, auto* row) {
                           using S = std::remove_reference_t<decltype(*row)>;
                           const S turn_i = angle(at, i) - angle(at, c);
                           const S turn_j = angle(at, j) - angle(at, c) - S(phase);
                           row[0] = within_half_turn(S(zi) * turn_i - S(zj) * turn_j);
                         });
}

std::shared_ptr<const Constraint> actuator_driver(const std::string& label, const Ends& ends,
                                                  const Prescription& law) {
  return make_constraint({{label, 2}}, coordinates_of({ends.i, ends.j}, kSize),
                         [law, ends](const auto& at, auto* row) {
                           const auto d =
                               position(at, ends.i, ends.a) - position(at, ends.j, ends.b);
                           row[0] = d.x * d.x + d.y * d.y - signed_square(law_at(law, at.t));
                         });
}

}  // namespace

std::shared_ptr<const Constraint> planar_joint(const Mechanism& mechanism, const Joint& joint,
                                               const Dimension* moving) {
  const std::string label = to_string(joint.type) + " " + joint.name;
  const JointTraits& type = traits(joint.type);
  if (!type.is_planar) throw std::logic_error("a planar mechanism has no joint " + label);
  if (type.turn == JointTurn::geared) return gear(joint, label);
  if (joint.type == JointType::cam_lever) return cam_lever(joint, label);
  const Ends ends = ends_of(mechanism, joint, moving);
  if (type.turn == JointTurn::by_rack) return rack(joint, ends, label);
  if (type.turn == JointTurn::by_cam) return cam(joint, ends, label);
  const bool has_turn = type.turn == JointTurn::not_at_all;
  return make_constraint(
      row_labels(label, type), coordinates_of({ends.i, ends.j}, kSize),
      [=, place = type.place, normal = turned_left(joint.axis[0]),
       turn = turn_jet(mechanism, joint, moving),
       length = length_jet(mechanism, joint, moving)](const auto& at, auto* row) {
        using S = std::remove_reference_t<decltype(*row)>;
        const auto d = position(at, ends.i, ends.a) - position(at, ends.j, ends.b);
        if (place == JointPlace::at_point) {
          *row++ = d.x;
          *row++ = d.y;
        } else if (place == JointPlace::on_line) {
          *row++ = displacement(at, ends, normal);
        } else if (place == JointPlace::at_distance) {
          *row++ = d.x * d.x + d.y * d.y - in_scalar<S>(length * length);
        }
        if (has_turn) *row = relative_angle(at, ends.i, ends.j, turn);
      });
}

std::shared_ptr<const Constraint> planar_driver(const Mechanism& mechanism, const Driver& driver,
                                                const Dimension* moving) {
  const std::string label = "driver " + driver.name + ": " + to_string(driver.kind);
  const Prescription law = prescription(mechanism, driver, moving);
  if (driver.kind == DriverKind::angle) {
    const auto [i, j] = driver.bodies;
    return make_constraint({{label, 0}}, coordinates_of({i, j}, kSize),
                           [law, i = i, j = j](const auto& at, auto* row) {
                             row[0] =
                                 within_half_turn(angle(at, j) - angle(at, i) - law_at(law, at.t));
                           });
  }
  if (driver.kind == DriverKind::slide) {
    const Joint& joint = mechanism.joints[driver.joint];
    const Ends ends = ends_of(mechanism, joint, moving);
    if (!has_line(joint.type)) return actuator_driver(label, ends, law);
    return make_constraint({{label, 1}}, coordinates_along(ends),
                           [law, ends, along = joint.axis[0]](const auto& at, auto* row) {
                             row[0] = displacement(at, ends, along) - law_at(law, at.t);
                           });
  }
  const bool along_x = driver.kind == DriverKind::x;
  const std::size_t body = driver.point.body;
  const Place point = place_of(mechanism, driver.point, moving);
  return make_constraint({{label, 1}}, coordinates_of({body}, kSize),
                         [law, body, point, along_x](const auto& at, auto* row) {
                           const auto r = position(at, body, point);
                           row[0] = (along_x ? r.x : r.y) - law_at(law, at.t);
                         });
}

}  // namespace moivre
