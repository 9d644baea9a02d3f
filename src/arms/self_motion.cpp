// SPDX-License-Identifier: MIT
// Steps along the directions that move the tip least, put right across them.
#include "self_motion.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "moivre/factorization/svd.h"
#include "moivre/numeric/random.h"
#include "polish.h"

namespace moivre {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

/// Radians, and arm's lengths.
constexpr double kProbe = 0.05;
constexpr double kStep = 0.05;
/// A set that reaches less far is none.
constexpr double kShortest = 0.2;
/// Singular values beside the largest: directions with larger ones do move the tip.
constexpr double kMayStand = 0.02;
/// A set of one dimension has at most so many samples to each side, one of more dimensions so many ways of so many steps.
constexpr int kMostSteps = 400;
constexpr int kWays = 12, kStepsOfAWay = 25;
/// Where random numbers of the first place, of one further on, and of ways begin.
constexpr std::uint64_t kFirstStream = 6000, kSecondStream = 6500, kThirdStream = 7000,
                        kNearStream = 7500;

/// Of a difference of joint values, in radians and arm's lengths.
VectorXd in_arms_lengths(const Arm& arm, VectorXd difference) {
  for (Index k = 0; k < difference.size(); ++k) {
    if (arm.joints[static_cast<std::size_t>(k)].is_slide) difference[k] /= arm.length;
  }
  return difference;
}

/// A posture near a set, in radians and arm's lengths as far as its directions go.
struct Place {
  VectorXd values;
  double residual = 0;
  MatrixXd V;      ///< right singular vectors, the last ones move the tip least
  VectorXd sigma;  ///< as many as joints, 0 where there are more joints than six
  VectorXd error;
  VectorXd least;  ///< unit: where the tip can move least
};

Place place_at(const Arm& arm, const Eigen::Isometry3d& pose, const VectorXd& values) {
  const Linearized at = linearized(arm, pose, values);
  const Svd stretch = svd(at.screws, SingularVectors::full);
  Place place;
  place.values = values;
  place.residual = size_of(at.error);
  place.V = stretch.V;
  place.sigma = VectorXd::Zero(values.size());
  place.sigma.head(stretch.sigma.size()) = stretch.sigma;
  place.error = at.error;
  place.least = stretch.U.col(stretch.sigma.size() - 1);
  return place;
}

/// Gauss-Newton steps across `frozen` (orthonormal columns) alone. What is within the accuracy is no reason to go far.
Place settled(const Arm& arm, const Eigen::Isometry3d& pose, VectorXd values,
              const MatrixXd& frozen, double accuracy) {
  constexpr int kMost = 40;
  constexpr double kLost = 1e-9, kLongest = 0.2, kSettled = 1e-13, kLongWay = kProbe / 10;
  const Index n = values.size();
  const MatrixXd across = MatrixXd::Identity(n, n) - frozen * frozen.transpose();
  for (int k = 0; k < kMost; ++k) {
    const Linearized at = linearized(arm, pose, values);
    const Svd stretch = svd(at.screws * across, SingularVectors::thin);
    VectorXd along = stretch.U.transpose() * at.error;
    for (Index i = 0; i < along.size(); ++i) {
      const double miss = std::abs(along[i]);
      const bool is_lost = stretch.sigma[i] <= kLost * stretch.sigma[0] ||
                           (miss <= accuracy && miss > kLongWay * stretch.sigma[i]);
      along[i] = is_lost ? 0 : along[i] / stretch.sigma[i];
    }
    VectorXd step = across * (stretch.V * along);
    const double size = step.cwiseAbs().maxCoeff();
    if (size > kLongest) step *= kLongest / size;
    values += in_joints<double>(arm, step);
    if (size < kSettled) break;
  }
  return place_at(arm, pose, values);
}

/// The place at `step` along `direction`; nothing where the pose is missed there.
std::optional<Place> moved(const Arm& arm, const Eigen::Isometry3d& pose, const Place& from,
                           const VectorXd& direction, double step, double accuracy) {
  const VectorXd there = from.values + in_joints<double>(arm, step * direction);
  Place place = settled(arm, pose, there, direction, accuracy);
  if (!(place.residual <= accuracy)) return std::nullopt;
  const VectorXd gone = place.values - from.values;
  const VectorXd meant = there - from.values;
  if ((gone - meant).cwiseAbs().maxCoeff() > std::abs(step)) return std::nullopt;
  return place;
}

/// Of the places where steps from here lead, as differences from here: those directions that are no rounding of others.
MatrixXd span_of(const std::vector<VectorXd>& differences) {
  constexpr double kCurved = 0.15;
  MatrixXd all(differences.front().size(), std::ssize(differences));
  for (Index k = 0; k < all.cols(); ++k) {
    all.col(k) = differences[static_cast<std::size_t>(k)].normalized();
  }
  const Svd stretch = svd(all, SingularVectors::thin);
  Index rank = 0;
  while (rank < stretch.sigma.size() && stretch.sigma[rank] > kCurved * stretch.sigma[0]) ++rank;
  return stretch.U.leftCols(rank);
}

/// Whether the set goes straight on from here to `gone`: half way there is a place of it as well. Other sets and closures may be as near.
bool leads_to(const Arm& arm, const Eigen::Isometry3d& pose, const Place& place,
              const VectorXd& gone, double accuracy) {
  constexpr double kBow = 0.1;
  const VectorXd half = place.values + in_joints<double>(arm, gone / 2);
  const Place between = settled(arm, pose, half, gone.normalized(), accuracy);
  return between.residual <= accuracy &&
         in_arms_lengths(arm, between.values - half).norm() <= kBow * gone.norm();
}

/// Directions in which the set goes on from here (orthonormal), and a place further on: random steps along what moves the tip least,
/// put right without restraint, come back to the set.
struct Around {
  MatrixXd directions;
  std::optional<VectorXd> further;
};
Around around(const Arm& arm, const Eigen::Isometry3d& pose, const Place& place, double accuracy,
              std::uint64_t seed, std::uint64_t stream, double probe = kProbe) {
  constexpr std::uint64_t kSteps = 8;
  const Index n = place.values.size();
  Index still = 0;
  while (still < n && place.sigma[n - 1 - still] <= kMayStand * place.sigma[0]) ++still;
  Around result;
  if (still == 0) return result;
  std::vector<VectorXd> differences;
  for (std::uint64_t k = 0; k < kSteps; ++k) {
    VectorXd direction = VectorXd::Zero(n);
    for (Index i = 0; i < still; ++i) {
      const auto index = stream + k * kMostJoints + static_cast<std::uint64_t>(i);
      direction += (2 * random_unit(seed, RandomStream::arm, index) - 1) * place.V.col(n - 1 - i);
    }
    direction.normalize();
    const VectorXd there = place.values + in_joints<double>(arm, probe * direction);
    // Where the posture is a closure that only the digits make a set of, Newton's method without restraint would come back to it;
    // where sets of closures meet, the restraint may leave no place.
    VectorXd landed = settled(arm, pose, there, direction, accuracy).values;
    if (!(size_of(linearized(arm, pose, landed).error) <= accuracy)) {
      landed = polish(arm, pose, there).values;
    }
    const VectorXd gone = in_arms_lengths(arm, landed - place.values);
    const bool is_near = gone.norm() > probe / 10 && gone.norm() < 3 * probe;
    if (!is_near || !(size_of(linearized(arm, pose, landed).error) <= accuracy)) continue;
    if (!leads_to(arm, pose, place, gone, accuracy)) continue;
    differences.push_back(gone);
    result.further = landed;
  }
  if (!differences.empty()) result.directions = span_of(differences);
  return result;
}

double apart(const Arm& arm, const VectorXd& a, const VectorXd& b) {
  return way_between(arm, a, b).norm();
}

struct Way {
  std::vector<Place> places;
  bool closes = false;
};

/// From `from` on along `direction`, to the end of the set or back to its beginning.
Way follow(const Arm& arm, const Eigen::Isometry3d& pose, const Place& from, VectorXd direction,
           Index dimension, int most, double accuracy) {
  constexpr int kHalvings = 4;
  /// Samples follow a curve: the cosine between one step and the next.
  constexpr double kStraight = 0.995;
  Way way;
  Place here = from;
  for (int k = 0; k < most; ++k) {
    std::optional<Place> next;
    double step = kStep;
    VectorXd gone;
    for (int h = 0; h <= kHalvings; ++h, step /= 2) {
      next = moved(arm, pose, here, direction, step, accuracy);
      if (!next) continue;
      gone = in_arms_lengths(arm, next->values - here.values).normalized();
      if (gone.dot(direction) > kStraight) break;
    }
    if (!next) return way;
    direction = gone;
    here = std::move(*next);
    way.places.push_back(here);
    const bool is_back = k > 3 && apart(arm, here.values, from.values) < kStep;
    if (dimension == 1 && is_back) {
      way.closes = true;
      return way;
    }
  }
  return way;
}

/// By how much the tip misses the pose there: along the direction in which it can move least, which turns little from place to place.
struct Miss {
  double s = 0;  ///< of the place, between two others
  VectorXd values;
  VectorXd least;  ///< unit, on the side of the last one's
  double size = 0;
};

Miss miss_at(const Place& place, const VectorXd& least_before, double s = 0) {
  Miss miss{s, place.values, place.least, 0};
  if (least_before.size() > 0 && place.least.dot(least_before) < 0) miss.least = -miss.least;
  miss.size = miss.least.dot(place.error);
  return miss;
}

/// Where the parabola through three misses is 0, or else nearest to 0.
double least_of_parabola(const std::array<Miss, 3>& at) {
  const auto& [a, b, c] = at;
  const double ab = (b.size - a.size) / (b.s - a.s);
  const double bc = (c.size - b.size) / (c.s - b.s);
  const double bend = (bc - ab) / (c.s - a.s);
  const double slope = ab + bend * (b.s - a.s);  // at b
  if (bend == 0) return b.s - b.size / slope;
  const double under_root = slope * slope - 4 * bend * b.size;
  if (under_root <= 0) return b.s - slope / (2 * bend);
  return b.s - 2 * b.size / (slope + std::copysign(std::sqrt(under_root), slope));
}

/// Between two places of the set, where the tip misses the pose least: by secants of second order along the set. Newton's method
/// alone leaves a set that is curved.
VectorXd nearest_to_pose(const Arm& arm, const Eigen::Isometry3d& pose, const Miss& from,
                         const Miss& to, double accuracy) {
  constexpr int kMost = 10;
  constexpr double kNothing = 1e-15;
  const VectorXd chord = to.values - from.values;
  const VectorXd direction = in_arms_lengths(arm, chord).normalized();
  const auto missed = [&](double s) {
    return miss_at(settled(arm, pose, from.values + s * chord, direction, accuracy), from.least, s);
  };
  std::array<Miss, 3> at{from, missed(0.5), to};
  at[2].s = 1;
  const auto by_size = [](const Miss& a, const Miss& b) {
    return std::abs(a.size) < std::abs(b.size);
  };
  for (int k = 0; k < kMost; ++k) {
    std::sort(at.begin(), at.end(), by_size);
    if (std::abs(at[0].size) < kNothing) break;
    const double s = least_of_parabola({at[1], at[0], at[2]});
    if (!(s >= 0 && s <= 1) || s == at[0].s || s == at[1].s) break;
    at[2] = missed(s);
  }
  return std::min_element(at.begin(), at.end(), by_size)->values;
}

/// Where the miss along the set changes its sign, or comes near to that and goes back.
void add_near_closures(const Arm& arm, const Eigen::Isometry3d& pose,
                       const std::vector<Place>& places, double accuracy, TracedSet& traced) {
  std::vector<Miss> miss;
  for (const Place& place : places) {
    miss.push_back(miss_at(place, miss.empty() ? VectorXd() : miss.back().least));
  }
  const auto size = [&](std::size_t k) { return std::abs(miss[k].size); };
  for (std::size_t k = 1; k < miss.size(); ++k) {
    if (miss[k - 1].size * miss[k].size <= 0) {
      traced.near_closures.push_back(nearest_to_pose(arm, pose, miss[k - 1], miss[k], accuracy));
    } else if (k + 1 < miss.size() && size(k) < size(k - 1) && size(k) < size(k + 1)) {
      traced.near_closures.push_back(
          nearest_to_pose(arm, pose, miss[k - 1], miss[k + 1], accuracy));
    }
  }
}

/// Rows r with r . (samples - first) = 0, in reduced echelon form over the joints that move.
std::vector<JointRelation> relations_of(const Arm& arm, const std::vector<VectorXd>& samples,
                                        int dimension) {
  constexpr double kFlat = 1e-6;
  const Index n = samples.front().size();
  MatrixXd spread(std::ssize(samples), n);
  for (Index i = 0; i < spread.rows(); ++i) {
    spread.row(i) = (samples[static_cast<std::size_t>(i)] - samples.front()).transpose();
  }
  std::vector<Index> moving;
  for (Index k = 0; k < n; ++k) {
    const double unit = arm.joints[static_cast<std::size_t>(k)].is_slide ? arm.length : 1;
    if (spread.col(k).cwiseAbs().maxCoeff() > kFlat * unit) moving.push_back(k);
  }
  if (moving.empty()) return {};
  const auto m = std::ssize(moving);
  MatrixXd of_moving(spread.rows(), m);
  for (Index k = 0; k < m; ++k) {
    of_moving.col(k) = spread.col(moving[static_cast<std::size_t>(k)]);
  }
  const Svd stretch = svd(of_moving.transpose() * of_moving, SingularVectors::full);
  for (Index k = dimension; k < m; ++k) {
    if (stretch.sigma[k] > kFlat * kFlat * stretch.sigma[0]) return {};
  }
  MatrixXd rows = stretch.V.rightCols(m - dimension).transpose();
  for (Index r = 0; r < rows.rows(); ++r) {
    Index pivot = 0;
    rows.row(r).cwiseAbs().maxCoeff(&pivot);
    rows.row(r) /= double(rows(r, pivot));
    for (Index other = 0; other < rows.rows(); ++other) {
      if (other != r) rows.row(other) -= double(rows(other, pivot)) * rows.row(r);
    }
  }
  std::vector<JointRelation> relations;
  for (Index r = 0; r < rows.rows(); ++r) {
    JointRelation& relation = relations.emplace_back();
    relation.factors = VectorXd::Zero(n);
    for (Index k = 0; k < m; ++k) {
      const double nearest = std::round(rows(r, k));
      const bool is_whole = std::abs(rows(r, k) - nearest) < kFlat;
      relation.factors[moving[static_cast<std::size_t>(k)]] = is_whole ? nearest : rows(r, k);
    }
    relation.value = relation.factors.dot(samples.front());
  }
  return relations;
}

/// A place at the beginning of a set that closes, as many whole turns on as the last one has gone.
Place again_after(const Arm& arm, const Place& last, Place place) {
  place.values = last.values + in_joints<double>(arm, way_between(arm, last.values, place.values));
  return place;
}

void take(const std::vector<Place>& places, std::vector<VectorXd>& samples, double& misfit) {
  for (const Place& place : places) {
    samples.push_back(place.values);
    misfit = std::max(misfit, place.residual);
  }
}

}  // namespace

