// SPDX-License-Identifier: MIT
// Which mechanisms does nobody tune a program to? Random ones, planar and spatial, typed in the
// coordinates of one assembled pose.
//
// Linkages are drawn until Phi_q is square and regular at q = 0, which is an isolated closure then,
// whatever else the linkage can do.
#pragma once

#include "linkage_sketch.h"
#include "moivre/mechanism/joint_type.h"

namespace moivre::test {

class LinkageDrawer : private LinkageSketch {
 public:
  LinkageDrawer(Space space, Draw draw) : LinkageSketch(space, draw) {}

  /// A linkage that is regular at q = 0.
  Mechanism draw() {
    for (;;) {
      begin();
      if (mechanism_.space == Space::planar) {
        add_planar();
      } else if (draw_.unit() < 0.7) {
        add_loop();
      } else {
        add_platform();
      }
      if (is_regular()) return mechanism_;
    }
  }

 private:
  /// One loop through the ground.
  void add_loop() {
    std::vector<JointType> types;
    while (freedoms_of(types) < 6) {
      types.push_back(one_of({JointType::revolute, JointType::revolute, JointType::revolute,
                              JointType::prismatic, JointType::cylindrical, JointType::universal,
                              JointType::spherical, JointType::planar, JointType::point_on_line,
                              JointType::point_on_plane, JointType::screw}));
    }
    if (types.size() < 2) return;
    std::size_t last = 0;
    for (std::size_t k = 0; k < types.size(); ++k) {
      const std::size_t next = k + 1 < types.size() ? add_body() : 0;
      draw_.unit() < 0.5 ? add_joint(types[k], last, next) : add_joint(types[k], next, last);
      last = next;
    }
    add_drivers(freedoms_of(types) - 6);
  }

  /// A body on two or three legs, or on six loose ties.
  void add_platform() {
    const std::size_t platform = add_body();
    const std::size_t legs = 2 + draw_.below(2);
    if (draw_.unit() < 0.4) {
      for (int rows = 0; rows < 6;) {
        const JointType type = one_of(
            {JointType::rod, JointType::rod, JointType::point_on_plane, JointType::point_on_line});
        rows += 6 - freedoms(type, Space::spatial);
        add_joint(type, 0, platform);
      }
      return;
    }
    int sum = 6;
    for (std::size_t leg = 0; leg < legs; ++leg) {
      std::vector<JointType> types;
      const int most = legs == 2 ? 3 : 4;
      while (freedoms_of(types) < most) {
        types.push_back(
            one_of({JointType::revolute, JointType::revolute, JointType::prismatic,
                    JointType::universal, JointType::spherical, JointType::cylindrical}));
      }
      std::size_t last = 0;
      for (std::size_t k = 0; k < types.size(); ++k) {
        const std::size_t next = k + 1 < types.size() ? add_body() : platform;
        add_joint(types[k], last, next);
        last = next;
      }
      sum += freedoms_of(types) - 6;
    }
    add_drivers(sum);
  }

  /// A tree of pins and slides from the ground, closed by joints until nothing is free but drivers;
  /// wheels now and then.
  void add_planar() {
    const std::size_t moving = 2 + draw_.below(6);
    int free = 0;
    for (std::size_t k = 0; k < moving; ++k) {
      const std::size_t to = draw_.below(mechanism_.bodies.size());
      const JointType type = one_of({JointType::revolute, JointType::revolute, JointType::revolute,
                                     JointType::prismatic, JointType::slot});
      add_joint(type, to, add_body());
      free += freedoms(type, Space::planar);
    }
    const int drivers = 1 + static_cast<int>(draw_.below(2));
    while (free > drivers) {
      const std::size_t i = draw_.below(mechanism_.bodies.size());
      const std::size_t j = draw_.below(mechanism_.bodies.size());
      if (i == j) continue;
      const JointType type = free == drivers + 1
                                 ? one_of({JointType::slot, JointType::rod})
                                 : one_of({JointType::revolute, JointType::revolute,
                                           JointType::prismatic, JointType::slot, JointType::rod});
      add_joint(type, i, j);
      free -= 3 - freedoms(type, Space::planar);
    }
    if (draw_.unit() < 0.2) add_wheel();
    add_drivers(free);
  }

  /// A wheel on the ground that meshes with a body.
  void add_wheel() {
    const std::size_t partner = 1 + draw_.below(mechanism_.bodies.size() - 1);
    const std::size_t wheel = add_body();
    add_joint(JointType::revolute, 0, wheel);
    Gear gear;
    gear.teeth = {1 + static_cast<int>(draw_.below(4)), -1 - static_cast<int>(draw_.below(4))};
    gear.has_all_meshings = true;
    add_gear(partner, wheel, gear);
  }

  void add_drivers(int count) {
    std::vector<std::size_t> drivable;
    for (std::size_t k = 0; k < mechanism_.joints.size(); ++k) {
      const JointType type = mechanism_.joints[k].type;
      // A screw ties an angle to a length: closures need it driven.
      if (type == JointType::screw) {
        drive(k);
        --count;
      } else if (has_angle(type) || (has_slide(type) && type != JointType::point_on_line)) {
        drivable.push_back(k);
      }
    }
    for (; count > 0 && !drivable.empty(); --count) {
      const std::size_t chosen = draw_.below(drivable.size());
      drive(drivable[chosen]);
      drivable.erase(drivable.begin() + static_cast<std::ptrdiff_t>(chosen));
    }
  }
};

inline Mechanism random_linkage(Space space, std::uint64_t seed, std::uint64_t number) {
  return LinkageDrawer(space, Draw(seed, number)).draw();
}

}  // namespace moivre::test
