// SPDX-License-Identifier: MIT
// How is a planar mechanism drawn? Links as hulls of their points, joints by type, the ground
// hatched.
#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <numeric>
#include <set>

#include "figures.h"
#include "moivre/mechanism/joint_type.h"
#include "moivre/mechanism/pose.h"

namespace moivre {
namespace {

// Sizes, all in radii of a revolute joint.
constexpr double kLinkRadius = 1.3;
constexpr double kSlotRadius = 0.85;
constexpr double kSlotFrameRadius = 1.8;
constexpr double kBlockHalfLength = 2.4;
constexpr double kBlockHalfHeight = 1.6;
constexpr double kGuideMargin = 4;    // that a guide goes on beyond the slider
constexpr double kSlotMargin = 6;     // that a slot goes on beyond the pin
constexpr double kSlotClearance = 3;  // between a slot's end and the joint it is measured from
constexpr double kWeldHalfSide = 1;
constexpr double kRodRadius = 0.55;
constexpr double kCylinderHalfHeight = 1.3;
constexpr double kCylinderShare = 0.6;  // of its least length
constexpr double kLeastShare = 0.3;     // of its greatest length, that counts as the least
constexpr double kToothMark = 2;        // length of the stroke that shows how a wheel has turned
constexpr double kRackHalfHeight = 0.9;
constexpr double kRackMargin = 5;  // that a rack goes on beyond all places of the pinion
constexpr double kRackTooth = 0.9;
constexpr double kRackPitch = 1.8;

Complex flat(const Eigen::Vector3d& r) { return {r.x(), r.y()}; }

class PlanarDrawing {
 public:
  PlanarDrawing(const Mechanism& mechanism, const std::vector<Eigen::VectorXd>& poses)
      : mechanism_(mechanism), poses_(poses), size_(symbol_size(extent(mechanism, poses))) {
    sketch_.drawing.symbol = size_;
    for (std::size_t body = 0; body < mechanism.bodies.size(); ++body) {
      sketch_.add(LineFrame{{body, Eigen::Vector3d::Zero()}, {body, Eigen::Vector3d::UnitX()}, 1});
    }
  }

  Drawing drawn() && {
    for (std::size_t body = 1; body < mechanism_.bodies.size(); ++body) add_link(body);
    for (const Joint& joint : mechanism_.joints) add(joint);
    for (const Site& site : sites(mechanism_)) add(site);
    for (std::size_t body = 1; body < mechanism_.bodies.size(); ++body) add_body_label(body);
    return std::move(sketch_).finished();
  }

 private:
  Complex at(const PointOf& point) const {
    return flat(mechanism_.bodies[point.body].points[point.point].at);
  }

  static std::optional<std::size_t> colour(std::size_t body) {
    return body == 0 ? std::nullopt : std::optional(body - 1);
  }

  std::vector<Complex> points_of(std::size_t body) const {
    std::vector<Complex> points;
    for (const BodyPoint& point : mechanism_.bodies[body].points) points.push_back(flat(point.at));
    return points;
  }

  void add_link(std::size_t body) {
    const std::vector<Complex> points = points_of(body);
    if (points.empty()) return;
    sketch_.add(Sketch::links, body, colour(body),
                {rounded_hull(Style::link, points, kLinkRadius * size_)});
  }

  /// A bar between two more points of a body; one with its link where all are in line.
  void lengthen_link(std::size_t body, Complex from, Complex to) {
    std::vector<Complex> points = points_of(body);
    points.push_back(from);
    points.push_back(to);
    Shape whole = rounded_hull(Style::link, points, kLinkRadius * size_);
    constexpr std::size_t kEndsOfLine = 2;
    if (whole.points.size() > kEndsOfLine) {
      whole = capsule(Style::link, from, to, kLinkRadius * size_);
    } else {
      std::erase_if(sketch_.layers[Sketch::links],
                    [&](const Figure& figure) { return figure.frame == body; });
    }
    sketch_.add(Sketch::links, body, colour(body), {whole});
  }

  void add(const Joint& joint) {
    const JointPlace place = traits(joint.type).place;
    const bool is_turning = traits(joint.type).turn == JointTurn::about_axis;
    if (place == JointPlace::at_point) return is_turning ? add_pin(joint) : add_weld(joint);
    if (place == JointPlace::on_line) return is_turning ? add_slot(joint) : add_slider(joint);
    if (place == JointPlace::at_distance) return add_rod(joint);
    if (place == JointPlace::at_any_distance) return add_actuator(joint);
    if (joint.type == JointType::cam || joint.type == JointType::cam_lever) return add_cam(joint);
    if (place == JointPlace::off_line) return add_rack(joint);
    return joint.type == JointType::belt ? add_belt(joint) : add_gear(joint);
  }

