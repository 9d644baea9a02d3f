// SPDX-License-Identifier: MIT
// Pairs of checkpoints, followed once each, and the times that part the motion.
#include "pair_search.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

#include "moivre/closures/same_pose.h"
#include "moivre/closures/stages.h"
#include "moivre/formulation/exact.h"
#include "moivre/kinematics/state.h"
#include "moivre/mechanism/pose.h"
#include "moivre/numeric/near_points.h"
#include "reconcile.h"

namespace moivre {
namespace {

// Of a stretch: no mechanism is symmetric about this place.
constexpr double kWithin = 0.4472;
// Another place of the same stretch for each further checkpoint: by the golden section no two are
// near each other.
constexpr double kGolden = 0.6180339887498949;
constexpr int kMostTries = 5;
// Of the motion: what is lost sooner shows nothing of the times beside a checkpoint.
constexpr double kLostAtOnce = 1e-3;
// Values of one pair that were found twice, in units.
constexpr double kSamePair = 1e-6;

/// Times at which the formulations are looked at anew: drivers move smoothly between.
std::vector<double> knots(const MotionRun& run) {
  constexpr int kFewest = 4;
  const int count = std::max(kFewest, std::min(run.options.checkpoints, 16));
  std::vector<double> times;
  for (int k = 0; k <= count; ++k) {
    times.push_back(run.options.from + (run.options.to - run.options.from) * k / count);
  }
  return times;
}

const BranchPose& nearest(const Phi& phi, const std::vector<BranchPose>& poses,
                          const BranchPose& to) {
  return *std::min_element(poses.begin(), poses.end(),
                           [&](const BranchPose& a, const BranchPose& b) {
                             return distance(phi, a.q, to.q) < distance(phi, b.q, to.q);
                           });
}

}  // namespace

Track brief_track(const Phi& phi, const BranchPose& begin, const BranchPose& pose,
                  const BranchPose& end) {
  const MotionState state = motion_state(phi, pose.q, pose.time);
  Track track;
  track.anchor = pose;
  track.is_simple = true;
  for (const bool is_forwards : {true, false}) {
    const BranchPose& last = is_forwards ? end : begin;
    BranchEvent event;
    event.time = last.time;
    event.q = last.q;
    Branch way;
    way.status = BranchStatus::ended;
    way.message = to_string(event.kind);
    way.samples.push_back({pose.time, pose.q, state.velocity, state.acceleration,
                           residual_by_size(phi, pose.q, pose.time), state.is_determined});
    way.pieces.push_back({0, 0, {pose.q, last.q}, {}, {}});
    way.event = std::move(event);
    (is_forwards ? track.forwards : track.backwards) = std::move(way);
  }
  return track;
}

PairSearch::PairSearch(const MotionRun& run, const Tracker& tracker)
    : run_(run), tracker_(tracker) {}

void PairSearch::prepare() {
  if (polynomials_) return;
  polynomials_ = std::make_unique<MovingPolynomials>(run_.mechanism, knots(run_));
  const BlockStructure structure = block_structure(polynomials_->formulation().system);
  if (!structure.free_variables.empty()) return;
  blocks_ = structure.blocks;
  for (std::size_t k = 0; k < blocks_.size(); ++k) {
    auto equations = std::make_unique<PairEquations>(*polynomials_, blocks_, k, run_.options.from,
                                                     run_.options.to);
    equations_.push_back(equations->has_mirror() ? std::move(equations) : nullptr);
  }
}

/// The pairs that a closure which is not real belongs to: in each block that is the first one not
/// real.
void PairSearch::enter_pairs(const Point& root, PairScene& solved) {
  for (std::size_t block = 0; block < equations_.size(); ++block) {
    if (equations_[block] == nullptr) continue;
    const PairEquations& equations = *equations_[block];
    const Point x = equations.restricted(root);
    const Point image = equations.image(x);
    const double size = std::max(1.0, max_norm(x));
    double needed = 0;
    double own = 0;
    for (std::size_t k = 0; k < x.size(); ++k) {
      double& apart = k < equations.needed() ? needed : own;
      apart = std::max(apart, std::abs(x[k] - image[k]));
    }
    if (needed > kHolds * size || own <= kHolds * size) continue;
    const bool is_known =
        std::any_of(solved.pairs.begin(), solved.pairs.end(), [&](const KnownPair& pair) {
          return pair.block == block &&
                 std::min(max_distance(pair.x, x), max_distance(pair.x, image)) <= kSamePair * size;
        });
    if (!is_known) solved.pairs.push_back({block, x, false});
  }
}

void PairSearch::enter(const SolvedCheckpoint& solved) {
  PairScene entered;
  entered.time = solved.time;
  entered.is_complete = solved.closures.complete;
  entered.are_apart = solved.are_apart;
  entered.closures = solved.distinct;
  for (const Solution& closure : solved.closures.solutions) {
    if (closure.real || closure.singular) continue;
    prepare();
    enter_pairs(closure.x, entered);
  }
  checkpoints_.push_back(std::move(entered));
}

void PairSearch::tell(const std::string& doubt) {
  if (std::find(doubts_.begin(), doubts_.end(), doubt) == doubts_.end()) doubts_.push_back(doubt);
}

/// A pair at a checkpoint; false where the curve is back at its beginning.
bool PairSearch::pass(std::size_t solved, std::size_t block, const Point& x,
                      const KnownPair& begun) {
  const Point image = equations_[block]->image(x);
  const double most = kSamePair * std::max(1.0, max_norm(x));
  for (KnownPair& pair : checkpoints_[solved].pairs) {
    if (pair.block != block ||
        std::min(max_distance(pair.x, x), max_distance(pair.x, image)) > most) {
      continue;
    }
    pair.is_passed = true;
    return &pair != &begun;
  }
  checkpoints_[solved].lacks_pair = true;
  return true;
}

/// Whether all closures are there and apart, complex ones too: at some times a few are at infinity,
/// or meet.
bool PairSearch::is_regular(const PairScene& solved) const {
  return solved.are_apart &&
         std::all_of(checkpoints_.begin(), checkpoints_.end(),
                     [&](const PairScene& other) { return other.closures <= solved.closures; });
}

std::vector<std::string> PairSearch::doubts() const {
  std::vector<std::string> all = doubts_;
  all.insert(all.end(), unclear_.begin(), unclear_.end());
  for (const PairScene& solved : checkpoints_) {
    if (!solved.lacks_pair || !solved.is_complete || !is_regular(solved)) continue;
    all.push_back(pair_not_solved(solved.time));
  }
  return all;
}

/// Poses in which a block's root is: the other blocks are solved above it.
std::vector<BranchPose> PairSearch::poses_above(const PairEquations& equations, const Point& x,
                                                double time) {
  const Formulation there = formulate(run_.mechanism, time);
  PartialRoot begun;
  begun.value.resize(there.system.variables.size());
  for (std::size_t k = 0; k < x.size(); ++k) {
    const std::uint32_t v = equations.variables()[k];
    begun.value[v] = std::make_shared<const Known>(exactly(x[k] * polynomials_->units()[v]));
  }
  std::vector<Block> others;
  for (const Block& block : blocks_) {
    if (!begun.value[block.variables.front()]) others.push_back(block);
  }
  RootProver prover(there, false);
  const BlockSolving solving{tracker_, run_.options.solve, nullptr, run_.stop};
  const StageRun run = solve_blocks(there, others, solving, prover, std::move(begun));
  if (!run.complete) tell(brief_closures_incomplete(time));
  std::vector<BranchPose> poses;
  for (const PartialRoot& found : run.roots) {
    if (!may_be_real(there, found)) continue;
    Point root;
    for (const KnownValue& value : found.value) root.push_back(value->rounded);
    const Eigen::VectorXd q = coordinates_of_root(there, root);
    const bool is_assembled = residual_by_size(run_.phi, q, time) <= kAssembled;
    if (is_assembled && !broken_limit(run_.mechanism, q)) poses.push_back({time, q});
  }
  return poses;
}

/// Both of them, as branches between their meetings.
void PairSearch::take_brief(const PairEquations& equations, const RealWhile& life) {
  const bool is_known =
      std::any_of(brief_lives_.begin(), brief_lives_.end(), [&](const RealWhile& known) {
        return known.roots[0].size() == life.roots[0].size() &&
               std::abs(known.at - life.at) <= kBriefest * equations.duration() &&
               max_distance(known.roots[0], life.roots[0]) <= kSamePlace;
      });
  if (is_known) return;
  brief_lives_.push_back(life);
  const std::vector<BranchPose> begins = poses_above(equations, life.meetings[0], life.times[0]);
  const std::vector<BranchPose> ends = poses_above(equations, life.meetings[1], life.times[1]);
  for (const Point& x : life.roots) {
    for (const BranchPose& pose : poses_above(equations, x, life.at)) {
      if (!begins.empty() && !ends.empty()) {
        brief_.push_back(brief_track(run_.phi, nearest(run_.phi, begins, pose), pose,
                                     nearest(run_.phi, ends, pose)));
        continue;
      }
      tell(brief_meeting_not_found(life.at));
    }
  }
}

void PairSearch::take(const PairEquations& equations, const PairCurve& curve) {
  borders_.insert(borders_.end(), curve.borders.begin(), curve.borders.end());
  instants_.insert(instants_.end(), curve.undecided.begin(), curve.undecided.end());
  fold_backs_.insert(fold_backs_.end(), curve.fold_backs.begin(), curve.fold_backs.end());
  for (const RealWhile& life : curve.short_lives) {
    if (life.times[1] - life.times[0] <= kBriefest * equations.duration()) {
      take_brief(equations, life);
    }
  }
}

/// Curves are lost at places that are nearer to each other than what shows nothing: these are one.
void PairSearch::lose(double time) {
  const double width = kLostAtOnce * (run_.options.to - run_.options.from);
  for (Stretch& place : lost_) {
    const double from = std::min(place.from, time);
    const double to = std::max(place.to, time);
    if (to - from > width) continue;
    place.from = from;
    place.to = to;
    return;
  }
  lost_.push_back({time, time, 0});
  borders_.push_back(time);
}

void PairSearch::follow(std::size_t solved, std::size_t pair) {
  KnownPair& begun = checkpoints_[solved].pairs[pair];
  const PairEquations& equations = *equations_[begun.block];
  std::vector<double> times;
  for (const PairScene& other : checkpoints_) times.push_back(other.time);
  begun.is_passed = true;
  bool has_come_back = false;
  for (const bool forwards : {true, false}) {
    if (has_come_back || run_.stop) return;
    const PassingPair passing = [&](std::size_t number, const Point& x) {
      has_come_back = !pass(number, begun.block, x, begun);
      return !has_come_back;
    };
    const PairCurve curve = follow_pair(equations, begun.x, checkpoints_[solved].time, forwards,
                                        times, passing, run_.stop);
    take(equations, curve);
    // Beyond a place where a curve is lost closures are solved again.
    if (!curve.is_lost || run_.stop) continue;
    const double way = std::abs(curve.last - checkpoints_[solved].time);
    const bool goes_out =
        checkpoints_[solved].time == (forwards ? run_.options.to : run_.options.from);
    if (way > kLostAtOnce * equations.duration()) {
      lose(curve.last);
    } else if (!goes_out) {
      checkpoints_[solved].leads_on = false;
    }
  }
}

void PairSearch::follow(const std::vector<SolvedCheckpoint>& checkpoints) {
  for (const SolvedCheckpoint& solved : checkpoints) {
    const bool is_known =
        std::any_of(checkpoints_.begin(), checkpoints_.end(),
                    [&](const PairScene& known) { return known.time == solved.time; });
    if (!is_known) enter(solved);
  }
  for (std::size_t k = 0; k < checkpoints_.size(); ++k) {
    for (std::size_t j = 0; j < checkpoints_[k].pairs.size() && !run_.stop; ++j) {
      if (!checkpoints_[k].pairs[j].is_passed) follow(k, j);
    }
  }
}

/// Times of pairs and of branches, at which the number of real closures may change.
std::vector<double> PairSearch::event_times() const {
  std::vector<double> times = borders_;
  for (const Track& track : run_.tracks) {
    for (const BranchEvent* event : track.events()) times.push_back(event->time);
  }
  return times;
}

/// Whether the checkpoint lies in the stretch and tells of all of it. One at either end of the
/// motion does, unless an event lies beside it.
bool PairSearch::shows(const PairScene& solved, double from, double to,
                       const std::vector<double>& events) const {
  // What was not decided is told, and solving beside it helps as little.
  if (solved.is_complete && (!is_regular(solved) || !solved.leads_on)) return false;
  if (solved.time != run_.options.from && solved.time != run_.options.to) {
    return solved.time > from && solved.time < to;
  }
  const double least = kBriefest * (run_.options.to - run_.options.from);
  return (solved.time == from || solved.time == to) &&
         std::none_of(events.begin(), events.end(), [&](double time) {
           return solved.time != time && std::abs(solved.time - time) <= least;
         });
}

/// Where to solve closures next in a stretch that no checkpoint shows; nullopt, and a note, after a
/// few times.
std::optional<double> PairSearch::next_time(double from, double to) {
  std::uint64_t tries = 0;
  bool are_regular = true;
  for (const PairScene& solved : checkpoints_) {
    if (solved.time <= from || solved.time >= to) continue;
    ++tries;
    are_regular = are_regular && is_regular(solved);
  }
  const double place = kWithin + kGolden * static_cast<double>(tries);
  if (tries < kMostTries) return from + (place - std::floor(place)) * (to - from);
  if (are_regular) {
    sampled_.push_back({from, to, tries});
  } else {
    unclear_.push_back(no_regular_time(tries, from, to));
  }
  return std::nullopt;
}

std::optional<SampledStretches> PairSearch::sampled() const {
  if (sampled_.empty()) return std::nullopt;
  SampledStretches all{sampled_.size(), sampled_.front().from, sampled_.back().to, 0};
  for (const Stretch& stretch : sampled_) all.checkpoints += stretch.checkpoints;
  return all;
}

std::vector<double> PairSearch::open_times() {
  const std::vector<double> events = event_times();
  std::vector<double> parts = events;
  parts.push_back(run_.options.from);
  parts.push_back(run_.options.to);
  std::sort(parts.begin(), parts.end());
  const double least = kBriefest * (run_.options.to - run_.options.from);
  sampled_.clear();
  unclear_.clear();
  std::vector<double> open;
  for (std::size_t k = 1; k < parts.size(); ++k) {
    const double from = parts[k - 1];
    const double to = parts[k];
    const bool is_seen = to - from <= least || std::any_of(checkpoints_.begin(), checkpoints_.end(),
                                                           [&](const PairScene& solved) {
                                                             return shows(solved, from, to, events);
                                                           });
    if (is_seen) continue;
    if (const auto time = next_time(from, to)) open.push_back(*time);
  }
  for (Stretch place : lost_) {
    if (!(place.to > place.from)) continue;
    place.checkpoints = static_cast<std::uint64_t>(
        std::count_if(checkpoints_.begin(), checkpoints_.end(), [&](const PairScene& solved) {
          return solved.time >= place.from && solved.time <= place.to;
        }));
    sampled_.push_back(place);
  }
  std::sort(sampled_.begin(), sampled_.end(),
            [](const Stretch& a, const Stretch& b) { return a.from < b.from; });
  for (const double time : fold_backs_) {
    const auto is_there = [&](double other) { return std::abs(other - time) <= least; };
    const bool is_seen =
        std::any_of(open.begin(), open.end(), is_there) ||
        std::any_of(checkpoints_.begin(), checkpoints_.end(),
                    [&](const PairScene& solved) { return is_there(solved.time); });
    if (!is_seen) open.push_back(time);
  }
  return open;
}

std::vector<Track> PairSearch::take_brief() { return std::exchange(brief_, {}); }

void search_pairs(MotionRun& run, const Tracker& tracker,
                  std::vector<SolvedCheckpoint>& checkpoints, PairSearch& pairs,
                  std::size_t most_times) {
  const std::size_t at_first = checkpoints.size();
  while (!run.stop) {
    pairs.follow(checkpoints);
    std::vector<Track> brief = pairs.take_brief();
    const bool is_new = !brief.empty();
    std::move(brief.begin(), brief.end(), std::back_inserter(run.tracks));
    const std::vector<double> open = pairs.open_times();
    if (!is_new && open.empty()) return;
    if (checkpoints.size() - at_first + open.size() > most_times) {
      const auto unsolved = open.empty() ? std::nullopt : std::optional(open.front());
      pairs.tell(events_without_end(checkpoints.size() - at_first, unsolved));
      return;
    }
    add_checkpoints(run, tracker, open, checkpoints);
    reconcile(run, checkpoints);
  }
}

}  // namespace moivre
