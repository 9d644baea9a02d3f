// SPDX-License-Identifier: MIT
// From closures at checkpoints to branches: tracks, their agreement with the closures, partners at dead points, events.
#include "moivre/closures/motion.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include "closure_id.h"
#include "moivre/kinematics/newton.h"
#include "track.h"

namespace moivre {
namespace {

// Tracks and closures are both corrected to rounding, unless the pose is nearly singular.
constexpr double kSamePose = 1e-6;
// Poses where branches meet are known to the root of that.
constexpr double kSamePlace = 1e-3;
// Of the motion's duration: events nearer than this to each other, or to a checkpoint, may be one.
constexpr double kSameTime = 1e-7;
// Each round follows with a quarter of the step.
constexpr int kMaximumRetracks = 4;
// Between two checkpoints, where closures are complex and a branch could begin and end: closures are solved so often.
constexpr int kFiner = 16;
// More samples than a plot shows, or a table is read by, only cost memory.
constexpr int kMostSamples = 1000000;
// New tracks bring new partners and new conflicts; each round settles all it sees.
constexpr int kRounds = 20;

using Seconds = std::chrono::duration<double>;

/// from + k (to - from) / steps.
std::vector<double> even_times(const MotionOptions& options, int steps) {
  std::vector<double> times;
  for (int k = 0; k <= steps; ++k) {
    times.push_back(options.from + (options.to - options.from) * k / steps);
  }
  times.back() = options.to;
  return times;
}

/// Both, ascending; what is the same but for rounding once, as in `a`.
std::vector<double> merged(const std::vector<double>& a, const std::vector<double>& b) {
  constexpr double kRounding = 1e-12;
  const double width = kRounding * (a.back() - a.front());
  std::vector<double> all = a;
  for (const double time : b) {
    const auto next = std::lower_bound(a.begin(), a.end(), time - width);
    if (next == a.end() || *next > time + width) all.push_back(time);
  }
  std::sort(all.begin(), all.end());
  return all;
}

void require_valid(const Mechanism& mechanism, const MotionOptions& options) {
  std::string broken;
  for (const std::string& rule : validate(options)) broken += (broken.empty() ? "" : "; ") + rule;
  if (!broken.empty()) throw std::invalid_argument(broken);
  for (const double time : {options.from, options.to}) require_drivers(mechanism, time);
}

std::string at_time(double time) { return "at t = " + std::to_string(time) + " s"; }

/// Velocities are for the samples; where closures may be compared poses do.
BranchOptions with_velocities_at(const std::vector<double>& times, BranchOptions options) {
  options.velocity_times = times;
  return options;
}

/// What is common to motions with and without closures: tracks become branches, their ends become events.
class Motion {
 public:
  Motion(const Mechanism& mechanism, const MotionOptions& options, int checkpoints,
         const std::atomic<bool>& stop)
      : mechanism_(mechanism),
        options_(options),
        stop_(stop),
        phi_(mechanism),
        times_(even_times(options, options.steps)),
        all_times_(checkpoints == 0 ? times_
                                    : merged(times_, even_times(options, checkpoints * kFiner))),
        follower_{mechanism_, all_times_, with_velocities_at(times_, options_.branch),
                  options_.follow, stop_} {
    result_.from = options.from;
    result_.to = options.to;
    result_.times = times_;
    result_.seed = options.solve.seed;
  }

 protected:
  double same_time() const { return kSameTime * std::abs(options_.to - options_.from); }
  bool is_same_event(const BranchEvent& a, const BranchEvent& b) const;
  bool is_at(const BranchEvent& event, double time, const Eigen::VectorXd& q,
             double uncertainty = 0) const;
  void show_progress(double share) const {
    if (options_.progress) options_.progress(share);
  }
  void name_tracks();
  void take_track(const Track& track);
  std::size_t event_index(const BranchEvent& event);
  void order_events();

