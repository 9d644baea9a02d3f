// SPDX-License-Identifier: MIT
// Bodies, planar joints and drivers as closure polynomials.
#include <algorithm>
#include <numeric>
#include <stdexcept>
#include <utility>

#include "isotropic_frame.h"
#include "meshings.h"
#include "moivre/formulation/block_structure.h"
#include "moivre/mechanism/phi.h"
#include "shared_pins.h"

namespace moivre {
namespace {

class Bodies {
 public:
  Bodies(const Mechanism& mechanism, double t, JointEnds ends)
      : mechanism_(mechanism),
        t_(t),
        ends_(std::move(ends)),
        angles_(known_angles(mechanism, t)),
        frame_(names(mechanism)),
        size_(Phi(mechanism).length()) {}

  Formulation build() &&;
  JointEnds ends_by_order_of_blocks() &&;

 private:
  static std::vector<std::string> names(const Mechanism& mechanism);
  void hold_angles();
  void add_positions();
  void add_joint(const Joint& joint);
  void add_line(const Joint& joint);
  void add_gear(const Joint& joint);
  void add_driver(const Driver& driver);
  void read_coordinates();
  void write();

  /// A place or direction of a body's frame as a complex number, turned with the body.
  Mirrored turned(std::size_t body, const Eigen::Vector3d& at) const {
    return typed_decimal(at.x(), at.y()) * frame_.t(body);
  }
  Mirrored place(const PointOf& point) const {
    return positions_[point.body] +
           turned(point.body, mechanism_.bodies[point.body].points[point.point].at);
  }
  /// From the joint's first point to its second.
  Mirrored gap(const Joint& joint) const {
    const auto& ends = ends_[static_cast<std::size_t>(&joint - mechanism_.joints.data())];
    return place(ends[1]) - place(ends[0]);
  }
  Polynomial without_rounding(Polynomial p) const;
  Mirrored without_rounding(const Mirrored& z) const {
    return {without_rounding(z.z), without_rounding(z.conjugate)};
  }
  std::string label(const Joint& joint) const { return to_string(joint.type) + " " + joint.name; }
  /// The driver that moves along this joint's line, if there is one.
  const Driver* slide_of(const Joint& joint) const;

