// SPDX-License-Identifier: MIT
// Bodies, planar joints and drivers as closure polynomials.
#include <algorithm>
#include <numeric>
#include <stdexcept>
#include <utility>

#include "isotropic_frame.h"
#include "known_motions.h"
#include "linear_values.h"
#include "moivre/formulation/block_structure.h"
#include "moivre/mechanism/joint_type.h"
#include "moivre/mechanism/phi.h"
#include "moivre/polynomial/value.h"
#include "shared_pins.h"
#include "typed_numbers.h"

namespace moivre {
namespace {

/// What each driver of an angle says at t; of other drivers nothing.
std::vector<EnclosedUnit> driven_units(const Mechanism& mechanism, double t) {
  std::vector<EnclosedUnit> units(mechanism.drivers.size());
  for (std::size_t a = 0; a < units.size(); ++a) {
    const Driver& driver = mechanism.drivers[a];
    if (driver.kind != DriverKind::angle) continue;
    units[a] = unit_at(driven_angle(driver.law, t, mechanism.units));
  }
  return units;
}

class Bodies {
 public:
  /// `driven`, driven_units() of the mechanism, outlives it.
  Bodies(const Mechanism& mechanism, double t, const std::vector<EnclosedUnit>& driven,
         JointEnds ends, KnownMotions known, bool has_factors = false)
      : mechanism_(mechanism),
        t_(t),
        driven_(driven),
        ends_(std::move(ends)),
        known_(std::move(known)),
        frame_(names(mechanism), has_factors),
        size_(largest_length(mechanism)) {}

  Formulation build() && {
    write();
    read_coordinates();
    return std::move(frame_.result());
  }

  EnclosedPolynomials enclosed(const Formulation& formulation) && {
    write();
    return with_factors(formulation, frame_);
  }

  /// Pins begin at the ground, else at the body of the earliest block.
  JointEnds ends_by_order_of_blocks() && {
    write();
    const System& f = frame_.result().system;
    const BlockStructure structure = block_structure(f);
    std::vector<std::size_t> block_of(f.variables.size(), structure.blocks.size());
    for (std::size_t b = 0; b < structure.blocks.size(); ++b) {
      for (const std::size_t v : structure.blocks[b].variables) block_of[v] = b;
    }
    return star_ends(mechanism_, [&](PointOf point) {
      std::size_t rank =
          0;  // the ground's, which holds no variable; of others the block, from 1 on
      for (const Term& term : place(point).z.terms) {
        for (const Power& power : term.monomial)
          rank = std::max(rank, block_of[power.variable] + 1);
      }
      return rank;
    });
  }

  /// Slides of racks that the linear equations of what is known say, by joint.
  std::vector<std::optional<double>> linear_slides() && {
    write();
    const LinearValues values(frame_.result());
    std::vector<std::optional<double>> slides(mechanism_.joints.size());
    for (const Joint& joint : mechanism_.joints) {
      if (joint.type != JointType::rack || known_.slides[number(joint)]) continue;
      const auto twice = values.value(twice_slide(joint));
      if (twice) slides[number(joint)] = twice->real() / 2;
    }
    return slides;
  }

 private:
  static std::vector<std::string> names(const Mechanism& mechanism) {
    std::vector<std::string> names;
    for (std::size_t i = 1; i < mechanism.bodies.size(); ++i) {
      names.push_back(mechanism.bodies[i].name);
    }
    return names;
  }

  void hold_angles() {
    for (std::size_t a = 0; a < driven_.size(); ++a) {
      const Driver& driver = mechanism_.drivers[a];
      if (driver.kind != DriverKind::angle) continue;
      frame_.hold_angle(driver.bodies[0], driver.bodies[1], driven_[a], "driver " + driver.name);
    }
    for (const Joint& joint : mechanism_.joints) {
      if (traits(joint.type).turn != JointTurn::not_at_all) continue;
      frame_.hold_angle(joint.at[0].body, joint.at[1].body,
                        unit_at(typed_angle(joint.turn_rad, mechanism_.units)), label(joint));
    }
    for (const Joint& joint : mechanism_.joints) {
      if (traits(joint.type).turn != JointTurn::geared || !is_settled(joint, known_.angles))
        continue;
      hold_known_angles({joint.at[0].body, joint.at[1].body, joint.gear.carrier}, label(joint));
      leave_out_meshings(joint);
    }
    for (const Joint& joint : mechanism_.joints) {
      if (joint.type == JointType::rack || joint.type == JointType::cam_lever) hold_second(joint);
    }
  }

