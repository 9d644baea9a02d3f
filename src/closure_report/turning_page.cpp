// SPDX-License-Identifier: MIT
// The page of a spatial mechanism: a canvas a pose, lines and spots in space as data, and a script
// that turns them.
//
// Data, as JSON: {"centre": [x, y, z], "radius": r, "eye": [azimuth, elevation], "closures":
// [{"strokes": [stroke ...], "spots": [[x, y, z] ...], "names": [[[x, y, z], name] ...]}]}; a
// stroke is [from, to, colour, pixels].
#include <Eigen/Geometry>
#include <algorithm>
#include <array>

#include "figures.h"
#include "moivre/closure_report/document.h"
#include "moivre/closure_report/sheet.h"
#include "moivre/mechanism/joint_type.h"
#include "moivre/mechanism/pose.h"
#include "moivre/report/markup.h"
#include "page_assets.h"
#include "svg.h"

namespace moivre {
namespace {

using Eigen::Vector3d;
using Eigen::VectorXd;

constexpr const char* kTriadColour = "#c3ccd4";
constexpr const char* kRodColour = "#4a5765";
constexpr std::array<const char*, 3> kFrameColours{"#c4302b", "#2f8f2f", "#2b50c4"};
constexpr double kBodyWidth = 5;  // pixels
constexpr double kRodWidth = 3;
constexpr double kFrameWidth = 2;
constexpr double kFineWidth = 1.5;

// Lengths relative to the radius of what is shown.
constexpr double kTriad = 0.35;
constexpr double kFrame = 0.16;
constexpr double kAxis = 0.06;
constexpr double kArrowAxis = 0.09;
constexpr double kStub = 0.3;  // of a body that hides its turn, along the axis that it carries

Json place_json(const Vector3d& at) {
  return Json::array({rounded(at.x()), rounded(at.y()), rounded(at.z())});
}

Json stroke_json(const Vector3d& from, const Vector3d& to, const std::string& colour,
                 double width) {
  return Json::array({place_json(from), place_json(to), colour, width});
}

/// A ball about all that is shown, the ground's origin too.
struct Ball {
  Vector3d centre;
  double radius = 1;
};

Ball ball_around(const Mechanism& mechanism, const Sheet& sheet) {
  std::vector<Vector3d> places{Vector3d::Zero()};
  for (const Panel& panel : sheet.panels) {
    for (std::size_t body = 0; body < mechanism.bodies.size(); ++body) {
      for (std::size_t k = 0; k < mechanism.bodies[body].points.size(); ++k) {
        places.push_back(point_position(mechanism, {body, k}, panel.q));
      }
    }
  }
  Eigen::AlignedBox3d box;
  for (const Vector3d& place : places) box.extend(place);
  Ball ball{box.center(), 1e-12};
  for (const Vector3d& place : places) {
    ball.radius = std::max(ball.radius, (place - ball.centre).norm());
  }
  return ball;
}

/// One pose as strokes, spots and names.
class Strokes {
 public:
  Strokes(const Mechanism& mechanism, const View& view, const VectorXd& q, double size)
      : mechanism_(mechanism), q_(q), size_(size) {
    if (view.frames.empty()) add_triad();
    for (const ShownFrame& frame : view.frames) add(frame);
    for (std::size_t body = 1; body < mechanism.bodies.size(); ++body) add_body(body);
    for (const Joint& joint : mechanism.joints) add(joint, view.has_arrows);
    if (view.has_arrows) add_sites();
  }

  Json json() && {
    return {{"strokes", std::move(strokes_)},
            {"spots", std::move(spots_)},
            {"names", std::move(names_)}};
  }

 private:
  Vector3d place_of(const PointOf& point) const { return point_position(mechanism_, point, q_); }

  void add_stroke(const Vector3d& from, const Vector3d& to, const std::string& colour,
                  double width) {
    strokes_.push_back(stroke_json(from, to, colour, width));
  }
  void add_name(const Vector3d& at, const std::string& name) {
    names_.push_back(Json::array({place_json(at), name}));
  }

  void add_triad() {
    for (int k = 0; k < 3; ++k) {
      const Vector3d tip = kTriad * size_ * Vector3d::Unit(k);
      add_stroke(Vector3d::Zero(), tip, kTriadColour, kFineWidth);
      add_name(tip, std::string(1, "xyz"[k]));
    }
  }

  void add(const ShownFrame& frame) {
    const std::size_t body = frame.origin.body;
    const Eigen::Matrix3d turn = orientation(mechanism_, body, q_);
    const Vector3d origin =
        body == 0 ? frame.origin.at : body_origin(body) + turn * frame.origin.at;
    for (int k = 0; k < 3; ++k) {
      const Vector3d tip = origin + kFrame * size_ * (turn * frame.axes.col(k));
      add_stroke(origin, tip, kFrameColours[static_cast<std::size_t>(k)], kFrameWidth);
      if (frame.is_lettered) add_name(tip, std::string(1, "xyz"[k]));
    }
  }

  Vector3d body_origin(std::size_t body) const {
    return q_.segment<3>(6 * static_cast<Eigen::Index>(body - 1));
  }

  void add_body(std::size_t body) {
    const std::size_t count = mechanism_.bodies[body].points.size();
    const std::size_t lines = count > 2 ? count : count - std::min<std::size_t>(count, 1);
    for (std::size_t k = 0; k < lines; ++k) {
      add_stroke(place_of({body, k}), place_of({body, (k + 1) % count}), colour_text(body - 1),
                 kBodyWidth);
    }
  }

