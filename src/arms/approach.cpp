// SPDX-License-Identifier: MIT
// Steps of Runge and Kutta, corrected by Newton's method, that shrink before closures meet.
#include "approach.h"

#include <Eigen/LU>
#include <algorithm>
#include <numbers>
#include <utility>

namespace moivre {
namespace {

/// The tip on its way, and its velocity by s.
struct Moving {
  Placement<Complex> at;
  Velocity6<Complex> velocity;
};

Moving moving(const Arm& arm, const TipWay& way, double s) {
  const Complex u(s, way.detour * s * (1 - s));
  const Complex du(1, way.detour * (1 - 2 * s));
  const double angle = way.turn.norm();
  const Eigen::Vector3d axis =
      angle > 0 ? Eigen::Vector3d(way.turn / angle) : Eigen::Vector3d::UnitX();
  Moving result;
  result.at.R = way.begin.R.cast<Complex>() * turn_about<Complex>(axis, u * angle);
  const Eigen::Vector3d shift = way.end.p - way.begin.p;
  result.at.p = way.begin.p.cast<Complex>() + u * shift.cast<Complex>();
  result.velocity << du / arm.length * shift.cast<Complex>(),
      du * (way.begin.R * way.turn).cast<Complex>();
  return result;
}

/// Joint velocities, or a Newton step, that give the tip this one.
JointVector<Complex> joints_for(const Arm& arm, const Screws<Complex>& screws,
                                const Velocity6<Complex>& wanted) {
  const Eigen::Matrix<Complex, 6, 6> square = screws;
  return in_joints<Complex>(arm, square.partialPivLu().solve(wanted));
}

JointVector<Complex> velocity_at(const Arm& arm, const TipWay& way, double s,
                                 const JointVector<Complex>& q) {
  return joints_for(arm, tip_motion<Complex>(arm, q).screws, moving(arm, way, s).velocity);
}

/// Radians, or arm's lengths.
double step_size(const Arm& arm, const JointVector<Complex>& step) {
  double largest = 0;
  for (Eigen::Index k = 0; k < step.size(); ++k) {
    const bool is_slide = arm.joints[static_cast<std::size_t>(k)].is_slide;
    const double size = std::abs(step[k]) / (is_slide ? arm.length : 1);
    if (!(size <= largest)) largest = size;
  }
  return largest;
}

JointVector<Complex> newton_step(const Arm& arm, const Placement<Complex>& pose,
                                 const JointVector<Complex>& q) {
  const TipMotion<Complex> motion = tip_motion<Complex>(arm, q);
  return joints_for(arm, motion.screws, small_difference<Complex>(arm, pose, motion.tip));
}

JointVector<Complex> predicted(const Arm& arm, const TipWay& way, double s, double h,
                               const JointVector<Complex>& q) {
  const JointVector<Complex> a = velocity_at(arm, way, s, q);
  const JointVector<Complex> b = velocity_at(arm, way, s + h / 2, q + h / 2 * a);
  const JointVector<Complex> c = velocity_at(arm, way, s + h / 2, q + h / 2 * b);
  const JointVector<Complex> d = velocity_at(arm, way, s + h, q + h * c);
  return q + h / 6 * (a + 2 * b + 2 * c + d);
}

/// What rounding makes of a Newton step here. Far from real, screws grow with the turns before
/// them, and the turns behind take as much away: the tip is wrong by the last bits of the square.
double rounding_of_step(const Arm& arm, const JointVector<Complex>& q) {
  constexpr double kLastBits = 1e-15;
  const Eigen::Matrix<Complex, 6, 6> square = tip_motion<Complex>(arm, q).screws;
  const double growth = std::max(1.0, square.cwiseAbs2().maxCoeff());
  return kLastBits * growth * square.partialPivLu().inverse().norm();
}

/// Newton steps, two at least, until what they leave is small; nothing where one is not smaller by
/// `contraction` than the one before. What is left next to a singular pose, where steps contract by
/// no more than this, would keep those from the next place from contracting at all.
struct Corrected {
  bool contracts = false;
  double first = 0;
};
Corrected corrected(const Arm& arm, const Placement<Complex>& pose, double contraction, bool is_end,
                    JointVector<Complex>& q) {
  /// Radians: a prediction that is farther off may be another path's.
  constexpr double kFarthest = 0.1;
  /// Steps that are smaller may be rounding's, next to a singular posture; they lead to no other
  /// path.
  constexpr double kRounding = 1e-9, kMostRounding = 1e-5;
  constexpr double kSmall = 1e-7;
  constexpr int kMost = 5;
  Corrected result;
  const JointVector<Complex> one = newton_step(arm, pose, q);
  result.first = step_size(arm, one);
  if (!(result.first <= kFarthest)) return result;
  q += one;
  double before = result.first;
  for (int k = 0; k < kMost; ++k) {
    const JointVector<Complex> step = newton_step(arm, pose, q);
    const double size = step_size(arm, step);
    const bool is_smaller = size <= std::max(contraction * before, kRounding);
    const bool may_be_rounding = !is_end && size <= kMostRounding;
    if (!is_smaller && !(may_be_rounding && size <= rounding_of_step(arm, q))) return result;
    q += step;
    if (!is_smaller || size <= kRounding || size * size <= kSmall * before) break;
    before = size;
  }
  result.contracts = true;
  return result;
}

bool is_infinite(const Arm& arm, const JointVector<Complex>& q) {
  constexpr double kAngle = 12, kSlide = 1e6;
  for (Eigen::Index k = 0; k < q.size(); ++k) {
    const bool is_slide = arm.joints[static_cast<std::size_t>(k)].is_slide;
    if (is_slide ? std::abs(q[k]) > kSlide * arm.length : std::abs(q[k].imag()) > kAngle) {
      return true;
    }
  }
  return false;
}

/// Closures that are nearer at a pose are one, where both are regular.
bool have_met(const Arm& arm, const ApproachEnd& a, const ApproachEnd& b) {
  const double within = std::max(1e-9, 10 * (a.accuracy + b.accuracy));
  return a.kind == ApproachKind::regular && b.kind == ApproachKind::regular &&
         distance_of(arm, a.values, b.values) <= within;
}

/// The poses are real: a closure's conjugate is another one, or the closure itself. Next to a
/// singular pose the path to it may have stopped before it.
bool has_conjugate(const Arm& arm, const ApproachEnd& end, const std::vector<ApproachEnd>& ends) {
  constexpr double kClearly = 4;
  if (end.kind != ApproachKind::regular) return true;
  const JointVector<Complex> mirrored = end.values.conjugate();
  return std::any_of(ends.begin(), ends.end(), [&](const ApproachEnd& other) {
    if (other.kind != ApproachKind::regular && other.kind != ApproachKind::singular) return false;
    const double within = std::max(1e-8, 10 * (end.accuracy + other.accuracy));
    return distance_of(arm, mirrored, other.values) <= within + kClearly * other.to_go;
  });
}

}  // namespace

Placement<Complex> complex_placement(const Eigen::Isometry3d& pose) {
  return {pose.linear().cast<Complex>(), pose.translation().cast<Complex>()};
}

double distance_of(const Arm& arm, const JointVector<Complex>& a, const JointVector<Complex>& b) {
  double largest = 0;
  for (Eigen::Index k = 0; k < a.size(); ++k) {
    const Complex difference = a[k] - b[k];
    const bool is_slide = arm.joints[static_cast<std::size_t>(k)].is_slide;
    const Complex apart =
        is_slide
            ? difference / arm.length
            : Complex(std::remainder(difference.real(), 2 * std::numbers::pi), difference.imag());
    largest = std::max(largest, std::abs(apart));
  }
  return largest;
}

TipWay tip_way(const Eigen::Isometry3d& begin, const Eigen::Isometry3d& end, double detour) {
  const Eigen::AngleAxisd turn(begin.linear().transpose() * end.linear());
  return {{begin.linear(), begin.translation()},
          {end.linear(), end.translation()},
          turn.angle() * turn.axis(),
          detour};
}

namespace {

/// Whether every motion of the joints moves the tip. On a set of closures steps along it are none
/// of Newton's, which then contracts at any of its points, complex ones too.
bool moves_in_all_ways(const Arm& arm, const JointVector<Complex>& q) {
  constexpr double kRounding = 1e-13;  // what the tip seems to move by where it stands
  const Eigen::Matrix<Complex, 6, 6> square = tip_motion<Complex>(arm, q).screws;
  return square.partialPivLu().inverse().norm() < 1 / kRounding;
}

/// Newton's method at one pose; also where it ends on a set of closures.
bool settles_at(const Arm& arm, const Placement<Complex>& pose, JointVector<Complex>& values,
                double farthest, double& accuracy) {
  constexpr int kMost = 12;
  constexpr double kRegular = 1e-5;
  JointVector<Complex> q = values;
  accuracy = std::numeric_limits<double>::infinity();
  for (int k = 0; k < kMost; ++k) {
    const JointVector<Complex> step = newton_step(arm, pose, q);
    const double size = step_size(arm, step);
    if (!std::isfinite(size)) return false;
    if (size > accuracy / 2 && accuracy <= kRegular) break;  // the last digits
    if (size > farthest) return false;
    q += step;
    accuracy = size;
    if (size == 0) break;
  }
  if (!(accuracy <= kRegular) || distance_of(arm, q, values) > farthest) return false;
  values = q;
  return true;
}

}  // namespace

bool correct_at(const Arm& arm, const Placement<Complex>& pose, JointVector<Complex>& values,
                double farthest, double& accuracy) {
  JointVector<Complex> q = values;
  if (!settles_at(arm, pose, q, farthest, accuracy) || !moves_in_all_ways(arm, q)) return false;
  values = q;
  return true;
}

ApproachEnd approach(const Arm& arm, const TipWay& way, const JointVector<Complex>& start,
                     double contraction) {
  constexpr double kFirstStep = 0.1, kLeastShare = 1e-7, kNear = 1e-3, kRounding = 1e-13;
  constexpr double kNearlyReal = 1e-6;
  /// Newton steps that a prediction should need, radians.
  constexpr double kWanted = 1e-3;
  constexpr double kQuarter = 0.25;
  constexpr int kMostSteps = 2000;
  const Placement<Complex> end{way.end.R.cast<Complex>(), way.end.p.cast<Complex>()};
  ApproachEnd result;
  result.values = start;
  double s = 0, h = kFirstStep;
  struct {
    double remaining = 1;
    JointVector<Complex> values;
  } lately{1, start}, before{1, start};
  for (int steps = 0; steps < kMostSteps; ++steps) {
    result.remaining = 1 - s;
    if (is_infinite(arm, result.values)) {
      result.kind = result.remaining < kNear ? ApproachKind::infinite : ApproachKind::lost;
      return result;
    }
    if (result.remaining < kRounding) break;
    const bool is_last = h >= result.remaining;
    h = std::min(h, result.remaining);
    const double next = is_last ? 1 : s + h;
    JointVector<Complex> q = predicted(arm, way, s, h, result.values);
    const Corrected step =
        corrected(arm, is_last ? end : moving(arm, way, next).at, contraction, is_last, q);
    if (step.contracts && is_last) {
      JointVector<Complex> last = q;
      const bool settles = settles_at(arm, end, last, kWanted, result.accuracy);
      const bool is_regular = settles && moves_in_all_ways(arm, last);
      // A place of a set that is not real tells nothing of what is real on it.
      if (is_regular || (settles && last.imag().cwiseAbs().maxCoeff() < kNearlyReal)) {
        result.values = last;
        result.remaining = 0;
        result.kind = is_regular ? ApproachKind::regular : ApproachKind::singular;
        if (!is_regular) result.to_go = result.accuracy;
        return result;
      }
    }
    if (step.contracts && !is_last) {
      result.values = q;
      s = next;
      if (1 - s < kQuarter * lately.remaining) {
        before = lately;
        lately = {1 - s, q};
      }
      const double growth = std::pow(kWanted / std::max(step.first, 1e-9), 0.2);
      h *= std::clamp(0.9 * growth, 0.3, 3.0);
      continue;
    }
    h /= 3;
    if (h < kLeastShare * result.remaining) break;
  }
  if (result.remaining < kNear) {
    result.kind = ApproachKind::singular;
    result.to_go = distance_of(arm, result.values, before.values);
  }
  return result;
}

bool are_different(const Arm& arm, const std::vector<ApproachEnd>& ends) {
  for (std::size_t k = 0; k < ends.size(); ++k) {
    if (ends[k].kind == ApproachKind::lost) return false;
    for (std::size_t j = 0; j < k; ++j) {
      if (have_met(arm, ends[j], ends[k])) return false;
    }
  }
  return true;
}

std::vector<std::size_t> without_conjugate(const Arm& arm, const std::vector<ApproachEnd>& ends) {
  std::vector<std::size_t> alone;
  for (std::size_t k = 0; k < ends.size(); ++k) {
    if (!has_conjugate(arm, ends[k], ends)) alone.push_back(k);
  }
  return alone;
}

}  // namespace moivre