  void leave_out_meshings(const Joint& gear) {
    const auto& [zi, zj] = gear.gear.teeth;
    const bool is_even = std::abs(zi) == std::abs(zj) && gear.gear.carrier == 0;
    if (is_even) return;
    frame_.result().left_out.emplace_back("other meshings than the drawn one of " + label(gear),
                                          "--meshings looks for them");
  }

  void hold_known_angles(const std::vector<std::size_t>& bodies, const std::string& name) {
    for (const std::size_t body : bodies) {
      const auto& angle = known_.angles[body];
      if (!angle || frame_.angle(body).root == frame_.angle(angle->root).root) continue;
      frame_.hold_angle(angle->root, body, unit_at(angle->exact), name);
    }
  }

  /// The pinion of a rack, the lever on a cam. One that follows stands at 0 until its angle is
  /// read.
  void hold_second(const Joint& joint) {
    constexpr double kAgreement = 1e-9;  // as known angles agree
    const auto& slide = known_.slides[number(joint)];
    const std::size_t second = joint.at[1].body;
    if (slide && disagreement(joint, *slide, known_.angles) > kAgreement) {
      frame_.contradict(label(joint));
    } else if (slide) {
      hold_known_angles({turn_body(joint), second}, label(joint));
    } else if (known_.is_followed[number(joint)]) {
      frame_.hold_angle(0, second, {}, label(joint));
    }
  }

  void add_positions() {
    positions_.push_back({constant({0, 0}), constant({0, 0})});
    for (std::size_t i = 1; i < mechanism_.bodies.size(); ++i) {
      const std::string& name = mechanism_.bodies[i].name;
      positions_.push_back(frame_.add_pair({"p_" + name, "pb_" + name}, false, {name}));
    }
  }

  void add_joint(const Joint& joint) {
    switch (traits(joint.type).place) {
      case JointPlace::at_point:
        frame_.add_equations(label(joint), without_rounding(gap(joint)));
        return;
      case JointPlace::on_line:
        add_line(joint);
        return;
      case JointPlace::at_distance:
        add_distance(joint, typed(joint.length));
        return;
      case JointPlace::anywhere:
        if (joint.type != JointType::cam_lever && !is_settled(joint, known_.angles))
          add_gear(joint);
        return;
      case JointPlace::off_line:
        add_known_slides(joint);
        return;
      case JointPlace::at_any_distance:
        if (const auto length = driven_slide(joint)) add_distance(joint, *length);
        return;
      case JointPlace::in_plane:
        break;
    }
    throw std::logic_error("a planar mechanism has no " + to_string(joint.type) + " joint");
  }

  void add_line(const Joint& joint) {
    const Mirrored along = along_line(joint.at[0].body, joint.axis[0]);
    if (const auto slide = driven_slide(joint)) {
      frame_.add_equations(label(joint) + ": slide",
                           without_rounding(gap(joint) - frame_.number(*slide) * along));
      return;
    }
    const Mirrored across = swapped(along) * gap(joint);
    frame_.add_equation(label(joint) + ": line", without_rounding(across.z - across.conjugate));
  }

  void add_distance(const Joint& joint, const EnclosedNumber& length) {
    const Mirrored d = gap(joint);
    // No two points are a length below 0 apart.
    const Coefficient sign{length.value < Rational() ? -1 : 1, 0};
    const Polynomial known = frame_.number(length);
    const Polynomial square = sign * (known * known);
    const Polynomial distance = d.z * d.conjugate;
    frame_.add_equation(label(joint), frame_.has_factors() ? distance - square
                                                           : rounded_difference(distance, square));
  }

  void add_gear(const Joint& joint) {
    const auto& gear = joint.gear;
    const int common = std::gcd(gear.teeth[0], gear.teeth[1]);
    const int zi = gear.teeth[0] / common;
    const int zj = gear.teeth[1] / common;
    frame_.add_turn(label(joint),
                    {{joint.at[0].body, zi}, {gear.carrier, zj - zi}, {joint.at[1].body, -zj}},
                    unit_at(times(-zj, typed_angle(gear.phase_rad, mechanism_.units))));
  }