  /// The ground's pivot below a joint, once a place.
  void hold_to_ground(const PointOf& point) {
    if (point.body != 0 || !held_.insert(point.point).second) return;
    sketch_.add(Sketch::backdrop, 0, std::nullopt, ground_pivot(at(point), size_));
  }

  void add_pin(const Joint& joint) {
    for (const PointOf& point : joint.at) {
      hold_to_ground(point);
      sketch_.add(Sketch::joints, point.body, std::nullopt,
                  {disc(Style::pin, at(point), kPinRadius * size_)});
    }
  }

  /// Least and greatest slide, in all poses.
  std::array<double, 2> travel(const Joint& joint) const {
    std::array<double, 2> range{};
    for (std::size_t k = 0; k < poses_.size(); ++k) {
      const double s = joint_coordinate(mechanism_, joint, poses_[k]).value_or(0);
      range = k == 0 ? std::array{s, s} : std::array{std::min(range[0], s), std::max(range[1], s)};
    }
    return range;
  }

  /// From the first point to beyond all places of the slider.
  void add_slider(const Joint& joint) {
    const std::size_t rail = joint.at[0].body;
    const Complex along = flat(joint.axis[0]);
    const auto [least, greatest] = travel(joint);
    const Complex from = at(joint.at[0]) + (std::min(least, 0.0) - kGuideMargin * size_) * along;
    const Complex to = at(joint.at[0]) + (std::max(greatest, 0.0) + kGuideMargin * size_) * along;
    if (rail == 0) {
      const Complex below = along * Complex(0, -kBlockHalfHeight * size_);
      sketch_.add(Sketch::backdrop, 0, std::nullopt, hatched_line(from + below, to + below, size_));
    } else {
      lengthen_link(rail, from, to);
    }
    sketch_.add(rail == 0 ? Sketch::backdrop : Sketch::holes, rail, std::nullopt,
                {polyline(Style::guide, {from, to})});
    const std::size_t block = joint.at[1].body;
    const Complex along_block = along * std::polar(1.0, -joint.turn_rad);
    sketch_.add(Sketch::sliders, block, colour(block),
                {rectangle(Style::block, at(joint.at[1]), along_block, kBlockHalfLength * size_,
                           kBlockHalfHeight * size_)});
  }

  /// Beyond all places of the pin, but not over the first point where no pin gets there; held to it
  /// by a bar.
  void add_slot(const Joint& joint) {
    const std::size_t body = joint.at[0].body;
    const Complex origin = at(joint.at[0]);
    const Complex along = flat(joint.axis[0]);
    const auto [least, greatest] = travel(joint);
    const double clear = kSlotClearance * size_;
    double lower = least - kSlotMargin * size_;
    double upper = greatest + kSlotMargin * size_;
    if (least > 2 * clear) lower = std::max(lower, clear);
    if (greatest < -2 * clear) upper = std::min(upper, -clear);
    const Complex from = origin + lower * along;
    const Complex to = origin + upper * along;
    if (body == 0) {
      const Complex below = along * Complex(0, -kSlotRadius * size_);
      sketch_.add(Sketch::backdrop, 0, std::nullopt, hatched_line(from + below, to + below, size_));
    } else {
      lengthen_link(body, origin, lower > 0 ? from : upper < 0 ? to : origin);
      sketch_.add(Sketch::links, body, colour(body),
                  {capsule(Style::link, from, to, kSlotFrameRadius * size_)});
    }
    sketch_.add(Sketch::holes, body, colour(body),
                {capsule(Style::slot, from, to, kSlotRadius * size_)});
    const std::size_t pin = joint.at[1].body;
    sketch_.add(Sketch::joints, pin, colour(pin),
                {disc(Style::slot_pin, at(joint.at[1]), kPinRadius * size_)});
  }

  void add_weld(const Joint& joint) {
    for (const PointOf& point : joint.at) hold_to_ground(point);
    sketch_.add(
        Sketch::joints, joint.at[0].body, std::nullopt,
        {rectangle(Style::weld, at(joint.at[0]), 1, kWeldHalfSide * size_, kWeldHalfSide * size_)});
  }

  MaterialPoint material(const PointOf& point) const {
    return {point.body, mechanism_.bodies[point.body].points[point.point].at};
  }

  void add_rod(const Joint& joint) {
    const std::size_t frame =
        sketch_.add(LineFrame{material(joint.at[0]), material(joint.at[1]), joint.length});
    sketch_.add(Sketch::links, frame, std::nullopt,
                {capsule(Style::rod, 0, joint.length, kRodRadius * size_)});
    add_pin(joint);
    if (!has_own_name(mechanism_, joint)) return;
    sketch_.drawing.labels.push_back(
        {LabelKind::body, joint.name, frame, joint.length / 2, std::nullopt, std::nullopt});
  }

