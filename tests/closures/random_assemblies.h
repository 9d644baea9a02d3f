// SPDX-License-Identifier: MIT
// Which planar mechanisms do designers build, drawn at random? Groups one after another on cranks,
// with gears, and wheels that idle.
//
//   crank          a body on a pin or a slide of the ground, driven
//   group          one to four loops of dyads (two bodies and three joints), single bodies, and
//                  ternary bodies on three legs; each hangs on two or three bodies that are there
//                  already, now and then on the cranks and the ground alone: a sub-chain
//   gear           a wheel on a body that is there, meshing with another: a pair on the ground, a
//                  planet on an arm
//   idle           wheels, pairs of wheels and sliders on which nothing depends
// q = 0 is a closure, isolated but for what idles.
#pragma once

#include <numeric>
#include <utility>

#include "linkage_sketch.h"

namespace moivre::test {

struct Assembly {
  Mechanism mechanism;
  /// Its first bodies, without what idles, gears replaced by drivers where the drivers determine
  /// the meshing: it has the same closures.
  Mechanism plain;
};

class AssemblyDrawer : private LinkageSketch {
 public:
  explicit AssemblyDrawer(Draw draw) : LinkageSketch(Space::planar, draw) {}

  Assembly draw() {
    for (;;) {
      begin();
      frame_ = {0};
      settled_.clear();
      add_cranks();
      for (std::size_t loops = 1 + draw_.below(4); loops > 0;) loops -= add_group(loops);
      if (!is_regular()) continue;
      Assembly assembly;
      assembly.plain = plain();
      add_idle();
      assembly.mechanism = std::move(mechanism_);
      return assembly;
    }
  }

 private:
  std::size_t add_framed_body() {
    frame_.push_back(mechanism_.bodies.size());
    return add_body();
  }

  /// A joint to a new body, which turns like `base` where the joint lets it not turn.
  void join(JointType type, std::size_t base, std::size_t body) {
    draw_.unit() < 0.5 ? add_joint(type, base, body) : add_joint(type, body, base);
    if (type == JointType::prismatic) frame_[body] = frame_[base];
  }

  void add_cranks() {
    cranks_ = draw_.unit() < 0.8 ? 1 : 2;
    for (std::size_t k = 0; k < cranks_; ++k) {
      const bool slides = draw_.unit() < 0.2;
      add_joint(slides ? JointType::prismatic : JointType::revolute, 0, add_framed_body());
      drive(mechanism_.joints.size() - 1);
      frame_.back() = 0;
    }
  }

  /// `count` different bodies to hang a group on.
  std::vector<std::size_t> bases(std::size_t count) {
    const bool is_sub_chain = draw_.unit() < 0.4 && cranks_ + 1 >= count;
    std::vector<std::size_t> all(is_sub_chain ? cranks_ + 1 : mechanism_.bodies.size());
    std::iota(all.begin(), all.end(), std::size_t{0});
    std::vector<std::size_t> chosen;
    while (chosen.size() < count) {
      const auto next = all.begin() + static_cast<std::ptrdiff_t>(draw_.below(all.size()));
      chosen.push_back(*next);
      all.erase(next);
    }
    return chosen;
  }

  /// Returns its loops.
  std::size_t add_group(std::size_t most) {
    const double kind = draw_.unit();
    if (kind < 0.25) {
      add_wheel();
    } else if (kind < 0.4) {
      add_single();
    } else if (kind < 0.55 && most > 1 && mechanism_.bodies.size() > 2) {
      add_ternary();
      return 2;
    } else {
      add_dyad();
    }
    return 1;
  }

