// SPDX-License-Identifier: MIT
// Which mechanisms does nobody tune a program to? Random ones, planar and spatial, typed in the coordinates of one assembled pose.
//
// Every point is typed as it lies in that pose, so that the pose is q = 0. Linkages are drawn until Phi_q is square and regular
// there: q = 0 is an isolated closure, whatever else the linkage can do. Half of them have special geometry: places on a lattice,
// axes along x, y and z, so that axes are parallel, meet, and lengths are equal.
#pragma once

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <optional>
#include <string>
#include <vector>

#include "moivre/kinematics/newton.h"
#include "moivre/numeric/random.h"

namespace moivre::test {

/// Numbers of one linkage, one after another.
class Draw {
 public:
  Draw(std::uint64_t seed, std::uint64_t number) : seed_(seed), next_(number << 32) {}
  double unit() { return random_unit(seed_, RandomStream::test, next_++); }
  std::size_t below(std::size_t n) {
    return std::min(n - 1, static_cast<std::size_t>(unit() * static_cast<double>(n)));
  }
  /// With three decimals, in (-2, 2).
  double number() { return std::round(4000 * unit() - 2000) / 1000; }

 private:
  std::uint64_t seed_, next_;
};

class LinkageDrawer {
 public:
  LinkageDrawer(Space space, Draw draw) : draw_(draw) { mechanism_.space = space; }

  /// A linkage that is regular at q = 0.
  Mechanism draw() {
    for (;;) {
      is_special_ = draw_.unit() < 0.5;
      const Space space = mechanism_.space;
      mechanism_ = {};
      mechanism_.space = space;
      if (space == Space::planar) {
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
  Eigen::Vector3d place() {
    const auto coordinate = [&] {
      return is_special_ ? static_cast<double>(draw_.below(5)) - 2 : draw_.number();
    };
    Eigen::Vector3d at(coordinate(), coordinate(), coordinate());
    if (mechanism_.space == Space::planar) at.z() = 0;
    return at;
  }

  Eigen::Vector3d direction() {
    if (is_special_ && draw_.unit() < 0.8) {
      return Eigen::Vector3d::Unit(
          static_cast<Eigen::Index>(draw_.below(mechanism_.space == Space::planar ? 2 : 3)));
    }
    Eigen::Vector3d along = place();
    while (along.norm() < 0.5) along = place();
    return along.normalized();
  }

  std::size_t add_body() {
    mechanism_.bodies.push_back({"b" + std::to_string(mechanism_.bodies.size()), {}, {}});
    return mechanism_.bodies.size() - 1;
  }

  PointOf add_point(std::size_t body, const Eigen::Vector3d& at) {
    auto& points = mechanism_.bodies[body].points;
    points.push_back({"P" + std::to_string(points.size()), at, {}});
    return {body, points.size() - 1};
  }

  void add_joint(JointType type, std::size_t i, std::size_t j) {
    Joint joint;
    joint.type = type;
    joint.name = "J" + std::to_string(mechanism_.joints.size());
    const Eigen::Vector3d a = place();
    Eigen::Vector3d b = a;
    joint.axis.fill(direction());
    switch (traits(type).place) {
      case JointPlace::on_line:
        b += draw_.number() * joint.axis[0];
        break;
      case JointPlace::in_plane:
        b += draw_.number() * joint.axis[0].unitOrthogonal();
        break;
      case JointPlace::at_distance:
        while ((a - b).norm() < 0.5) b = place();
        joint.length = (a - b).norm();
        break;
      case JointPlace::at_point:
      case JointPlace::anywhere:
      case JointPlace::off_line:
      case JointPlace::at_any_distance:
        break;
    }
    if (traits(type).turn == JointTurn::about_two_axes) {
      joint.axis[1] = joint.axis[0].unitOrthogonal();
    }
    if (traits(type).turn == JointTurn::by_thread) {
      joint.pitch = 0.5;
      b = a;
    }
    joint.at = {add_point(i, a), add_point(j, b)};
    mechanism_.joints.push_back(joint);
  }

  int freedoms_of(const std::vector<JointType>& types) const {
    int sum = 0;
    for (const JointType type : types) sum += freedoms(type, mechanism_.space);
    return sum;
  }

  JointType one_of(const std::vector<JointType>& types) { return types[draw_.below(types.size())]; }

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

  /// A tree of pins and slides from the ground, closed by joints until nothing is free but drivers; wheels now and then.
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
    Joint gear;
    gear.type = JointType::gear;
    gear.name = "G";
    gear.at = {PointOf{partner, 0}, PointOf{wheel, 0}};
    gear.gear.teeth = {1 + static_cast<int>(draw_.below(4)), -1 - static_cast<int>(draw_.below(4))};
    gear.gear.has_all_meshings = true;
    mechanism_.joints.push_back(gear);
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

  void drive(std::size_t number) {
    const Joint& joint = mechanism_.joints[number];
    Driver driver;
    driver.name = joint.name;
    driver.joint = number;
    const bool slides = has_slide(joint.type);
    driver.kind = slides ? DriverKind::slide : DriverKind::angle;
    driver.bodies = {joint.at[0].body, joint.at[1].body};
    const auto point = [&](std::size_t k) {
      return mechanism_.bodies[joint.at[k].body].points[joint.at[k].point].at;
    };
    driver.law = Parabola{slides ? joint.axis[0].dot(point(1) - point(0)) : 0, 0, 0};
    mechanism_.drivers.push_back(driver);
  }

  bool is_regular() const {
    if (mechanism_.bodies.size() < 2 || mechanism_.joints.empty()) return false;
    const Phi phi(mechanism_);
    if (phi.size() != phi.dimension()) return false;
    const Eigen::VectorXd origin = Eigen::VectorXd::Zero(phi.dimension());
    constexpr double kRegular = 1e-3;
    const NewtonResult there = newton(phi, origin);
    return there.status == NewtonStatus::converged && there.steps() == 0 && !there.is_singular &&
           there.smallest_singular_value > kRegular;
  }

  Draw draw_;
  bool is_special_ = false;
  Mechanism mechanism_;
};

inline Mechanism random_linkage(Space space, std::uint64_t seed, std::uint64_t number) {
  return LinkageDrawer(space, Draw(seed, number)).draw();
}

}  // namespace moivre::test
