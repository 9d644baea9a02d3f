// SPDX-License-Identifier: MIT
// Which drawing suits the mechanism, and where does a pose put its frames?
#include "moivre/closure_report/drawing.h"

#include <algorithm>
#include <cmath>

#include "figures.h"
#include "moivre/mechanism/pose.h"

namespace moivre {
namespace {

using Eigen::Vector3d;
using Eigen::VectorXd;

/// Origin of a body's frame.
Vector3d origin(const Mechanism& mechanism, std::size_t body, const VectorXd& q) {
  if (body == 0) return Vector3d::Zero();
  const Eigen::Index size = mechanism.space == Space::spatial ? 6 : 3;
  const Eigen::Index begin = size * static_cast<Eigen::Index>(body - 1);
  const bool is_spatial = mechanism.space == Space::spatial;
  return {q[begin], q[begin + 1], is_spatial ? q[begin + 2] : 0};
}

Complex place_of(const Mechanism& mechanism, const MaterialPoint& point, const VectorXd& q,
                 const Eye& eye) {
  return seen(mechanism,
              origin(mechanism, point.body, q) + orientation(mechanism, point.body, q) * point.at,
              eye);
}

struct Placement {
  const Mechanism& mechanism;
  const VectorXd& q;
  const Eye& eye;

  Similarity operator()(const LineFrame& frame) const {
    const Complex from = place_of(mechanism, frame.from, q, eye);
    const bool is_one_place = frame.from.body == frame.to.body && frame.from.at == frame.to.at;
    if (is_one_place) return {1, from};
    return {(place_of(mechanism, frame.to, q, eye) - from) / frame.length, from};
  }
  Similarity operator()(const AimFrame& frame) const {
    const Complex from = place_of(mechanism, frame.from, q, eye);
    const Complex gap = place_of(mechanism, frame.to, q, eye) - from;
    return {gap == 0.0 ? 1 : gap / std::abs(gap), from};
  }
  Similarity operator()(const DialFrame& frame) const {
    return {std::polar(1.0, q[frame.coordinate]), frame.centre};
  }
  Similarity operator()(const RulerFrame& frame) const {
    return {1, frame.zero + frame.scale * q[frame.coordinate]};
  }
};

}  // namespace

std::string to_string(Style style) {
  switch (style) {
    case Style::link:
      return "link";
    case Style::slot:
      return "slot";
    case Style::block:
      return "block";
    case Style::pin:
      return "pin";
    case Style::slot_pin:
      return "slot-pin";
    case Style::weld:
      return "weld";
    case Style::rod:
      return "rod";
    case Style::wire:
      return "wire";
    case Style::ground:
      return "ground";
    case Style::hatch:
      return "hatch";
    case Style::guide:
      return "guide";
    case Style::pitch_circle:
      return "pitch-circle";
    case Style::axis:
      return "axis";
    case Style::x_axis:
      return "x-axis";
    case Style::y_axis:
      return "y-axis";
    case Style::z_axis:
      return "z-axis";
    case Style::mark:
      return "mark";
  }
  return "unknown";
}

void Box::include(Complex z, double radius) {
  const Complex reach(radius, radius);
  const Complex low = z - reach;
  const Complex high = z + reach;
  if (is_empty()) {
    lower = low;
    upper = high;
    return;
  }
  lower = {std::min(lower.real(), low.real()), std::min(lower.imag(), low.imag())};
  upper = {std::max(upper.real(), high.real()), std::max(upper.imag(), high.imag())};
}

Complex seen(const Mechanism& mechanism, const Vector3d& r, const Eye& eye) {
  if (mechanism.space == Space::planar) return {r.x(), r.y()};
  const double sa = std::sin(eye.azimuth_rad), ca = std::cos(eye.azimuth_rad);
  const double se = std::sin(eye.elevation_rad), ce = std::cos(eye.elevation_rad);
  const Vector3d right(-sa, ca, 0);
  const Vector3d up(-ca * se, -sa * se, ce);
  return {right.dot(r), up.dot(r)};
}

Drawing draw(const Mechanism& mechanism, const std::vector<VectorXd>& poses, const View& view) {
  if (is_typed(mechanism)) return draw_unknowns(mechanism, poses);
  if (mechanism.space == Space::spatial) return draw_spatial(mechanism, poses, view);
  return draw_planar(mechanism, poses);
}

std::vector<Similarity> place(const Drawing& drawing, const Mechanism& mechanism,
                              const VectorXd& q) {
  std::vector<Similarity> places;
  for (const Frame& frame : drawing.frames) {
    places.push_back(std::visit(Placement{mechanism, q, drawing.eye}, frame));
  }
  return places;
}

Box bounds(const Drawing& drawing, const std::vector<Similarity>& places) {
  Box box;
  for (const Figure& figure : drawing.figures) {
    const Similarity& at = places[figure.frame];
    for (const Shape& shape : figure.shapes) {
      for (const Complex z : shape.points) box.include(at(z), shape.radius * std::abs(at.a));
    }
  }
  return box;
}

}  // namespace moivre
