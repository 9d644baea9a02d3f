// SPDX-License-Identifier: MIT
// Motions of sub-chains, the choices of their branches, and the whole made of them.
#include "motion_product.h"

#include <algorithm>
#include <map>
#include <tuple>

#include "moivre/closures/canonical_order.h"
#include "moivre/mechanism/closure_id.h"
#include "moivre/motion/circuits.h"
#include "moivre/numeric/saturating.h"
#include "motion_record.h"
#include "motion_sentences.h"

namespace moivre {
namespace {

using Eigen::VectorXd;

// Over the motion, so that the curve between two samples is their velocities' and accelerations',
// to 1e-9 of a turn.
constexpr int kFewestSamples = 100;
// Of the motion's duration: what is shorter is no branch.
constexpr double kInstant = 1e-9;

/// Of each sub-chain the event at some time, or the branch that it is on then (0 beside an event).
struct PartEvents {
  std::vector<std::optional<std::size_t>> event;
  std::vector<std::size_t> branch;
  auto operator<=>(const PartEvents&) const = default;
};

/// One branch of each sub-chain, and when all of them are there.
struct BranchChoice {
  std::vector<std::size_t> branch;
  double begins = 0;
  double ends = 0;
};

class MotionProduct {
 public:
  MotionProduct(const Mechanism& mechanism, const std::vector<IndependentChain>& chains,
                const MotionOptions& options, const std::atomic<bool>& stop)
      : mechanism_(mechanism),
        chains_(chains),
        options_(options),
        stop_(stop),
        result_(empty_result(options, motion_times(options, options.checkpoints))) {}

  MotionResult run(const Tracker& tracker) {
    follow_chains(tracker);
    choose();
    for (std::size_t k = 0; k < choices_.size(); ++k) enter(choices_[k], k);
    tell_drawn();
    order_events(result_);
    enter_checkpoints();
    enter_account();
    if (finer_ > 1) strip_samples();
    return std::move(result_);
  }

 private:
  void follow_chains(const Tracker& tracker) {
    finer_ = std::max(1, (kFewestSamples + options_.steps - 1) / options_.steps);
    for (std::size_t k = 0; k < chains_.size(); ++k) {
      MotionOptions options = options_;
      options.steps *= finer_;
      if (options_.progress) {
        options.progress = [&, k](double share) {
          options_.progress((static_cast<double>(k) + share) / static_cast<double>(chains_.size()));
        };
      }
      result_.sub_chains.push_back(
          {chains_[k], find_motion(chains_[k].mechanism, tracker, options, stop_)});
    }
  }

  void choose() {
    add_choices({{}, options_.from, options_.to});
    if (choices_.size() > kMostBranchesListed) choose_some();
    order_choices();
  }

  /// Every choice that goes on with this one, until there are more than can be listed.
  void add_choices(const BranchChoice& begun) {
    if (choices_.size() > kMostBranchesListed) return;
    if (begun.branch.size() == chains_.size()) {
      choices_.push_back(begun);
      return;
    }
    for (std::size_t b = 0; b < motion(begun.branch.size()).branches.size(); ++b) {
      if (const auto longer = joined_by(begun, b)) add_choices(*longer);
    }
  }

  void choose_some() {
    result_.all_listed = false;
    choices_.clear();
    for (std::size_t k = 0; k < chains_.size(); ++k) {
      for (std::size_t b = 0; b < motion(k).branches.size(); ++b) {
        const auto choice = choice_with(k, b);
        const auto is_same = [&](const BranchChoice& other) {
          return other.branch == choice->branch;
        };
        if (choice && std::none_of(choices_.begin(), choices_.end(), is_same)) {
          choices_.push_back(*choice);
        }
      }
    }
    for (const std::vector<std::string>& ids : asked_ids()) {
      const auto choice = choice_of(ids);
      const auto is_same = [&](const BranchChoice& other) {
        return other.branch == choice->branch;
      };
      if (choice && std::none_of(choices_.begin(), choices_.end(), is_same)) {
        choices_.push_back(*choice);
      }
    }
  }

