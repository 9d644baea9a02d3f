// SPDX-License-Identifier: MIT
// Vertices of parabolas through the distances of complex closures from real ones, solved one after another.
#include "short_branches.h"

#include <algorithm>
#include <limits>
#include <optional>

#include "near_real.h"

namespace moivre {
namespace {

// A parabola's vertex comes nearer by squares: what is not decided after these is a distance that stays at zero or noise.
constexpr int kMostProbes = 8;
// Of the motion's duration: nearer times tell nothing new.
constexpr double kSameProbe = 1e-9;
// Of the motion's duration: a branch that is shorter is no more than an instant, as far as its ends are known.
constexpr double kInstant = 1e-7;

/// The complex closures of a scene.
struct Slice {
  double time = 0;
  std::vector<ComplexPair> pairs;
};

/// `formulation`: at any time, since what mirrors what is always the same.
Slice slice_of(const Formulation& formulation, const Scene& scene) {
  return {scene.time, complex_pairs(formulation, scene.closures.solutions)};
}

/// Where a track is between its samples, roughly: the polynomial through them.
Eigen::VectorXd between(const Phi& phi, const std::vector<const BranchSample*>& samples,
                        double time) {
  const Eigen::VectorXd& base = samples.front()->q;
  Eigen::VectorXd there = base;
  for (const BranchSample* sample : samples) {
    double weight = 1;
    for (const BranchSample* other : samples) {
      if (other != sample) weight *= (time - other->time) / (sample->time - other->time);
    }
    there += weight * phi.canonical(sample->q - base);
  }
  return there;
}

/// The closure that is nearer by far than any other to where a track is, which is the track's.
std::optional<std::size_t> closure_of(const MotionRun& run, const Eigen::VectorXd& there,
                                      const Scene& scene) {
  constexpr double kByFar = 0.1;
  const auto& closures = scene.closures.closures;
  std::optional<std::size_t> nearest;
  double least = std::numeric_limits<double>::infinity();
  double next = least;
  for (std::size_t j = 0; j < closures.size(); ++j) {
    const double gap = distance(run.phi, there, closures[j].q);
    if (gap < least) nearest = j;
    next = std::min(next, std::max(gap, least));
    least = std::min(gap, least);
  }
  return least < kByFar * next ? nearest : std::nullopt;
}

/// For each closure how many tracks pass by it, as far as that is clear.
std::vector<int> passing_tracks(const MotionRun& run, const Scene& scene) {
  std::vector<int> count(scene.closures.closures.size());
  const auto& times = run.times.all;
  const auto after = std::upper_bound(times.begin(), times.end(), scene.time);
  if (after == times.begin() || after == times.end()) return count;
  // Two before and two behind, where there are so many.
  const auto first = std::max(times.begin() + 2, after) - 2;
  const auto last = std::min(times.end() - 2, after) + 2;
  for (const Track& track : run.tracks) {
    if (track.at(*(after - 1)) == nullptr || track.at(*after) == nullptr) continue;
    std::vector<const BranchSample*> samples;
    for (auto time = first; time != last; ++time) {
      if (const BranchSample* sample = track.at(*time)) samples.push_back(sample);
    }
    const Eigen::VectorXd there = between(run.phi, samples, scene.time);
    if (const auto closure = closure_of(run, there, scene)) ++count[*closure];
  }
  return count;
}

/// Whether a track that lives between the scenes only is there already.
bool is_followed(const MotionRun& run, double time, double before, double after) {
  return std::any_of(run.tracks.begin(), run.tracks.end(), [&](const Track& track) {
    const bool is_short = track.begins() > before && track.ends() < after;
    return is_short && track.begins() <= time && time <= track.ends();
  });
}

/// Takes the new point up among three, by time, round the least of all four.
std::array<DistanceFromReal, 3> narrowed(const std::array<DistanceFromReal, 3>& points,
                                         const DistanceFromReal& point) {
  std::array<DistanceFromReal, 4> all{points[0], points[1], points[2], point};
  std::sort(all.begin(), all.end(),
            [](const DistanceFromReal& a, const DistanceFromReal& b) { return a.time < b.time; });
  const auto least = std::min_element(
      all.begin() + 1, all.end() - 1,
      [](const DistanceFromReal& a, const DistanceFromReal& b) { return a.square < b.square; });
  return {*(least - 1), *least, *(least + 1)};
}

/// Seeks real closures between three scenes.
class Probe {
 public:
  Probe(MotionRun& run, const Tracker& tracker, ShortBranches& result,
        const Formulation& formulation, const Slice& before, const Slice& at, const Slice& after)
      : run_(run),
        tracker_(tracker),
        result_(result),
        formulation_(formulation),
        before_(before),
        at_(at),
        after_(after) {}

