// SPDX-License-Identifier: MIT
// Lagrange's polynomials through points at which sigma was halved from one to the next.
#include "meeting.h"

#include <algorithm>
#include <cmath>

namespace moivre {
namespace {

using Eigen::VectorXd;

/// The polynomial in tau = sigma^(1 / order) through the points from `first` to `last`, at tau = 0.
/// Its doubt is that by rounding.
Meeting at_zero(const std::vector<CurvePoint>& points, std::size_t first, std::size_t last,
                int order) {
  // A point is known to this over sigma.
  constexpr double kRounding = 2e-16;
  const auto tau = [&](std::size_t k) { return std::pow(points[k].sigma, 1.0 / order); };
  Meeting meeting{VectorXd::Zero(points[last].y.size()), 0, order};
  for (std::size_t i = first; i <= last; ++i) {
    double weight = 1;
    for (std::size_t k = first; k <= last; ++k) {
      if (k != i) weight *= tau(k) / (tau(k) - tau(i));
    }
    meeting.y += weight * points[i].y;
    meeting.doubt += std::abs(weight) * kRounding / points[i].sigma;
  }
  return meeting;
}

/// The last point, and before it those of at least 1 / kFallen times the sigma of the next: the
/// differences of nearer ones are rounding.
std::vector<CurvePoint> spread(const std::vector<CurvePoint>& approach) {
  constexpr double kFallen = 0.7;
  std::vector<CurvePoint> points{approach.back()};
  for (std::size_t k = approach.size() - 1; k-- > 0;) {
    if (points.back().sigma <= kFallen * approach[k].sigma) points.push_back(approach[k]);
  }
  std::reverse(points.begin(), points.end());
  return points;
}

/// The meeting that a few points up to `last` point to. Points far off do not show sigma's shape:
/// the doubt is what the first of them changes. Points near by are known to 1e-16 / sigma only.
Meeting meeting_from(const std::vector<CurvePoint>& points, std::size_t last, int order) {
  // Sigma is halved from point to point, so that more of them change nothing in double.
  constexpr std::size_t kPoints = 8;
  const std::size_t first = last + 1 > kPoints ? last + 1 - kPoints : 0;
  Meeting meeting = at_zero(points, first, last, order);
  meeting.doubt += (meeting.y - at_zero(points, first + 1, last, order).y).norm();
  return meeting;
}

}  // namespace

Meeting meeting_of(const std::vector<CurvePoint>& approach, const Curve& curve) {
  constexpr int kHighestOrder = 4;
  constexpr double kClearly = 0.1;
  constexpr std::size_t kFewest = 4;
  // From 1 down to 1e-7, halved each time.
  constexpr std::size_t kMost = 24;
  std::vector<CurvePoint> points = spread(approach);
  if (points.size() > kMost) points.erase(points.begin(), points.end() - kMost);
  for (CurvePoint& point : points) point.sigma = curve.sigma(point.y);
  Meeting best = at_zero(points, 0, points.size() - 1, 1);
  best.doubt = std::numeric_limits<double>::infinity();
  for (int order = 1; order <= kHighestOrder && points.size() > 1; ++order) {
    Meeting of_order;
    for (std::size_t last = std::min(kFewest, points.size()) - 1; last < points.size(); ++last) {
      Meeting meeting = meeting_from(points, last, order);
      const bool is_known = meeting.y.allFinite() && meeting.doubt < of_order.doubt;
      if (is_known) of_order = std::move(meeting);
    }
    if (of_order.doubt < kClearly * best.doubt) best = std::move(of_order);
  }
  return best;
}

}  // namespace moivre