  const Mechanism& mechanism_;
  const MotionOptions& options_;
  const std::atomic<bool>& stop_;
  const Phi phi_;
  const std::vector<double> times_;      ///< of the samples
  const std::vector<double> all_times_;  ///< of possible checkpoints too
  const TrackFollower follower_;
  std::vector<Track> tracks_;
  MotionResult result_;
};

/// Whether the event is at that pose, as far as both are known. A pose moves with the root of the time beside a dead point.
bool Motion::is_at(const BranchEvent& event, double time, const Eigen::VectorXd& q,
                   double uncertainty) const {
  const double doubt = event.uncertainty + uncertainty;
  const double place = std::sqrt(doubt / std::abs(options_.to - options_.from));
  return std::abs(event.time - time) <= std::max(same_time(), doubt) &&
         distance(phi_, event.q, q) <= std::max(kSamePlace, place);
}

bool Motion::is_same_event(const BranchEvent& a, const BranchEvent& b) const {
  return a.kind == b.kind && is_at(a, b.time, b.q, b.uncertainty);
}

std::size_t Motion::event_index(const BranchEvent& event) {
  for (std::size_t k = 0; k < result_.events.size(); ++k) {
    BranchEvent& known = result_.events[k].at;
    if (!is_same_event(known, event)) continue;
    if (event.uncertainty < known.uncertainty) {
      known = event;
      result_.events[k].drivers = driver_values(mechanism_, event.time);
    }
    return k;
  }
  result_.events.push_back({event, driver_values(mechanism_, event.time), {}, {}});
  return result_.events.size() - 1;
}

/// Tracks that begin at `from` keep their order, the others follow by where they begin.
void Motion::name_tracks() {
  std::stable_sort(tracks_.begin(), tracks_.end(), [](const Track& a, const Track& b) {
    if (a.is_from_start != b.is_from_start) return a.is_from_start;
    return !a.is_from_start && a.begins() < b.begins();
  });
}

void Motion::take_track(const Track& track) {
  MotionBranch branch;
  branch.id = closure_id(result_.branches.size());
  branch.begins = track.begins();
  branch.ends = track.ends();
  branch.steps = track.steps();
  branch.retracked = track.retracked;
  const auto is_wanted = [&](const BranchSample& sample) {
    return std::binary_search(times_.begin(), times_.end(), sample.time);
  };
  for (std::size_t k = track.backwards.samples.size(); k-- > 1;) {
    if (is_wanted(track.backwards.samples[k])) branch.samples.push_back(track.backwards.samples[k]);
  }
  for (const BranchSample& sample : track.forwards.samples) {
    if (is_wanted(sample)) branch.samples.push_back(sample);
  }
  if (track.backwards.event) {
    branch.begin_event = event_index(*track.backwards.event);
    result_.events[*branch.begin_event].beginning.push_back(branch.id);
  }
  if (track.forwards.event) {
    branch.end_event = event_index(*track.forwards.event);
    result_.events[*branch.end_event].ending.push_back(branch.id);
  }
  const auto is_decided = [](const Branch& way) {
    return way.status == BranchStatus::reached || way.status == BranchStatus::ended;
  };
  branch.complete = is_decided(track.forwards) && is_decided(track.backwards);
  branch.message = track.forwards.message;
  for (const Branch* way : {&track.backwards, &track.forwards}) {
    if (way->status == BranchStatus::failed) {
      result_.failures.push_back("branch " + branch.id + " " +
                                 at_time(way == &track.forwards ? branch.ends : branch.begins) +
                                 ": " + way->message);
    }
  }
  result_.steps += track.steps();
  result_.rejected += track.rejected();
  result_.branches.push_back(std::move(branch));
}

void Motion::order_events() {
  std::vector<std::size_t> order(result_.events.size());
  for (std::size_t k = 0; k < order.size(); ++k) order[k] = k;
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return result_.events[a].at.time < result_.events[b].at.time;
  });
  std::vector<MotionEvent> sorted;
  std::vector<std::size_t> place(order.size());
  for (std::size_t k = 0; k < order.size(); ++k) {
    place[order[k]] = k;
    sorted.push_back(std::move(result_.events[order[k]]));
  }
  result_.events = std::move(sorted);
  for (MotionBranch& branch : result_.branches) {
    if (branch.begin_event) branch.begin_event = place[*branch.begin_event];
    if (branch.end_event) branch.end_event = place[*branch.end_event];
  }
}