  void seek_all() {
    for (const ComplexPair& pair : at_.pairs) seek(pair);
  }

 private:
  void seek(const ComplexPair& pair);
  void follow(const Scene& scene);
  bool is_known(double time, const std::array<DistanceFromReal, 3>& points) const;

  MotionRun& run_;
  const Tracker& tracker_;
  ShortBranches& result_;
  const Formulation& formulation_;
  const Slice& before_;
  const Slice& at_;
  const Slice& after_;
};

bool Probe::is_known(double time, const std::array<DistanceFromReal, 3>& points) const {
  const double duration = run_.times.to - run_.times.from;
  const auto is_old = [&](const DistanceFromReal& point) {
    return std::abs(point.time - time) <= kSameProbe * duration;
  };
  const auto is_instant = [&](double instant) {
    return std::abs(instant - time) <= kInstant * duration;
  };
  return is_followed(run_, time, before_.time, after_.time) ||
         std::any_of(points.begin(), points.end(), is_old) ||
         std::any_of(result_.instants.begin(), result_.instants.end(), is_instant);
}

void Probe::follow(const Scene& scene) {
  const double instant = kInstant * (run_.times.to - run_.times.from);
  bool is_instant = false;
  const std::vector<int> passing = passing_tracks(run_, scene);
  for (std::size_t j = 0; j < passing.size(); ++j) {
    if (passing[j] == 1) continue;
    const BranchPose pose{scene.time, scene.closures.closures[j].q};
    if (run_.follower.reaches(pose, after_.time) || run_.follower.reaches(pose, before_.time)) {
      continue;
    }
    Track track = run_.follower.follow(pose);
    if (track.begins() <= before_.time || track.ends() >= after_.time) continue;
    if (track.ends() - track.begins() > instant) {
      run_.tracks.push_back(std::move(track));
    } else {
      is_instant = true;
    }
  }
  if (is_instant) result_.instants.push_back(scene.time);
}

void Probe::seek(const ComplexPair& pair) {
  const ComplexPair* earlier = nearest_pair(before_.pairs, pair.x);
  const ComplexPair* later = nearest_pair(after_.pairs, pair.x);
  if (earlier == nullptr || later == nullptr) return;
  std::array<DistanceFromReal, 3> points{
      {{before_.time, earlier->square}, {at_.time, pair.square}, {after_.time, later->square}}};
  Point x = pair.x;
  for (int k = 0; k < kMostProbes && !run_.stop; ++k) {
    const auto time = time_near_real(points);
    if (!time || is_known(*time, points)) return;
    result_.solved.push_back(solve_scene(run_, tracker_, *time));
    const Slice slice = slice_of(formulation_, result_.solved.back());
    if (slice.pairs.size() < at_.pairs.size()) return follow(result_.solved.back());
    const ComplexPair* nearest = nearest_pair(slice.pairs, x);
    x = nearest->x;
    points = narrowed(points, {*time, nearest->square});
  }
}

}  // namespace

ShortBranches follow_short_branches(MotionRun& run, const Tracker& tracker,
                                    const std::vector<Scene>& scenes) {
  std::vector<Slice> slices;
  ShortBranches result;
  if (scenes.empty()) return result;
  const Formulation formulation = formulate(run.mechanism, scenes.front().time);
  for (const Scene& scene : scenes) slices.push_back(slice_of(formulation, scene));
  for (std::size_t k = 1; k + 1 < slices.size(); ++k) {
    Probe(run, tracker, result, formulation, slices[k - 1], slices[k], slices[k + 1]).seek_all();
  }
  return result;
}

}  // namespace moivre
