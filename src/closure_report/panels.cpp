// SPDX-License-Identifier: MIT
// A sheet of panels: one scale from the size of the symbols, one box for all poses.
#include "panels.h"

#include <algorithm>
#include <cmath>

#include "labels.h"
#include "moivre/closure_report/angles.h"
#include "moivre/closure_report/sheet.h"
#include "pose_text.h"
#include "svg.h"

namespace moivre {
namespace {

// All in pixels.
constexpr double kPinRadius = 5;
constexpr double kMargin = 16;       // around the sheet
constexpr double kGap = 12;          // between panels
constexpr double kLabelRoom = 30;    // around the mechanism in its panel
constexpr double kCaptionRoom = 26;  // above it
constexpr double kCaptionLeft = 10;
constexpr double kWidest = 1180;    // of all panels in a row
constexpr double kNarrowest = 440;  // of a sheet
constexpr double kTitleFont = 17;
constexpr double kNoteFont = 12;
constexpr double kTitleLine = 22;
constexpr double kNoteLine = 17;
constexpr double kFooter = 34;

struct Layout {
  double panel_width = 0;
  double panel_height = 0;
  std::size_t columns = 1;
  std::size_t rows = 1;
  double width() const {
    const double n = static_cast<double>(columns);
    return std::max(kNarrowest, n * panel_width + (n - 1) * kGap);
  }
};

/// What caption and notes take above the mechanism, in every panel alike.
double heading_room(const Sheet& sheet) {
  std::size_t notes = 0;
  for (const Panel& panel : sheet.panels) notes = std::max(notes, panel.notes.size());
  return kCaptionRoom + kNoteLine * static_cast<double>(notes);
}

Layout lay_out(const Box& box, double scale, const Sheet& sheet) {
  const std::size_t panels = sheet.panels.size();
  Layout layout;
  constexpr double kCaptionWidth = 130;
  layout.panel_width = std::max(kCaptionWidth, box.width() * scale + 2 * kLabelRoom);
  for (const Panel& panel : sheet.panels) {
    for (const std::string& note : panel.notes) {
      layout.panel_width =
          std::max(layout.panel_width, text_width(note, kNoteFont) + 2 * kCaptionLeft);
    }
  }
  layout.panel_height = box.height() * scale + 2 * kLabelRoom + heading_room(sheet);
  const auto most = static_cast<std::size_t>((kWidest + kGap) / (layout.panel_width + kGap));
  layout.rows = (panels - 1) / std::max<std::size_t>(most, 1) + 1;
  layout.columns = (panels - 1) / layout.rows + 1;
  return layout;
}

std::string heading(const Sheet& sheet, double width, double& y) {
  std::string svg;
  for (const std::string& line : wrapped(sheet.title, kTitleFont, width)) {
    y += kTitleLine;
    svg += text_svg({kMargin, y}, "start", "title", line);
  }
  for (const std::string& line : wrapped(sheet.summary, kNoteFont, width)) {
    y += kNoteLine;
    svg += text_svg({kMargin, y}, "start", "note", line);
  }
  return svg;
}

std::string panel_svg(const Panel& panel, const Drawing& drawing, const Mechanism& mechanism,
                      const PixelMap& map, const Box& frame, double heading) {
  const std::vector<Similarity> places = place(drawing, mechanism, panel.q);
  std::string svg = element("rect", {{"class", "panel"},
                                     {"x", pixel_text(frame.lower.real())},
                                     {"y", pixel_text(frame.lower.imag())},
                                     {"width", pixel_text(frame.width())},
                                     {"height", pixel_text(frame.height())},
                                     {"rx", "6"}}) +
                    '\n';
  double line = 20;
  svg += text_svg(frame.lower + Complex(kCaptionLeft, line), "start",
                  panel.is_faint ? "note" : "id", panel.caption);
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

double pixel_scale(const Drawing& drawing) { return kPinRadius / drawing.symbol; }

bool drives_angle(const Mechanism& mechanism, const Driver& driver) {
  if (driver.kind == DriverKind::unknown) return mechanism.unknowns[driver.unknown].is_angle;
  return driver.kind == DriverKind::angle;
}

std::string drivers_text(const Mechanism& mechanism, double time) {
  std::string text;
  for (const Driver& driver : mechanism.drivers) {
    const auto kind =
        drives_angle(mechanism, driver) ? CoordinateKind::angle : CoordinateKind::length;
    const Coordinate shown{driver.name, kind, 0};
    text += (text.empty() ? "" : ", ") + label_of(driver) + " = " +
            coordinate_text(mechanism, shown, driver_state(driver.law, time).value);
  }
  return text;
}

std::string sheet_svg(const Sheet& sheet, const Mechanism& mechanism) {
  std::vector<Eigen::VectorXd> poses;
  for (const Panel& panel : sheet.panels) poses.push_back(panel.q);
  const Drawing drawing = draw(mechanism, poses, sheet.view);
  Box box;
  for (const Eigen::VectorXd& q : poses) {
    const Box one = bounds(drawing, place(drawing, mechanism, q));
    box.include(one.lower);
    box.include(one.upper);
  }
  const double scale = pixel_scale(drawing);
  const double room = heading_room(sheet);
  const Layout layout = lay_out(box, scale, sheet);
  double y = kMargin / 2;
  std::string svg = heading(sheet, layout.width(), y);
  y += kGap;
  for (std::size_t k = 0; k < sheet.panels.size(); ++k) {
    const std::size_t row = k / layout.columns;
    const std::size_t column = k % layout.columns;
    Box frame;
    const Complex corner(kMargin + static_cast<double>(column) * (layout.panel_width + kGap),
                         y + static_cast<double>(row) * (layout.panel_height + kGap));
    frame.include(corner);
    frame.include(corner + Complex(layout.panel_width, layout.panel_height));
    const Complex middle =
        corner + Complex(layout.panel_width / 2, (layout.panel_height + room) / 2);
    const PixelMap map{scale, middle - std::conj((box.lower + box.upper) / 2.0) * scale};
    svg += panel_svg(sheet.panels[k], drawing, mechanism, map, frame, room);
  }
  y += static_cast<double>(layout.rows) * (layout.panel_height + kGap);
  if (drawing.to_scale) {
    svg += scale_bar({kMargin, y + kFooter / 3}, scale, mechanism.units.length);
    y += kFooter;
  }
  return svg_document(layout.width() + 2 * kMargin, y, sheet.title, svg);
}

}  // namespace moivre