/// The closures of a checkpoint and which track is at each.
struct Scene {
  double time = 0;
  ClosureResult closures;
  std::vector<std::optional<std::size_t>> track_of;  ///< one a closure
};

class ClosureMotion : Motion {
 public:
  ClosureMotion(const Mechanism& mechanism, const Tracker& tracker, const MotionOptions& options,
                const std::atomic<bool>& stop)
      : Motion(mechanism, options, options.checkpoints, stop), tracker_(tracker) {}

  MotionResult run();

 private:
  Scene solve(double time, std::uint64_t seed);
  double grid_time(int k) const;
  void solve_scenes();
  bool is_filled(const Scene& a, const Scene& b) const;
  bool look_closer();
  void begin_tracks();
  void reconcile();
  std::optional<std::pair<std::size_t, std::size_t>> match(Scene& scene) const;
  bool settle(Scene& scene);
  bool is_same_all_along(const Track& a, const Track& b) const;
  bool part(std::size_t first, std::size_t second);
  bool is_event_of_a_track(double time, const Eigen::VectorXd& q) const;
  bool add_partners();
  bool leads_back(const Track& track, bool is_forwards) const;
  bool verify();
  void check(const Scene& scene);
  void conclude();

  const Tracker& tracker_;
  std::vector<Scene> scenes_;
};

Scene ClosureMotion::solve(double time, std::uint64_t seed) {
  ClosureOptions options;
  options.time = time;
  options.solve = options_.solve;
  options.solve.seed = seed;
  Scene scene;
  scene.time = time;
  scene.closures = find_closures(mechanism_, tracker_, options, stop_);
  scene.track_of.resize(scene.closures.closures.size());
  result_.paths += scene.closures.paths;
  result_.time_s.threads = std::max(result_.time_s.threads, scene.closures.time_s.threads);
  return scene;
}

/// The possible checkpoint number `k` of checkpoints x kFiner, as it stands in all_times_.
double ClosureMotion::grid_time(int k) const {
  const double even = options_.from + (options_.to - options_.from) * k /
                                          std::max(1, options_.checkpoints * kFiner);
  return *std::min_element(all_times_.begin(), all_times_.end(), [&](double a, double b) {
    return std::abs(a - even) < std::abs(b - even);
  });
}

void ClosureMotion::solve_scenes() {
  for (int c = 0; c <= options_.checkpoints && !stop_; ++c) {
    scenes_.push_back(solve(grid_time(c * kFiner), options_.solve.seed));
    // Half of the bar for the closures, half for the branches.
    show_progress(0.5 * (c + 1) / (options_.checkpoints + 1));
  }
}

/// Whether every closure, complex ones too, is on a track from `a` to `b`: none is left from which a branch could begin.
bool ClosureMotion::is_filled(const Scene& a, const Scene& b) const {
  std::uint64_t whole = 0;
  for (const Track& track : tracks_) whole += track.at(a.time) && track.at(b.time) ? 1 : 0;
  return whole >= a.closures.counts.complex && whole >= b.closures.counts.complex;
}

/// Solves closures in between where a branch could begin and end unseen. True when there was such a place.
bool ClosureMotion::look_closer() {
  if (mechanism_.drivers.empty() || scenes_.empty()) return false;
  std::vector<Scene> all;
  for (std::size_t c = 0; c < scenes_.size(); ++c) {
    if (c > 0 && !is_filled(scenes_[c - 1], scenes_[c])) {
      for (int k = 1; k < kFiner && !stop_; ++k) {
        all.push_back(solve(grid_time(static_cast<int>(c - 1) * kFiner + k), options_.solve.seed));
      }
    }
    all.push_back(scenes_[c]);
  }
  const bool is_new = all.size() > scenes_.size();
  scenes_ = std::move(all);
  return is_new;
}