  /// A cylinder that is as long in every pose, and a rod that goes into it.
  void add_actuator(const Joint& joint) {
    const MaterialPoint from = material(joint.at[0]);
    const MaterialPoint to = material(joint.at[1]);
    sketch_.add(Sketch::links, sketch_.add(LineFrame{from, to, 1}), std::nullopt,
                {polyline(Style::wire, {0, 1})});
    const auto [least, greatest] = travel(joint);
    const double shortest = joint.limits ? std::min(least, joint.limits->lower) : least;
    const double longest = joint.limits ? std::max(greatest, joint.limits->upper) : greatest;
    const double half = kCylinderShare * std::max(shortest, kLeastShare * longest) / 2;
    const std::size_t aim = sketch_.add(AimFrame{from, to});
    sketch_.add(Sketch::links, aim, std::nullopt,
                {rectangle(Style::rod, half, 1, half, kCylinderHalfHeight * size_)});
    add_pin(joint);
    sketch_.drawing.labels.push_back(
        {LabelKind::body, joint.name, aim, half, std::nullopt, std::nullopt});
  }

  /// The point of the carrier about which a wheel turns, and the same point of the wheel: held
  /// together by one joint, or by a pin that both are on.
  std::optional<std::array<PointOf, 2>> axle(std::size_t carrier, std::size_t wheel) const {
    for (const Site& site : sites(mechanism_)) {
      const auto on = [&](std::size_t body) {
        return std::find_if(site.points.begin(), site.points.end(),
                            [&](const PointOf& point) { return point.body == body; });
      };
      const auto of_carrier = on(carrier);
      const auto of_wheel = on(wheel);
      if (of_carrier == site.points.end() || of_wheel == site.points.end()) continue;
      return std::array{*of_carrier, *of_wheel};
    }
    return std::nullopt;
  }

  /// The axles of both wheels; nothing where they do not turn about points of the carrier, apart
  /// from each other.
  std::optional<std::array<std::array<PointOf, 2>, 2>> axles(const Joint& joint) const {
    const auto first = axle(joint.gear.carrier, joint.at[0].body);
    const auto second = axle(joint.gear.carrier, joint.at[1].body);
    if (!first || !second || at((*first)[0]) == at((*second)[0])) return std::nullopt;
    return std::array{*first, *second};
  }

  void add_gear(const Joint& joint) {
    const auto pair = axles(joint);
    const auto& teeth = joint.gear.teeth;
    const double sum = std::abs(teeth[0] - teeth[1]);
    if (!pair || sum == 0) return;
    const double distance = std::abs(at((*pair)[1][0]) - at((*pair)[0][0]));
    for (std::size_t k = 0; k < 2; ++k) {
      add_wheel((*pair)[k][1], distance * std::abs(teeth[k]) / sum);
    }
  }

  /// Both pulleys and the common tangents of their circles, outer ones or, crossed, inner ones.
  void add_belt(const Joint& joint) {
    const auto pair = axles(joint);
    if (!pair) return;
    const auto& [r1, r2] = joint.gear.radii;
    const Complex from = at((*pair)[0][0]);
    const Complex to = at((*pair)[1][0]);
    const Complex along = (to - from) / std::abs(to - from);
    const double side = joint.gear.teeth[0] > 0 ? 1 : -1;
    // The tangents' feet stand at this angle to the line of centres.
    const double cosine = (r1 - side * r2) / std::abs(to - from);
    add_wheel((*pair)[0][1], r1);
    add_wheel((*pair)[1][1], r2);
    if (std::abs(cosine) > 1) return;
    std::vector<Shape> tangents;
    for (const double angle : {std::acos(cosine), -std::acos(cosine)}) {
      const Complex foot = along * std::polar(1.0, angle);
      tangents.push_back(polyline(Style::mark, {from + r1 * foot, to + side * r2 * foot}));
    }
    const std::size_t carrier = joint.gear.carrier;
    sketch_.add(Sketch::links, carrier, colour(carrier), std::move(tangents));
  }

  /// A pitch circle, with a stroke where no other point shows how it has turned.
  void add_wheel(const PointOf& centre, double radius) {
    const std::size_t wheel = centre.body;
    const Complex z = at(centre);
    std::vector<Shape> shapes{disc(Style::pitch_circle, z, radius)};
    if (wheel != 0 && mechanism_.bodies[wheel].points.size() == 1) {
      shapes.push_back(polyline(Style::mark, {z + radius - kToothMark * size_, z + radius}));
    }
    sketch_.add(wheel == 0 ? Sketch::backdrop : Sketch::links, wheel, colour(wheel),
                std::move(shapes));
  }

  /// How far the joint's second point is from the line through its first, on the left.
  double height_over(const Joint& joint) const {
    const Eigen::VectorXd& q = poses_.front();
    const Eigen::Vector3d gap =
        point_position(mechanism_, joint.at[1], q) - point_position(mechanism_, joint.at[0], q);
    const Eigen::Vector3d along = orientation(mechanism_, line_body(joint), q) * joint.axis[0];
    return along.x() * gap.y() - along.y() * gap.x();
  }

