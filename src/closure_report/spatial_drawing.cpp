// SPDX-License-Identifier: MIT
// How is a spatial mechanism drawn? Bodies as thick lines between their points, joints with their
// axes, and where x, y, z go.
#include <Eigen/Geometry>
#include <algorithm>
#include <array>

#include "figures.h"
#include "moivre/mechanism/joint_type.h"

namespace moivre {
namespace {

// Sizes, all in radii of a revolute joint.
constexpr double kAxisReach = 4.5;  // of a joint's axis, to each side
constexpr double kTriadReach = 6;
constexpr double kStubReach = 9;  // of a body that hides its turn, along the axis that it carries
constexpr double kAlong = 1e-6;   // sine of the angle between a line and an axis along it

using Eigen::Vector3d;

class SpatialDrawing {
 public:
  SpatialDrawing(const Mechanism& mechanism, const std::vector<Eigen::VectorXd>& poses,
                 const View& view)
      : mechanism_(mechanism),
        view_(view),
        size_(view.symbol > 0 ? view.symbol : symbol_size(extent(mechanism, poses, view.eye))) {
    sketch_.drawing.eye = view.eye;
    sketch_.drawing.symbol = size_;
    sketch_.drawing.to_scale = false;  // what goes into the picture is foreshortened
  }

  Drawing drawn() && {
    if (view_.frames.empty()) add_triad();
    for (const ShownFrame& frame : view_.frames) add(frame);
    for (std::size_t body = 1; body < mechanism_.bodies.size(); ++body) add_body(body);
    for (const Joint& joint : mechanism_.joints) add(joint);
    for (const Site& site : sites(mechanism_)) add(site);
    return std::move(sketch_).finished();
  }

 private:
  MaterialPoint material(const PointOf& point) const {
    return {point.body, mechanism_.bodies[point.body].points[point.point].at};
  }

  std::size_t add_spot(const PointOf& point) {
    return sketch_.add(LineFrame{material(point), material(point), 1});
  }

  void add_line(Sketch::Layer layer, Style style, std::optional<std::size_t> colour,
                const MaterialPoint& from, const MaterialPoint& to) {
    sketch_.add(layer, sketch_.add(LineFrame{from, to, 1}), colour, {polyline(style, {0, 1})});
  }

  void add_label(LabelKind kind, const std::string& text, std::size_t frame, Complex at,
                 std::optional<std::size_t> colour = std::nullopt) {
    sketch_.drawing.labels.push_back({kind, text, frame, at, colour, std::nullopt});
  }

  void add_triad() {
    for (int k = 0; k < 3; ++k) {
      const Vector3d tip = kTriadReach * size_ * Vector3d::Unit(k);
      add_line(Sketch::backdrop, Style::hatch, std::nullopt, {0, Vector3d::Zero()}, {0, tip});
      add_label(LabelKind::point, std::string(1, "xyz"[k]), sketch_.drawing.frames.size() - 1, 1);
    }
  }

  void add(const ShownFrame& frame) {
    for (int k = 0; k < 3; ++k) {
      const auto style =
          std::array{Style::x_axis, Style::y_axis, Style::z_axis}[static_cast<std::size_t>(k)];
      const Vector3d tip = frame.origin.at + kTriadReach * size_ * frame.axes.col(k);
      add_line(Sketch::holes, style, std::nullopt, frame.origin, {frame.origin.body, tip});
      if (!frame.is_lettered) continue;
      add_label(LabelKind::point, std::string(1, "xyz"[k]), sketch_.drawing.frames.size() - 1, 1);
    }
  }

  /// A joint's axis; its head is drawn in a frame in which the line is 1 long.
  void add_axis(const MaterialPoint& at, const Vector3d& reach) {
    constexpr Complex kBarb(-0.16, 0.07);
    const MaterialPoint from{at.body, at.at - reach};
    const MaterialPoint to{at.body, at.at + reach};
    std::vector<Shape> shapes{polyline(Style::axis, {0, 1})};
    if (view_.has_arrows) {
      shapes.push_back(polyline(Style::axis, {1.0 + kBarb, 1, 1.0 + std::conj(kBarb)}));
    }
    sketch_.add(Sketch::holes, sketch_.add(LineFrame{from, to, 1}), std::nullopt, shapes);
  }

