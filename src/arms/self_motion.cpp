// SPDX-License-Identifier: MIT
// Steps along the directions that move the tip least, put right across them.
#include "self_motion.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>

#include "least_motion.h"
#include "moivre/factorization/svd.h"
#include "moivre/numeric/random.h"
#include "near_closures.h"
#include "polish.h"
#include "set_place.h"

namespace moivre {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

/// A set that reaches less far is none, in probes; a curve that ends, from one end to the other.
constexpr double kShortest = 4, kShortestCurve = 6;
/// Singular values relative to the largest: directions with larger ones do move the tip.
constexpr double kMayStand = 0.02;
/// A set of one dimension has at most so many samples to each side; for one of more dimensions so
/// many ways are gone.
constexpr int kMostSteps = 2000;
constexpr int kMostWays = 10'000;
/// Where sets cross so many ways are tried.
constexpr std::uint64_t kWays = 12;
/// Of a probe: how near places of a curve are that tell its one direction.
constexpr double kNearProbe = 0.1;
/// Where random numbers of the first place, of one further on, and of ways begin.
constexpr std::uint64_t kFirstStream = 6000, kSecondStream = 6500, kThirdStream = 7000,
                        kNearStream = 7500;

/// Of the places where steps from here lead, as differences from here: those directions that are no
/// rounding of others.
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

/// In the plane of these orthonormal columns.
VectorXd random_unit_vector(const MatrixXd& columns, std::uint64_t seed, std::uint64_t stream) {
  VectorXd along(columns.cols());
  for (Index i = 0; i < along.size(); ++i) {
    const auto index = stream + static_cast<std::uint64_t>(i);
    along[i] = 2 * random_unit(seed, RandomStream::arm, index) - 1;
  }
  return columns * along.normalized();
}

/// As many directions as move the tip so little that it may stand, from those that move it least.
MatrixXd still_directions(const Svd& stretch) {
  const Index n = stretch.sigma.size();
  Index still = 0;
  while (still < n && stretch.sigma[n - 1 - still] <= kMayStand * stretch.sigma[0]) ++still;
  return stretch.V.rightCols(still);
}

/// Whether more directions than one move the tip so little.
bool may_stand_along_more(const Screws<double>& screws) {
  return still_count(screws, kMayStand * screws.norm()) > 1;
}

struct Still {
  MatrixXd directions;
  VectorXd sigma;  ///< of one direction alone the last two
};

/// Of six joints one direction, or none, is found without the others.
std::optional<Still> one_still(const Screws<double>& screws) {
  constexpr Index kJoints = 6;
  if (screws.cols() != kJoints) return std::nullopt;
  // The largest singular value, but for a factor.
  const double most = screws.norm(), least = most / std::sqrt(double(kJoints));
  if (may_stand_along_more(screws)) return std::nullopt;
  const LeastMotion motion = least_motion(screws);
  const bool is_still = motion.singular_value <= kMayStand * least;
  if (!is_still && motion.singular_value <= kMayStand * most) return std::nullopt;
  Still still{MatrixXd(kJoints, 0), VectorXd::Zero(kJoints)};
  if (!is_still) return still;
  const Screws<double> others = screws + most * motion.tip * motion.joints.transpose();
  still.directions = motion.joints;
  still.sigma.tail(2) << least_motion(others).singular_value, motion.singular_value;
  return still;
}

Still still_at(const SetPlace& place) {
  if (auto one = one_still(place.at.screws)) return std::move(*one);
  const Svd stretch = stretch_of(place);
  return {still_directions(stretch), stretch.sigma};
}

/// Directions in which the set goes on from here (orthonormal), and a place further on: random
/// steps along what moves the tip least, put right without restraint, come back to the set.
struct Around {
  MatrixXd directions;
  std::optional<VectorXd> further;
  VectorXd sigma;  ///< singular values, here, as Still has them
};
Around around(const Arm& arm, const Eigen::Isometry3d& pose, const SetPlace& place, double accuracy,
              std::uint64_t seed, std::uint64_t stream, double probe) {
  constexpr std::uint64_t kSteps = 8;
  const auto [least, sigma] = still_at(place);
  const Index still = least.cols();
  Around result;
  result.sigma = sigma;
  if (still == 0) return result;
  std::vector<VectorXd> differences;
  const std::uint64_t steps = still == 1 ? 2 : kSteps;  // a single direction has two sides
  for (std::uint64_t k = 0; k < steps; ++k) {
    const VectorXd direction = still == 1
                                   ? VectorXd((k == 0 ? 1 : -1) * least)
                                   : random_unit_vector(least, seed, stream + k * kMostJoints);
    const VectorXd there = place.values + in_joints<double>(arm, probe * direction);
    // Where the posture is a closure that only the digits make a set of, Newton's method without
    // restraint would come back to it;
    // where sets of closures meet, the restraint may leave no place.
    VectorXd landed = settled(arm, pose, there, direction, accuracy).values;
    double missed = size_of(linearized(arm, pose, landed).error);
    if (!(missed <= accuracy)) {
      landed = polish(arm, pose, there).values;
      missed = size_of(linearized(arm, pose, landed).error);
    }
    const VectorXd gone = in_arms_lengths(arm, landed - place.values);
    const bool is_near = gone.norm() > probe / 10 && gone.norm() < 3 * probe;
    if (!is_near || !(missed <= accuracy)) continue;
    if (!leads_to(arm, pose, place, gone, accuracy)) continue;
    differences.push_back(gone);
    result.further = landed;
  }
  if (!differences.empty()) result.directions = span_of(differences);
  return result;
}

struct Way {
  SetPlaces places;
  bool closes = false;
  bool is_whole = true;  ///< not cut off after `most` steps
};

struct StepLengths {
  double usual = kStep;
  double straight = kStep;  ///< where the set is straight, and no other one may cross it
};

/// From `from` on along `direction`, to the end of the set or back to its beginning. Where it has
/// gone far, steps are longer than usual: a small loop would have come back.
/// Beyond a place that misses the pose only the longest step is tried: the set may be open there
/// again. Shorter ones look for its end on this side.
Way follow(const Arm& arm, const Eigen::Isometry3d& pose, const SetPlace& from,
           JointVector<double> direction, int most, double accuracy, const StepLengths& lengths) {
  const int halvings = accuracy > kReach ? 3 : 4;  // an end within an accuracy is no point
  /// Samples follow a curve: the cosine between one step and the next.
  constexpr double kStraight = 0.995;
  constexpr double kSameWay = 0.5;
  constexpr double kOfTheWay = 0.1;
  constexpr double kClearlyBefore = 0.9;
  constexpr double kVeryStraight = 0.9998;
  Way way;
  JointVector<double> first;
  /// By which chords turn, for the way gone.
  JointVector<double> bend = JointVector<double>::Zero(direction.size());
  double last = 0;  // the last step's length
  double farthest = 0;
  double longest = lengths.usual;                            // of the next step
  double to_miss = std::numeric_limits<double>::infinity();  // the nearest one ahead
  for (int k = 0; k < most; ++k) {
    const SetPlace& here = way.places.empty() ? from : way.places.back();
    std::optional<SetPlace> next;
    longest = std::max(longest, std::min(kStep, kOfTheWay * farthest));
    double step = longest;
    JointVector<double> gone;
    for (int h = 0; h <= halvings; ++h, step /= 2) {
      if (h > 0 && step > kClearlyBefore * to_miss) continue;
      const JointVector<double> chord = (direction + (last + step) / 2 * bend).normalized();
      next = moved(arm, pose, here, chord, step, accuracy);
      if (!next) {
        to_miss = std::min(to_miss, step);
        continue;
      }
      if (step > to_miss) to_miss = std::numeric_limits<double>::infinity();
      gone = in_arms_lengths(arm, next->values - here.values).normalized();
      if (gone.dot(direction) > kStraight) break;
    }
    if (!next) return way;
    const double went = apart(arm, here.values, next->values);
    if (k > 0) bend = (gone - direction) / ((last + went) / 2);
    const bool is_straight = k > 0 && gone.dot(direction) > kVeryStraight;
    direction = gone;
    last = went;
    to_miss = went < to_miss ? to_miss - went : std::numeric_limits<double>::infinity();
    const double away = apart(arm, next->values, from.values);
    way.places.push_back(std::move(*next));
    // A narrow loop passes its beginning in the other direction.
    if (k == 0) first = direction;
    farthest = std::max(farthest, away);
    const bool is_back =
        farthest > 2 * longest && away < longest && direction.dot(first) > kSameWay;
    if (is_back) {
      way.closes = true;
      return way;
    }
    if (lengths.straight > lengths.usual) {
      const bool may_grow = is_straight && !may_stand_along_more(way.places.back().at.screws);
      longest = may_grow ? std::min(2 * longest, lengths.straight) : lengths.usual;
    }
  }
  way.is_whole = false;
  return way;
}

/// Of samples that are in a plane in joint space.
struct JointPlane {
  std::vector<JointRelation> relations;  ///< none: in no plane, or every joint that moves is free
  MatrixXd along;  ///< orthonormal columns; rows of joints that stand still are 0
};

/// Rows r with r . (samples - first) = 0, in reduced echelon form over the joints that move. Digits
/// such as 1.5708 bend a plane by a little.
JointPlane plane_of(const Arm& arm, const std::vector<VectorXd>& samples, int dimension) {
  constexpr double kFlat = 3e-5;
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
  const auto m = std::ssize(moving);
  if (m == 0 || m < dimension) return {};
  MatrixXd of_moving(spread.rows(), m);
  for (Index k = 0; k < m; ++k) {
    of_moving.col(k) = spread.col(moving[static_cast<std::size_t>(k)]);
  }
  const MatrixXd gram = of_moving.transpose() * of_moving;
  // Of a line the sum of squares of the values is the square of their sum, but for this.
  const double sum = gram.trace();
  const double beside = sum * sum - gram.squaredNorm();
  const double flat = 2 * static_cast<double>(m) * kFlat * kFlat;
  if (dimension == 1 && beside > 2 * flat * sum * sum) return {};
  const Svd stretch = svd(gram, SingularVectors::full);
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
  JointPlane plane;
  for (Index r = 0; r < rows.rows(); ++r) {
    JointRelation& relation = plane.relations.emplace_back();
    relation.factors = VectorXd::Zero(n);
    for (Index k = 0; k < m; ++k) {
      const double nearest = std::round(rows(r, k));
      const bool is_whole = std::abs(rows(r, k) - nearest) < kFlat;
      relation.factors[moving[static_cast<std::size_t>(k)]] = is_whole ? nearest : rows(r, k);
    }
    const auto first = std::find_if(relation.factors.begin(), relation.factors.end(),
                                    [](double factor) { return factor != 0; });
    if (*first < 0) relation.factors = VectorXd::Zero(n) - relation.factors;
    relation.value = relation.factors.dot(samples.front());
    const bool has_single_turn = std::any_of(moving.begin(), moving.end(), [&](Index k) {
      return !arm.joints[static_cast<std::size_t>(k)].is_slide &&
             std::abs(relation.factors[k]) == 1;
    });
    if (has_single_turn) relation.value = reduced_turn(relation.value);
  }
  plane.along = MatrixXd::Zero(n, dimension);
  for (Index k = 0; k < m; ++k) {
    plane.along.row(moving[static_cast<std::size_t>(k)]) = stretch.V.row(k).head(dimension);
  }
  return plane;
}

/// A place at the beginning of a set that closes, as many whole turns on as the last one has gone.
SetPlace again_after(const Arm& arm, const SetPlace& last, SetPlace place) {
  place.values = last.values + in_joints<double>(arm, way_between(arm, last.values, place.values));
  return place;
}

void take(const SetPlaces& places, std::vector<VectorXd>& samples, double& misfit) {
  for (const SetPlace& place : places) {
    samples.push_back(place.values);
    misfit = std::max(misfit, place.residual);
  }
}

/// Where a set is followed from, and in which directions.
struct SetBegin {
  SetPlace place;
  MatrixXd ways;
};

std::optional<SetBegin> set_begin(const Arm& arm, const Eigen::Isometry3d& pose,
                                  const VectorXd& from, double accuracy, double probe,
                                  std::uint64_t seed) {
  const SetPlace start = place_at(arm, pose, from);
  const Around here = around(arm, pose, start, accuracy, seed, kFirstStream, probe);
  if (!here.further) return std::nullopt;
  // Where sets meet, directions belong to several: a place further on has those of its own.
  const SetPlace next = place_at(arm, pose, *here.further);
  const Around there = around(arm, pose, next, accuracy, seed, kSecondStream, probe);
  if (!there.further) return std::nullopt;
  // A place where sets meet is known to half the digits or fewer: the other one is better.
  const auto clearness = [](const Around& place, Index dimension) {
    const Index across = place.sigma.size() - 1 - dimension;
    return across < 0 ? 0.0 : place.sigma[across];
  };
  const Index dimension = std::min(here.directions.cols(), there.directions.cols());
  const bool is_meeting = there.directions.cols() < here.directions.cols() ||
                          clearness(there, dimension) > 2 * clearness(here, dimension);
  SetBegin begin = is_meeting ? SetBegin{next, there.directions} : SetBegin{start, here.directions};
  // Places of a curve that is bent span two dimensions unless they are near. What is within an
  // accuracy tells nothing there.
  if (begin.ways.cols() > 1 && accuracy <= kReach) {
    const Around near =
        around(arm, pose, begin.place, accuracy, seed, kNearStream, kNearProbe * probe);
    if (near.further && near.directions.cols() < begin.ways.cols()) begin.ways = near.directions;
  }
  return begin;
}

/// Its places, in order.
SetPlaces trace_curve(const Arm& arm, const Eigen::Isometry3d& pose, const SetBegin& begin,
                      double accuracy, const StepLengths& lengths, TracedSet& traced) {
  const VectorXd direction = begin.ways.col(0);
  Way forth = follow(arm, pose, begin.place, direction, kMostSteps, accuracy, lengths);
  Way back;
  if (!forth.closes) {
    back = follow(arm, pose, begin.place, -direction, kMostSteps, accuracy, lengths);
  }
  SetPlaces places = std::move(forth.places);
  places.push_front(begin.place);
  std::move(back.places.begin(), back.places.end(), std::front_inserter(places));
  take(places, traced.motion.samples, traced.motion.misfit);
  traced.motion.closes = forth.closes;
  traced.is_whole = forth.is_whole && back.is_whole;
  return places;
}

/// Of 3^n - 1: along each of orthonormal columns, to both sides, and between them.
std::vector<VectorXd> all_sides(const MatrixXd& columns) {
  std::vector<VectorXd> sides{VectorXd::Zero(columns.rows())};
  for (Index k = 0; k < columns.cols(); ++k) {
    const std::size_t count = sides.size();
    for (const double sign : {-1.0, 1.0}) {
      for (std::size_t i = 0; i < count; ++i) sides.push_back(sides[i] + sign * columns.col(k));
    }
  }
  sides.erase(sides.begin());
  for (VectorXd& side : sides) side.normalize();
  return sides;
}

/// apart() is less, from the first joint on that tells.
bool is_nearer(const Arm& arm, const VectorXd& a, const VectorXd& b, double within) {
  double square = 0;
  for (Index k = 0; k < a.size() && square < within * within; ++k) {
    const double way = joint_way(arm, a, b, k);
    square += way * way;
  }
  return square < within * within;
}

/// To one side, as far as the set goes on, and no farther than so many steps.
SetPlace walk(const Arm& arm, const Eigen::Isometry3d& pose, SetPlace here,
              JointVector<double> side, double accuracy, double step, int most) {
  for (int k = 0; k < most; ++k) {
    auto next = moved(arm, pose, here, side, step, accuracy);
    if (!next) break;
    side = in_arms_lengths(arm, next->values - here.values).normalized();
    here = std::move(*next);
  }
  return here;
}

/// Places of the set, no nearer to each other than kApart steps; what can be walked to is no
/// farther from one of them, if they are all.
struct Cover {
  SetPlaces places;
  bool is_whole = true;
};

/// From each place to all sides, where none is yet. What moves the tip least is not the same
/// everywhere, and at a corner of what is open it leads out.
Cover cover_of(const Arm& arm, const Eigen::Isometry3d& pose, const SetPlace& begin,
               double accuracy, double step) {
  constexpr int kSteps = 5;
  constexpr double kLong = 3, kApart = 10;  // relative to a step
  Cover cover{{begin}};
  const auto is_covered = [&](const VectorXd& values) {
    return std::any_of(cover.places.begin(), cover.places.end(), [&](const SetPlace& place) {
      return is_nearer(arm, place.values, values, kApart * step);
    });
  };
  int ways = 0;
  for (std::size_t k = 0; k < cover.places.size(); ++k) {
    const SetPlace from = cover.places[k];
    for (const VectorXd& side : all_sides(still_directions(stretch_of(from)))) {
      const VectorXd ahead = kSteps * kLong * step * side;
      if (is_covered(from.values + in_joints<double>(arm, ahead))) continue;
      if (++ways > kMostWays) {
        cover.is_whole = false;
        return cover;
      }
      SetPlace end = walk(arm, pose, from, side, accuracy, kLong * step, kSteps);
      if (!is_covered(end.values)) cover.places.push_back(std::move(end));
    }
  }
  return cover;
}

/// Where closures of the arm are on a surface that is open within an accuracy only Newton's method
/// tells, from everywhere.
void trace_surface(const Cover& cover, TracedSet& traced) {
  SelfMotion& motion = traced.motion;
  take(cover.places, motion.samples, motion.misfit);
  traced.is_whole = cover.is_whole;
}

/// The directions in which its places lie: beside a curve along which the tip moves as little
/// across, walks come back to it, and all places are on a line.
MatrixXd directions_of(const Arm& arm, const Cover& cover) {
  std::vector<VectorXd> ways;
  for (std::size_t k = 1; k < cover.places.size(); ++k) {
    ways.push_back(in_arms_lengths(arm, cover.places[k].values - cover.places.front().values));
  }
  return ways.empty() ? MatrixXd() : span_of(ways);
}

double reach_of(const Arm& arm, const std::vector<VectorXd>& samples) {
  double reached = 0;
  for (const VectorXd& sample : samples) {
    reached = std::max(reached, apart(arm, sample, samples.front()));
  }
  return reached;
}

/// An accuracy lets the tip stand along many directions for a little; of the set are those that it
/// goes on in. A way may turn into another one: of the set are as many as the ends of ways span.
MatrixXd far_reaching(const Arm& arm, const Eigen::Isometry3d& pose, const SetBegin& begin,
                      double accuracy, double step) {
  constexpr int kSteps = 8;
  // Places that probes come to are joined by chords, under which the tip moves much more than under
  // tangents where they are bent.
  const MatrixXd ways = still_directions(stretch_of(begin.place));
  MatrixXd far(ways.rows(), 0);
  std::vector<VectorXd> gone;
  for (Index k = ways.cols() - 1; k >= 0; --k) {
    const SetPlace back = walk(arm, pose, begin.place, -ways.col(k), accuracy, step, kSteps);
    const SetPlace forth = walk(arm, pose, begin.place, ways.col(k), accuracy, step, kSteps);
    if (apart(arm, back.values, forth.values) < kShortestCurve * step) continue;
    gone.push_back(in_arms_lengths(arm, forth.values - back.values));
    far.conservativeResize(Eigen::NoChange, far.cols() + 1);
    far.rightCols(1) = ways.col(k);
  }
  if (gone.empty()) return far;
  const MatrixXd spanned = span_of(gone);
  if (spanned.cols() == far.cols()) return far;
  return spanned.cols() == 1 ? MatrixXd(far.leftCols(1)) : spanned;
}

/// A surface that is open within as much is reported there: it is followed once.
bool is_told_there(const Arm& arm, const std::vector<SelfMotion>& told, const SetBegin& begin,
                   double accuracy) {
  return std::any_of(told.begin(), told.end(), [&](const SelfMotion& set) {
    return set.dimension >= begin.ways.cols() && set.misfit <= kAsClear * accuracy &&
           is_on(arm, set, begin.place.values, kBesideSet);
  });
}

/// Of an arm of six joints or fewer the one direction along which the tip may stand within the
/// accuracy, where there is but one: over a probe others move it by clearly more, or, where the
/// accuracy is coarse, are none whose singular value is small.
std::optional<SetBegin> one_way(const Arm& arm, const Eigen::Isometry3d& pose, const VectorXd& from,
                                double accuracy) {
  constexpr Index kSix = 6;
  constexpr double kClearly = 4;
  if (from.size() > kSix) return std::nullopt;
  SetPlace place = place_at(arm, pose, from);
  const Screws<double>& screws = place.at.screws;
  const double may_stand = std::min(kMayStand * screws.norm(), kClearly * accuracy / kProbe);
  if (still_count(screws, may_stand) > 1) return std::nullopt;
  const VectorXd way = least_motion(screws).joints;
  return SetBegin{std::move(place), way};
}

/// Whether a curve that is reported may be there: it reaches kShortestCurve probes, half of that to
/// one side.
bool may_reach(const Arm& arm, const Eigen::Isometry3d& pose, const SetBegin& begin,
               double accuracy) {
  constexpr int kSteps = 3;
  constexpr double kNearlyHalf = 0.47 * kShortestCurve * kProbe, kClearly = 1.15;
  const auto reaches = [&](const VectorXd& side) {
    const double step = kNearlyHalf / kSteps;
    const SetPlace end = walk(arm, pose, begin.place, side, kClearly * accuracy, step, kSteps);
    return apart(arm, end.values, begin.place.values) > (kSteps - 0.5) * step;
  };
  const VectorXd way = begin.ways.col(0);
  return reaches(way) || reaches(-way);
}

/// `size`: of probes and steps, relative to the usual ones.
std::optional<TracedSet> trace_at_size(const Arm& arm, const Eigen::Isometry3d& pose,
                                       std::optional<SetBegin> begin, const SetSought& sought,
                                       double size, const std::vector<SelfMotion>& told) {
  constexpr double kLonger = 4;
  const double accuracy = sought.accuracy;
  const double probe = size * kProbe, step = size * kStep;
  if (!begin) return std::nullopt;
  if (begin->ways.cols() > 1 && accuracy > kReach) {
    begin->ways = far_reaching(arm, pose, *begin, accuracy, step);
    if (begin->ways.cols() == 0) return std::nullopt;
    const bool is_surface = begin->ways.cols() > 1;
    if (is_surface && is_told_there(arm, told, *begin, accuracy)) return std::nullopt;
  }
  std::optional<Cover> cover;
  if (begin->ways.cols() > 1) {
    cover = cover_of(arm, pose, begin->place, accuracy, step);
    const MatrixXd directions = directions_of(arm, *cover);
    if (directions.cols() == 1) begin->ways = directions;
  }
  TracedSet traced;
  SelfMotion& motion = traced.motion;
  motion.dimension = static_cast<int>(begin->ways.cols());
  motion.values = begin->place.values;
  motion.misfit = begin->place.residual;
  traced.accuracy = accuracy;
  if (motion.dimension == 1) {
    const bool may_be_longer = accuracy > kReach && !sought.for_closures;
    const StepLengths lengths{step, may_be_longer ? kLonger * step : step};
    traced.curve = trace_curve(arm, pose, *begin, accuracy, lengths, traced);
  } else {
    trace_surface(*cover, traced);
  }
  // A few steps are no set: closures that meet leave the accuracy behind as slowly.
  const double reached = reach_of(arm, motion.samples);
  const bool is_open = motion.dimension == 1 && !motion.closes;
  if (reached < (is_open ? kShortestCurve : kShortest) * probe) return std::nullopt;
  // A curve of postures ends nowhere: what is small and ends is near closures alone.
  if (size < 1 && !motion.closes && reached < kShortestCurve * kProbe) return std::nullopt;
  JointPlane plane = plane_of(arm, motion.samples, motion.dimension);
  motion.directions = begin->ways;
  for (Index k = 0; k < motion.directions.cols(); ++k) {
    VectorXd direction = in_joints<double>(arm, VectorXd(motion.directions.col(k)));
    // Where sets cross the directions at one place are of both.
    if (!plane.relations.empty()) direction = plane.along * (plane.along.transpose() * direction);
    motion.directions.col(k) = direction.normalized();
  }
  const Velocity6<double> least = least_moved(begin->place);
  motion.lost = {arm.length * least.head<3>(), least.tail<3>()};
  motion.relations = std::move(plane.relations);
  for (std::size_t k = 0; k < arm.joints.size(); ++k) {
    double& value = motion.values[static_cast<Index>(k)];
    if (!arm.joints[k].is_slide) value = reduced_turn(value);
  }
  return traced;
}

}  // namespace