  /// Where the follower's point is in the carrier, beside the cam's centre, at a lift; nothing of a
  /// lever that has no pin on the carrier or no other point.
  std::function<Complex(double)> follower_of(const Joint& joint) const {
    if (joint.type == JointType::cam) {
      const Complex along = flat(joint.axis[0]);
      return [along, height = height_over(joint)](double lift) {
        return along * Complex(lift, height);
      };
    }
    const auto pair = axles(joint);
    const std::vector<Complex> points = points_of(joint.at[1].body);
    if (!pair || points.size() < 2) return nullptr;
    const Complex pivot = at((*pair)[1][1]);
    const auto tip =
        std::find_if(points.begin(), points.end(), [&](Complex point) { return point != pivot; });
    if (tip == points.end()) return nullptr;
    return [from = at((*pair)[1][0]) - at((*pair)[0][0]), arm = *tip - pivot](double lift) {
      return from + std::polar(1.0, lift) * arm;
    };
  }

  /// The cam's pitch curve: where the follower's point goes as it is seen from the cam.
  void add_cam(const Joint& joint) {
    const auto follower = follower_of(joint);
    if (!follower) return;
    constexpr int kSamples = 180;
    const std::size_t cam = joint.at[0].body;
    const Complex centre =
        joint.type == JointType::cam ? at(joint.at[0]) : at((*axles(joint))[0][1]);
    std::vector<Complex> curve;
    for (int k = 0; k <= kSamples; ++k) {
      const double angle = 2 * std::numbers::pi * k / kSamples;
      const double lift = periodic_state(joint.profile, angle - joint.gear.phase_rad).value;
      curve.push_back(centre + std::polar(1.0, -angle) * follower(lift));
    }
    sketch_.add(Sketch::links, cam, colour(cam), {polyline(Style::link, std::move(curve))});
  }

  /// A toothed bar where the pinion's pitch circle touches, from the first point to beyond all the
  /// pinion's places.
  void add_rack(const Joint& joint) {
    const std::size_t body = joint.at[0].body;
    const Complex along = flat(joint.axis[0]);
    const Complex away = along * Complex(0, joint.radius > 0 ? 1 : -1);
    const Complex touching =
        at(joint.at[0]) + along * Complex(0, height_over(joint) + joint.radius);
    const auto [least, greatest] = travel(joint);
    const double first = std::min(least, 0.0) - kRackMargin * size_;
    const double last = std::max(greatest, 0.0) + kRackMargin * size_;
    const Complex middle = touching + (first + last) / 2 * along;
    const double half_height = kRackHalfHeight * size_;
    const bool is_ground = body == 0;
    sketch_.add(is_ground ? Sketch::backdrop : Sketch::links, body, colour(body),
                {rectangle(Style::link, middle + half_height * away, along, (last - first) / 2,
                           half_height)});
    std::vector<Shape> teeth;
    const int count = std::max(2, static_cast<int>((last - first) / (kRackPitch * size_)));
    for (int k = 0; k <= count; ++k) {
      const Complex foot = touching + (first + (last - first) * k / count) * along;
      teeth.push_back(polyline(Style::mark, {foot, foot - kRackTooth * size_ * away}));
    }
    sketch_.add(is_ground ? Sketch::backdrop : Sketch::links, body, std::nullopt, std::move(teeth));
    add_wheel(joint.at[1], std::abs(joint.radius));
  }

  void add(const Site& site) {
    const PointOf& first = site.points.front();
    if (!site.is_jointed) {
      const double reach = kMarkRadius * size_;
      sketch_.add(Sketch::joints, first.body, std::nullopt, {disc(Style::mark, at(first), reach)});
    }
    sketch_.drawing.labels.push_back(
        {LabelKind::point, site.name, first.body, at(first), std::nullopt, std::nullopt});
  }

  void add_body_label(std::size_t body) {
    const std::vector<Complex> points = points_of(body);
    if (points.empty()) return;
    const Complex centre = std::accumulate(points.begin(), points.end(), Complex(0)) /
                           static_cast<double>(points.size());
    sketch_.drawing.labels.push_back(
        {LabelKind::body, mechanism_.bodies[body].name, body, centre, colour(body), std::nullopt});
  }

  const Mechanism& mechanism_;
  const std::vector<Eigen::VectorXd>& poses_;
  double size_;
  Sketch sketch_;
  std::set<std::size_t> held_;
};

}  // namespace

Drawing draw_planar(const Mechanism& mechanism, const std::vector<Eigen::VectorXd>& poses) {
  return PlanarDrawing(mechanism, poses).drawn();
}

}  // namespace moivre