  /// base - body - body - base, each joint a pin or a slide, not all of them slides.
  void add_dyad() {
    const std::vector<std::size_t> base = bases(2);
    std::vector<JointType> types;
    do {
      types.clear();
      for (int k = 0; k < 3; ++k) {
        types.push_back(one_of(
            {JointType::revolute, JointType::revolute, JointType::revolute, JointType::prismatic}));
      }
    } while (std::count(types.begin(), types.end(), JointType::prismatic) == 3);
    const std::size_t first = add_framed_body();
    const std::size_t second = add_framed_body();
    join(types[0], base[0], first);
    join(types[2], base[1], second);
    // The body that slides nowhere else turns like the other.
    types[0] == JointType::prismatic ? join(types[1], first, second)
                                     : join(types[1], second, first);
  }

  /// A body on a pin and a slot or a rod, or on three of these.
  void add_single() {
    const bool has_pin = draw_.unit() < 0.6 || mechanism_.bodies.size() < 3;
    const std::vector<std::size_t> base = bases(has_pin ? 2 : 3);
    const std::size_t body = add_framed_body();
    if (has_pin) join(JointType::revolute, base[0], body);
    for (std::size_t k = has_pin ? 1 : 0; k < base.size(); ++k) {
      join(one_of({JointType::slot, JointType::rod}), base[k], body);
    }
  }

  /// A body on three legs, each a body between two pins, or a rod.
  void add_ternary() {
    const std::vector<std::size_t> base = bases(3);
    const std::size_t body = add_framed_body();
    for (const std::size_t foot : base) {
      if (draw_.unit() < 0.3) {
        join(JointType::rod, foot, body);
        continue;
      }
      const std::size_t leg = add_framed_body();
      join(JointType::revolute, foot, leg);
      join(JointType::revolute, leg, body);
    }
  }

  Gear gear_on(std::size_t carrier) {
    Gear gear;
    const auto teeth = [&] { return 1 + static_cast<int>(draw_.below(3)); };
    gear.teeth = {teeth(), draw_.unit() < 0.7 ? -teeth() : teeth()};
    gear.carrier = carrier;
    return gear;
  }

  /// On a carrier, meshing with another body: the ground, as the sun of a planet, too.
  void add_wheel() {
    const std::vector<std::size_t> base = bases(2);
    const std::size_t wheel = add_framed_body();
    join(JointType::revolute, base[0], wheel);
    Gear gear = gear_on(base[0]);
    gear.has_all_meshings = draw_.unit() < 0.3;
    if (!gear.has_all_meshings && frame_[base[0]] == frame_[base[1]]) {
      settled_.push_back(mechanism_.joints.size());
      frame_[wheel] = frame_[base[0]];
    }
    add_gear(base[1], wheel, gear);
  }

  /// The joints that drivers name stand before all gears, and keep their numbers.
  Mechanism plain() const {
    Mechanism plain = mechanism_;
    for (auto gear = settled_.rbegin(); gear != settled_.rend(); ++gear) {
      const Joint& joint = mechanism_.joints[*gear];
      Driver driver;
      driver.name = joint.name;
      driver.bodies = {joint.gear.carrier, joint.at[1].body};
      driver.law = Parabola{0, 0, 0};
      plain.drivers.push_back(driver);
      plain.joints.erase(plain.joints.begin() + static_cast<std::ptrdiff_t>(*gear));
    }
    return plain;
  }

  void add_idle() {
    while (draw_.unit() < 0.4) {
      const std::size_t base = draw_.below(mechanism_.bodies.size());
      const double kind = draw_.unit();
      join(kind < 0.8 ? JointType::revolute : JointType::slot, base, add_framed_body());
      if (kind > 0.3) continue;
      const std::size_t partner = add_framed_body();
      join(JointType::revolute, base, partner);
      add_gear(partner - 1, partner, gear_on(base));
    }
  }

  /// Of each body: a body that always turns like it, the same for all that do; the ground's is 0.
  std::vector<std::size_t> frame_;
  std::vector<std::size_t> settled_;  ///< gears, by joint, whose meshing the drawn pose settles
  std::size_t cranks_ = 0;
};

inline Assembly random_assembly(std::uint64_t seed, std::uint64_t number) {
  return AssemblyDrawer(Draw(seed, number)).draw();
}

}  // namespace moivre::test