void ClosureMotion::begin_tracks() {
  if (scenes_.empty()) return;
  const auto& closures = scenes_.front().closures.closures;
  for (const Closure& closure : closures) {
    if (stop_) return;
    tracks_.push_back(follower_.follow({scenes_.front().time, closure.q}));
    show_progress(0.5 +
                  0.5 * static_cast<double>(tracks_.size()) / static_cast<double>(closures.size()));
  }
}

bool ClosureMotion::is_event_of_a_track(double time, const Eigen::VectorXd& q) const {
  return std::any_of(tracks_.begin(), tracks_.end(), [&](const Track& track) {
    for (const Branch* way : {&track.forwards, &track.backwards}) {
      if (way->event && is_at(*way->event, time, q)) return true;
    }
    return false;
  });
}

bool ClosureMotion::is_same_all_along(const Track& a, const Track& b) const {
  return std::all_of(scenes_.begin(), scenes_.end(), [&](const Scene& scene) {
    const BranchSample* of_a = a.at(scene.time);
    const BranchSample* of_b = b.at(scene.time);
    if (of_a == nullptr || of_b == nullptr) return of_a == of_b;
    return distance(phi_, of_a->q, of_b->q) <= kSamePose;
  });
}

/// Two tracks at one closure: the younger goes where it is a copy, else both are followed again with shorter steps.
/// False when nothing more can be done.
bool ClosureMotion::part(std::size_t first, std::size_t second) {
  if (!tracks_[second].is_from_start && is_same_all_along(tracks_[first], tracks_[second])) {
    tracks_.erase(tracks_.begin() + static_cast<std::ptrdiff_t>(second));
    return true;
  }
  if (tracks_[second].retracked >= kMaximumRetracks) return false;
  follower_.follow_again(tracks_[first]);
  follower_.follow_again(tracks_[second]);
  return true;
}

/// Which track is at each closure; two that are at one are returned, the older first.
std::optional<std::pair<std::size_t, std::size_t>> ClosureMotion::match(Scene& scene) const {
  const auto& closures = scene.closures.closures;
  std::optional<std::pair<std::size_t, std::size_t>> conflict;
  std::fill(scene.track_of.begin(), scene.track_of.end(), std::nullopt);
  for (std::size_t k = 0; k < tracks_.size(); ++k) {
    const BranchSample* sample = tracks_[k].at(scene.time);
    if (sample == nullptr) continue;
    std::optional<std::size_t> nearest;
    double least = kSamePose;
    for (std::size_t j = 0; j < closures.size(); ++j) {
      const double gap = distance(phi_, sample->q, closures[j].q);
      if (gap > least) continue;
      least = gap;
      nearest = j;
    }
    if (!nearest) continue;
    auto& owner = scene.track_of[*nearest];
    if (!owner) {
      owner = k;
    } else if (!conflict) {
      conflict = {*owner, k};
    }
  }
  return conflict;
}

/// True when a track was changed or added, so that the checkpoints want another look.
bool ClosureMotion::settle(Scene& scene) {
  const auto conflict = match(scene);
  if (conflict && part(conflict->first, conflict->second)) return true;
  for (std::size_t j = 0; j < scene.track_of.size() && !stop_; ++j) {
    const Eigen::VectorXd& q = scene.closures.closures[j].q;
    if (scene.track_of[j] || is_event_of_a_track(scene.time, q)) continue;
    tracks_.push_back(follower_.follow({scene.time, q}));
    return true;
  }
  return false;
}

