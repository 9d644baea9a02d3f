// SPDX-License-Identifier: MIT
// A sweep as a picture: a curve of counts, or a map of them with its borders.
#include <algorithm>
#include <filesystem>
#include <set>
#include <utility>

#include "moivre/closure_report/sweep_report.h"
#include "moivre/report/markup.h"
#include "moivre/report/number_text.h"
#include "plot_frame.h"

namespace moivre {
namespace {

// Light to dark with the number of closures; told apart without colours, too.
constexpr const char* kColours[] = {"#f4f4f4", "#c6dbef", "#9ecae1", "#6baed6", "#4292c6",
                                    "#2171b5", "#08519c", "#08306b", "#041a3d"};

constexpr const char* kMoving = "#c7e9c0";
constexpr const char* kUndecided = "#fdd0a2";

std::string number(double x) { return short_text(x, 6); }

std::string text_at(double x, double y, const char* anchor, const std::string& text) {
  return "<text x=\"" + number(x) + "\" y=\"" + number(y) + "\" text-anchor=\"" + anchor + "\">" +
         escaped(text) + "</text>\n";
}

std::string line_svg(double x1, double y1, double x2, double y2, const char* style) {
  return "<path d=\"M" + number(x1) + ' ' + number(y1) + 'L' + number(x2) + ' ' + number(y2) +
         "\" style=\"" + style + "\"/>\n";
}

/// The frame's pixels of a number between its ends.
struct Axis {
  double from, to, begin, end;
  double operator()(double value) const {
    return begin + (end - begin) * (value - from) / (to - from);
  }
};

Axis horizontal(double from, double to) { return {from, to, kPlotLeft, kPlotRight}; }
Axis vertical(double from, double to) { return {from, to, kPlotBottom, kPlotTop}; }

std::string picture_head(const std::string& title) {
  return "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"" + number(kPictureWidth) +
         "\" height=\"" + number(kPictureHeight) + "\" viewBox=\"0 0 " + number(kPictureWidth) +
         ' ' + number(kPictureHeight) + "\" font-family=\"sans-serif\" font-size=\"13\">\n" +
         "<rect width=\"100%\" height=\"100%\" fill=\"white\"/>\n" +
         text_at(kPlotLeft, kPlotTop - 16, "start", title);
}

std::string ticks(const Varied& number_varied, const Axis& axis, bool is_horizontal) {
  std::string text;
  constexpr int kTicks = 4;
  for (int k = 0; k <= kTicks; ++k) {
    const double value = number_varied.from + (number_varied.to - number_varied.from) * k / kTicks;
    text += is_horizontal ? text_at(axis(value), kPlotBottom + 20, "middle", number(value))
                          : text_at(kPlotLeft - 8, axis(value) + 4, "end", number(value));
  }
  return text;
}

std::string frame() {
  return "<rect x=\"" + number(kPlotLeft) + "\" y=\"" + number(kPlotTop) + "\" width=\"" +
         number(kPlotRight - kPlotLeft) + "\" height=\"" + number(kPlotBottom - kPlotTop) +
         "\" fill=\"none\" stroke=\"#444\"/>\n";
}

/// Which closures are counted: the usable ones, which are the real ones where no sample has limits
/// or fit that tell.
struct Wanted {
  bool has_limits = false;
  bool has_fit = false;

