// SPDX-License-Identifier: MIT
// Labels placed greedily: points first, bodies then, each where it costs least.
#include "labels.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <numbers>

namespace moivre {
namespace {

constexpr double kPointFont = 12;  // pixels, as in the style sheet
constexpr double kBodyFont = 11;
// A base line below the middle of the letters, in font sizes.
constexpr double kBaseline = 0.36;
constexpr double kSpacing = 2;  // pixels from one dot of ink to the next
// Costs: of a dot of a line, of a dot of a joint or of the ground, of a square pixel shared by two
// labels or outside the frame, of a pixel of distance.
constexpr double kLineCost = 1;
constexpr double kSymbolCost = 3;
constexpr double kOverlapCost = 1.5;
constexpr double kDistanceCost = 0.35;

struct Dot {
  Complex at;
  double weight;
};

struct Rectangle {
  Complex centre;
  double half_width;
  double half_height;

  bool contains(Complex z) const {
    const Complex d = z - centre;
    return std::abs(d.real()) <= half_width && std::abs(d.imag()) <= half_height;
  }
  double area() const { return 4 * half_width * half_height; }
  double area_shared_with(const Rectangle& other) const {
    const auto shared = [](double distance, double half, double other_half) {
      return std::max(
          0.0, std::min(half, distance + other_half) - std::max(-half, distance - other_half));
    };
    const Complex d = other.centre - centre;
    return shared(d.real(), half_width, other.half_width) *
           shared(d.imag(), half_height, other.half_height);
  }
};

double weight_of(Style style) {
  switch (style) {
    case Style::link:
    case Style::slot:
    case Style::rod:
    case Style::wire:
    case Style::guide:
    case Style::axis:
    case Style::x_axis:
    case Style::y_axis:
    case Style::z_axis:
    case Style::pitch_circle:
      return kLineCost;
    case Style::block:
    case Style::pin:
    case Style::slot_pin:
    case Style::weld:
    case Style::ground:
    case Style::hatch:
    case Style::mark:
      return kSymbolCost;
  }
  return kLineCost;
}

void ink_line(std::vector<Dot>& ink, Complex from, Complex to, double weight) {
  const int steps = std::max(1, static_cast<int>(std::abs(to - from) / kSpacing));
  for (int k = 0; k <= steps; ++k) {
    ink.push_back({from + (to - from) * (static_cast<double>(k) / steps), weight});
  }
}

void ink_circle(std::vector<Dot>& ink, Complex centre, double radius, double weight) {
  const int steps = std::max(8, static_cast<int>(2 * std::numbers::pi * radius / kSpacing));
  for (int k = 0; k < steps; ++k) {
    ink.push_back({centre + std::polar(radius, 2 * std::numbers::pi * k / steps), weight});
  }
}

std::vector<Dot> ink_of(const Drawing& drawing, const std::vector<Similarity>& places,
                        const PixelMap& map) {
  std::vector<Dot> ink;
  for (const Figure& figure : drawing.figures) {
    const Similarity& at = places[figure.frame];
    for (const Shape& shape : figure.shapes) {
      const double radius = shape.radius * std::abs(at.a) * map.scale;
      const double weight = weight_of(shape.style);
      std::vector<Complex> z;
      for (const Complex point : shape.points) z.push_back(map(at(point)));
      if (shape.is_closed && z.size() == 1) {
        ink_circle(ink, z[0], radius, weight);
        continue;
      }
      const std::size_t lines = shape.is_closed && z.size() > 2 ? z.size() : z.size() - 1;
      for (std::size_t k = 0; k < lines; ++k) {
        const Complex to = z[(k + 1) % z.size()];
        ink_line(ink, z[k], to, weight);
        if (radius == 0 || z[k] == to) continue;
        const Complex aside = (to - z[k]) / std::abs(to - z[k]) * Complex(0, radius);
        ink_line(ink, z[k] + aside, to + aside, weight);
        ink_line(ink, z[k] - aside, to - aside, weight);
      }
    }
  }
  return ink;
}

class Placer {
 public:
  Placer(std::vector<Dot> ink, const Box& frame) : ink_(std::move(ink)), frame_(frame) {}

