// SPDX-License-Identifier: MIT
// The page of a spatial mechanism: a canvas a closure, lines and spots in space as data, and a script that turns them.
//
// Data, as JSON: {"centre": [x, y, z], "radius": r, "ground": [stroke ...], "names": [[[x, y, z], name] ...],
// "closures": [{"strokes": [stroke ...], "spots": [[x, y, z] ...]}]}; a stroke is [from, to, colour, pixels].
#include "turning_page.h"

#include <Eigen/Geometry>
#include <algorithm>

#include "moivre/mechanism/pose.h"
#include "moivre/report/number_text.h"
#include "page_assets.h"
#include "page_parts.h"
#include "svg.h"

namespace moivre {
namespace {

using Eigen::Vector3d;
using Eigen::VectorXd;

constexpr const char* kAxisColour = "#c3ccd4";
constexpr const char* kRodColour = "#4a5765";
constexpr double kBodyWidth = 5;  // pixels
constexpr double kRodWidth = 3;
constexpr double kFineWidth = 1.5;

Json place_json(const Vector3d& at) {
  return Json::array({rounded(at.x()), rounded(at.y()), rounded(at.z())});
}

Json stroke_json(const Vector3d& from, const Vector3d& to, const std::string& colour,
                 double width) {
  return Json::array({place_json(from), place_json(to), colour, width});
}

/// Named points of all bodies, and the ground's.
Eigen::AlignedBox3d extent(const Mechanism& mechanism, const std::vector<VectorXd>& poses) {
  Eigen::AlignedBox3d box(Vector3d::Zero());
  for (const VectorXd& q : poses) {
    for (std::size_t body = 0; body < mechanism.bodies.size(); ++body) {
      for (std::size_t k = 0; k < mechanism.bodies[body].points.size(); ++k) {
        box.extend(point_position(mechanism, {body, k}, q));
      }
    }
  }
  return box;
}

Json strokes_json(const Mechanism& mechanism, const VectorXd& q, double size) {
  Json strokes = Json::array();
  for (std::size_t body = 1; body < mechanism.bodies.size(); ++body) {
    const std::size_t count = mechanism.bodies[body].points.size();
    const std::size_t lines = count > 2 ? count : count - std::min<std::size_t>(count, 1);
    for (std::size_t k = 0; k < lines; ++k) {
      strokes.push_back(stroke_json(point_position(mechanism, {body, k}, q),
                                    point_position(mechanism, {body, (k + 1) % count}, q),
                                    colour_text(body - 1), kBodyWidth));
    }
  }
  for (const Joint& joint : mechanism.joints) {
    const Vector3d at = point_position(mechanism, joint.at[0], q);
    if (joint.type == JointType::rod) {
      strokes.push_back(
          stroke_json(at, point_position(mechanism, joint.at[1], q), kRodColour, kRodWidth));
    } else if (joint.type != JointType::spherical && joint.type != JointType::weld) {
      const Vector3d reach =
          0.06 * size * (orientation(mechanism, joint.at[0].body, q) * joint.axis[0]);
      strokes.push_back(stroke_json(at - reach, at + reach, kRodColour, kFineWidth));
    }
  }
  return strokes;
}

Json closure_json(const Mechanism& mechanism, const VectorXd& q, double size) {
  Json spots = Json::array();
  for (const Joint& joint : mechanism.joints) {
    for (const PointOf& point : joint.at) {
      spots.push_back(place_json(point_position(mechanism, point, q)));
    }
  }
  return {{"strokes", strokes_json(mechanism, q, size)}, {"spots", spots}};
}

}  // namespace

std::string turning_html(const ClosureResult& result, const Mechanism& mechanism,
                         const std::string& file, const std::string& summary) {
  constexpr double kTriad = 0.35;  // of the radius
  std::vector<VectorXd> poses;
  for (const Closure& closure : result.closures) poses.push_back(closure.q);
  const Eigen::AlignedBox3d box = extent(mechanism, poses);
  const double radius = std::max(0.5 * box.diagonal().norm(), 1e-12);
  Json data{{"centre", place_json(box.center())},
            {"radius", rounded(radius)},
            {"ground", Json::array()},
            {"names", Json::array()},
            {"closures", Json::array()}};
  for (int k = 0; k < 3; ++k) {
    const Vector3d tip = kTriad * radius * Vector3d::Unit(k);
    data["ground"].push_back(stroke_json(Vector3d::Zero(), tip, kAxisColour, kFineWidth));
    data["names"].push_back(Json::array({place_json(tip), std::string(1, "xyz"[k])}));
  }
  std::string panels;
  for (const Closure& closure : result.closures) {
    data["closures"].push_back(closure_json(mechanism, closure.q, radius));
    panels += element("figure", {},
                      element("figcaption", {}, element("b", {}, escaped(closure.id))) +
                          element("canvas", {{"tabindex", "0"}}, " "));
  }
  const std::string crowd = poses.size() <= 2 ? "few" : poses.size() <= 4 ? "some" : "many";
  const std::string title = mechanism.title.empty() ? file : mechanism.title;
  std::string body = element("h1", {}, escaped(title)) + element("p", {}, escaped(summary)) +
                     element("p", {},
                             "Drag to turn all closures, wheel to come nearer, double click to go "
                             "back; or the arrow keys.") +
                     element("p", {{"id", "error"}}, " ") +
                     element("div", {{"id", "panels"}, {"class", crowd}}, panels);
  body += element("script", {{"type", "application/json"}, {"id", "data"}}, script_data(data));
  return html_document(title, body, turning_script());
}

}  // namespace moivre
