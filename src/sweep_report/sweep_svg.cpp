// SPDX-License-Identifier: MIT
// A sweep as a picture: a curve of counts, or a map of them with its borders.
#include <algorithm>
#include <set>

#include "moivre/report/markup.h"
#include "moivre/report/number_text.h"
#include "moivre/sweep_report/sweep_report.h"
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

std::string line(double x1, double y1, double x2, double y2, const char* style) {
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

std::string head(const std::string& title) {
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

/// Steps: level up to where the next sample, or a border before it, says otherwise.
std::string curve(const SweepResult& result, const Axis& x, const Axis& y, bool of_real,
                  const char* style) {
  std::string path;
  std::size_t border = 0;
  for (std::size_t k = 0; k < result.samples.size(); ++k) {
    const SweepSample& sample = result.samples[k];
    const double level = y(static_cast<double>(of_real ? sample.real : sample.complex));
    if (of_real && k > 0) {
      const double low = std::min(result.samples[k - 1].at[0], sample.at[0]);
      const double high = std::max(result.samples[k - 1].at[0], sample.at[0]);
      for (; border < result.borders.size(); ++border) {
        const SweepBorder& edge = result.borders[border];
        if (edge.at[0] < low || edge.at[0] > high) break;
        path += 'L' + number(x(edge.at[0])) + ' ' + number(y(static_cast<double>(edge.below)));
        path += 'L' + number(x(edge.at[0])) + ' ' + number(y(static_cast<double>(edge.above)));
      }
    }
    path += (k == 0 ? 'M' : 'L') + number(x(sample.at[0])) + ' ' + number(level);
  }
  return "<path d=\"" + path + "\" fill=\"none\" style=\"" + style + "\"/>\n";
}

std::string curve_svg(const SweepResult& result, const std::string& title) {
  std::uint64_t most = 1;
  for (const SweepSample& sample : result.samples)
    most = std::max({most, sample.complex, sample.real});
  const Varied& varied = result.varied[0];
  const Axis x = horizontal(varied.from, varied.to);
  const Axis y = vertical(-0.5, static_cast<double>(most) + 0.5);
  std::string svg = head(title) + frame() + ticks(varied, x, true);
  for (std::uint64_t k = 0; k <= most; ++k) {
    svg += text_at(kPlotLeft - 8, y(static_cast<double>(k)) + 4, "end", std::to_string(k));
  }
  svg += curve(result, x, y, false, "stroke:#999;stroke-width:1;stroke-dasharray:4 3");
  svg += curve(result, x, y, true, "stroke:#2171b5;stroke-width:2");
  for (const SweepBorder& border : result.borders) {
    svg += "<g>" +
           line(x(border.at[0]), kPlotTop, x(border.at[0]), kPlotBottom,
                "stroke:#d94801;stroke-width:0.7") +
           "<title>" + escaped(varied.name) + " = " + number(border.at[0]) + "</title></g>\n";
  }
  svg += text_at((kPlotLeft + kPlotRight) / 2, kPictureHeight - 16, "middle", varied.name);
  svg += text_at(kPlotRight + 8, kPlotTop + 14, "start", "real") +
         text_at(kPlotRight + 8, kPlotTop + 32, "start", "all (dashed)");
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
    return line(x(points[0]->at[0]), y(points[0]->at[1]), x(points[1]->at[0]), y(points[1]->at[1]),
                kStyle);
  }
  std::string svg;
  for (const SweepBorder* point : points) {
    svg += line(x(point->at[0]), y(point->at[1]), mx, my, kStyle);
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
  for (const SweepSample& sample : result.samples) counts.insert(sample.real);
  const double width = (kPlotRight - kPlotLeft) / static_cast<double>(a.count - 1);
  const double height = (kPlotBottom - kPlotTop) / static_cast<double>(b.count - 1);
  std::string svg = head(title) + "<clipPath id=\"map\">" + frame() + "</clipPath>\n" +
                    "<g clip-path=\"url(#map)\" shape-rendering=\"crispEdges\">\n";
  for (const SweepSample& sample : result.samples) {
    const char* fill = !sample.complete ? kUndecided
                       : sample.moves   ? kMoving
                                        : colour(sample.real, *counts.rbegin());
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
  double place = kPlotTop;
  const auto add_to_legend = [&](const char* fill, const std::string& text) {
    svg += "<rect x=\"" + number(kPlotRight + 12) + "\" y=\"" + number(place) +
           "\" width=\"16\" height=\"16\" stroke=\"#444\" fill=\"" + fill + "\"/>\n" +
           text_at(kPlotRight + 34, place + 13, "start", text);
    place += 22;
  };
  for (const std::uint64_t count : counts) {
    add_to_legend(colour(count, *counts.rbegin()), std::to_string(count) + " real");
  }
  const auto any = [&](auto is_so) {
    return std::any_of(result.samples.begin(), result.samples.end(), is_so);
  };
  if (any([](const SweepSample& sample) { return sample.complete && sample.moves; })) {
    add_to_legend(kMoving, "moves");
  }
  if (any([](const SweepSample& sample) { return !sample.complete; })) {
    add_to_legend(kUndecided, "undecided");
  }
  return svg + "</svg>\n";
}

}  // namespace

std::string sweep_svg(const SweepResult& result, const std::string& title) {
  return result.varied.size() == 1 ? curve_svg(result, title) : map_svg(result, title);
}

}  // namespace moivre
