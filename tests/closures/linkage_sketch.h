// SPDX-License-Identifier: MIT
// How is a linkage drawn at random, typed in the coordinates of one assembled pose?
//
// Every point is typed as it lies in that pose, so that the pose is q = 0. Half of the linkages
// have special geometry: places on a lattice, axes along x, y and z, so that axes are parallel,
// meet, and lengths are equal.
#pragma once

#include <Eigen/Geometry>
#include <algorithm>
#include <string>
#include <vector>

#include "moivre/kinematics/newton.h"
#include "moivre/mechanism/joint_type.h"
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

/// The pieces of a linkage that random drawers put together.
class LinkageSketch {
 protected:
  LinkageSketch(Space space, Draw draw) : draw_(draw) { mechanism_.space = space; }

  /// Nothing but the ground.
  void begin() {
    is_special_ = draw_.unit() < 0.5;
    const Space space = mechanism_.space;
    mechanism_ = {};
    mechanism_.space = space;
  }

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

  void add_gear(std::size_t i, std::size_t j, const Gear& gear) {
    Joint joint;
    joint.type = JointType::gear;
    joint.name = "G" + std::to_string(mechanism_.joints.size());
    joint.at = {PointOf{i, 0}, PointOf{j, 0}};
    joint.gear = gear;
    mechanism_.joints.push_back(joint);
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

}  // namespace moivre::test
