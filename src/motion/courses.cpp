// SPDX-License-Identifier: MIT
// Values along the steps of a branch, made to go on, and the extremes of polynomials between them.
#include "courses.h"

#include <algorithm>
#include <boost/math/tools/minima.hpp>
#include <cmath>
#include <optional>

#include "moivre/mechanism/jet.h"
#include "moivre/mechanism/joint_type.h"
#include "moivre/mechanism/pose.h"
#include "moivre/numeric/quintic.h"
#include "moivre/numeric/zero_between.h"

namespace moivre {
namespace {

using Eigen::VectorXd;

// Central differences along a step, where a radian, or the mechanism's length, is 1: their error is
// the square.
constexpr double kDifference = 1e-4;

double difference(const MovingPart& quantity, double a, double b) {
  const bool is_cut = !quantity.goes_on && quantity.kind == CoordinateKind::angle;
  return is_cut ? std::remainder(a - b, kOneTurn) : a - b;
}

/// A quantity over one step, beside its value at the beginning.
class StepCurve {
 public:
  StepCurve(const BranchPiece& piece, const MovingPart& quantity) {
    length_ = piece.length;
    at_ = {along(piece, quantity, 0), along(piece, quantity, 1)};
    at_[1].f = difference(quantity, quantity.value(piece.q[1]), quantity.value(piece.q[0]));
  }

  double value(double x) const { return at(x).f; }
  double slope(double x) const { return at({x, 1, 0}).d; }

 private:
  /// At one end of the step, beside the value there.
  static Jet along(const BranchPiece& piece, const MovingPart& quantity, std::size_t end) {
    const double here = quantity.value(piece.q[end]);
    const auto moved = [&](double x) {
      const VectorXd q = piece.q[end] + x * piece.slope[end] + x * x / 2 * piece.bend[end];
      return difference(quantity, quantity.value(q), here);
    };
    const double later = moved(kDifference);
    const double earlier = moved(-kDifference);
    return {0, (later - earlier) / (2 * kDifference),
            (later + earlier) / (kDifference * kDifference)};
  }
  Jet at(const Jet& x) const {
    const QuinticWeights<Jet> w = quintic_weights(x, length_);
    return w.slope_a * at_[0].d + w.bend_a * at_[0].dd + w.b * at_[1].f + w.slope_b * at_[1].d +
           w.bend_b * at_[1].dd;
  }

  double length_ = 0;
  std::array<Jet, 2> at_;
};

/// Takes one step in from value `v`, where it begins; returns the value where it ends.
double take_step(const BranchPiece& piece, const MovingPart& quantity, double v, Course& course) {
  const auto take = [&](double value) {
    course.lower = std::min(course.lower, value);
    course.upper = std::max(course.upper, value);
    return value;
  };
  if (piece.slope[0].size() == 0) {
    return take(v + difference(quantity, quantity.value(piece.q[1]), quantity.value(piece.q[0])));
  }
  const StepCurve curve(piece, quantity);
  const double end = take(v + curve.value(piece.until));
  if (curve.slope(0) * curve.slope(piece.until) >= 0) return end;
  constexpr int kBits = 26;  // half of a double's: the place of an extreme is known no better
  const double sign = curve.slope(0) > 0 ? -1 : 1;
  const auto found = boost::math::tools::brent_find_minima(
      [&](double x) { return sign * curve.value(x); }, 0.0, piece.until, kBits);
  take(v + sign * found.second);
  return end;
}

MovingPart coordinate_quantity(const Coordinate& coordinate, const std::string& name,
                               std::size_t index) {
  const auto i = static_cast<Eigen::Index>(index);
  return {name, coordinate.kind, coordinate.is_periodic, true,
          [i](const VectorXd& q) { return q[i]; }};
}

}  // namespace

std::vector<MovingPart> body_quantities(const Mechanism& mechanism) {
  std::vector<MovingPart> all;
  const std::vector<Coordinate> names = coordinates(mechanism);
  for (std::size_t k = 0; k < names.size(); ++k) {
    if (is_typed(mechanism)) {
      all.push_back(coordinate_quantity(names[k], names[k].name, k));
    } else if (names[k].kind == CoordinateKind::angle) {
      all.push_back(coordinate_quantity(names[k], mechanism.bodies[names[k].group + 1].name, k));
    }
  }
  return all;
}

std::vector<MovingPart> joint_quantities(const Mechanism& mechanism) {
  std::vector<MovingPart> all;
  if (is_typed(mechanism)) return all;
  const bool is_planar = mechanism.space == Space::planar;
  const VectorXd origin = VectorXd::Zero(static_cast<Eigen::Index>(coordinates(mechanism).size()));
  for (const Joint& joint : mechanism.joints) {
    const bool is_angle = is_angular(joint.type);
    const bool is_told = is_planar && is_angle && joint.at[0].body * joint.at[1].body == 0;
    if (is_told || !joint_coordinate(mechanism, joint, origin)) continue;
    all.push_back({joint.name, is_angle ? CoordinateKind::angle : CoordinateKind::length, is_angle,
                   false, [&mechanism, &joint](const VectorXd& q) {
                     return *joint_coordinate(mechanism, joint, q);
                   }});
  }
  return all;
}

Course course(const MotionBranch& branch, const MovingPart& quantity) {
  const auto& [back, on] = branch.ways;
  const VectorXd& found = !on.empty()     ? on.front().q[0]
                          : !back.empty() ? back.front().q[0]
                                          : branch.begin_pose;
  const double start = quantity.value(found);
  Course all{start, start, start, start};
  for (const BranchPiece& piece : back) all.first = take_step(piece, quantity, all.first, all);
  for (const BranchPiece& piece : on) all.last = take_step(piece, quantity, all.last, all);
  return all;
}

/// Where a driver that goes the one way at `from` and the other way at `to` turns back; nullopt
/// where it does not.
std::optional<double> turning_time(const DriverLaw& law, double from, double to) {
  const auto rate = [&](double time) { return driver_state(law, time).velocity; };
  if (!(rate(from) * rate(to) < 0)) return std::nullopt;
  return zero_between(rate, from, to, rate(from), rate(to));
}

Course driver_course(const MotionBranch& branch, const Driver& driver) {
  const auto value = [&](double time) { return driver_state(driver.law, time).value; };
  Course all{value(branch.begins), value(branch.ends), 0, 0};
  std::tie(all.lower, all.upper) = std::minmax(all.first, all.last);
  const auto include = [&](double time) {
    all.lower = std::min(all.lower, value(time));
    all.upper = std::max(all.upper, value(time));
  };
  double before = branch.begins;
  const auto pass = [&](double time) {
    include(time);
    if (const auto turn = turning_time(driver.law, before, time)) include(*turn);
    before = time;
  };
  for (const BranchSample& sample : branch.samples) pass(sample.time);
  pass(branch.ends);
  return all;
}

}  // namespace moivre