std::optional<TracedSet> trace_set(const Arm& arm, const Eigen::Isometry3d& pose,
                                   const VectorXd& from, double accuracy, std::uint64_t seed) {
  const Place start = place_at(arm, pose, from);
  const Around here = around(arm, pose, start, accuracy, seed, kFirstStream);
  if (!here.further) return std::nullopt;
  // Where sets meet, directions belong to several: a place further on has those of its own.
  const Place next = place_at(arm, pose, *here.further);
  const Around there = around(arm, pose, next, accuracy, seed, kSecondStream);
  if (!there.further) return std::nullopt;
  TracedSet traced;
  SelfMotion& motion = traced.motion;
  // A place where sets meet is known to half the digits or fewer: the other one is better.
  const auto clearness = [](const Place& place, Index dimension) {
    const Index across = place.sigma.size() - 1 - dimension;
    return across < 0 ? 0.0 : place.sigma[across];
  };
  const Index dimension = std::min(here.directions.cols(), there.directions.cols());
  const bool is_meeting = there.directions.cols() < here.directions.cols() ||
                          clearness(next, dimension) > 2 * clearness(start, dimension);
  const Place& begin = is_meeting ? next : start;
  MatrixXd ways = is_meeting ? there.directions : here.directions;
  // Places of a curve that is bent span two dimensions unless they are near. What is within an accuracy tells nothing there.
  if (ways.cols() > 1 && accuracy <= kReach) {
    const Around near = around(arm, pose, begin, accuracy, seed, kNearStream, kProbe / 10);
    if (near.further && near.directions.cols() < ways.cols()) ways = near.directions;
  }
  motion.dimension = static_cast<int>(ways.cols());
  motion.values = begin.values;
  motion.misfit = begin.residual;
  if (motion.dimension == 1) {
    Way forth = follow(arm, pose, begin, ways.col(0), 1, kMostSteps, accuracy);
    Way back;
    if (!forth.closes) back = follow(arm, pose, begin, -ways.col(0), 1, kMostSteps, accuracy);
    std::vector<Place> places(back.places.rbegin(), back.places.rend());
    places.push_back(begin);
    places.insert(places.end(), forth.places.begin(), forth.places.end());
    take(places, motion.samples, motion.misfit);
    motion.closes = forth.closes;
    if (motion.misfit > kReach) {
      for (std::size_t k = 0; motion.closes && k < 2; ++k) {
        places.push_back(again_after(arm, places.back(), places[k]));
      }
      add_near_closures(arm, pose, places, accuracy, traced);
    }
  } else {
    motion.samples.push_back(begin.values);
    for (int way = 0; way < kWays; ++way) {
      VectorXd direction = VectorXd::Zero(from.size());
      for (Index k = 0; k < ways.cols(); ++k) {
        const auto index = static_cast<std::uint64_t>(way * kMostJoints + k);
        direction +=
            (2 * random_unit(seed, RandomStream::arm, kThirdStream + index) - 1) * ways.col(k);
      }
      const Way gone = follow(arm, pose, begin, direction.normalized(), motion.dimension,
                              kStepsOfAWay, accuracy);
      take(gone.places, motion.samples, motion.misfit);
    }
  }
  // A few steps are no set: closures that meet leave the accuracy behind as slowly.
  double reached = 0;
  for (const VectorXd& sample : motion.samples) {
    reached = std::max(reached, apart(arm, sample, motion.values));
  }
  if (reached < kShortest) return std::nullopt;
  motion.directions = ways;
  for (Index k = 0; k < motion.directions.cols(); ++k) {
    motion.directions.col(k) =
        in_joints<double>(arm, VectorXd(motion.directions.col(k))).normalized();
  }
  motion.lost = {arm.length * begin.least.head<3>(), begin.least.tail<3>()};
  motion.relations = relations_of(arm, motion.samples, motion.dimension);
  return traced;
}

