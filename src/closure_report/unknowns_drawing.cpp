// SPDX-License-Identifier: MIT
// How are typed equations drawn, which have no bodies? A dial for each angle, a ruler for each
// length.
#include <algorithm>

#include "figures.h"

namespace moivre {
namespace {

// In radii of a dial.
constexpr double kDialSpacing = 3.2;
constexpr double kNeedle = 0.86;
constexpr double kNeedleRadius = 0.06;
constexpr double kTick = 0.12;
constexpr double kLabelDepth = 1.3;
constexpr double kRulerSpacing = 1.1;
constexpr double kShortestRuler = 5;
constexpr double kMarkerRadius = 0.13;
constexpr double kRulerLabelDepth = 0.45;

std::vector<Shape> dial_face(Complex centre) {
  std::vector<Shape> shapes{disc(Style::axis, centre, 1)};
  for (const Complex direction : {Complex(1, 0), Complex(0, 1), Complex(-1, 0), Complex(0, -1)}) {
    shapes.push_back(polyline(Style::mark, {centre + direction, centre + (1 - kTick) * direction}));
  }
  return shapes;
}

/// Least and greatest length in all poses, 0 among them.
std::array<double, 2> length_range(const Mechanism& mechanism,
                                   const std::vector<Eigen::VectorXd>& poses) {
  std::array<double, 2> range{0, 0};
  for (const Eigen::VectorXd& q : poses) {
    for (std::size_t k = 0; k < mechanism.unknowns.size(); ++k) {
      if (mechanism.unknowns[k].is_angle) continue;
      range[0] = std::min(range[0], q[static_cast<Eigen::Index>(k)]);
      range[1] = std::max(range[1], q[static_cast<Eigen::Index>(k)]);
    }
  }
  if (range[0] == range[1]) range[1] = 1;
  return range;
}

}  // namespace

Drawing draw_unknowns(const Mechanism& mechanism, const std::vector<Eigen::VectorXd>& poses) {
  Sketch sketch;
  sketch.drawing.to_scale = false;
  const std::size_t ground = sketch.add(LineFrame{});
  const auto dials =
      static_cast<double>(std::count_if(mechanism.unknowns.begin(), mechanism.unknowns.end(),
                                        [](const Unknown& unknown) { return unknown.is_angle; }));
  const double width = std::max(kShortestRuler, kDialSpacing * (dials - 1) + 2);
  const auto [shortest, longest] = length_range(mechanism, poses);
  const double scale = width / (longest - shortest);
  double dial_x = 0;
  double ruler_y = dials > 0 ? -kLabelDepth - kRulerSpacing : 0;
  for (std::size_t k = 0; k < mechanism.unknowns.size(); ++k) {
    const auto coordinate = static_cast<Eigen::Index>(k);
    Complex label;
    if (mechanism.unknowns[k].is_angle) {
      sketch.add(Sketch::backdrop, ground, std::nullopt, dial_face(dial_x));
      sketch.add(Sketch::links, sketch.add(DialFrame{coordinate, dial_x}), k,
                 {capsule(Style::link, 0, kNeedle, kNeedleRadius), disc(Style::pin, 0, kTick / 2)});
      label = {dial_x, -kLabelDepth};
      dial_x += kDialSpacing;
    } else {
      const Complex zero(-1 - shortest * scale, ruler_y);
      const Complex tick(0, kTick);
      sketch.add(Sketch::backdrop, ground, std::nullopt,
                 {polyline(Style::axis, {{-1, ruler_y}, {width - 1, ruler_y}}),
                  polyline(Style::mark, {zero - tick, zero + tick})});
      sketch.drawing.labels.push_back(
          {LabelKind::unknown, "0", ground, zero + 3.0 * tick, std::nullopt, std::nullopt});
      sketch.add(Sketch::links, sketch.add(RulerFrame{coordinate, zero, scale}), k,
                 {disc(Style::link, 0, kMarkerRadius)});
      label = {width / 2 - 1, ruler_y - kRulerLabelDepth};
      ruler_y -= kRulerSpacing;
    }
    sketch.drawing.labels.push_back(
        {LabelKind::unknown, mechanism.unknowns[k].name, ground, label, k, coordinate});
  }
  Drawing drawing = std::move(sketch).finished();
  drawing.symbol = symbol_size(bounds(drawing, place(drawing, mechanism, poses.front())));
  return drawing;
}

}  // namespace moivre
