// SPDX-License-Identifier: MIT
// Names and frames of a robot's links, outwards from the root.
#include "layout.h"

#include <Eigen/Geometry>
#include <cctype>
#include <cmath>
#include <numbers>

#include "moivre/urdf/placement.h"

namespace moivre {
namespace {

/// The angle as typed, or the right angle that it means where that is nearer than a nanoradian.
double meant_angle(const Rational& angle) {
  constexpr double kNanoradian = 1e-9;
  const auto quarters = quarter_turns(angle);
  const double typed = to_double(angle);
  const double right = quarters.value_or(0) * (std::numbers::pi / 2);
  return quarters && std::abs(typed - right) < kNanoradian ? right : typed;
}

/// Rotation with entries that are 0 and 1 where the angles are right.
Eigen::Matrix3d meant_rotation(const ExactVector& rpy) {
  Eigen::Matrix3d product = Eigen::Matrix3d::Identity();
  for (const int k : {2, 1, 0}) {
    const double angle = meant_angle(rpy[static_cast<std::size_t>(k)]);
    product *= Eigen::AngleAxisd(angle, Eigen::Vector3d::Unit(k)).toRotationMatrix();
  }
  constexpr double kRounding = 1e-15;
  return product.unaryExpr([](double x) { return std::abs(x) < kRounding ? 0 : x; });
}

std::vector<std::size_t> outwards(const Robot& robot) {
  std::vector<std::size_t> order{robot.root};
  for (std::size_t k = 0; k < order.size(); ++k) {
    for (const std::size_t joint : robot.links[order[k]].children) {
      order.push_back(robot.joints[joint].child);
    }
  }
  return order;
}

}  // namespace

std::string typed_name(const std::string& name, std::set<std::string>& taken) {
  std::string clean;
  for (const char c : name) {
    const bool is_fit = std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_' || c == '-';
    clean += is_fit ? c : '_';
  }
  std::string unique = clean;
  for (int k = 2; !taken.insert(unique).second; ++k) unique = clean + "_" + std::to_string(k);
  return unique;
}

Layout layout_of(const Robot& robot) {
  Layout layout;
  std::set<std::string> bodies{"ground"};
  for (std::size_t k = 0; k < robot.links.size(); ++k) {
    layout.bodies.push_back(k == robot.root ? "ground" : typed_name(robot.links[k].name, bodies));
  }
  std::set<std::string> joints;
  for (const RobotJoint& joint : robot.joints) {
    layout.joints.push_back(typed_name(joint.name, joints));
  }
  layout.order = outwards(robot);
  layout.rotation.assign(robot.links.size(), Eigen::Matrix3d::Identity());
  for (const std::size_t link : layout.order) {
    for (const std::size_t joint : robot.links[link].children) {
      layout.rotation[robot.joints[joint].child] =
          layout.rotation[link] * meant_rotation(robot.joints[joint].rpy);
    }
  }
  return layout;
}

}  // namespace moivre