  /// Of each sub-chain the branch that was drawn, "" where none was.
  std::vector<std::string> drawn_ids() const {
    std::vector<std::string> ids;
    for (const MotionSubChain& part : result_.sub_chains) ids.push_back(part.motion.drawn);
    return ids;
  }

  /// The names that were asked for, taken apart, and the drawn one.
  std::vector<std::vector<std::string>> asked_ids() const {
    std::vector<std::vector<std::string>> all;
    for (const std::string& name : options_.asked) all.push_back(parts_of_name(name));
    all.push_back(drawn_ids());
    return all;
  }

  /// The branches with these names at `from`, one of each sub-chain; nullopt where one does not
  /// exist.
  std::optional<BranchChoice> choice_of(const std::vector<std::string>& ids) const {
    if (ids.size() != chains_.size()) return std::nullopt;
    BranchChoice choice{{}, options_.from, options_.to};
    for (std::size_t k = 0; k < ids.size(); ++k) {
      std::optional<BranchChoice> longer;
      for (const std::size_t b : first_branches(motion(k))) {
        if (motion(k).branches[b].id == ids[k]) longer = joined_by(choice, b);
      }
      if (!longer) return std::nullopt;
      choice = *longer;
    }
    return choice;
  }

  void tell_drawn() {
    const std::vector<std::string> ids = drawn_ids();
    for (const std::size_t k : first_branches(result_)) {
      if (result_.branches[k].of == ids) result_.drawn = result_.branches[k].id;
    }
  }

  /// With this branch, the others the first that are there at that time.
  std::optional<BranchChoice> choice_at(double time, std::size_t chain, std::size_t branch) const {
    BranchChoice choice{{}, options_.from, options_.to};
    for (std::size_t k = 0; k < chains_.size(); ++k) {
      const auto& branches = motion(k).branches;
      const auto first = std::find_if(branches.begin(), branches.end(), [&](const MotionBranch& b) {
        return b.begins <= time && time <= b.ends;
      });
      if (k != chain && first == branches.end()) return std::nullopt;
      const auto longer = joined_by(
          choice, k == chain ? branch : static_cast<std::size_t>(first - branches.begin()));
      if (!longer) return std::nullopt;
      choice = *longer;
    }
    return choice;
  }

  /// With this branch, in its middle or else between two times at which some branch begins or ends;
  /// nullopt: nothing is ever there with it.
  std::optional<BranchChoice> choice_with(std::size_t chain, std::size_t branch) const {
    const MotionBranch& given = motion(chain).branches[branch];
    if (auto choice = choice_at((given.begins + given.ends) / 2, chain, branch)) return choice;
    std::vector<double> times;
    for (const MotionSubChain& part : result_.sub_chains) {
      for (const MotionBranch& other : part.motion.branches) {
        times.push_back(std::clamp(other.begins, given.begins, given.ends));
        times.push_back(std::clamp(other.ends, given.begins, given.ends));
      }
    }
    std::sort(times.begin(), times.end());
    for (std::size_t k = 1; k < times.size(); ++k) {
      if (auto choice = choice_at((times[k - 1] + times[k]) / 2, chain, branch)) return choice;
    }
    return std::nullopt;
  }

  /// As without sub-chains: those at `from` by pose, as closures are lettered, then by their
  /// beginning.
  void order_choices() {
    std::stable_sort(
        choices_.begin(), choices_.end(),
        [](const BranchChoice& a, const BranchChoice& b) { return a.begins < b.begins; });
    if (!result_.all_listed) return;
    const Phi phi(mechanism_);
    std::vector<VectorXd> poses;
    for (const BranchChoice& choice : choices_) {
      if (choice.begins > options_.from) break;
      poses.push_back(phi.canonical(whole_sample(choice, options_.from).q));
    }
    std::vector<BranchChoice> ordered;
    for (const std::size_t k : canonical_order(poses, phi.coordinates(), phi.length())) {
      ordered.push_back(choices_[k]);
    }
    std::move(ordered.begin(), ordered.end(), choices_.begin());
  }

