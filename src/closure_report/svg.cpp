// SPDX-License-Identifier: MIT
// SVG by hand: paths with arcs, numbers to a hundredth of a pixel, a style sheet.
#include "svg.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

#include "pose_text.h"

namespace moivre {
namespace {

// Dark enough to be read as text on white, apart from each other for colour-blind eyes too.
constexpr std::array<std::string_view, 8> kPalette{"#1f6fb4", "#c8610f", "#2c8c4a", "#b8385a",
                                                   "#7352a8", "#85681b", "#107f8b", "#55606e"};

// Of a document, classes as to_string(Style) and the writers give them.
constexpr std::string_view kRules =
    "text{font-family:'DejaVu Sans',Verdana,sans-serif;font-size:12px;fill:#1c2733}"
    ".title{font-size:17px;font-weight:bold}"
    ".id{font-size:15px;font-weight:bold}"
    ".note{fill:#4a5765}"
    ".label{stroke:#fff;stroke-width:3px;stroke-linejoin:round;paint-order:stroke}"
    ".body{font-size:11px;font-style:italic}"
    "path,circle{stroke:#1c2733;stroke-width:1.2px;fill:none;stroke-linejoin:round;"
    "stroke-linecap:round}"
    ".pin{fill:#fff}.mark,.weld{fill:#1c2733}"
    ".hatch{stroke-width:0.9px}"
    "path.ground{fill:#fff;stroke-width:1.4px}"
    ".guide{stroke-width:0.9px;stroke-dasharray:9 3 2 3;stroke-linecap:butt}"
    ".axis{stroke-width:1px;stroke:#7a8591}"
    ".x-axis,.y-axis,.z-axis{stroke-width:2px}"
    ".x-axis{stroke:#c4302b}.y-axis{stroke:#2f8f2f}.z-axis{stroke:#2b50c4}"
    ".pitch-circle{stroke-dasharray:8 3 2 3;stroke-linecap:butt}"
    ".wire{stroke-width:5px;stroke:#7a8591}"
    ".rod{fill:#c9d0d8;stroke:#55606e}"
    ".slot{fill:#fff}"
    ".panel{fill:none;stroke:#dfe4e9;stroke-width:1px}"
    ".k .link{fill:#c9d0d8;stroke:#7a8591}.k .block{fill:#aeb8c2}.k .slot{stroke:#7a8591}"
    ".event{fill:#fff;stroke-width:1.6px}"
    ".faint{opacity:0.45}"
    ".bar{stroke-width:2px;stroke-linecap:butt}";

// Of a colour: @ stands for its class, # for its value.
constexpr std::string_view kColourRules =
    ".@ .link{fill:#;fill-opacity:0.25;stroke:#}"
    ".@ .block{fill:#;fill-opacity:0.4;stroke:#}"
    ".@ .slot,.@ .pitch-circle,.@ .wire{stroke:#}"
    ".@ .slot-pin{fill:#}"
    "text.@{fill:#}"
    "path.curve.@{stroke:#;stroke-width:1.8px}";

std::string point_text(Complex z) {
  std::string text = pixel_text(z.real());
  return text.append(1, ' ').append(pixel_text(z.imag()));
}

/// "M1 2", "L3 4".
void draw_to(std::string& data, char command, Complex z) {
  data.append(1, command).append(point_text(z));
}

/// The outline at distance `radius` from a polygon that is counter-clockwise to the eye.
std::string outline_data(const std::vector<Complex>& polygon, double radius) {
  const std::string arc = pixel_text(radius) + ' ' + pixel_text(radius) + " 0 0 0 ";
  std::string data;
  for (std::size_t k = 0; k < polygon.size(); ++k) {
    const Complex from = polygon[k];
    const Complex to = polygon[(k + 1) % polygon.size()];
    const Complex next = polygon[(k + 2) % polygon.size()];
    // To the right of the way, in a plane whose y points down.
    const auto outward = [&](Complex way) { return way / std::abs(way) * Complex(0, radius); };
    if (k == 0) draw_to(data, 'M', from + outward(to - from));
    draw_to(data, 'L', to + outward(to - from));
    if (radius > 0) data.append(1, 'A').append(arc).append(point_text(to + outward(next - to)));
  }
  return data + 'Z';
}

std::string shape_svg(const Shape& shape, const Similarity& at, const PixelMap& map) {
  std::vector<Complex> points;
  for (const Complex z : shape.points) points.push_back(map(at(z)));
  const double radius = shape.radius * std::abs(at.a) * map.scale;
  const std::string style = to_string(shape.style);
  if (shape.is_closed && points.size() == 1) {
    return element("circle", {{"class", style},
                              {"cx", pixel_text(points[0].real())},
                              {"cy", pixel_text(points[0].imag())},
                              {"r", pixel_text(radius)}});
  }
  return element("path",
                 {{"class", style},
                  {"d", shape.is_closed ? outline_data(points, radius) : path_data(points)}});
}

}  // namespace

std::string pixel_text(double x) {
  if (!std::isfinite(x)) return "0";
  char text[40];
  std::snprintf(text, sizeof text, "%.2f", x);
  std::string shortest = text;
  while (shortest.back() == '0') shortest.pop_back();
  if (shortest.back() == '.') shortest.pop_back();
  return shortest == "-0" ? "0" : shortest;
}

std::string path_data(const std::vector<Complex>& points) {
  std::string data;
  for (const Complex z : points) draw_to(data, data.empty() ? 'M' : 'L', z);
  return data;
}

std::string figure_svg(const Figure& figure, const Similarity& at, const PixelMap& map) {
  std::string shapes;
  for (const Shape& shape : figure.shapes) shapes += shape_svg(shape, at, map);
  return element("g", {{"class", colour_class(figure.colour)}}, shapes) + '\n';
}

std::string figures_svg(const Drawing& drawing, const std::vector<Similarity>& places,
                        const PixelMap& map) {
  std::string svg;
  for (const Figure& figure : drawing.figures) {
    svg += figure_svg(figure, places[figure.frame], map);
  }
  return svg;
}

std::string colour_text(std::size_t number) {
  return std::string(kPalette[number % kPalette.size()]);
}

std::string dashes_text(std::size_t colour, std::size_t number) {
  constexpr std::array<const char*, 3> kDashes{"", "7 4", "2 3"};
  return kDashes[std::min(colour / kPalette.size() + number, kDashes.size() - 1)];
}

std::string colour_class(std::optional<std::size_t> colour) {
  std::string name(1, colour ? 'c' : 'k');
  return colour ? name.append(std::to_string(*colour % kPalette.size())) : name;
}

std::string style_sheet() {
  std::string rules(kRules);
  for (std::size_t k = 0; k < kPalette.size(); ++k) {
    std::string of_colour(kColourRules);
    for (const auto& [mark, text] : {std::pair('@', colour_class(k)), {'#', colour_text(k)}}) {
      for (std::size_t at = 0; (at = of_colour.find(mark, at)) != std::string::npos;) {
        of_colour.replace(at, 1, text);
        at += text.size();
      }
    }
    rules += of_colour;
  }
  return rules;
}

std::string text_svg(Complex at, std::string_view anchor, std::string_view classes,
                     std::string_view text) {
  return element("text",
                 {{"x", pixel_text(at.real())},
                  {"y", pixel_text(at.imag())},
                  {"text-anchor", std::string(anchor)},
                  {"class", std::string(classes)}},
                 escaped(text)) +
         '\n';
}

double text_width(std::string_view text, double font_size) {
  // The mean advance of DejaVu Sans, a wide font.
  constexpr double kAdvance = 0.62;
  const auto letters = std::count_if(text.begin(), text.end(), [](char c) {
    return (static_cast<unsigned char>(c) & 0xC0) != 0x80;
  });
  return kAdvance * font_size * static_cast<double>(letters);
}

std::vector<std::string> wrapped(const std::string& text, double font_size, double width) {
  std::vector<std::string> lines{""};
  std::size_t begin = 0;
  while (begin < text.size()) {
    const std::size_t end = std::min(text.find(' ', begin), text.size());
    const std::string word = text.substr(begin, end - begin);
    std::string& line = lines.back();
    if (line.empty()) {
      line = word;
    } else if (text_width(line + ' ' + word, font_size) <= width) {
      line += ' ' + word;
    } else {
      lines.push_back(word);
    }
    begin = end + 1;
  }
  return lines;
}

std::string heading_svg(const std::string& title, const std::string& note, double left,
                        double width, double& y) {
  constexpr double kTitleFont = 17;
  constexpr double kTitleLine = 22;
  std::string svg;
  for (const std::string& line : wrapped(title, kTitleFont, width)) {
    y += kTitleLine;
    svg += text_svg({left, y}, "start", "title", line);
  }
  for (const std::string& line : wrapped(note, kNoteFont, width)) {
    y += kNoteLine;
    svg += text_svg({left, y}, "start", "note", line);
  }
  return svg;
}

std::string label_text(const Label& label, const Mechanism& mechanism, const Eigen::VectorXd& q) {
  if (!label.coordinate) return label.text;
  const Coordinate coordinate = coordinates(mechanism)[static_cast<std::size_t>(*label.coordinate)];
  return label.text + " = " + coordinate_text(mechanism, coordinate, q[*label.coordinate]);
}

std::string scale_bar(Complex at, double pixels_per_length, const std::string& unit) {
  constexpr double kWanted = 80;  // pixels
  const double wanted = kWanted / pixels_per_length;
  const double power = std::pow(10, std::floor(std::log10(wanted)));
  const double digit = wanted / power >= 5 ? 5 : wanted / power >= 2 ? 2 : 1;
  const double length = digit * power;
  const double width = length * pixels_per_length;
  constexpr double kHalfTick = 4;
  std::string data;
  for (const Complex end : {at, at + width}) {
    draw_to(data, 'M', end - Complex(0, kHalfTick));
    draw_to(data, 'L', end + Complex(0, kHalfTick));
  }
  draw_to(data, 'M', at);
  draw_to(data, 'L', at + width);
  const std::string named = unit.empty() ? "in the file's unit of length" : unit;
  return element("path", {{"class", "bar"}, {"d", data}}) +
         text_svg(at + Complex(width + 8, 4), "start", "note", short_text(length) + ' ' + named);
}

std::string svg_document(double width, double height, std::string_view title,
                         const std::string& body) {
  const std::string w = pixel_text(std::ceil(width));
  const std::string h = pixel_text(std::ceil(height));
  std::string content = "\n";
  content += element("title", {}, escaped(title)) + '\n';
  content += element("style", {}, style_sheet()) + '\n';
  content += element("rect", {{"width", w}, {"height", h}, {"fill", "#fff"}}) + '\n';
  content += body;
  return element("svg",
                 {{"xmlns", "http://www.w3.org/2000/svg"},
                  {"width", w},
                  {"height", h},
                  {"viewBox", std::string("0 0 ").append(w).append(1, ' ').append(h)},
                  {"role", "img"}},
                 content) +
         '\n';
}

}  // namespace moivre
