// SPDX-License-Identifier: MIT
// Poses as JSON objects keyed by the file's names.
#include "pose_json.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <span>

#include "moivre/mechanism/pose.h"

namespace moivre {
namespace {

/// Place and unit quaternion, its first number that is not zero positive.
void add_spatial_body(const Mechanism& mechanism, std::size_t body, const Eigen::VectorXd& q,
                      std::vector<double>& numbers) {
  constexpr Eigen::Index kSize = 6;
  const Eigen::Index at = kSize * static_cast<Eigen::Index>(body - 1);
  const Eigen::Quaterniond turn(orientation(mechanism, body, q));
  const std::array<double, 4> parts{turn.w(), turn.x(), turn.y(), turn.z()};
  const auto first = std::find_if(parts.begin(), parts.end(), [](double x) { return x != 0; });
  const double sign = first != parts.end() && *first < 0 ? -1 : 1;
  numbers.insert(numbers.end(), {q[at], q[at + 1], q[at + 2]});
  for (const double part : parts) numbers.push_back(part == 0 ? 0 : sign * part);
}

Json bodies_form(const Mechanism& mechanism) {
  Json form = Json::object();
  if (is_typed(mechanism)) return form;
  if (mechanism.space == Space::spatial) {
    for (std::size_t body = 1; body < mechanism.bodies.size(); ++body) {
      form[mechanism.bodies[body].name] = {
          {"x", nullptr}, {"y", nullptr}, {"z", nullptr}, {"q", Json::array_t(4)}};
    }
    return form;
  }
  for (const Coordinate& coordinate : coordinates(mechanism)) {
    const std::string& body = mechanism.bodies[coordinate.group + 1].name;
    form[body][coordinate.name.substr(body.size() + 1)] = nullptr;
  }
  return form;
}

/// In the order of the form.
std::vector<double> body_numbers(const Mechanism& mechanism, const Eigen::VectorXd& q) {
  std::vector<double> numbers;
  if (is_typed(mechanism)) return numbers;
  if (mechanism.space == Space::planar) return {q.begin(), q.end()};
  for (std::size_t body = 1; body < mechanism.bodies.size(); ++body) {
    add_spatial_body(mechanism, body, q, numbers);
  }
  return numbers;
}

std::size_t axes_of(const Mechanism& mechanism) { return mechanism.space == Space::planar ? 2 : 3; }

Json points_form(const Mechanism& mechanism) {
  const std::size_t axes = axes_of(mechanism);
  Json form = Json::object();
  for (std::size_t body = 1; body < mechanism.bodies.size(); ++body) {
    for (const BodyPoint& point : mechanism.bodies[body].points) {
      form[mechanism.bodies[body].name + "." + point.name] = Json::array_t(axes);
    }
  }
  return form;
}

/// In the order of the form.
std::vector<double> point_numbers(const Mechanism& mechanism, const Eigen::VectorXd& q) {
  const auto axes = static_cast<Eigen::Index>(axes_of(mechanism));
  const Eigen::VectorXd rest = Eigen::VectorXd::Zero(q.size());
  std::vector<double> numbers;
  for (const PointState& at : point_states(mechanism, q, rest, rest)) {
    numbers.insert(numbers.end(), at.position.begin(), at.position.begin() + axes);
  }
  return numbers;
}

}  // namespace

void refill(Json& tree, const Eigen::VectorXd& numbers) {
  refill(tree, std::span<const double>(numbers.data(), static_cast<std::size_t>(numbers.size())));
}

Json coordinates_form(const Mechanism& mechanism) {
  Json form = Json::object();
  for (const Coordinate& coordinate : coordinates(mechanism)) form[coordinate.name] = nullptr;
  return form;
}

PoseJson::PoseJson(const Mechanism& mechanism)
    : mechanism_(mechanism),
      pose_{{"coordinates", coordinates_form(mechanism)},
            {"bodies", bodies_form(mechanism)},
            {"points", points_form(mechanism)}} {}

const Json& PoseJson::read(const Eigen::VectorXd& q) {
  refill(pose_["coordinates"], q);
  refill(pose_["bodies"], body_numbers(mechanism_, q));
  refill(pose_["points"], point_numbers(mechanism_, q));
  return pose_;
}

Json coordinates_json(const Mechanism& mechanism, const Eigen::VectorXd& q) {
  Json json = coordinates_form(mechanism);
  refill(json, q);
  return json;
}

Json to_json(const Eigen::VectorXd& v) {
  Json json = Json::array();
  for (const double x : v) json.push_back(to_json(x));
  return json;
}

Json idle_json(const std::vector<IdleJoint>& idle) {
  return list_json(idle, [](const IdleJoint& joint) {
    return Json{{"body", joint.body}, {"joint", joint.joint}, {"held", joint.held}};
  });
}

Json rows_json(const Eigen::MatrixXd& m) {
  Json json = Json::array();
  for (Eigen::Index i = 0; i < m.rows(); ++i) {
    json.push_back(to_json(Eigen::VectorXd(m.row(i).transpose())));
  }
  return json;
}

Json units_json(const Mechanism& mechanism) {
  return {{"length", mechanism.units.length.empty() ? Json(nullptr) : Json(mechanism.units.length)},
          {"angle", "rad"}};
}

}  // namespace moivre
