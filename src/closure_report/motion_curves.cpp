// SPDX-License-Identifier: MIT
// Curves, marks and legends of motions.
#include "motion_curves.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

#include "pose_text.h"

namespace moivre {
namespace {

// In pixels.
constexpr double kMarkSize = 5;
constexpr double kLine = 1.8;  // as in the style sheet
constexpr double kStripe =
    5;  // by how much a branch's line is wider than the next one's on the same curve
constexpr double kWidestStripes = 14;  // of all branches on one curve
// Pairs of points, so that a long table is drawn at once: curves of more are told alike by their
// times alone.
constexpr std::size_t kMostPairs = 4'000'000;

double distance_to_segment(Complex z, Complex from, Complex to) {
  const Complex way = to - from;
  const double along =
      std::norm(way) > 0 ? ((z - from) * std::conj(way)).real() / std::norm(way) : 0;
  return std::abs(z - from - std::clamp(along, 0.0, 1.0) * way);
}

/// Whether every point of `a` lies on `b`.
bool lies_on(const std::vector<Complex>& a, const std::vector<Complex>& b, double apart) {
  return std::all_of(a.begin(), a.end(), [&](Complex z) {
    if (std::abs(z - b.front()) <= apart) return true;
    for (std::size_t k = 1; k < b.size(); ++k) {
      if (distance_to_segment(z, b[k - 1], b[k]) <= apart) return true;
    }
    return false;
  });
}

/// One place at one time, or the same places at other times.
bool is_same_curve(const std::vector<Complex>& a, const std::vector<Complex>& b, double apart) {
  const bool is_same_motion = a.size() == b.size() && std::equal(a.begin(), a.end(), b.begin(),
                                                                 [apart](Complex x, Complex y) {
                                                                   return std::abs(x - y) <= apart;
                                                                 });
  if (is_same_motion || a.empty() || b.empty()) return is_same_motion;
  return a.size() * b.size() <= kMostPairs && lies_on(a, b, apart) && lies_on(b, a, apart);
}

std::string branch_text(const MotionResult& result, const Mechanism& mechanism,
                        const MotionBranch& branch, const BranchLook& look) {
  const auto end = [&](double time, const std::optional<std::size_t>& event) {
    std::string text = moving_drivers_text(mechanism, time);
    if (text.empty()) text = "t = " + short_text(time) + " s";
    return event ? text + " (" + to_string(result.events[*event].at.kind) + ")" : text;
  };
  const std::string text = branch.id + ": " + end(branch.begins, branch.begin_event) + " to " +
                           end(branch.ends, branch.end_event);
  const std::string& circuit = look.circuit;
  const std::string named = circuit.empty() ? text : text + "; " + circuit;
  return branch.complete ? named : named + ", not finished";
}

/// Two branches on one line.
std::string shared_sample(Complex at) {
  const std::vector<Complex> line{{at.real() + 3, -at.imag()}, {at.real() + 9, -at.imag()}};
  return curve_svg(line, PixelMap{}, {0, "", ""}, {0, 2}) +
         curve_svg(line, PixelMap{}, {1, "", ""}, {1, 2});
}

std::string stroke(const std::string& colour, double width) {
  return colour + "stroke-width:" + pixel_text(width) + "px";
}

}  // namespace

std::string curve_svg(const std::vector<Complex>& points, const PixelMap& map,
                      const BranchLook& look, Share share) {
  std::vector<Complex> mapped;
  for (const Complex z : points) mapped.push_back(map(z));
  std::vector<Attribute> attributes{{"class", "curve " + colour_class(look.colour)},
                                    {"d", path_data(mapped)}};
  if (share.of == 1) {
    if (!look.dashes.empty()) attributes.push_back({"stroke-dasharray", look.dashes});
    return element("path", attributes) + '\n';
  }
  const double step =
      std::min(kStripe, (kWidestStripes - kLine) / static_cast<double>(share.of - 1));
  const double width = kLine + step * static_cast<double>(share.of - 1 - share.number);
  std::string svg;
  if (share.number > 0) {
    const double gap = step / 2;  // white, half of it on either side
    svg = element(
              "path",
              {{"class", "curve"}, {"style", stroke("stroke:#fff;", width + gap)}, attributes[1]}) +
          '\n';
  }
  attributes.push_back({"style", stroke("", width)});
  return svg + element("path", attributes) + '\n';
}

std::vector<Share> shares_of(const std::vector<std::vector<Complex>>& curves, double apart) {
  std::vector<Share> shares(curves.size());
  for (std::size_t k = 0; k < curves.size(); ++k) {
    std::vector<std::size_t> alike;
    for (std::size_t j = 0; j < curves.size() && !curves[k].empty(); ++j) {
      if (is_same_curve(curves[j], curves[k], apart)) alike.push_back(j);
    }
    const auto at = std::find(alike.begin(), alike.end(), k);
    if (at != alike.end()) shares[k] = {static_cast<std::size_t>(at - alike.begin()), alike.size()};
  }
  return shares;
}

std::string event_mark(EventKind kind, Complex at) {
  std::vector<Complex> corners;
  switch (kind) {
    case EventKind::dead_point:
      corners = {{0, -1.2}, {1.2, 0}, {0, 1.2}, {-1.2, 0}};
      break;
    case EventKind::bifurcation:
      corners = {{-1, -1}, {1, -1}, {1, 1}, {-1, 1}};
      break;
    case EventKind::joint_limit:
      corners = {{0, -1.2}, {1.1, 0.9}, {-1.1, 0.9}};
      break;
  }
  for (Complex& corner : corners) corner = at + kMarkSize * corner;
  return element("path", {{"class", "event"}, {"d", path_data(corners) + "Z"}}) + '\n';
}

std::string begin_mark(Complex at, std::size_t colour) {
  return element("g", {{"class", colour_class(colour)}},
                 element("circle", {{"class", "slot-pin"},
                                    {"cx", pixel_text(at.real())},
                                    {"cy", pixel_text(at.imag())},
                                    {"r", "3.5"}})) +
         '\n';
}

std::string motion_legend(const MotionResult& result, const Mechanism& mechanism,
                          const std::vector<BranchLook>& looks, bool has_shared_curve, double width,
                          double& y) {
  constexpr double kText = 38;  // pixels to the right of the margin
  constexpr double kFont = 12;
  std::string svg;
  std::set<EventKind> kinds;
  for (const MotionEvent& event : result.events) kinds.insert(event.at.kind);
  for (std::size_t k = 0; k < result.branches.size(); ++k) {
    y += kLegendLine;
    svg += curve_svg({{kMotionMargin, 4 - y}, {kMotionMargin + 28, 4 - y}}, PixelMap{}, looks[k]);
    bool is_first = true;
    for (const std::string& line : wrapped(
             branch_text(result, mechanism, result.branches[k], looks[k]), kFont, width - kText)) {
      if (!std::exchange(is_first, false)) y += kLegendLine;
      svg += text_svg({kMotionMargin + kText, y}, "start", "note", line);
    }
  }
  y += kLegendLine;
  double x = kMotionMargin;
  const auto add_entry = [&](const std::string& mark, const std::string& text) {
    svg += mark + text_svg({x + 16, y}, "start", "note", text);
    x += 34 + text_width(text, kFont);
  };
  add_entry(
      element(
          "circle",
          {{"class", "mark"}, {"cx", pixel_text(x + 5)}, {"cy", pixel_text(y - 4)}, {"r", "3.5"}}),
      "begins");
  if (has_shared_curve) add_entry(shared_sample({x, y - 4}), "several branches on one curve");
  for (const EventKind kind : kinds) {
    add_entry(event_mark(kind, {x + 5, y - 4}), to_string(kind));
  }
  return svg;
}

}  // namespace moivre