  const char* name() const {
    return has_limits ? "within limits" : has_fit ? "within fit" : "real";
  }
  bool is_real() const { return !has_limits && !has_fit; }
};

Wanted wanted_of(const SweepResult& result) {
  Wanted wanted;
  for (const SweepSample& sample : result.samples) {
    wanted.has_limits |= sample.found.filtered > 0;
    wanted.has_fit |= sample.found.fitted > 0;
  }
  return wanted;
}

std::string curve_path(const std::string& path, const char* style) {
  return "<path d=\"" + path + "\" fill=\"none\" style=\"" + style + "\"/>\n";
}

/// The number of all closures.
std::string curve_of_all(const SweepResult& result, const Axis& x, const Axis& y,
                         const char* style) {
  std::string path;
  for (const SweepSample& sample : result.samples) {
    path += (path.empty() ? 'M' : 'L') + number(x(sample.at[0])) + ' ' +
            number(y(static_cast<double>(sample.complex)));
  }
  return curve_path(path, style);
}

/// Steps: level up to where the next sample, or a border before it, says otherwise.
std::string count_curve(const SweepResult& result, const Axis& x, const Axis& y, auto count,
                        const char* style) {
  std::string path;
  const auto add = [&](double at, const Assemblies& found) {
    path += (path.empty() ? 'M' : 'L') + number(x(at)) + ' ' +
            number(y(static_cast<double>(count(found))));
  };
  std::size_t border = 0;
  for (std::size_t k = 0; k < result.samples.size(); ++k) {
    const SweepSample& sample = result.samples[k];
    if (k > 0) {
      const double low = std::min(result.samples[k - 1].at[0], sample.at[0]);
      const double high = std::max(result.samples[k - 1].at[0], sample.at[0]);
      for (; border < result.borders.size(); ++border) {
        const SweepBorder& edge = result.borders[border];
        if (edge.at[0] < low || edge.at[0] > high) break;
        add(edge.at[0], edge.below);
        add(edge.at[0], edge.above);
      }
    }
    add(sample.at[0], sample.found);
  }
  return curve_path(path, style);
}

/// What a sample is beside its count: its colour, nullptr where it is nothing.
const char* mark_of(const SweepSample& sample) {
  if (!sample.complete) return kUndecided;
  return sample.found.moves ? kMoving : nullptr;
}

/// Behind the curve, from a border to the next one, or half-way to the next sample.
std::string bands(const SweepResult& result, const Axis& x) {
  constexpr double kNarrowest = 9;  // pixels: a single value at which it moves shows, too
  std::string svg;
  const auto& samples = result.samples;
  const auto end = [&](std::size_t k, std::size_t next) {
    const double here = samples[k].at[0];
    const double there = samples[next].at[0];
    double place = (here + there) / 2;
    for (const SweepBorder& border : result.borders) {
      const bool is_between = (border.at[0] - here) * (border.at[0] - there) <= 0;
      if (is_between && border.below.moves != border.above.moves) place = border.at[0];
    }
    return x(place);
  };
  for (std::size_t k = 0; k < samples.size(); ++k) {
    const char* mark = mark_of(samples[k]);
    if (mark == nullptr) continue;
    double left = k == 0 ? x(samples[k].at[0]) : end(k, k - 1);
    double right = k + 1 == samples.size() ? x(samples[k].at[0]) : end(k, k + 1);
    const double spare = std::max(0.0, kNarrowest - (right - left)) / 2;
    left = std::max(kPlotLeft, left - spare);
    right = std::min(kPlotRight, right + spare);
    svg += "<rect x=\"" + number(left) + "\" y=\"" + number(kPlotTop) + "\" width=\"" +
           number(right - left) + "\" height=\"" + number(kPlotBottom - kPlotTop) + "\" fill=\"" +
           mark + "\"/>\n";
  }
  return svg;
}

/// A square of the colour beside its meaning, on the right of the plot.
std::string legend_entry(double top, const char* fill, const std::string& text) {
  return "<rect x=\"" + number(kPlotRight + 12) + "\" y=\"" + number(top) +
         "\" width=\"16\" height=\"16\" stroke=\"#444\" fill=\"" + fill + "\"/>\n" +
         text_at(kPlotRight + 34, top + 13, "start", text);
}

constexpr double kLegendStep = 22;

/// The meanings of the samples' marks, from `top` downwards.
std::string legend_of_marks(const SweepResult& result, double top) {
  std::string svg;
  for (const auto& [mark, text] : {std::pair{kMoving, "moves"}, {kUndecided, "undecided"}}) {
    const bool is_there =
        std::any_of(result.samples.begin(), result.samples.end(),
                    [&, which = mark](const SweepSample& s) { return mark_of(s) == which; });
    if (!is_there) continue;
    svg += legend_entry(top, mark, text);
    top += kLegendStep;
  }
  return svg;
}

/// A short line beside its meaning, on the right of the plot.
std::string line_entry(double top, const char* style, const std::string& text) {
  return line_svg(kPlotRight + 8, top + 8, kPlotRight + 26, top + 8, style) +
         text_at(kPlotRight + 32, top + 12, "start", text);
}

std::string counts_svg(const SweepResult& result, const std::string& title) {
  std::uint64_t most = 1;
  for (const SweepSample& sample : result.samples)
    most = std::max({most, sample.complex, sample.found.real, sample.found.usable()});
  const Varied& varied = result.varied[0];
  const Axis x = horizontal(varied.from, varied.to);
  const Axis y = vertical(-0.5, static_cast<double>(most) + 0.5);
  std::string svg = picture_head(title) + bands(result, x) + frame() + ticks(varied, x, true);
  for (std::uint64_t k = 0; k <= most; ++k) {
    svg += text_at(kPlotLeft - 8, y(static_cast<double>(k)) + 4, "end", std::to_string(k));
  }
  constexpr const char* kOfAll = "stroke:#999;stroke-width:1;stroke-dasharray:4 3";
  constexpr const char* kOfReal = "stroke:#2171b5;stroke-width:2";
  constexpr const char* kOfWanted = "stroke:#006d2c;stroke-width:2";
  const Wanted wanted = wanted_of(result);
  svg += curve_of_all(result, x, y, kOfAll);
  svg += count_curve(
      result, x, y, [](const Assemblies& found) { return found.real; }, kOfReal);
  double top = kPlotTop;
  const auto add_to_legend = [&](const char* style, const std::string& text) {
    svg += line_entry(top, style, text);
    top += kLegendStep;
  };
  if (!wanted.is_real()) {
    svg += count_curve(
        result, x, y, [](const Assemblies& found) { return found.usable(); }, kOfWanted);
    add_to_legend(kOfWanted, wanted.name());
  }
  add_to_legend(kOfReal, "real");
  add_to_legend(kOfAll, "all");
  svg += legend_of_marks(result, top);
  for (const SweepBorder& border : result.borders) {
    svg += "<g>" +
           line_svg(x(border.at[0]), kPlotTop, x(border.at[0]), kPlotBottom,
                    "stroke:#d94801;stroke-width:0.7") +
           "<title>" + escaped(varied.name) + " = " + number(border.at[0]) + "</title></g>\n";
  }
  svg += text_at((kPlotLeft + kPlotRight) / 2, kPictureHeight - 16, "middle", varied.name);
  return svg + "</svg>\n";
}

const char* colour(std::uint64_t count, std::uint64_t most) {
  const std::size_t last = std::size(kColours) - 1;
  if (count == 0) return kColours[0];
  return kColours[most <= last
                      ? count
                      : 1 + (count - 1) * (last - 1) / std::max<std::uint64_t>(most - 1, 1)];
}

/// The border points of a cell, joined: two by a line, more to their middle.
std::string cell_borders(const std::vector<const SweepBorder*>& points, const Axis& x,
                         const Axis& y) {
  constexpr const char* kStyle = "stroke:#d94801;stroke-width:1.2";
  if (points.size() < 2) return "";
  double mx = 0;
  double my = 0;
  for (const SweepBorder* point : points) {
    mx += x(point->at[0]) / static_cast<double>(points.size());
    my += y(point->at[1]) / static_cast<double>(points.size());
  }
  if (points.size() == 2) {
    return line_svg(x(points[0]->at[0]), y(points[0]->at[1]), x(points[1]->at[0]),
                    y(points[1]->at[1]), kStyle);
  }
  std::string svg;
  for (const SweepBorder* point : points) {
    svg += line_svg(x(point->at[0]), y(point->at[1]), mx, my, kStyle);
  }
  return svg;
}

/// In which cells a border point lies: it is on an edge of one or two.
std::vector<std::vector<const SweepBorder*>> borders_by_cell(const SweepResult& result) {
  const Varied& a = result.varied[0];
  const Varied& b = result.varied[1];
  const auto place = [](const Varied& v, double value) {
    const double k = (value - v.from) / (v.to - v.from) * static_cast<double>(v.count - 1);
    return std::clamp(k, 0.0, static_cast<double>(v.count - 1));
  };
  const std::size_t columns = b.count - 1;
  std::vector<std::vector<const SweepBorder*>> cells((a.count - 1) * columns);
  for (const SweepBorder& border : result.borders) {
    if (border.below.usable() == border.above.usable() &&
        border.below.moves == border.above.moves) {
      continue;
    }
    // On a grid line of the number that does not vary, inside an edge of the other.
    const bool varies_a = border.along == 0;
    const Varied& across = varies_a ? b : a;
    const auto grid = static_cast<std::size_t>(place(across, border.at[varies_a ? 1 : 0]) + 0.5);
    const Varied& along = varies_a ? a : b;
    const auto inside =
        std::min(static_cast<std::size_t>(place(along, border.at[border.along])), along.count - 2);
    for (const std::size_t cell : {grid, grid - 1}) {
      if (cell >= across.count - 1) continue;
      const std::size_t i = varies_a ? inside : cell;
      const std::size_t j = varies_a ? cell : inside;
      cells[i * columns + j].push_back(&border);
    }
  }
  return cells;
}

std::string map_svg(const SweepResult& result, const std::string& title) {
  const Varied& a = result.varied[0];
  const Varied& b = result.varied[1];
  const Axis x = horizontal(a.from, a.to);
  const Axis y = vertical(b.from, b.to);
  std::set<std::uint64_t> counts;
  for (const SweepSample& sample : result.samples) counts.insert(sample.found.usable());
  const double width = (kPlotRight - kPlotLeft) / static_cast<double>(a.count - 1);
  const double height = (kPlotBottom - kPlotTop) / static_cast<double>(b.count - 1);
  std::string svg = picture_head(title) + "<clipPath id=\"map\">" + frame() + "</clipPath>\n" +
                    "<g clip-path=\"url(#map)\" shape-rendering=\"crispEdges\">\n";
  for (const SweepSample& sample : result.samples) {
    const char* mark = mark_of(sample);
    const char* fill = mark != nullptr ? mark : colour(sample.found.usable(), *counts.rbegin());
    svg += "<rect x=\"" + number(x(sample.at[0]) - width / 2) + "\" y=\"" +
           number(y(sample.at[1]) - height / 2) + "\" width=\"" + number(width) + "\" height=\"" +
           number(height) + "\" fill=\"" + fill + "\"/>\n";
  }
  svg += "</g>\n";
  for (const auto& cell : borders_by_cell(result)) svg += cell_borders(cell, x, y);
  svg += frame() + ticks(a, x, true) + ticks(b, y, false);
  svg += text_at((kPlotLeft + kPlotRight) / 2, kPictureHeight - 16, "middle", a.name);
  svg += "<g transform=\"translate(16 " + number((kPlotTop + kPlotBottom) / 2) +
         ") rotate(-90)\">" + text_at(0, 0, "middle", b.name) + "</g>\n";
  double top = kPlotTop;
  const std::string name = wanted_of(result).name();
  for (const std::uint64_t count : counts) {
    svg += legend_entry(top, colour(count, *counts.rbegin()), std::to_string(count) + ' ' + name);
    top += kLegendStep;
  }
  return svg + legend_of_marks(result, top) + "</svg>\n";
}

}  // namespace

std::string sweep_svg(const SweepResult& result, const std::string& file) {
  const std::string title = std::filesystem::path(file).filename().string();
  return result.varied.size() == 1 ? counts_svg(result, title) : map_svg(result, title);
}

}  // namespace moivre
