// SPDX-License-Identifier: MIT
// The motion's picture: curves over a pale mechanism, marks where branches begin and end, a legend.
#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <stdexcept>

#include "circuits_report.h"
#include "labels.h"
#include "moivre/closure_report/picture.h"
#include "moivre/expression/counted.h"
#include "moivre/report/number_text.h"
#include "panels.h"
#include "svg.h"
#include "traces.h"

namespace moivre {
namespace {

// All in pixels.
constexpr double kMargin = 16;
constexpr double kRoom = 34;        // around the curves
constexpr double kMagnified = 1.6;  // against a panel of closures
constexpr double kNarrowest = 560;
constexpr double kLegendLine = 19;
constexpr double kMarkSize = 5;
constexpr double kDash = 9;        // of each of the branches that share a curve, in turn
constexpr double kSampleDash = 5;  // in the legend
constexpr double kSameCurve = 1;   // apart, everywhere: less than a line is wide
// Pairs of points, so that a long table is drawn at once: curves of more are told alike by their times alone.
constexpr std::size_t kMostPairs = 4'000'000;

std::string polyline_data(const std::vector<Complex>& points, const PixelMap& map) {
  std::string data;
  for (const Complex z : points) {
    const Complex at = map(z);
    data.append(1, data.empty() ? 'M' : 'L').append(pixel_text(at.real())).append(1, ' ');
    data.append(pixel_text(at.imag()));
  }
  return data;
}

/// Of the branches that take one and the same curve: which is this, of how many?
struct Share {
  std::size_t number = 0;
  std::size_t of = 1;
};

/// Shares of a curve are dashes in turn, so that every branch is seen.
std::string curve_svg(const std::string& data, const BranchLook& look, Share share = {}) {
  std::vector<Attribute> attributes{{"class", "curve " + colour_class(look.colour)}, {"d", data}};
  const auto dashes_of = [](std::size_t count) {
    return pixel_text(kDash * static_cast<double>(count));
  };
  if (share.of > 1) {
    attributes.push_back({"stroke-dasharray", dashes_of(1) + ' ' + dashes_of(share.of - 1)});
    attributes.push_back({"stroke-dashoffset", dashes_of(share.of - share.number)});
  } else if (!look.dashes.empty()) {
    attributes.push_back({"stroke-dasharray", look.dashes});
  }
  return element("path", attributes) + '\n';
}

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

/// Of each curve; an empty one shares nothing.
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

/// Dead point: a diamond. Bifurcation: a square. Joint limit: a triangle.
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
  std::string data;
  for (const Complex corner : corners) {
    const Complex z = at + kMarkSize * corner;
    data.append(1, data.empty() ? 'M' : 'L').append(pixel_text(z.real())).append(1, ' ');
    data.append(pixel_text(z.imag()));
  }
  return element("path", {{"class", "event"}, {"d", data + "Z"}}) + '\n';
}

std::string begin_mark(Complex at, std::size_t colour) {
  return element("g", {{"class", colour_class(colour)}},
                 element("circle", {{"class", "slot-pin"},
                                    {"cx", pixel_text(at.real())},
                                    {"cy", pixel_text(at.imag())},
                                    {"r", "3.5"}})) +
         '\n';
}

/// Without bodies' colours and names; of the points' names those of the ground and of the curves.
Drawing pale(Drawing drawing, const Mechanism& mechanism, const std::vector<MovingPoint>& traced) {
  for (Figure& figure : drawing.figures) figure.colour.reset();
  std::set<std::string> kept;
  for (const MovingPoint& point : traced) {
    kept.insert(mechanism.bodies[point.point.body].points[point.point.point].name);
  }
  for (const BodyPoint& point : mechanism.bodies[0].points) kept.insert(point.name);
  if (mechanism.space == Space::spatial) kept.insert({"x", "y", "z"});
  std::erase_if(drawing.labels, [&](const Label& label) {
    return label.kind != LabelKind::point || kept.count(label.text) == 0;
  });
  return drawing;
}

class MotionPicture {
 public:
  MotionPicture(const MotionResult& result, const Mechanism& mechanism)
      : result_(result),
        mechanism_(mechanism),
        looks_(branch_looks(find_circuits(mechanism, result), result)),
        traced_(traced_points(mechanism)),
        drawing_(pale(draw(mechanism, all_poses(mechanism, result)), mechanism, traced_)),
        first_(result.branches.front().samples.empty() ? all_poses(mechanism, result).front()
                                                       : result.branches.front().samples[0].q) {
    const std::vector<Similarity> places = place(drawing_, mechanism_, first_);
    box_ = bounds(drawing_, places);
    for (const MovingPoint& point : traced_) {
      auto& curves = curves_.emplace_back();
      for (const MotionBranch& branch : result_.branches) {
        curves.push_back(curve(mechanism_, point, branch, result_));
        for (const Complex z : curves.back()) box_.include(z);
      }
    }
    map_.scale = kMagnified * pixel_scale(drawing_);
    for (const auto& curves : curves_) {
      shares_.push_back(shares_of(curves, kSameCurve / map_.scale));
    }
  }