  std::optional<BranchChoice> joined_by(const BranchChoice& choice, std::size_t branch) const {
    const MotionBranch& next = motion(choice.branch.size()).branches[branch];
    BranchChoice longer = choice;
    longer.branch.push_back(branch);
    longer.begins = std::max(choice.begins, next.begins);
    longer.ends = std::min(choice.ends, next.ends);
    const bool is_there = longer.ends - longer.begins > kInstant * (options_.to - options_.from);
    return is_there ? std::optional(std::move(longer)) : std::nullopt;
  }

  /// Of a sub-chain's branch at a time between its ends.
  const BranchSample& sample_at(std::size_t chain, std::size_t branch, double time) {
    const MotionBranch& on = motion(chain).branches[branch];
    const auto after =
        std::lower_bound(on.samples.begin(), on.samples.end(), time,
                         [](const BranchSample& sample, double t) { return sample.time < t; });
    if (after != on.samples.end() && after->time == time) return *after;
    const auto [place, is_new] = between_.try_emplace({chain, branch, time});
    BranchSample& found = place->second;
    if (!is_new) return found;
    found.time = time;
    found.is_determined = false;
    if (time <= on.begins || time >= on.ends || on.samples.empty()) {
      found.q = time <= on.begins ? on.begin_pose : on.end_pose;
      return found;
    }
    const BranchSample& from = after == on.samples.begin() ? *after : *(after - 1);
    const Branch way =
        follow_branch(chains_[chain].mechanism, from.q, {from.time, time}, options_.branch, stop_);
    found = way.samples.back();
    found.is_determined = found.is_determined && found.time == time;
    found.time = time;
    return found;
  }

  BranchSample whole_sample(const BranchChoice& choice, double time) {
    const auto size = static_cast<Eigen::Index>(coordinates(mechanism_).size());
    BranchSample whole;
    whole.time = time;
    whole.q = whole.velocity = whole.acceleration = VectorXd::Zero(size);
    for (std::size_t k = 0; k < chains_.size(); ++k) {
      const BranchSample& part = sample_at(k, choice.branch[k], time);
      const auto& places = chains_[k].coordinates;
      whole.q(places) = part.q;
      whole.residual = std::max(whole.residual, part.residual);
      whole.is_determined = whole.is_determined && part.is_determined;
      if (part.velocity.size() == 0) continue;
      whole.velocity(places) = part.velocity;
      whole.acceleration(places) = part.acceleration;
    }
    return whole;
  }

  void enter(const BranchChoice& choice, std::size_t number) {
    MotionBranch branch;
    for (std::size_t k = 0; k < chains_.size(); ++k) branch.of.push_back(branch_of(choice, k).id);
    if (result_.all_listed) {
      branch.id = closure_id(number);
    } else {
      for (const std::string& id : branch.of) branch.id += (branch.id.empty() ? "" : ".") + id;
    }
    branch.begins = choice.begins;
    branch.ends = choice.ends;
    std::vector<BranchSample> all;
    const std::vector<double>& times = motion(0).times;
    for (std::size_t k = 0; k < times.size(); ++k) {
      if (times[k] < choice.begins || times[k] > choice.ends) continue;
      all.push_back(whole_sample(choice, times[k]));
      if (k % static_cast<std::size_t>(finer_) != 0) continue;
      branch.samples.push_back(all.back());
      branch.samples.back().time = result_.times[k / static_cast<std::size_t>(finer_)];
    }
    enter_pieces(choice, all, branch);
    enter_event(choice, false, branch);
    enter_event(choice, true, branch);
    branch.complete = true;
    branch.message = followed_to_the_end();
    for (std::size_t k = 0; k < chains_.size(); ++k) {
      const MotionBranch& part = branch_of(choice, k);
      branch.complete = branch.complete && part.complete;
      branch.steps += part.steps;
      branch.retracked = std::max(branch.retracked, part.retracked);
      if (part.ends == choice.ends) branch.message = part.message;
    }
    result_.branches.push_back(std::move(branch));
  }

