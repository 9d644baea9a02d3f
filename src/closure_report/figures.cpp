// SPDX-License-Identifier: MIT
// Shapes, layers and named sites, by plane geometry.
#include "figures.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "moivre/mechanism/joint_type.h"
#include "moivre/mechanism/pose.h"

namespace moivre {
namespace {

/// More than rounding puts c on the left of the line from a to b.
bool turns_left(Complex a, Complex b, Complex c) {
  constexpr double kRounding = 1e-12;
  return std::imag(std::conj(b - a) * (c - a)) > kRounding * std::abs(b - a) * std::abs(c - a);
}

bool is_left_of(Complex a, Complex b) {
  return a.real() != b.real() ? a.real() < b.real() : a.imag() < b.imag();
}

/// Andrew's monotone chains, counter-clockwise.
std::vector<Complex> convex_hull(std::vector<Complex> points) {
  std::sort(points.begin(), points.end(), is_left_of);
  points.erase(std::unique(points.begin(), points.end()), points.end());
  if (points.size() < 3) return points;
  std::vector<Complex> hull;
  for (int chain = 0; chain < 2; ++chain) {
    const std::size_t begin = hull.size();
    for (const Complex z : points) {
      while (hull.size() >= begin + 2 && !turns_left(hull[hull.size() - 2], hull.back(), z)) {
        hull.pop_back();
      }
      hull.push_back(z);
    }
    hull.pop_back();
    std::reverse(points.begin(), points.end());
  }
  return hull;
}

std::vector<Site> named(const Mechanism& mechanism, const std::vector<PointOf>& points,
                        const std::vector<std::size_t>& site_of,
                        const std::vector<bool>& is_jointed) {
  std::vector<Site> sites(points.size());
  for (std::size_t k = 0; k < points.size(); ++k) {
    Site& site = sites[site_of[k]];
    const std::string& name = mechanism.bodies[points[k].body].points[points[k].point].name;
    const bool is_new = std::none_of(site.points.begin(), site.points.end(), [&](PointOf other) {
      return mechanism.bodies[other.body].points[other.point].name == name;
    });
    if (is_new) site.name += (site.name.empty() ? "" : ", ") + name;
    site.points.push_back(points[k]);
    site.is_jointed = site.is_jointed || is_jointed[k];
  }
  std::erase_if(sites, [](const Site& site) { return site.points.empty(); });
  return sites;
}

}  // namespace

Shape disc(Style style, Complex centre, double radius) { return {style, {centre}, true, radius}; }

Shape capsule(Style style, Complex from, Complex to, double radius) {
  return rounded_hull(style, {from, to}, radius);
}

Shape polyline(Style style, std::vector<Complex> points) {
  return {style, std::move(points), false, 0};
}

Shape rounded_hull(Style style, std::vector<Complex> points, double radius) {
  return {style, convex_hull(std::move(points)), true, radius};
}

Shape rectangle(Style style, Complex centre, Complex along, double half_length,
                double half_height) {
  const Complex u = along * half_length;
  const Complex v = along * Complex(0, half_height);
  return {style, {centre - u - v, centre + u - v, centre + u + v, centre - u + v}, true, 0};
}

std::vector<Shape> hatched_line(Complex from, Complex to, double size) {
  std::vector<Shape> shapes{polyline(Style::ground, {from, to})};
  const double length = std::abs(to - from);
  const Complex along = (to - from) / length;
  const double spacing = 1.1 * size;
  const Complex stroke = along * Complex(-0.9, -1.1) * size;
  const int strokes = std::max(2, static_cast<int>(length / spacing));
  for (int k = 0; k < strokes; ++k) {
    const Complex begin = from + along * (length * (k + 0.7) / strokes);
    shapes.push_back(polyline(Style::hatch, {begin, begin + stroke}));
  }
  return shapes;
}

std::vector<Shape> ground_pivot(Complex z, double size) {
  const double depth = 2.9 * size;
  const double half_base = 1.8 * size;
  const double half_line = 2.6 * size;
  std::vector<Shape> shapes{rounded_hull(
      Style::ground, {z, z + Complex(-half_base, -depth), z + Complex(half_base, -depth)}, 0)};
  for (Shape& shape :
       hatched_line(z + Complex(-half_line, -depth), z + Complex(half_line, -depth), size)) {
    shapes.push_back(std::move(shape));
  }
  return shapes;
}

std::size_t Sketch::add(Frame frame) {
  drawing.frames.push_back(std::move(frame));
  return drawing.frames.size() - 1;
}

void Sketch::add(Layer layer, std::size_t frame, std::optional<std::size_t> colour,
                 std::vector<Shape> shapes) {
  if (shapes.empty()) return;
  layers[static_cast<std::size_t>(layer)].push_back({frame, colour, std::move(shapes)});
}

Drawing Sketch::finished() && {
  for (std::vector<Figure>& layer : layers) {
    for (Figure& figure : layer) drawing.figures.push_back(std::move(figure));
  }
  return std::move(drawing);
}

double symbol_size(const Box& extent) {
  // At the size of the pictures, some 320 pixels, a joint has a radius of 5.
  constexpr double kShareOfPicture = 0.0155;
  const double size = std::max(extent.width(), extent.height());
  return size > 0 ? kShareOfPicture * size : 1;
}

std::vector<Site> sites(const Mechanism& mechanism) {
  std::vector<PointOf> points;
  std::vector<std::size_t> first_of_body;
  for (std::size_t body = 0; body < mechanism.bodies.size(); ++body) {
    first_of_body.push_back(points.size());
    for (std::size_t k = 0; k < mechanism.bodies[body].points.size(); ++k) {
      points.push_back({body, k});
    }
  }
  std::vector<std::size_t> site_of(points.size());
  std::iota(site_of.begin(), site_of.end(), 0);
  std::vector<bool> is_jointed(points.size(), false);
  for (const Joint& joint : mechanism.joints) {
    if (is_transmission(joint.type)) continue;
    const std::size_t a = first_of_body[joint.at[0].body] + joint.at[0].point;
    const std::size_t b = first_of_body[joint.at[1].body] + joint.at[1].point;
    is_jointed[a] = is_jointed[a] || !has_line(joint.type);
    is_jointed[b] = is_jointed[b] || joint.type != JointType::prismatic;
    if (traits(joint.type).place != JointPlace::at_point) continue;
    const std::size_t kept = std::min(site_of[a], site_of[b]);
    const std::size_t merged = std::max(site_of[a], site_of[b]);
    std::replace(site_of.begin(), site_of.end(), merged, kept);
  }
  return named(mechanism, points, site_of, is_jointed);
}

Box extent(const Mechanism& mechanism, const std::vector<Eigen::VectorXd>& poses, const Eye& eye) {
  Box box;
  for (const Eigen::VectorXd& q : poses) {
    for (std::size_t body = 0; body < mechanism.bodies.size(); ++body) {
      for (std::size_t k = 0; k < mechanism.bodies[body].points.size(); ++k) {
        box.include(seen(mechanism, point_position(mechanism, {body, k}, q), eye));
      }
    }
  }
  return box;
}

bool has_own_name(const Mechanism& mechanism, const Joint& joint) {
  const auto full = [&](const PointOf& point) {
    const Body& body = mechanism.bodies[point.body];
    return body.name + "." + body.points[point.point].name;
  };
  return joint.name != full(joint.at[0]) + "-" + full(joint.at[1]);
}

bool is_guided(const Joint& joint) {
  const JointPlace place = traits(joint.type).place;
  return place == JointPlace::on_line || place == JointPlace::in_plane;
}

}  // namespace moivre