  std::string document(const std::string& title) {
    const double drawn = box_.width() * map_.scale + 2 * kRoom;
    width_ = std::max(kNarrowest, drawn);
    std::string svg = heading(title);
    const Complex middle(kMargin + width_ / 2, y_ + kRoom + box_.height() * map_.scale / 2);
    map_.origin = middle - std::conj((box_.lower + box_.upper) / 2.0) * map_.scale;
    svg += mechanism_svg() + curves_svg() + labels();
    y_ += box_.height() * map_.scale + 2 * kRoom;
    svg += legend();
    if (drawing_.to_scale) {
      y_ += kLegendLine;
      svg += scale_bar({kMargin, y_}, map_.scale, mechanism_.units.length);
    }
    return svg_document(width_ + 2 * kMargin, y_ + kMargin, title, svg);
  }

 private:
  std::string heading(const std::string& title) {
    std::string svg;
    y_ = kMargin / 2;
    for (const std::string& line : wrapped(title, 17, width_)) {
      y_ += 22;
      svg += text_svg({kMargin, y_}, "start", "title", line);
    }
    for (const std::string& line : wrapped(summary(), 12, width_)) {
      y_ += 17;
      svg += text_svg({kMargin, y_}, "start", "note", line);
    }
    return svg;
  }

  std::string summary() const {
    std::string names;
    for (const MovingPoint& point : traced_) names += (names.empty() ? "" : ", ") + point.name;
    std::string text =
        "Curves of " + names + " in " + counted(result_.branches.size(), "branch", "branches") +
        ", t = " + short_text(result_.from) + " s to " + short_text(result_.to) + " s";
    return result_.complete ? text : text + "; " + result_.message;
  }

  std::string mechanism_svg() const {
    return element("g", {{"class", "faint"}},
                   figures_svg(drawing_, place(drawing_, mechanism_, first_), map_)) +
           '\n';
  }

  std::string curves_svg() const {
    std::string svg;
    std::string marks;
    for (std::size_t k = 0; k < result_.branches.size(); ++k) {
      const MotionBranch& branch = result_.branches[k];
      for (std::size_t p = 0; p < traced_.size(); ++p) {
        const std::vector<Complex>& places = curves_[p][k];
        if (places.empty()) continue;
        svg += curve_svg(polyline_data(places, map_), looks_[k], shares_[p][k]);
        marks += branch.begin_event ? mark_of(*branch.begin_event, places.front())
                                    : begin_mark(map_(places.front()), looks_[k].colour);
        if (branch.end_event) marks += mark_of(*branch.end_event, places.back());
      }
    }
    return svg + marks;
  }

  std::string mark_of(std::size_t event, Complex z) const {
    return event_mark(result_.events[event].at.kind, map_(z));
  }

  std::string labels() const {
    Box frame;
    frame.include(map_(box_.lower), kRoom);
    frame.include(map_(box_.upper), kRoom);
    return labels_svg(place_labels(drawing_, mechanism_, first_,
                                   place(drawing_, mechanism_, first_), map_, frame));
  }