bool has_ends(const SelfMotion& set) {
  return set.dimension == 1 && !set.closes && set.misfit > kRoundingError;
}

std::optional<TracedSet> trace_set(const Arm& arm, const Eigen::Isometry3d& pose,
                                   const VectorXd& from, const SetSought& sought,
                                   const std::vector<SelfMotion>& told) {
  const double accuracy = sought.accuracy;
  const auto traced_at = [&](double size, double open) {
    return trace_at_size(arm, pose, set_begin(arm, pose, from, open, size * kProbe, sought.seed),
                         {open, sought.seed, sought.for_closures}, size, told);
  };
  if (accuracy > kReach) {
    auto begin = one_way(arm, pose, from, accuracy);
    if (!begin) return traced_at(1, accuracy);
    if (!may_reach(arm, pose, *begin, accuracy)) return std::nullopt;
    // Within a coarse accuracy other directions may stand for a probe, too.
    const double moves_others = kMayStand * begin->place.at.screws.norm() * kProbe;
    if (accuracy > moves_others) return traced_at(1, accuracy);
    return trace_at_size(arm, pose, std::move(begin), sought, 1, told);
  }
  // The exact set may be small, as beside a stretched elbow. Where k closures meet the tip is
  // missed by the k-th power of the way: so near it must not be missed by as much.
  constexpr double kSmaller[] = {0.1, 0.01};
  auto traced = traced_at(1, accuracy);
  for (const double size : kSmaller) {
    if (!traced) traced = traced_at(size, size * accuracy);
  }
  return traced;
}

