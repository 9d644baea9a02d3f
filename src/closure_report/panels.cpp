// SPDX-License-Identifier: MIT
// A sheet of panels: one scale from the size of the symbols, one box for all poses.
#include "panels.h"

#include <algorithm>
#include <filesystem>
#include <numbers>

#include "labels.h"
#include "moivre/closure_report/angles.h"
#include "moivre/closure_report/sheet.h"
#include "moivre/numeric/invalid_input.h"
#include "pose_text.h"
#include "svg.h"

namespace moivre {
namespace {

// All in pixels.
constexpr double kPinDot = 5;
constexpr double kSheetMargin = 16;  // around the sheet
constexpr double kGap = 12;          // between panels
constexpr double kLabelRoom = 30;    // around the mechanism in its panel
constexpr double kCaptionRoom = 26;  // above it
constexpr double kCaptionLeft = 10;
constexpr double kWidest = 1180;         // of all panels in a row
constexpr double kNarrowestSheet = 440;  // of a sheet
constexpr double kFooter = 34;

/// The mechanism from one side.
struct Aspect {
  std::string name;  ///< empty where there is but one
  Drawing drawing;
  Box box;  ///< of all poses
};

struct Side {
  const char* name;
  Eye eye;
};
constexpr double kRightAngle = std::numbers::pi / 2;
constexpr Side kThreeSides[] = {{"front: x, z", {-kRightAngle, 0}},
                                {"right: y, z", {0, 0}},
                                {"above: x, y", {-kRightAngle, kRightAngle}}};

Aspect aspect_of(const Sheet& sheet, const Mechanism& mechanism, const std::string& name,
                 const View& view) {
  std::vector<Eigen::VectorXd> poses;
  for (const Panel& panel : sheet.panels) poses.push_back(panel.q);
  Aspect aspect{name, draw(mechanism, poses, view), {}};
  for (const Eigen::VectorXd& q : poses) {
    const Box one = bounds(aspect.drawing, place(aspect.drawing, mechanism, q));
    aspect.box.include(one.lower);
    aspect.box.include(one.upper);
  }
  return aspect;
}

std::vector<Aspect> aspects_of(const Sheet& sheet, const Mechanism& mechanism) {
  if (sheet.views == Views::standing) return {aspect_of(sheet, mechanism, "", sheet.view)};
  require_spatial(mechanism);
  const double symbol = aspect_of(sheet, mechanism, "", sheet.view).drawing.symbol;
  std::vector<Aspect> aspects;
  for (const Side& side : kThreeSides) {
    View view = sheet.view;
    view.eye = side.eye;
    view.symbol = symbol;
    aspects.push_back(aspect_of(sheet, mechanism, side.name, view));
  }
  return aspects;
}

/// Of the same size for every aspect, about its own middle.
Complex common_size(const std::vector<Aspect>& aspects) {
  double width = 0;
  double height = 0;
  for (const Aspect& aspect : aspects) {
    width = std::max(width, aspect.box.width());
    height = std::max(height, aspect.box.height());
  }
  return {width, height};
}

/// Several aspects have to fit into one row.
double scale_for(const std::vector<Aspect>& aspects, Complex size) {
  const double scale = pixel_scale(aspects.front().drawing);
  const auto count = static_cast<double>(aspects.size());
  if (aspects.size() == 1) return scale;
  const double room = (kWidest - (count - 1) * kGap) / count - 2 * kLabelRoom;
  return std::min(scale, room / size.real());
}

struct Layout {
  double panel_width = 0;
  double panel_height = 0;
  std::size_t columns = 1;
  std::size_t rows = 1;
  double width() const {
    const double n = static_cast<double>(columns);
    return std::max(kNarrowestSheet, n * panel_width + (n - 1) * kGap);
  }
};

/// What caption and notes take above the mechanism, in every panel alike.
double heading_room(const Sheet& sheet) {
  std::size_t notes = 0;
  for (const Panel& panel : sheet.panels) notes = std::max(notes, panel.notes.size());
  return kCaptionRoom + kNoteLine * static_cast<double>(notes);
}

/// size: of the mechanism in pixels. The panels of one closure stand in one row.
Layout lay_out(Complex size, const Sheet& sheet, std::size_t aspects) {
  const std::size_t poses = sheet.panels.size();
  Layout layout;
  constexpr double kCaptionWidth = 130;
  layout.panel_width = std::max(kCaptionWidth, size.real() + 2 * kLabelRoom);
  for (const Panel& panel : sheet.panels) {
    for (const std::string& note : panel.notes) {
      layout.panel_width =
          std::max(layout.panel_width, text_width(note, kNoteFont) + 2 * kCaptionLeft);
    }
  }
  layout.panel_height = size.imag() + 2 * kLabelRoom + heading_room(sheet);
  const auto most = static_cast<std::size_t>((kWidest + kGap) / (layout.panel_width + kGap));
  layout.rows = (poses - 1) / std::max<std::size_t>(most / aspects, 1) + 1;
  layout.columns = ((poses - 1) / layout.rows + 1) * aspects;
  return layout;
}

std::string panel_svg(const Panel& panel, const Aspect& aspect, const Mechanism& mechanism,
                      const PixelMap& map, const Box& frame, double heading) {
  const Drawing& drawing = aspect.drawing;
  const std::vector<Similarity> places = place(drawing, mechanism, panel.q);
  std::string svg = element("rect", {{"class", "panel"},
                                     {"x", pixel_text(frame.lower.real())},
                                     {"y", pixel_text(frame.lower.imag())},
                                     {"width", pixel_text(frame.width())},
                                     {"height", pixel_text(frame.height())},
                                     {"rx", "6"}}) +
                    '\n';
  double line = 20;
  svg +=
      text_svg(frame.lower + Complex(kCaptionLeft, line), "start", panel.is_faint ? "note" : "id",
               panel.caption + (aspect.name.empty() ? "" : ", " + aspect.name));
  for (const std::string& note : panel.notes) {
    line += kNoteLine;
    svg += text_svg(frame.lower + Complex(kCaptionLeft, line), "start", "note", note);
  }
  Box inside = frame;
  inside.lower += Complex(0, heading);
  const std::string pose =
      figures_svg(drawing, places, map) +
      labels_svg(place_labels(drawing, mechanism, panel.q, places, map, inside));
  return svg + element("g", {{"class", panel.is_faint ? "faint" : "pose"}}, pose) + '\n';
}

}  // namespace

double pixel_scale(const Drawing& drawing) { return kPinDot / drawing.symbol; }

void require_spatial(const Mechanism& mechanism) {
  if (mechanism.space == Space::spatial && !is_typed(mechanism)) return;
  throw InvalidInput(
      "three views are for spatial mechanisms and robots; this one has a single view");
}

std::string picture_title(const Mechanism& mechanism, const std::string& file) {
  return mechanism.title.empty() ? std::filesystem::path(file).filename().string()
                                 : mechanism.title;
}

std::string sheet_svg(const Sheet& sheet, const Mechanism& mechanism) {
  const std::vector<Aspect> aspects = aspects_of(sheet, mechanism);
  const Complex size = common_size(aspects);
  const double scale = scale_for(aspects, size);
  const double room = heading_room(sheet);
  const Layout layout = lay_out(size * scale, sheet, aspects.size());
  double y = kSheetMargin / 2;
  std::string svg = heading_svg(sheet.title, sheet.summary, kSheetMargin, layout.width(), y);
  y += kGap;
  for (std::size_t k = 0; k < sheet.panels.size() * aspects.size(); ++k) {
    const Aspect& aspect = aspects[k % aspects.size()];
    const std::size_t row = k / layout.columns;
    const std::size_t column = k % layout.columns;
    Box frame;
    const Complex corner(kSheetMargin + static_cast<double>(column) * (layout.panel_width + kGap),
                         y + static_cast<double>(row) * (layout.panel_height + kGap));
    frame.include(corner);
    frame.include(corner + Complex(layout.panel_width, layout.panel_height));
    const Complex middle =
        corner + Complex(layout.panel_width / 2, (layout.panel_height + room) / 2);
    const Complex centre = (aspect.box.lower + aspect.box.upper) / 2.0;
    const PixelMap map{scale, middle - std::conj(centre) * scale};
    svg += panel_svg(sheet.panels[k / aspects.size()], aspect, mechanism, map, frame, room);
  }
  y += static_cast<double>(layout.rows) * (layout.panel_height + kGap);
  if (aspects.front().drawing.to_scale || sheet.views == Views::three) {
    svg += scale_bar({kSheetMargin, y + kFooter / 3}, scale, mechanism.units.length);
    y += kFooter;
  }
  return svg_document(layout.width() + 2 * kSheetMargin, y, sheet.title, svg);
}

}  // namespace moivre