namespace {

/// The places of a set's samples that are tried, each this far from the others.
constexpr int kTargets = 3;
constexpr double kTargetsApart = 0.5;

/// Goes from a place to a sample along what does not move the tip. False where it does not come nearer, or leaves the pose.
bool walks_to(const Arm& arm, const Eigen::Isometry3d& pose, Place here, const VectorXd& sample,
              int dimension, double accuracy) {
  constexpr int kMost = 200;
  constexpr double kTurnedAway = 0.1;
  for (int k = 0; k < kMost; ++k) {
    const VectorXd to = way_between(arm, here.values, sample);
    if (to.norm() < kStep) return to.norm() < kStep / 10 || leads_to(arm, pose, here, to, accuracy);
    const MatrixXd tangent = here.V.rightCols(dimension);
    const VectorXd along = tangent * (tangent.transpose() * to);
    if (along.norm() < kTurnedAway * to.norm()) return false;
    const double step = std::min(2 * kStep, along.norm());
    auto next = moved(arm, pose, here, along.normalized(), step, accuracy);
    if (!next) return false;
    here = std::move(*next);
  }
  return false;
}

/// A surface is known by samples that are far apart: of it is what one can walk to them from.
bool is_on_surface(const Arm& arm, const SelfMotion& motion, const VectorXd& values,
                   double within) {
  constexpr double kAllowance = 2;
  const Eigen::Isometry3d pose = forward_kinematics(arm, motion.values);
  const double accuracy = std::max(kReach, kAllowance * motion.misfit);
  const Place here = settled(arm, pose, values, MatrixXd(values.size(), 0), accuracy);
  if (!(here.residual <= accuracy) || apart(arm, here.values, values) > within) return false;
  std::vector<VectorXd> targets;
  for (int k = 0; k < kTargets; ++k) {
    const VectorXd* nearest = nullptr;
    for (const VectorXd& sample : motion.samples) {
      const bool is_tried = std::any_of(targets.begin(), targets.end(), [&](const VectorXd& one) {
        return apart(arm, one, sample) < kTargetsApart;
      });
      if (is_tried) continue;
      const bool is_nearer =
          nearest == nullptr || apart(arm, sample, values) < apart(arm, *nearest, values);
      if (is_nearer) nearest = &sample;
    }
    if (nearest == nullptr) return false;
    if (walks_to(arm, pose, here, *nearest, motion.dimension, accuracy)) return true;
    targets.push_back(*nearest);
  }
  return false;
}

}  // namespace

