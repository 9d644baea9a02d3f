// SPDX-License-Identifier: MIT
// Poses as JSON objects keyed by the file's names.
#include "pose_json.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>

#include "moivre/mechanism/pose.h"

namespace moivre {
namespace {

/// Place and unit quaternion, its first number that is not zero positive.
Json spatial_body_json(const Mechanism& mechanism, std::size_t body, const Eigen::VectorXd& q) {
  constexpr Eigen::Index kSize = 6;
  const Eigen::Index at = kSize * static_cast<Eigen::Index>(body - 1);
  const Eigen::Quaterniond turn(orientation(mechanism, body, q));
  std::array<double, 4> parts{turn.w(), turn.x(), turn.y(), turn.z()};
  const auto first = std::find_if(parts.begin(), parts.end(), [](double x) { return x != 0; });
  const double sign = first != parts.end() && *first < 0 ? -1 : 1;
  Json quaternion = Json::array();
  for (const double part : parts) quaternion.push_back(to_json(part == 0 ? 0 : sign * part));
  return {{"x", to_json(q[at])},
          {"y", to_json(q[at + 1])},
          {"z", to_json(q[at + 2])},
          {"q", quaternion}};
}

}  // namespace

Json coordinates_json(const Mechanism& mechanism, const Eigen::VectorXd& q) {
  Json json = Json::object();
  Eigen::Index k = 0;
  for (const Coordinate& coordinate : coordinates(mechanism)) {
    json[coordinate.name] = to_json(q[k++]);
  }
  return json;
}

Json bodies_json(const Mechanism& mechanism, const Eigen::VectorXd& q) {
  Json json = Json::object();
  if (is_typed(mechanism)) return json;
  const std::vector<Coordinate> names = coordinates(mechanism);
  if (mechanism.space == Space::spatial) {
    for (std::size_t body = 1; body < mechanism.bodies.size(); ++body) {
      json[mechanism.bodies[body].name] = spatial_body_json(mechanism, body, q);
    }
    return json;
  }
  for (Eigen::Index k = 0; k < q.size(); ++k) {
    const Coordinate& coordinate = names[static_cast<std::size_t>(k)];
    const std::string& body = mechanism.bodies[coordinate.group + 1].name;
    json[body][coordinate.name.substr(body.size() + 1)] = to_json(q[k]);
  }
  return json;
}

Json points_json(const Mechanism& mechanism, const Eigen::VectorXd& q) {
  Json json = Json::object();
  const bool is_spatial = mechanism.space == Space::spatial;
  for (std::size_t body = 1; body < mechanism.bodies.size(); ++body) {
    for (std::size_t k = 0; k < mechanism.bodies[body].points.size(); ++k) {
      const Eigen::Vector3d r = point_position(mechanism, {body, k}, q);
      Json at = Json::array({to_json(r.x()), to_json(r.y())});
      if (is_spatial) at.push_back(to_json(r.z()));
      json[mechanism.bodies[body].name + "." + mechanism.bodies[body].points[k].name] = at;
    }
  }
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