std::vector<VectorXd> closures_near(const Arm& arm, const Eigen::Isometry3d& pose,
                                    TracedSet&& traced) {
  const SelfMotion& motion = traced.motion;
  if (motion.misfit <= kReach && !has_ends(motion)) return {};
  if (motion.dimension > 1) return motion.samples;
  SetPlaces& places = traced.curve;
  for (std::size_t k = 0; motion.closes && k < 2; ++k) {
    places.push_back(again_after(arm, places.back(), places[k]));
  }
  return near_closures(arm, pose, places, traced.accuracy);
}

std::vector<TracedSet> trace_branches(const Arm& arm, const Eigen::Isometry3d& pose,
                                      const VectorXd& crossing, int weak, const SetSought& sought,
                                      const std::vector<SelfMotion>& told) {
  constexpr int kSteps = 8;
  const SetPlace place = place_at(arm, pose, crossing);
  const MatrixXd directions = stretch_of(place).V.rightCols(weak);
  std::vector<TracedSet> branches;
  for (std::uint64_t way = 0; way < kWays; ++way) {
    const VectorXd direction =
        random_unit_vector(directions, sought.seed, kThirdStream + way * kMostJoints);
    const Way gone = follow(arm, pose, place, direction, kSteps, sought.accuracy, {});
    if (gone.places.empty()) continue;
    const VectorXd& there = gone.places.back().values;
    if (apart(arm, there, crossing) < kShortestCurve * kProbe) continue;
    const bool is_known =
        std::any_of(branches.begin(), branches.end(), [&](const TracedSet& branch) {
          return is_on(arm, branch.motion, there, kNearProbe * kProbe);
        });
    if (is_known) continue;
    if (auto branch = trace_set(arm, pose, there, sought, told)) {
      branches.push_back(std::move(*branch));
    }
  }
  return branches;
}

}  // namespace moivre