  std::string branch_text(std::size_t number) const {
    const MotionBranch& branch = result_.branches[number];
    const auto end = [&](double time, const std::optional<std::size_t>& event) {
      std::string text = drivers_text(mechanism_, time);
      if (text.empty()) text = "t = " + short_text(time) + " s";
      return event ? text + " (" + to_string(result_.events[*event].at.kind) + ")" : text;
    };
    const std::string text = branch.id + ": " + end(branch.begins, branch.begin_event) + " to " +
                             end(branch.ends, branch.end_event);
    const std::string& circuit = looks_[number].circuit;
    const std::string named = circuit.empty() ? text : text + "; " + circuit;
    return branch.complete ? named : named + ", not finished";
  }

  bool has_shared_curve() const {
    return std::any_of(shares_.begin(), shares_.end(), [](const std::vector<Share>& shares) {
      return std::any_of(shares.begin(), shares.end(), [](Share share) { return share.of > 1; });
    });
  }

  /// Two dashes, one a colour.
  static std::string shared_sample(Complex at) {
    const auto dash = [at](std::size_t branch) {
      const double x = at.real() + kSampleDash * static_cast<double>(branch);
      return curve_svg(polyline_data({{x, -at.imag()}, {x + kSampleDash, -at.imag()}}, PixelMap{}),
                       BranchLook{branch, "", ""});
    };
    return dash(0) + dash(1);
  }

  std::string legend() {
    std::string svg;
    std::set<EventKind> kinds;
    for (const MotionEvent& event : result_.events) kinds.insert(event.at.kind);
    for (std::size_t k = 0; k < result_.branches.size(); ++k) {
      y_ += kLegendLine;
      svg += curve_svg(
          polyline_data({Complex(kMargin, 4 - y_), Complex(kMargin + 28, 4 - y_)}, PixelMap{}),
          looks_[k]);
      svg += text_svg({kMargin + 38, y_}, "start", "note", branch_text(k));
    }
    y_ += kLegendLine;
    double x = kMargin;
    const auto add_entry = [&](const std::string& mark, const std::string& text) {
      svg += mark + text_svg({x + 16, y_}, "start", "note", text);
      x += 34 + text_width(text, 12);
    };
    add_entry(element("circle", {{"class", "mark"},
                                 {"cx", pixel_text(x + 5)},
                                 {"cy", pixel_text(y_ - 4)},
                                 {"r", "3.5"}}),
              "begins");
    if (has_shared_curve()) add_entry(shared_sample({x, y_ - 4}), "several branches on one curve");
    for (const EventKind kind : kinds) {
      add_entry(event_mark(kind, {x + 5, y_ - 4}), to_string(kind));
    }
    return svg;
  }

  const MotionResult& result_;
  const Mechanism& mechanism_;
  std::vector<BranchLook> looks_;
  std::vector<MovingPoint> traced_;
  Drawing drawing_;
  Eigen::VectorXd first_;
  std::vector<std::vector<std::vector<Complex>>> curves_;  ///< of each traced point, of each branch
  std::vector<std::vector<Share>> shares_;                 ///< likewise
  Box box_;
  PixelMap map_;
  double width_ = kNarrowest;
  double y_ = 0;
};

}  // namespace

void require_drawable_motion(const Mechanism& mechanism) {
  if (!is_typed(mechanism)) return;
  throw std::invalid_argument(
      "--svg draws the curves of points, and typed equations have none; --html plots the unknowns");
}

std::string motion_svg(const MotionResult& result, const Mechanism& mechanism,
                       const std::string& file) {
  require_drawable_motion(mechanism);
  const std::string title = mechanism.title.empty() ? file : mechanism.title;
  if (all_poses(mechanism, result).empty()) {
    return svg_document(
        kNarrowest, 4 * kLegendLine, title,
        text_svg({kMargin, 2 * kLegendLine}, "start", "title", title) +
            text_svg({kMargin, 3 * kLegendLine}, "start", "note", "no branch: " + result.message));
  }
  return MotionPicture(result, mechanism).document(title);
}

}  // namespace moivre