  /// The centre of the rectangle where it costs least.
  Complex best(Complex anchor, double width, double height, bool may_cover_anchor) {
    Rectangle found{anchor, width / 2, height / 2};
    double least = std::numeric_limits<double>::infinity();
    const std::vector<Dot> near = ink_within({anchor, kFarthest + width, kFarthest + height});
    const auto consider = [&](Complex centre) {
      const Rectangle place{centre, width / 2, height / 2};
      const double cost = cost_of(place, near) + kDistanceCost * std::abs(centre - anchor);
      if (cost >= least) return;
      least = cost;
      found = place;
    };
    if (may_cover_anchor) consider(anchor);
    for (const double distance : {7.0, 10.0, 14.0, 19.0, 26.0, kFarthest}) {
      for (int k = 0; k < kDirections; ++k) {
        const Complex u =
            std::polar(1.0, kFirstDirection_rad + 2 * std::numbers::pi * k / kDirections);
        consider(anchor + u * distance + Complex(u.real() * width / 2, u.imag() * height / 2));
      }
    }
    taken_.push_back(found);
    return found.centre;
  }

 private:
  static constexpr double kFarthest = 34;  // pixels from an anchor to its label
  static constexpr int kDirections = 16;
  static constexpr double kFirstDirection_rad = -std::numbers::pi / 4;  // above on the right

  std::vector<Dot> ink_within(const Rectangle& place) const {
    std::vector<Dot> within;
    std::copy_if(ink_.begin(), ink_.end(), std::back_inserter(within),
                 [&](const Dot& dot) { return place.contains(dot.at); });
    return within;
  }

  double cost_of(const Rectangle& place, const std::vector<Dot>& ink) const {
    double cost = 0;
    for (const Dot& dot : ink) cost += place.contains(dot.at) ? dot.weight : 0;
    for (const Rectangle& other : taken_) cost += kOverlapCost * place.area_shared_with(other);
    const Rectangle frame{(frame_.lower + frame_.upper) / 2.0, frame_.width() / 2,
                          frame_.height() / 2};
    return cost + kOverlapCost * (place.area() - place.area_shared_with(frame));
  }

  std::vector<Dot> ink_;
  Box frame_;
  std::vector<Rectangle> taken_;
};

}  // namespace

std::vector<PlacedLabel> place_labels(const Drawing& drawing, const Mechanism& mechanism,
                                      const Eigen::VectorXd& q,
                                      const std::vector<Similarity>& places, const PixelMap& map,
                                      const Box& frame) {
  Placer placer(ink_of(drawing, places, map), frame);
  std::vector<PlacedLabel> placed;
  for (const LabelKind kind : {LabelKind::unknown, LabelKind::point, LabelKind::body}) {
    for (const Label& label : drawing.labels) {
      if (label.kind != kind) continue;
      const std::string text = label_text(label, mechanism, q);
      const Complex anchor = map(places[label.frame](label.at));
      const double font = kind == LabelKind::body ? kBodyFont : kPointFont;
      const Complex centre =
          kind == LabelKind::unknown
              ? anchor
              : placer.best(anchor, text_width(text, font), font, kind == LabelKind::body);
      const Complex baseline(0, kBaseline * font);
      placed.push_back({&label, text, centre + baseline, baseline});
    }
  }
  return placed;
}

std::string labels_svg(const std::vector<PlacedLabel>& labels) {
  std::string svg;
  for (const PlacedLabel& placed : labels) {
    const bool is_body = placed.label->kind == LabelKind::body;
    svg += text_svg(
        placed.at, "middle",
        std::string("label ") + (is_body ? "body " : "") + colour_class(placed.label->colour),
        placed.text);
  }
  return svg;
}

}  // namespace moivre