  void add(const Joint& joint, bool has_arrows) {
    for (const PointOf& point : joint.at) spots_.push_back(place_json(place_of(point)));
    const Vector3d at = place_of(joint.at[0]);
    if (joint.type == JointType::rod) {
      add_stroke(at, place_of(joint.at[1]), kRodColour, kRodWidth);
      return;
    }
    if (joint.type == JointType::actuator) {
      constexpr double kCylinder = 0.55;
      const Vector3d rod_end = place_of(joint.at[1]);
      const Vector3d cylinder_end = at + kCylinder * (rod_end - at);
      add_stroke(at, cylinder_end, kRodColour, kBodyWidth);
      add_stroke(cylinder_end, rod_end, kRodColour, kFineWidth);
      return;
    }
    if (axis_count(joint.type) == 0 || joint.type == JointType::weld) return;
    const Eigen::Matrix3d turn = orientation(mechanism_, joint.at[0].body, q_);
    const Vector3d along = turn * joint.axis[0];
    if (is_guided(joint)) add_stroke(at, place_of(joint.at[1]), kRodColour, kFineWidth);
    const double reach = (has_arrows ? kArrowAxis : kAxis) * size_;
    add_stroke(at - reach * along, at + reach * along, kRodColour, kFineWidth);
    if (has_arrows) add_head(at + reach * along, along, reach, kRodColour, kFineWidth);
    const std::size_t body = joint.at[0].body;
    if (!hides_its_turn(mechanism_, body)) return;
    const Vector3d tip = at + kStub * size_ * along;
    add_stroke(at, tip, colour_text(body - 1), kRodWidth);
    add_head(tip, along, kStub * size_, colour_text(body - 1), kRodWidth);
  }

  /// Four barbs: a head that is seen from every side.
  void add_head(const Vector3d& tip, const Vector3d& along, double length,
                const std::string& colour, double width) {
    const Vector3d aside = along.unitOrthogonal();
    for (const Vector3d& barb :
         {aside, Vector3d(-aside), Vector3d(along.cross(aside)), Vector3d(aside.cross(along))}) {
      add_stroke(tip, tip + 0.3 * length * (0.5 * barb - along), colour, width);
    }
  }

  void add_sites() {
    for (const Site& site : sites(mechanism_)) {
      // The tip's name, which is long, would cover the wrist; its frame is there to be seen.
      if (site.is_jointed && !site.name.empty()) add_name(place_of(site.points.front()), site.name);
    }
  }

  const Mechanism& mechanism_;
  const VectorXd& q_;
  double size_;
  Json strokes_ = Json::array();
  Json spots_ = Json::array();
  Json names_ = Json::array();
};

std::string panel_html(const Panel& panel) {
  std::string caption = element("b", {}, escaped(panel.caption));
  std::string notes;
  for (const std::string& note : panel.notes) {
    notes += (notes.empty() ? "" : element("br", {})) + escaped(note);
  }
  if (!notes.empty()) caption += element("span", {}, notes);
  return element("figure", {},
                 element("figcaption", {}, caption) + element("canvas", {{"tabindex", "0"}}, " "));
}

/// As many columns as leave the last row fullest, of four, five and three: eight postures are two
/// rows of four.
std::size_t columns_for(std::size_t panels) {
  constexpr std::size_t kFew = 3;
  if (panels <= kFew) return std::max<std::size_t>(panels, 1);
  if (panels == kFew + 1) return 2;
  std::size_t best = 0;
  std::size_t least_empty = panels;
  for (const std::size_t columns : {4U, 5U, 3U}) {
    const std::size_t empty = (columns - panels % columns) % columns;
    if (empty >= least_empty) continue;
    least_empty = empty;
    best = columns;
  }
  return best;
}

/// No more columns than that, fewer where the window is narrow.
std::string grid_style(std::size_t columns) {
  const std::string gaps = std::to_string(12 * (columns - 1)) + "px";  // as in page.css
  return "grid-template-columns:repeat(auto-fill,minmax(min(100%,max(225px,calc((100% - " + gaps +
         ")/" + std::to_string(columns) + "))),1fr))";
}

}  // namespace

std::string turning_html(const Sheet& sheet, const Mechanism& mechanism) {
  const auto [centre, radius] = ball_around(mechanism, sheet);
  Json data{{"centre", place_json(centre)},
            {"radius", rounded(radius)},
            {"eye", Json::array({sheet.view.eye.azimuth_rad, sheet.view.eye.elevation_rad})},
            {"closures", Json::array()}};
  std::string panels;
  for (const Panel& panel : sheet.panels) {
    data["closures"].push_back(Strokes(mechanism, sheet.view, panel.q, radius).json());
    panels += panel_html(panel);
  }
  const std::size_t count = sheet.panels.size();
  const std::string crowd = count <= 2 ? "few" : count <= 4 ? "some" : "many";
  std::string body =
      element("h1", {}, escaped(sheet.title)) + element("p", {}, escaped(sheet.summary)) +
      element("p", {},
              "Drag to turn all closures, wheel to come nearer, double click to go "
              "back; or the arrow keys.") +
      element("p", {{"id", "error"}}, " ") +
      element("div",
              {{"id", "panels"}, {"class", crowd}, {"style", grid_style(columns_for(count))}},
              panels);
  body += element("script", {{"type", "application/json"}, {"id", "data"}}, script_data(data));
  return html_document(sheet.title, body, turning_script());
}

}  // namespace moivre