  /// Nothing else shows how the body is turned: an arrow in its colour.
  void add_stub(const MaterialPoint& at, const Vector3d& reach) {
    constexpr Complex kBarb(-0.3, 0.14);
    const LineFrame line{at, {at.body, at.at + reach}, 1};
    sketch_.add(Sketch::links, sketch_.add(line), at.body - 1,
                {polyline(Style::wire, {0, 1}),
                 polyline(Style::wire, {1.0 + kBarb, 1, 1.0 + std::conj(kBarb)})});
  }

  /// A cylinder for the first part of the line, a rod for the rest.
  void add_actuator(const Joint& joint) {
    constexpr double kCylinder = 0.55;
    const LineFrame line{material(joint.at[0]), material(joint.at[1]), 1};
    sketch_.add(Sketch::links, sketch_.add(line), std::nullopt,
                {polyline(Style::mark, {kCylinder, 1}), polyline(Style::wire, {0, kCylinder})});
    add_label(LabelKind::body, joint.name, sketch_.drawing.frames.size() - 1, kCylinder);
  }

  /// Its points one after the other, round where there are three or more.
  void add_body(std::size_t body) {
    const std::size_t count = mechanism_.bodies[body].points.size();
    const std::size_t lines = count > 2 ? count : count - std::min<std::size_t>(count, 1);
    bool is_named = false;
    for (std::size_t k = 0; k < lines; ++k) {
      const MaterialPoint from = material({body, k});
      const MaterialPoint to = material({body, (k + 1) % count});
      if (from.at == to.at) continue;
      add_line(Sketch::links, Style::wire, body - 1, from, to);
      if (is_named || mechanism_.bodies[body].name.empty()) continue;
      is_named = true;
      add_label(LabelKind::body, mechanism_.bodies[body].name, sketch_.drawing.frames.size() - 1,
                0.5, body - 1);
    }
  }

  void add(const Joint& joint) {
    const MaterialPoint first = material(joint.at[0]);
    if (joint.type == JointType::rod) {
      add_line(Sketch::links, Style::wire, std::nullopt, first, material(joint.at[1]));
      if (has_own_name(mechanism_, joint)) {
        add_label(LabelKind::body, joint.name, sketch_.drawing.frames.size() - 1, 0.5);
      }
    }
    if (joint.type == JointType::actuator) add_actuator(joint);
    if (axis_count(joint.type) > 0 && joint.type != JointType::weld) {
      add_axis(first, kAxisReach * size_ * joint.axis[0]);
      if (hides_its_turn(mechanism_, first.body))
        add_stub(first, kStubReach * size_ * joint.axis[0]);
    }
    if (is_guided(joint)) {
      add_line(Sketch::holes, Style::axis, std::nullopt, first, material(joint.at[1]));
    }
    for (const PointOf& point : joint.at) {
      const std::size_t spot = add_spot(point);
      if (point.body == 0) {
        sketch_.add(Sketch::backdrop, spot, std::nullopt, ground_pivot(0, size_));
      }
      const bool is_weld = joint.type == JointType::weld;
      sketch_.add(Sketch::joints, spot, std::nullopt,
                  {disc(is_weld ? Style::weld : Style::pin, 0, kPinRadius * size_)});
    }
  }

  void add(const Site& site) {
    const std::size_t spot = add_spot(site.points.front());
    if (!site.is_jointed) {
      sketch_.add(Sketch::joints, spot, std::nullopt, {disc(Style::mark, 0, kMarkRadius * size_)});
    }
    if (!site.name.empty()) add_label(LabelKind::point, site.name, spot, 0);
  }

  const Mechanism& mechanism_;
  const View& view_;
  double size_;
  Sketch sketch_;
};

}  // namespace

bool hides_its_turn(const Mechanism& mechanism, std::size_t body) {
  const auto& points = mechanism.bodies[body].points;
  const auto is_line_along = [&](const Vector3d& axis) {
    return std::all_of(points.begin(), points.end(), [&](const auto& point) {
      const Vector3d from_first = point.at - points.front().at;
      return from_first.cross(axis).norm() <= kAlong * from_first.norm();
    });
  };
  return body > 0 &&
         std::any_of(mechanism.joints.begin(), mechanism.joints.end(), [&](const Joint& joint) {
           return axis_count(joint.type) > 0 && joint.at[1].body == body &&
                  is_line_along(joint.axis[1]);
         });
}

Drawing draw_spatial(const Mechanism& mechanism, const std::vector<Eigen::VectorXd>& poses,
                     const View& view) {
  return SpatialDrawing(mechanism, poses, view).drawn();
}

}  // namespace moivre