  /// From each of these to the next.
  void enter_pieces(const BranchChoice& choice, const std::vector<BranchSample>& all,
                    MotionBranch& branch) {
    const auto add = [&](const BranchSample& a, const BranchSample& b) {
      const double length = b.time - a.time;
      if (!(length > 0)) return;
      BranchPiece piece{length, length, {a.q, b.q}, {}, {}};
      if (a.is_determined && b.is_determined) {
        piece.slope = {a.velocity, b.velocity};
        piece.bend = {a.acceleration, b.acceleration};
      }
      branch.ways[1].push_back(std::move(piece));
    };
    BranchSample last = whole_sample(choice, choice.begins);
    branch.begin_pose = last.q;
    for (const BranchSample& sample : all) {
      add(last, sample);
      last = sample;
    }
    const BranchSample end = whole_sample(choice, choice.ends);
    branch.end_pose = end.q;
    add(last, end);
  }

  /// The event of the sub-chain whose branch begins last, or ends first; once for what the others
  /// are on. Dead points of several at one time are one event, where all branches of these meet.
  void enter_event(const BranchChoice& choice, bool is_end, MotionBranch& branch) {
    const double time = is_end ? choice.ends : choice.begins;
    PartEvents at{std::vector<std::optional<std::size_t>>(chains_.size()), choice.branch};
    std::vector<const BranchEvent*> parts;
    VectorXd q = whole_sample(choice, time).q;
    for (std::size_t k = 0; k < chains_.size(); ++k) {
      const MotionBranch& part = branch_of(choice, k);
      const auto& event = is_end ? part.end_event : part.begin_event;
      const double gap = (is_end ? part.ends : part.begins) - time;
      if (!event || std::abs(gap) > kSameTime * (options_.to - options_.from)) continue;
      at.event[k] = event;
      at.branch[k] = 0;
      parts.push_back(&motion(k).events[*event].at);
      q(chains_[k].coordinates) = parts.back()->q;
    }
    if (parts.empty()) return;
    const auto [place, is_new] = event_of_.try_emplace(at, result_.events.size());
    if (is_new) {
      MotionEvent whole{*parts.front(), driver_values(mechanism_, time), {}, {}};
      whole.at.q = q;
      const bool meets = std::any_of(parts.begin(), parts.end(), [](const BranchEvent* part) {
        return part->kind != EventKind::joint_limit;
      });
      if (parts.size() > 1 && meets) whole.at.kind = EventKind::bifurcation;
      result_.events.push_back(std::move(whole));
    }
    (is_end ? branch.end_event : branch.begin_event) = place->second;
    MotionEvent& whole = result_.events[place->second];
    (is_end ? whole.ending : whole.beginning).push_back(branch.id);
  }

  void enter_checkpoints() {
    for (const Checkpoint& first : motion(0).checkpoints) {
      std::vector<const Checkpoint*> rows;
      for (std::size_t k = 0; k < chains_.size(); ++k) {
        for (const Checkpoint& row : motion(k).checkpoints) {
          if (row.time == first.time) rows.push_back(&row);
        }
      }
      if (rows.size() == chains_.size()) enter_checkpoint(rows);
    }
  }