/// A branch that meets another at its dead point may live between two checkpoints only.
bool ClosureMotion::add_partners() {
  for (std::size_t k = 0; k < tracks_.size() && !stop_; ++k) {
    for (const bool is_forwards : {true, false}) {
      const Branch& way = is_forwards ? tracks_[k].forwards : tracks_[k].backwards;
      if (!way.event || !way.beyond) continue;
      const BranchPose beyond = *way.beyond;
      if (!(beyond.time > options_.from && beyond.time < options_.to)) continue;
      const BranchEvent event = *way.event;
      const bool is_met = std::any_of(tracks_.begin(), tracks_.end(), [&](const Track& other) {
        const Branch& its_way = is_forwards ? other.forwards : other.backwards;
        return &other != &tracks_[k] && its_way.event && is_same_event(*its_way.event, event);
      });
      if (is_met) continue;
      tracks_.push_back(follower_.follow(beyond));
      return true;
    }
  }
  return false;
}

/// Whether the way back, from the closure that was solved at the track's last checkpoint, is the way there.
bool ClosureMotion::leads_back(const Track& track, bool is_forwards) const {
  std::vector<double> backs{track.anchor.time};
  const Scene* last = nullptr;
  for (const Scene& scene : scenes_) {
    const bool is_on_the_way =
        is_forwards ? scene.time > track.anchor.time : scene.time < track.anchor.time;
    const BranchSample* sample = track.at(scene.time);
    if (!is_on_the_way || sample == nullptr || !sample->is_determined) continue;
    if (last == nullptr || is_forwards) last = &scene;
    if (is_forwards) {
      backs.insert(backs.begin(), scene.time);
    } else {
      backs.insert(backs.end() - 1, scene.time);
    }
  }
  if (last == nullptr) return true;
  const Eigen::VectorXd* start = nullptr;
  for (const Closure& closure : last->closures.closures) {
    if (distance(phi_, closure.q, track.at(last->time)->q) <= kSamePose) start = &closure.q;
  }
  if (start == nullptr) return true;
  const Branch back = follower_.follow_back({last->time, *start}, backs, track);
  if (back.samples.size() != backs.size()) return stop_;
  return std::all_of(back.samples.begin(), back.samples.end(), [&](const BranchSample& sample) {
    const BranchSample* there = track.at(sample.time);
    return there != nullptr && distance(phi_, sample.q, there->q) <= kSamePose;
  });
}

/// Follows tracks back; those that do not lead back are followed again. True when there were such.
bool ClosureMotion::verify() {
  bool is_changed = false;
  for (Track& track : tracks_) {
    if (track.is_verified || track.retracked > kMaximumRetracks || stop_) continue;
    if (leads_back(track, true) && leads_back(track, false)) {
      track.is_verified = true;
      continue;
    }
    follower_.follow_again(track);
    is_changed = true;
  }
  return is_changed;
}

void ClosureMotion::reconcile() {
  for (int round = 0; round < kRounds * static_cast<int>(1 + tracks_.size()) && !stop_; ++round) {
    bool is_settled = true;
    for (Scene& scene : scenes_) is_settled = is_settled && !settle(scene);
    if (is_settled) is_settled = !add_partners();
    if (is_settled) is_settled = !verify();
    if (is_settled) return;
  }
}

MotionResult ClosureMotion::run() {
  const auto begin = std::chrono::steady_clock::now();
  result_.tracker = tracker_.kind();
  result_.tracker_options = tracker_.options_in_force();
  solve_scenes();
  result_.time_s.track = Seconds(std::chrono::steady_clock::now() - begin).count();
  begin_tracks();
  reconcile();
  if (look_closer()) reconcile();
  name_tracks();
  for (Scene& scene : scenes_) match(scene);
  for (const Track& track : tracks_) take_track(track);
  for (const Scene& scene : scenes_) check(scene);
  for (std::size_t k = 0; k < tracks_.size() && !stop_; ++k) {
    if (tracks_[k].is_verified) continue;
    result_.failures.push_back("branch " + result_.branches[k].id +
                               ": followed back from its last checkpoint it takes another way");
  }
  order_events();
  conclude();
  result_.time_s.total = Seconds(std::chrono::steady_clock::now() - begin).count();
  return std::move(result_);
}

