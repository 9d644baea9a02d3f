// SPDX-License-Identifier: MIT
// Scalar Newton for the points of lanes.
#include "lane_newton.h"

#include <algorithm>

namespace moivre {

Rescue LaneNewton<Complex>::rescue(Point& x, Point& dx, const LaneControl& control) {
  const WorkCount before = path_.work();
  CorrectorOptions options;
  options.tolerance = control.rescue_tolerance();
  options.fine = control.is_polishing();  // double has been tried, in the lane
  given_ = x;
  Correction correction = path_.correct(x, control.next_time(), options, true);
  if (options.fine && !(correction.last <= options.tolerance)) {
    x = given_;
    options.fine = false;
    correction = path_.correct(x, control.next_time(), options, true);
  }
  if (correction.converged) path_.tangent(control.next_dt(), dx);
  return {correction.converged, path_.work() - before, std::nullopt};
}

void LaneNewton<Complex>::normalize(Point& x) {
  const double scale = 1 / euclidean_norm(x);
  for (Complex& xi : x) xi *= scale;
}

Rescue LaneNewton<ComplexDoubleDouble>::rescue(FinePoint& x, FinePoint& dx,
                                               const LaneControl& control) {
  using Fine = FinePathSystem<ComplexDoubleDouble>;
  const WorkCount before = fine_.work();
  const bool is_end = control.is_proving_end();
  SettlingRules rules = is_end ? Fine::at_end() : Fine::on_path();
  rules.aim = std::min(rules.aim, control.rescue_tolerance());
  fine_.set_patch(x);
  const Settling settling = fine_.settle(x, control.next_time(), rules);
  Rescue result;
  result.converged = settling.converged && (!is_end || fine_.is_regular_end());
  if (result.converged) {
    if (is_end) {
      result.regular_condition = fine_.condition();
      result.accuracy = Fine::end_accuracy();
    }
    fine_.tangent(control.next_dt(), dx);
  }
  result.work = fine_.work() - before;
  return result;
}

const Point& LaneNewton<ComplexDoubleDouble>::rounded(const FinePoint& x) {
  round_into<ComplexDoubleDouble>(x, rounded_);
  return rounded_;
}

void LaneNewton<ComplexDoubleDouble>::normalize(FinePoint& x) {
  const DoubleDouble scale(1 / euclidean_norm(rounded(x)));
  for (ComplexDoubleDouble& xi : x) xi = product(scale, xi);
}

}  // namespace moivre