  /// The row of the whole where each sub-chain has one at that time.
  void enter_checkpoint(const std::vector<const Checkpoint*>& rows) {
    Checkpoint whole;
    whole.time = rows.front()->time;
    whole.drivers = driver_values(mechanism_, whole.time);
    whole.agrees = true;
    std::vector<ClosureCounts> counts;
    std::uint64_t closures = 1;
    for (const Checkpoint* row : rows) {
      counts.push_back(row->counts);
      closures = saturating_product(closures, row->branches.size());
      whole.paths += row->paths;
      if (whole.agrees) whole.message = row->message;
      whole.agrees = whole.agrees && row->agrees;
    }
    whole.counts = product_of(counts);
    std::size_t branches = 0;
    for (std::size_t b = 0; b < choices_.size(); ++b) {
      bool is_there = true;
      for (std::size_t k = 0; k < rows.size(); ++k) {
        const auto& ids = rows[k]->branches;
        is_there =
            is_there && std::find(ids.begin(), ids.end(), result_.branches[b].of[k]) != ids.end();
      }
      if (!is_there) continue;
      whole.branches.push_back(result_.branches[b].id);
      ++branches;
    }
    if (whole.agrees) whole.message = one_to_one_in_sub_chains(closures, branches);
    result_.checkpoints.push_back(std::move(whole));
  }

  void enter_account() {
    result_.complete = true;
    result_.message = motion(0).message;
    for (std::size_t k = 0; k < chains_.size(); ++k) {
      const MotionResult& part = motion(k);
      if (!part.complete || (result_.complete && part.branches.empty()))
        result_.message = part.message;
      result_.complete = result_.complete && part.complete;
      result_.paths += part.paths;
      result_.steps += part.steps;
      result_.rejected += part.rejected;
      result_.time_s.threads = std::max(result_.time_s.threads, part.time_s.threads);
      result_.time_s.track += part.time_s.track;
      for (const std::string& failure : part.failures) {
        result_.failures.push_back(sub_chain_failure(chains_[k].bodies.front(), failure));
      }
      add_left_out(part.left_out, result_.left_out);
    }
    result_.tracker = motion(0).tracker;
    result_.tracker_options = motion(0).tracker_options;
    if (result_.all_listed) return;
    result_.left_out.push_back(combined_branches_left_out(kMostBranchesListed));
  }

  /// Leaves the samples that were asked for.
  void strip_samples() {
    for (MotionSubChain& part : result_.sub_chains) {
      std::vector<double> times;
      for (std::size_t k = 0; k < part.motion.times.size(); k += static_cast<std::size_t>(finer_)) {
        times.push_back(part.motion.times[k]);
      }
      for (MotionBranch& branch : part.motion.branches) {
        std::erase_if(branch.samples, [&](const BranchSample& sample) {
          return !std::binary_search(times.begin(), times.end(), sample.time);
        });
      }
      part.motion.times = std::move(times);
    }
  }

  const MotionResult& motion(std::size_t chain) const { return result_.sub_chains[chain].motion; }
  const MotionBranch& branch_of(const BranchChoice& choice, std::size_t chain) const {
    return motion(chain).branches[choice.branch[chain]];
  }

  const Mechanism& mechanism_;
  const std::vector<IndependentChain>& chains_;
  const MotionOptions& options_;
  const std::atomic<bool>& stop_;
  int finer_ = 1;  ///< samples of a sub-chain for one of the whole
  MotionResult result_;
  std::vector<BranchChoice> choices_;
  std::map<std::tuple<std::size_t, std::size_t, double>, BranchSample> between_;
  std::map<PartEvents, std::size_t> event_of_;
};

}  // namespace

std::vector<std::string> parts_of_name(const std::string& name) {
  std::vector<std::string> parts{""};
  for (const char letter : name) {
    if (letter == '.') {
      parts.emplace_back();
    } else {
      parts.back() += letter;
    }
  }
  return parts;
}

MotionResult find_motion_apart(const Mechanism& mechanism,
                               const std::vector<IndependentChain>& chains, const Tracker& tracker,
                               const MotionOptions& options, const std::atomic<bool>& stop) {
  return MotionProduct(mechanism, chains, options, stop).run(tracker);
}

}  // namespace moivre
