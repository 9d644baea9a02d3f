// SPDX-License-Identifier: MIT
// What do all diagrams of a study share? Their size and font, colours and symbols, logarithmic axes
// from one decade to another.
#pragma once

#include <limits>
#include <string>

#include "moivre/study_report/study_report.h"

namespace moivre {

/// Errors below this are drawn here: a logarithm has no place for 0.
inline constexpr double kLeastDrawn = 1e-18;
/// Where nothing was found: an error as large as the root.
inline constexpr double kMostDrawn = 1;

double drawn_error(double error);

/// The decades that an axis has to hold.
struct DiagramRange {
  double low = std::numeric_limits<double>::infinity();
  double high = 0;

  void take(double x);
  /// From a power of ten to another, a decade at least, and `margin` more decades at both ends.
  std::string text(double margin) const;
};

/// The k-th curve's colour, "#0072b2"; symbol and colour together.
std::string curve_colour(std::size_t k);
std::string curve_style(std::size_t k);

/// The script's first lines, and its terminal and output NAME.svg with logarithmic axes.
std::string gnuplot_head(const std::string& name);
std::string gnuplot_terminal(const std::string& name, int width, int height);

/// The script that writes NAME.svg from a table, and whether it has columns to draw.
bool is_drawn(const StudyTable& table);
std::string table_gnuplot(const std::string& name, const StudyTable& table);

}  // namespace moivre