/// The checkpoint's row, and what does not agree.
void ClosureMotion::check(const Scene& scene) {
  Checkpoint row;
  row.time = scene.time;
  row.drivers = driver_values(mechanism_, scene.time);
  row.counts = scene.closures.counts;
  row.paths = scene.closures.paths;
  row.agrees = scene.closures.complete;
  row.message = scene.closures.message;
  std::size_t matched = 0;
  for (std::size_t j = 0; j < scene.track_of.size(); ++j) {
    const auto& owner = scene.track_of[j];
    row.branches.push_back(owner ? result_.branches[*owner].id : "");
    matched += owner ? 1 : 0;
    if (owner || is_event_of_a_track(scene.time, scene.closures.closures[j].q)) continue;
    row.agrees = false;
    result_.failures.push_back("closure " + scene.closures.closures[j].id + " " +
                               at_time(scene.time) + " is on no branch");
  }
  std::size_t present = 0;
  for (std::size_t k = 0; k < tracks_.size(); ++k) {
    if (tracks_[k].at(scene.time) == nullptr) continue;
    ++present;
    const bool is_found =
        std::find(scene.track_of.begin(), scene.track_of.end(), k) != scene.track_of.end();
    if (is_found || scene.closures.moves) continue;
    row.agrees = false;
    result_.failures.push_back("branch " + result_.branches[k].id + " " + at_time(scene.time) +
                               " is at no closure of its own that was found there");
  }
  if (row.agrees) {
    row.message = "one to one: " + std::to_string(matched) + " closures, " +
                  std::to_string(present) + " branches";
  } else if (!scene.closures.complete) {
    result_.failures.push_back("closures " + at_time(scene.time) + ": " + scene.closures.message);
  }
  result_.checkpoints.push_back(std::move(row));
}

void ClosureMotion::conclude() {
  const bool is_whole = std::all_of(result_.branches.begin(), result_.branches.end(),
                                    [](const MotionBranch& branch) { return branch.complete; });
  result_.complete = is_whole && result_.failures.empty() && !stop_;
  const Scene* start = scenes_.empty() ? nullptr : &scenes_.front();
  if (stop_) {
    result_.message = "interrupted: what is finished is reported";
  } else if (!result_.complete) {
    result_.message = "not everything was decided: see failures";
  } else if (start != nullptr && start->closures.moves) {
    result_.message = start->closures.message;
  } else if (result_.branches.empty()) {
    result_.message = "cannot be assembled at any checkpoint";
  } else {
    result_.message = "every branch was followed to an event or to the end";
  }
  if (options_.checkpoints > 0) {
    result_.left_out.push_back(
        {"branches that begin and end between two checkpoints and meet no other",
         "closures are solved at checkpoints, and 16 times as often where some are complex"});
    static_assert(kFiner == 16, "update the sentence above");
  } else {
    result_.left_out.push_back({"checkpoints",
                                "none were asked for: branches that begin later are "
                                "not seen, and an exchange would not be"});
  }
}

class GuessMotion : Motion {
 public:
  GuessMotion(const Mechanism& mechanism, const MotionOptions& options,
              const std::atomic<bool>& stop)
      : Motion(mechanism, options, 0, stop) {}
  MotionResult run(const std::vector<Eigen::VectorXd>& guesses);

 private:
  void begin_track(const Eigen::VectorXd& guess, std::size_t number);
};

void GuessMotion::begin_track(const Eigen::VectorXd& guess, std::size_t number) {
  const NewtonResult assembled = newton(phi_, guess, options_.from);
  const std::string name = "guess " + std::to_string(number);
  if (assembled.status != NewtonStatus::converged) {
    result_.failures.push_back(name + ": Newton-Raphson " + assembled.message);
    return;
  }
  for (const Track& track : tracks_) {
    if (distance(phi_, track.anchor.q, assembled.q) > kSamePose) continue;
    result_.left_out.push_back({name, "it assembles where an earlier guess does"});
    return;
  }
  tracks_.push_back(follower_.follow({options_.from, phi_.canonical(assembled.q)}));
}

