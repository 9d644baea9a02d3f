// SPDX-License-Identifier: MIT
// How do figures become SVG? Shapes as paths in pixels (y downwards), a style sheet, text that no
// name can break out of.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "moivre/closure_report/drawing.h"
#include "moivre/report/markup.h"
#include "moivre/report/number_text.h"

namespace moivre {

/// The shortest decimal to 1/100; "0" where x is not finite.
std::string pixel_text(double x);
/// "M1 2L3 4": from each of the points, in pixels, to the next.
std::string path_data(const std::vector<Complex>& points);

/// z -> conj(z) scale + origin: from the picture's plane to pixels.
struct PixelMap {
  double scale = 1;
  Complex origin = 0;
  Complex operator()(Complex z) const { return std::conj(z) * scale + origin; }
};

/// One <g> with its shapes, each placed by `at` and then by `map`.
std::string figure_svg(const Figure& figure, const Similarity& at, const PixelMap& map);
/// All figures, each on its frame.
std::string figures_svg(const Drawing& drawing, const std::vector<Similarity>& places,
                        const PixelMap& map);

/// Of the body with this number; they repeat.
std::string colour_text(std::size_t number);
/// Of a line, as stroke-dasharray: number 0 is solid, and so are all whose colour is in the
/// palette's first round.
std::string dashes_text(std::size_t colour, std::size_t number = 0);

/// Rules for the classes that figures and texts have.
std::string style_sheet();

/// `anchor` is "start", "middle" or "end"; `classes` are of the style sheet.
std::string text_svg(Complex at, std::string_view anchor, std::string_view classes,
                     std::string_view text);
/// About as wide as the text comes out, in pixels.
double text_width(std::string_view text, double font_size);
/// Broken between words so that no line is wider, where that is possible.
std::vector<std::string> wrapped(const std::string& text, double font_size, double width);

/// Of notes, in pixels.
inline constexpr double kNoteFont = 12;
inline constexpr double kNoteLine = 17;

/// Lines of a title and of a note below it, from `left` on; y moves down.
std::string heading_svg(const std::string& title, const std::string& note, double left,
                        double width, double& y);

/// A label's text, with its value where it has one.
std::string label_text(const Label& label, const Mechanism& mechanism, const Eigen::VectorXd& q);

/// A bar of a round length (1, 2 or 5 times a power of ten) about 80 pixels long, with the unit,
/// its left end at `at`.
std::string scale_bar(Complex at, double pixels_per_length, const std::string& unit);

/// The document around `body`, white behind it.
std::string svg_document(double width, double height, std::string_view title,
                         const std::string& body);

}  // namespace moivre
