// SPDX-License-Identifier: MIT
// Axes, colours and heads of the diagrams' scripts.
#include "gnuplot_axes.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "moivre/report/number_text.h"

namespace moivre {
namespace {

/// A colour a curve, told apart with any colour vision [Okabe and Ito], and a symbol of gnuplot's
/// SVG terminal: methods come in pairs of one hue, light and dark.
struct CurveStyle {
  const char* colour;
  int symbol;
};
constexpr std::array<CurveStyle, 9> kStyles{{{"#0072b2", 7},
                                             {"#56b4e9", 5},
                                             {"#d55e00", 9},
                                             {"#e69f00", 11},
                                             {"#009e73", 4},
                                             {"#7fcf9f", 6},
                                             {"#000000", 13},
                                             {"#cc79a7", 8},
                                             {"#999999", 10}}};

}  // namespace

double drawn_error(double error) { return std::clamp(error, kLeastDrawn, kMostDrawn); }

void DiagramRange::take(double x) {
  low = std::min(low, x);
  high = std::max(high, x);
}

std::string DiagramRange::text(double margin) const {
  const double first = std::floor(std::log10(low)) - margin;
  const double last = std::max(std::ceil(std::log10(high)), first + 1) + margin;
  return "[1e" + exact_text(first) + ":1e" + exact_text(last) + "]";
}

std::string curve_colour(std::size_t k) { return kStyles[k % kStyles.size()].colour; }

std::string curve_style(std::size_t k) {
  return "pt " + std::to_string(kStyles[k % kStyles.size()].symbol) + " lc rgb \"" +
         curve_colour(k) + "\"";
}

std::string gnuplot_head(const std::string& name) {
  return "# SPDX-License-Identifier: MIT\n# Error against run time of " + name + ": run `gnuplot " +
         name + ".gp` in this folder.\n";
}

std::string gnuplot_terminal(const std::string& name, int width, int height) {
  return "set terminal svg size " + std::to_string(width) + ',' + std::to_string(height) +
         " dynamic font \"sans-serif,13\" background \"white\"\nset output \"" + name +
         ".svg\"\n"
         "set logscale xy 10\nset format xy \"10^{%T}\"\nset grid lc rgb \"#dddddd\"\n";
}

}  // namespace moivre