MotionResult GuessMotion::run(const std::vector<Eigen::VectorXd>& guesses) {
  const auto begin = std::chrono::steady_clock::now();
  for (std::size_t k = 0; k < guesses.size() && !stop_; ++k) {
    begin_track(guesses[k], k + 1);
    show_progress(static_cast<double>(k + 1) / static_cast<double>(guesses.size()));
  }
  for (const Track& track : tracks_) take_track(track);
  order_events();
  result_.complete = !stop_ && result_.failures.empty() &&
                     std::all_of(result_.branches.begin(), result_.branches.end(),
                                 [](const MotionBranch& branch) { return branch.complete; });
  result_.message = stop_              ? "interrupted: what is finished is reported"
                    : result_.complete ? "every branch was followed to an event or to the end"
                                       : "not everything was decided: see failures";
  result_.left_out.push_back({"closures and checkpoints",
                              "the motion was asked for from guesses: no polynomials were solved"});
  result_.time_s.total = Seconds(std::chrono::steady_clock::now() - begin).count();
  return std::move(result_);
}

}  // namespace

std::vector<std::string> validate(const MotionOptions& options) {
  std::vector<std::string> broken;
  if (!std::isfinite(options.from) || !std::isfinite(options.to) || !(options.to > options.from)) {
    broken.emplace_back("`to` must be later than `from`, both finite");
  }
  if (options.steps < 1 || options.steps > kMostSamples) {
    broken.emplace_back("`steps` must lie between 1 and a million");
  }
  if (options.checkpoints < 0 || options.checkpoints > kMostSamples) {
    broken.emplace_back("`checkpoints` must lie between 0 and a million");
  }
  return broken;
}

std::vector<double> driver_values(const Mechanism& mechanism, double time) {
  std::vector<double> values;
  for (const Driver& driver : mechanism.drivers) {
    values.push_back(driver_state(driver.law, time).value);
  }
  return values;
}

double natural_duration(const Mechanism& mechanism, double from) {
  constexpr double kTurn = 2 * std::numbers::pi;
  for (const Driver& driver : mechanism.drivers) {
    if (const auto* spline = std::get_if<Spline>(&driver.law)) {
      if (spline->t.back() > from) return spline->t.back() - from;
    }
    const bool is_angle =
        driver.kind == DriverKind::angle ||
        (driver.kind == DriverKind::unknown && mechanism.unknowns[driver.unknown].is_angle);
    const auto* parabola = std::get_if<Parabola>(&driver.law);
    if (!is_angle || parabola == nullptr) continue;
    const double velocity = parabola->velocity + parabola->acceleration * from;
    const double acceleration = parabola->acceleration * (velocity < 0 ? -1 : 1);
    // |velocity| d + acceleration d^2 / 2 = a turn, in the form that does not cancel.
    const double square = velocity * velocity + 2 * acceleration * kTurn;
    if (square < 0) continue;
    const double sum = std::abs(velocity) + std::sqrt(square);
    if (sum > 0) return 2 * kTurn / sum;
  }
  return 1;
}

MotionResult find_motion(const Mechanism& mechanism, const Tracker& tracker,
                         const MotionOptions& options, const std::atomic<bool>& stop) {
  require_valid(mechanism, options);
  return ClosureMotion(mechanism, tracker, options, stop).run();
}

MotionResult follow_guesses(const Mechanism& mechanism, const std::vector<Eigen::VectorXd>& guesses,
                            const MotionOptions& options, const std::atomic<bool>& stop) {
  require_valid(mechanism, options);
  return GuessMotion(mechanism, options, stop).run(guesses);
}

}  // namespace moivre