  /// Of a rack or a cam: what a driver says, and what an angle does; 0 for a tappet until its lift
  /// is read.
  void add_known_slides(const Joint& joint) {
    const auto add = [&](const EnclosedNumber& slide) {
      const Polynomial twice = Coefficient{2, 0} * frame_.number(slide);
      frame_.add_equation(label(joint), without_rounding(twice_slide(joint) - twice));
    };
    const auto driven = driven_slide(joint);
    if (driven) add(*driven);
    const auto& slide = known_.slides[number(joint)];
    const bool is_driven_rack = driven && joint.type == JointType::rack;
    if (slide && !slide->follows && !is_driven_rack) add(computed_number(slide->value));
    if (joint.type == JointType::cam && known_.is_followed[number(joint)]) add({});
  }

  void add_driver(const Driver& driver) {
    if (driver.kind != DriverKind::x && driver.kind != DriverKind::y) return;
    const Mirrored at = place(driver.point);
    const EnclosedNumber value = driven_length(driver.law, t_);
    const Polynomial known = frame_.number(value);
    const std::string name = "driver " + driver.name;
    if (driver.kind == DriverKind::x) {
      frame_.add_equation(name, at.z + at.conjugate - Coefficient{2, 0} * known);
    } else {
      frame_.add_equation(name, at.z - at.conjugate - Coefficient{0, 2} * known);
    }
  }

  void read_coordinates() {
    using Part = Formulation::Reading::Part;
    for (std::size_t i = 1; i < mechanism_.bodies.size(); ++i) {
      auto& coordinates = frame_.result().coordinates;
      coordinates.push_back({Part::re, positions_[i].z});
      coordinates.push_back({Part::im, positions_[i].z});
      coordinates.push_back({Part::argument, frame_.t(i).z});
    }
    for (const Joint& joint : mechanism_.joints) {
      if (known_.is_followed[number(joint)]) read_follower(joint);
    }
  }

  /// What the second body of a rack or a cam has turned or been lifted by, at a root.
  std::function<double(const Point&)> read_lift(const Joint& joint) {
    if (joint.type == JointType::rack) {
      const Coefficient per_slide{1 / (2 * typed_decimal(joint.radius)), 0};
      return [turned = per_slide * twice_slide(joint), phase = joint.gear.phase_rad](
                 const Point& root) { return value_at(turned, root).real() + phase; };
    }
    const Polynomial turned = frame_.t(joint.at[0].body).z * frame_.t(joint.gear.carrier).conjugate;
    return [turned, phase = joint.gear.phase_rad, profile = joint.profile](const Point& root) {
      return periodic_state(profile, std::arg(value_at(turned, root)) - phase).value;
    };
  }

  /// A tappet stands at lift 0 in the polynomials, a pinion and a lever at angle 0.
  void read_follower(const Joint& joint) {
    using Part = Formulation::Reading::Part;
    const std::size_t body = joint.at[1].body;
    auto* const readings = frame_.result().coordinates.data() + 3 * (body - 1);
    const auto lift = read_lift(joint);
    const std::size_t base = joint.type == JointType::cam ? line_body(joint) : turn_body(joint);
    const Polynomial frame = frame_.t(base).z;
    if (joint.type == JointType::cam) {
      const Complex along(joint.axis[0].x(), joint.axis[0].y());
      const auto lifted = [lift, frame](const Point& root) {
        return lift(root) * value_at(frame, root);
      };
      readings[0] = {Part::re, positions_[body].z, along, lifted};
      readings[1] = {Part::im, positions_[body].z, along, lifted};
      return;
    }
    const PointOf pivot = *pivot_of(mechanism_, joint);
    const Eigen::Vector3d& at = mechanism_.bodies[body].points[pivot.point].at;
    const Complex arm(-at.x(), -at.y());
    const auto turned = [lift, frame](const Point& root) {
      return std::polar(1.0, std::arg(value_at(frame, root)) + lift(root));
    };
    readings[0] = {Part::re, place(pivot).z, arm, turned};
    readings[1] = {Part::im, place(pivot).z, arm, turned};
    readings[2] = {Part::argument, {}, 1, turned};
  }

  void write() {
    hold_angles();
    add_positions();
    frame_.add_angles();
    for (const Driver& driver : mechanism_.drivers) add_driver(driver);
    for (const Joint& joint : mechanism_.joints) add_joint(joint);
  }

