// SPDX-License-Identifier: MIT
// How do typed equations move? A plot of each unknown over the time, one below the other, every
// branch in its colour.
#include <algorithm>
#include <numbers>
#include <optional>
#include <string>
#include <vector>

#include "moivre/expression/counted.h"
#include "motion_curves.h"
#include "traces.h"

namespace moivre {
namespace {

// In pixels.
constexpr double kPlotWidth = 600;
constexpr double kPlotHeight = 130;
constexpr double kPlotGap = 34;  // between two plots: the upper one's times, the lower one's name
constexpr double kPlotRoom = 6;  // between a plot's frame and its curves
constexpr double kNumbersRoom = 70;  // for the numbers on the left
constexpr double kTextDepth = 14;
constexpr double kSamePlot = 1;  // apart, everywhere: less than a line is wide

struct Interval {
  double lower = 0;
  double upper = 0;

  void include(double x) {
    lower = std::min(lower, x);
    upper = std::max(upper, x);
  }
  /// Where between the ends; the middle of an interval without length.
  double share(double x) const { return upper > lower ? (x - lower) / (upper - lower) : 0.5; }
};

class UnknownsPicture {
 public:
  UnknownsPicture(const MotionResult& result, const Mechanism& mechanism)
      : result_(result),
        mechanism_(mechanism),
        looks_(branch_looks(find_circuits(mechanism, result), result)) {
    for (const MotionBranch& branch : result.branches) {
      poses_.push_back(traced_poses(mechanism, branch, result));
    }
  }

  std::string document(const std::string& title) {
    double y = kMotionMargin / 2;
    std::string svg = heading_svg(title, summary(), kMotionMargin, kNumbersRoom + kPlotWidth, y);
    for (std::size_t unknown = 0; unknown < mechanism_.unknowns.size(); ++unknown) {
      y += kPlotGap;
      svg += plot(unknown, y);
      y += kPlotHeight;
    }
    y += kTextDepth;
    svg += times_svg(y);
    svg += motion_legend(result_, mechanism_, looks_, is_shared_, kNumbersRoom + kPlotWidth, y);
    return svg_document(kNumbersRoom + kPlotWidth + 2 * kMotionMargin, y + kMotionMargin, title,
                        svg);
  }

 private:
  std::string summary() const {
    const std::string text = counted(mechanism_.unknowns.size(), "unknown") + " over the time in " +
                             counted(result_.branches.size(), "branch", "branches");
    return result_.complete ? text : text + "; " + result_.message;
  }

  double value(const TracedPose& pose, std::size_t unknown) const {
    return pose.q[static_cast<Eigen::Index>(unknown)] * unit(unknown).size;
  }

  struct Unit {
    std::string name;
    double size = 1;
  };
  Unit unit(std::size_t unknown) const {
    if (!mechanism_.unknowns[unknown].is_angle) return {mechanism_.units.length, 1};
    if (mechanism_.units.angle == "deg") return {"deg", 180 / std::numbers::pi};
    return {"rad", 1};
  }

  /// Of the unknown's values in all branches.
  Interval values(std::size_t unknown) const {
    std::optional<Interval> all;
    for (const auto& poses : poses_) {
      for (const TracedPose& pose : poses) {
        const double x = value(pose, unknown);
        if (!all) all = Interval{x, x};
        all->include(x);
      }
    }
    return all.value_or(Interval{});
  }

  /// Its upper edge at y.
  std::string plot(std::size_t unknown, double y) {
    const Interval range = values(unknown);
    const double left = kMotionMargin + kNumbersRoom;
    const Unit of = unit(unknown);
    const std::string& name = mechanism_.unknowns[unknown].name;
    std::string svg = text_svg({left, y - kPlotRoom}, "start", "note",
                               of.name.empty() ? name : name + " [" + of.name + "]");
    svg += element("rect", {{"class", "axis"},
                            {"x", pixel_text(left)},
                            {"y", pixel_text(y)},
                            {"width", pixel_text(kPlotWidth)},
                            {"height", pixel_text(kPlotHeight)},
                            {"fill", "none"}}) +
           '\n';
    svg += text_svg({left - kPlotRoom, y + kTextDepth}, "end", "note", short_text(range.upper));
    if (range.upper > range.lower) {
      svg += text_svg({left - kPlotRoom, y + kPlotHeight - kPlotRoom / 2}, "end", "note",
                      short_text(range.lower));
    }
    // Upwards, as curves are, so that PixelMap{} turns them over.
    const auto place = [&](const TracedPose& pose) {
      const double inner = kPlotHeight - 2 * kPlotRoom;
      return Complex(left + kPlotRoom + (kPlotWidth - 2 * kPlotRoom) * times().share(pose.time),
                     -(y + kPlotRoom + inner * (1 - range.share(value(pose, unknown)))));
    };
    std::vector<std::vector<Complex>> curves;
    for (const auto& poses : poses_) {
      auto& curve = curves.emplace_back();
      for (const TracedPose& pose : poses) curve.push_back(place(pose));
    }
    return svg + curves_svg(curves);
  }

  std::string curves_svg(const std::vector<std::vector<Complex>>& curves) {
    const std::vector<Share> shares = shares_of(curves, kSamePlot);
    std::string svg;
    std::string marks;
    for (std::size_t k = 0; k < curves.size(); ++k) {
      if (curves[k].empty()) continue;
      is_shared_ = is_shared_ || shares[k].of > 1;
      svg += curve_svg(curves[k], PixelMap{}, looks_[k], shares[k]);
      const MotionBranch& branch = result_.branches[k];
      const auto mark = [&](std::size_t event, Complex z) {
        return event_mark(result_.events[event].at.kind, std::conj(z));
      };
      marks += branch.begin_event ? mark(*branch.begin_event, curves[k].front())
                                  : begin_mark(std::conj(curves[k].front()), looks_[k].colour);
      if (branch.end_event) marks += mark(*branch.end_event, curves[k].back());
    }
    return svg + marks;
  }

  Interval times() const { return {result_.from, result_.to}; }

  std::string times_svg(double y) const {
    const double left = kMotionMargin + kNumbersRoom;
    return text_svg({left, y}, "start", "note", "t = " + short_text(times().lower) + " s") +
           text_svg({left + kPlotWidth, y}, "end", "note",
                    "t = " + short_text(times().upper) + " s");
  }

  const MotionResult& result_;
  const Mechanism& mechanism_;
  std::vector<BranchLook> looks_;
  std::vector<std::vector<TracedPose>> poses_;  ///< of each branch
  bool is_shared_ = false;
};

}  // namespace

std::string unknowns_svg(const MotionResult& result, const Mechanism& mechanism,
                         const std::string& title) {
  return UnknownsPicture(result, mechanism).document(title);
}

}  // namespace moivre