bool is_on(const Arm& arm, const SelfMotion& motion, const VectorXd& values, double within) {
  constexpr double kStandsStill = 5e-3, kChord = 5e-3;
  const double near_plane = within;
  if (!motion.relations.empty()) {
    const VectorXd away = way_between(arm, motion.values, values);
    // Joints that no relation names stand still.
    VectorXd named = VectorXd::Zero(values.size());
    bool holds = true;
    for (const JointRelation& relation : motion.relations) {
      named += relation.factors.cwiseAbs();
      double miss = 0;
      for (Index k = 0; k < values.size(); ++k) {
        const bool is_slide = arm.joints[static_cast<std::size_t>(k)].is_slide;
        miss += relation.factors[k] * away[k] * (is_slide ? arm.length : 1);
      }
      holds = holds && std::abs(std::remainder(miss, 2 * std::numbers::pi)) < near_plane;
    }
    for (Index k = 0; k < values.size(); ++k) {
      const bool moves =
          named[k] > 0 || motion.directions.row(k).cwiseAbs().maxCoeff() > kStandsStill;
      holds = holds && (moves || std::abs(away[k]) < near_plane);
    }
    return holds;
  }
  if (motion.dimension > 1) return is_on_surface(arm, motion, values, within);
  // Between samples, which are kStep apart, a curve leaves its chord by a little.
  const double near = std::max(within, kChord);
  for (std::size_t k = motion.closes ? 0 : 1; k < motion.samples.size(); ++k) {
    const VectorXd& a = k > 0 ? motion.samples[k - 1] : motion.samples.back();
    const VectorXd side = way_between(arm, a, motion.samples[k]), to = way_between(arm, a, values);
    const double along = std::clamp(to.dot(side) / std::max(side.squaredNorm(), 1e-300), 0.0, 1.0);
    if ((to - along * side).norm() < near) return true;
  }
  return false;
}

}  // namespace moivre