  /// A place or direction of a body's frame as a complex number, turned with the body.
  Mirrored turned(std::size_t body, const Eigen::Vector3d& at) const {
    if (at.x() == 0 && at.y() == 0) return {};
    return typed_decimal(at.x(), at.y()) * frame_.t(body);
  }
  /// A line's direction was brought to length 1, which rounds it unless it is one of the axes.
  Mirrored along_line(std::size_t body, const Eigen::Vector3d& axis) {
    constexpr double kRounding = 0x1p-51;
    const bool is_axis = axis.x() == 0 || axis.y() == 0;
    return frame_.enclosed(turned(body, axis), is_axis ? 0 : kRounding);
  }
  Mirrored place(const PointOf& point) const {
    return positions_[point.body] +
           turned(point.body, mechanism_.bodies[point.body].points[point.point].at);
  }
  /// From the joint's first point to its second.
  Mirrored gap(const Joint& joint) const {
    const auto& ends = ends_[number(joint)];
    return place(ends[1]) - place(ends[0]);
  }

  /// p, linear in lengths, without what points as typed leave where they mean nothing: a
  /// coefficient that is rounding relative to the mechanism's size would be a root at 1e16.
  Polynomial without_rounding(Polynomial p) const {
    if (frame_.has_factors()) return p;
    constexpr double kRounding = 2e-15;  // a sum of a few lengths right to 2^-53
    const auto has_position = [&](const Term& term) {
      return std::any_of(term.monomial.begin(), term.monomial.end(), [&](const Power& power) {
        return !frame_.result().is_direction[power.variable];
      });
    };
    for (Term& term : p.terms) {
      if (has_position(term)) continue;
      const Complex size = to_complex(term.coefficient);
      if (std::abs(size.real()) <= kRounding * size_) term.coefficient.re = 0;
      if (std::abs(size.imag()) <= kRounding * size_) term.coefficient.im = 0;
    }
    const auto is_nothing = [](const Term& term) {
      return term.coefficient.re.is_zero() && term.coefficient.im.is_zero();
    };
    p.terms.erase(std::remove_if(p.terms.begin(), p.terms.end(), is_nothing), p.terms.end());
    return p;
  }

  Mirrored without_rounding(const Mirrored& z) const {
    return {without_rounding(z.z), without_rounding(z.conjugate)};
  }
  /// Twice the displacement of the second point along the line.
  Polynomial twice_slide(const Joint& joint) {
    const Mirrored advance = swapped(along_line(line_body(joint), joint.axis[0])) * gap(joint);
    return without_rounding(advance.z + advance.conjugate);
  }
  std::size_t number(const Joint& joint) const {
    return static_cast<std::size_t>(&joint - mechanism_.joints.data());
  }
  std::string label(const Joint& joint) const { return to_string(joint.type) + " " + joint.name; }
  std::optional<EnclosedNumber> driven_slide(const Joint& joint) const {
    std::optional<EnclosedNumber> slide;
    for (const Driver& driver : mechanism_.drivers) {
      if (driver.kind == DriverKind::slide && driver.joint == number(joint)) {
        slide = driven_length(driver.law, t_);
      }
    }
    return slide;
  }

  const Mechanism& mechanism_;
  double t_;
  const std::vector<EnclosedUnit>& driven_;
  JointEnds ends_;
  KnownMotions known_;
  IsotropicFrame frame_;
  double size_;  ///< of the mechanism
  std::vector<Mirrored> positions_;
};

}  // namespace

Formulation isotropic_bodies(const Mechanism& mechanism, double t) {
  const std::vector<EnclosedUnit> driven = driven_units(mechanism, t);
  JointEnds ends = typed_ends(mechanism);
  const KnownMotions known = known_motions(mechanism, t, [&](const KnownMotions& so_far) {
    return Bodies(mechanism, t, driven, ends, so_far).linear_slides();
  });
  if (has_shared_pins(mechanism)) {
    ends = Bodies(mechanism, t, driven, ends, known).ends_by_order_of_blocks();
  }
  Formulation formulation = Bodies(mechanism, t, driven, ends, known).build();
  formulation.has_rounded_angles = std::any_of(
      driven.begin(), driven.end(), [](const EnclosedUnit& unit) { return unit.error > 0; });
  formulation.enclosed = [mechanism, t, driven, ends, known, plain = formulation] {
    return Bodies(mechanism, t, driven, ends, known, true).enclosed(plain);
  };
  return formulation;
}

}  // namespace moivre
