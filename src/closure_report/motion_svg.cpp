// SPDX-License-Identifier: MIT
// The motion's picture: curves over a pale mechanism, marks where branches begin and end, a legend.
#include <algorithm>
#include <set>

#include "labels.h"
#include "moivre/closure_report/closure_report.h"
#include "moivre/closure_report/motion_report.h"
#include "moivre/closure_report/sheet.h"
#include "moivre/closures/same_pose.h"
#include "moivre/expression/counted.h"
#include "moivre/report/number_text.h"
#include "motion_curves.h"
#include "panels.h"
#include "svg.h"
#include "traces.h"

namespace moivre {
namespace {

// All in pixels.
constexpr double kRoom = 34;        // around the curves
constexpr double kMagnified = 1.6;  // against a panel of closures
constexpr double kSameCurve = 1;    // apart, everywhere: less than a line is wide

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

/// The branch that begins nearest to this pose; nullptr where none begins at `from`.
const MotionBranch* nearest_branch(const Phi& phi, const MotionResult& result,
                                   const Eigen::VectorXd& q) {
  const MotionBranch* nearest = nullptr;
  for (const MotionBranch& branch : result.branches) {
    if (branch.samples.empty() || branch.begins != result.from) continue;
    const bool is_nearer = nearest == nullptr || distance(phi, branch.samples[0].q, q) <
                                                     distance(phi, nearest->samples[0].q, q);
    if (is_nearer) nearest = &branch;
  }
  return nearest;
}

/// The pose in which the mechanism is shown: as drawn, q = 0, where a branch begins there; else the
/// beginning nearest to the guess.
Eigen::VectorXd shown_pose(const Mechanism& mechanism, const MotionResult& result) {
  const Phi phi(mechanism);
  const Eigen::VectorXd drawn = Eigen::VectorXd::Zero(phi.dimension());
  const MotionBranch* branch = nearest_branch(phi, result, drawn);
  if (branch == nullptr) return all_poses(mechanism, result).front();
  if (!is_same_pose(phi, branch->samples[0].q, drawn)) {
    branch = nearest_branch(phi, result, initial_guess(mechanism, result.from));
  }
  return branch->samples[0].q;
}

class MotionPicture {
 public:
  MotionPicture(const MotionResult& result, const Mechanism& mechanism)
      : result_(result),
        mechanism_(mechanism),
        looks_(branch_looks(find_circuits(mechanism, result), result)),
        traced_(traced_points(mechanism)),
        drawing_(pale(draw(mechanism, all_poses(mechanism, result)), mechanism, traced_)),
        shown_(shown_pose(mechanism, result)) {
    const std::vector<Similarity> places = place(drawing_, mechanism_, shown_);
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
    width_ = std::max(kNarrowestMotion, drawn);
    y_ = kMotionMargin / 2;
    std::string svg = heading_svg(title, summary(), kMotionMargin, width_, y_);
    const Complex middle(kMotionMargin + width_ / 2, y_ + kRoom + box_.height() * map_.scale / 2);
    map_.origin = middle - std::conj((box_.lower + box_.upper) / 2.0) * map_.scale;
    svg += mechanism_svg() + curves_svg() + labels();
    y_ += box_.height() * map_.scale + 2 * kRoom;
    svg += motion_legend(result_, mechanism_, looks_, has_shared_curve(), width_, y_);
    if (drawing_.to_scale) {
      y_ += kLegendLine;
      svg += scale_bar({kMotionMargin, y_}, map_.scale, mechanism_.units.length);
    }
    return svg_document(width_ + 2 * kMotionMargin, y_ + kMotionMargin, title, svg);
  }

 private:
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
                   figures_svg(drawing_, place(drawing_, mechanism_, shown_), map_)) +
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
        svg += curve_svg(places, map_, looks_[k], shares_[p][k]);
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
    return labels_svg(place_labels(drawing_, mechanism_, shown_,
                                   place(drawing_, mechanism_, shown_), map_, frame));
  }

  bool has_shared_curve() const {
    return std::any_of(shares_.begin(), shares_.end(), [](const std::vector<Share>& shares) {
      return std::any_of(shares.begin(), shares.end(), [](Share share) { return share.of > 1; });
    });
  }

  const MotionResult& result_;
  const Mechanism& mechanism_;
  std::vector<BranchLook> looks_;
  std::vector<MovingPoint> traced_;
  Drawing drawing_;
  Eigen::VectorXd shown_;
  std::vector<std::vector<std::vector<Complex>>> curves_;  ///< of each traced point, of each branch
  std::vector<std::vector<Share>> shares_;                 ///< likewise
  Box box_;
  PixelMap map_;
  double width_ = kNarrowestMotion;
  double y_ = 0;
};

}  // namespace

std::string motion_svg(const MotionResult& result, const Mechanism& mechanism,
                       const std::string& file) {
  const std::string title = picture_title(mechanism, file);
  if (all_poses(mechanism, result).empty()) {
    return svg_document(kNarrowestMotion, 4 * kLegendLine, title,
                        text_svg({kMotionMargin, 2 * kLegendLine}, "start", "title", title) +
                            text_svg({kMotionMargin, 3 * kLegendLine}, "start", "note",
                                     "no branch: " + result.message));
  }
  if (is_typed(mechanism)) return unknowns_svg(result, mechanism, title);
  return MotionPicture(result, mechanism).document(title);
}

}  // namespace moivre