  const Mechanism& mechanism_;
  double t_;
  JointEnds ends_;
  std::vector<std::optional<KnownAngle>>
      angles_;  ///< of bodies, as drivers and gears determine them
  IsotropicFrame frame_;
  double size_;  ///< of the mechanism
  std::vector<Mirrored> positions_;
};

std::vector<std::string> Bodies::names(const Mechanism& mechanism) {
  std::vector<std::string> names;
  for (std::size_t i = 1; i < mechanism.bodies.size(); ++i) {
    names.push_back(mechanism.bodies[i].name);
  }
  return names;
}

void Bodies::hold_angles() {
  for (const Driver& driver : mechanism_.drivers) {
    if (driver.kind != DriverKind::angle) continue;
    frame_.hold_angle(driver.bodies[0], driver.bodies[1],
                      unit_at(driver_state(driver.law, t_).value), "driver " + driver.name);
  }
  for (const Joint& joint : mechanism_.joints) {
    if (traits(joint.type).turn != JointTurn::not_at_all) continue;
    frame_.hold_angle(joint.at[0].body, joint.at[1].body, unit_at(joint.turn_rad), label(joint));
  }
  for (const Joint& joint : mechanism_.joints) {
    if (traits(joint.type).turn != JointTurn::geared || !is_settled(joint, angles_)) continue;
    for (const std::size_t body : {joint.at[0].body, joint.at[1].body, joint.gear.carrier}) {
      const auto& [root, value] = *angles_[body];
      if (frame_.angle(body).root == frame_.angle(root).root) continue;
      frame_.hold_angle(root, body, unit_at(value), label(joint));
    }
  }
}

void Bodies::add_positions() {
  positions_.push_back({constant({0, 0}), constant({0, 0})});
  for (std::size_t i = 1; i < mechanism_.bodies.size(); ++i) {
    const std::string& name = mechanism_.bodies[i].name;
    positions_.push_back(frame_.add_pair(name, name));
  }
}

/// p, linear in lengths, without what points as typed leave where they mean nothing: a coefficient that is rounding beside the
/// mechanism's size would be a root at 1e16.
Polynomial Bodies::without_rounding(Polynomial p) const {
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

const Driver* Bodies::slide_of(const Joint& joint) const {
  for (const Driver& driver : mechanism_.drivers) {
    if (driver.kind == DriverKind::slide && &mechanism_.joints[driver.joint] == &joint) {
      return &driver;
    }
  }
  return nullptr;
}

void Bodies::add_line(const Joint& joint) {
  const Mirrored along = turned(joint.at[0].body, joint.axis[0]);
  if (const Driver* driver = slide_of(joint)) {
    const Coefficient s{typed_decimal(driver_state(driver->law, t_).value), 0};
    frame_.add_equations(label(joint) + ": slide", without_rounding(gap(joint) - s * along));
    return;
  }
  const Mirrored across = swapped(along) * gap(joint);
  frame_.add_equation(label(joint) + ": line", without_rounding(across.z - across.conjugate));
}

void Bodies::add_gear(const Joint& joint) {
  const auto& gear = joint.gear;
  const int common = std::gcd(gear.teeth[0], gear.teeth[1]);
  const int zi = gear.teeth[0] / common;
  const int zj = gear.teeth[1] / common;
  frame_.add_turn(label(joint),
                  {{joint.at[0].body, zi}, {gear.carrier, zj - zi}, {joint.at[1].body, -zj}},
                  unit_at(-zj * gear.phase_rad));
}

void Bodies::add_joint(const Joint& joint) {
  switch (traits(joint.type).place) {
    case JointPlace::at_point:
      frame_.add_equations(label(joint), without_rounding(gap(joint)));
      return;
    case JointPlace::on_line:
      add_line(joint);
      return;
    case JointPlace::at_distance: {
      const Mirrored d = gap(joint);
      const Rational length = typed_decimal(joint.length);
      frame_.add_equation(label(joint),
                          rounded_difference(d.z * d.conjugate, constant({length * length, 0})));
      return;
    }
    case JointPlace::anywhere:
      if (!is_settled(joint, angles_)) add_gear(joint);
      return;
    case JointPlace::in_plane:
      break;
  }
  throw std::logic_error("a planar mechanism has no " + to_string(joint.type) + " joint");
}

void Bodies::add_driver(const Driver& driver) {
  if (driver.kind != DriverKind::x && driver.kind != DriverKind::y) return;
  const Mirrored at = place(driver.point);
  const Rational value = typed_decimal(driver_state(driver.law, t_).value);
  const std::string name = "driver " + driver.name;
  if (driver.kind == DriverKind::x) {
    frame_.add_equation(name, at.z + at.conjugate - constant({2 * value, 0}));
  } else {
    frame_.add_equation(name, at.z - at.conjugate - constant({0, 2 * value}));
  }
}

void Bodies::read_coordinates() {
  using Part = Formulation::Reading::Part;
  for (std::size_t i = 1; i < mechanism_.bodies.size(); ++i) {
    auto& coordinates = frame_.result().coordinates;
    coordinates.push_back({Part::re, positions_[i].z});
    coordinates.push_back({Part::im, positions_[i].z});
    coordinates.push_back({Part::argument, frame_.t(i).z});
  }
}

void Bodies::write() {
  hold_angles();
  add_positions();
  frame_.add_angles("_");
  for (const Driver& driver : mechanism_.drivers) add_driver(driver);
  for (const Joint& joint : mechanism_.joints) add_joint(joint);
}

Formulation Bodies::build() && {
  write();
  read_coordinates();
  return std::move(frame_).take();
}

/// Pins begin at the ground, else at the body of the earliest block.
JointEnds Bodies::ends_by_order_of_blocks() && {
  write();
  const System& f = frame_.result().system;
  const BlockStructure structure = block_structure(f);
  std::vector<std::size_t> block_of(f.variables.size(), structure.blocks.size());
  for (std::size_t b = 0; b < structure.blocks.size(); ++b) {
    for (const std::size_t v : structure.blocks[b].variables) block_of[v] = b;
  }
  return star_ends(mechanism_, [&](PointOf point) {
    std::size_t rank = 0;  // the ground's, which holds no variable; of others the block, from 1 on
    for (const Term& term : place(point).z.terms) {
      for (const Power& power : term.monomial) rank = std::max(rank, block_of[power.variable] + 1);
    }
    return rank;
  });
}

}  // namespace

Formulation isotropic_bodies(const Mechanism& mechanism, double t) {
  JointEnds ends = typed_ends(mechanism);
  if (has_shared_pins(mechanism)) ends = Bodies(mechanism, t, ends).ends_by_order_of_blocks();
  return Bodies(mechanism, t, std::move(ends)).build();
}

}  // namespace moivre
