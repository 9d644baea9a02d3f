// SPDX-License-Identifier: MIT
// Ways between branches, and the motion of what can be reached.
#include <algorithm>
#include <cmath>
#include <iterator>
#include <queue>
#include <stdexcept>

#include "moivre/mechanism/closure_id.h"
#include "moivre/motion/circuits.h"
#include "moivre/numeric/invalid_input.h"
#include "motion_product.h"
#include "motion_record.h"
#include "motion_sentences.h"

namespace moivre {
namespace {

std::size_t count_branches(const Circuits& circuits) {
  std::size_t count = 0;
  for (const Circuit& circuit : circuits.circuits) count += circuit.branches.size();
  return count;
}

/// Whether a name means this branch: its id, the ids of its sub-chains' branches as in E.H, one of
/// these as in 1:E, or the drawn pose.
bool is_named(const MotionResult& motion, const MotionBranch& branch, const std::string& name) {
  if (branch.id == name) return true;
  if (name == kDrawn) return branch.id == motion.drawn;
  for (std::size_t k = 0; k < branch.of.size(); ++k) {
    if (name == sub_chain_name(k, branch.of[k])) return true;
  }
  return !branch.of.empty() && parts_of_name(name) == branch.of;
}

std::string names_text(const MotionResult& motion, const std::vector<std::size_t>& branches) {
  constexpr std::size_t kListed = 60;
  std::vector<std::string> known;
  for (const std::size_t k : branches) known.push_back(motion.branches[k].id);
  const bool are_many = known.size() > kListed;
  known.resize(std::min(known.size(), kListed));
  const std::string text = known_closures(known, are_many);
  if (known.empty() || motion.sub_chains.empty()) return text;
  return text + names_in_sub_chains(motion.branches[branches.front()].of);
}

/// The branches at `from` with these names. Throws std::invalid_argument that names every unknown
/// one.
std::vector<std::size_t> named_branches(const MotionResult& motion,
                                        const std::vector<std::string>& names) {
  const std::vector<std::size_t> firsts = first_branches(motion);
  std::vector<std::size_t> found;
  std::string refusal;
  for (const std::string& name : names) {
    const std::size_t before = found.size();
    std::copy_if(firsts.begin(), firsts.end(), std::back_inserter(found),
                 [&](std::size_t k) { return is_named(motion, motion.branches[k], name); });
    if (found.size() > before) continue;
    if (!refusal.empty()) refusal += '\n';
    refusal +=
        "there is no closure '" + name + "' where the motion begins; " + names_text(motion, firsts);
  }
  if (!refusal.empty()) throw InvalidInput(refusal);
  return found;
}

/// Keeps the events at which a kept branch begins or ends, with the kept branches alone.
void keep_events_of_branches(MotionResult& motion) {
  std::vector<std::size_t> kept;
  for (std::size_t k = 0; k < motion.events.size(); ++k) {
    MotionEvent& event = motion.events[k];
    const auto is_dropped = [&](const std::string& id) {
      return std::none_of(motion.branches.begin(), motion.branches.end(),
                          [&](const MotionBranch& branch) { return branch.id == id; });
    };
    std::erase_if(event.ending, is_dropped);
    std::erase_if(event.beginning, is_dropped);
    if (!event.ending.empty() || !event.beginning.empty()) kept.push_back(k);
  }
  keep_events(kept, motion);
}

/// Keeps the sub-chains' branches of which branches of the whole are made.
void keep_parts_of_branches(MotionResult& motion) {
  for (std::size_t k = 0; k < motion.sub_chains.size(); ++k) {
    MotionResult& part = motion.sub_chains[k].motion;
    std::erase_if(part.branches, [&](const MotionBranch& one) {
      return std::none_of(motion.branches.begin(), motion.branches.end(),
                          [&](const MotionBranch& whole) { return whole.of[k] == one.id; });
    });
    keep_events_of_branches(part);
  }
}

/// Whether each sub-chain is on the circuit on which it is in one of `from`; the circuits of the
/// whole are parts of these.
std::vector<bool> reachable_by_sub_chains(const MotionResult& motion,
                                          const std::vector<std::size_t>& from) {
  std::vector<bool> is_kept(motion.branches.size(), false);
  std::vector<std::vector<std::size_t>> circuit_of_branch(motion.branches.size());
  for (std::size_t k = 0; k < motion.sub_chains.size(); ++k) {
    const auto& [chain, part] = motion.sub_chains[k];
    const Circuits circuits = find_circuits(chain.mechanism, part);
    for (std::size_t b = 0; b < motion.branches.size(); ++b) {
      const auto at = std::find_if(
          part.branches.begin(), part.branches.end(),
          [&](const MotionBranch& branch) { return branch.id == motion.branches[b].of[k]; });
      circuit_of_branch[b].push_back(
          circuit_of(circuits, static_cast<std::size_t>(at - part.branches.begin())));
    }
  }
  for (std::size_t b = 0; b < motion.branches.size(); ++b) {
    is_kept[b] = std::any_of(from.begin(), from.end(), [&](std::size_t first) {
      return circuit_of_branch[first] == circuit_of_branch[b];
    });
  }
  return is_kept;
}

}  // namespace

std::size_t circuit_of(const Circuits& circuits, std::size_t branch) {
  const auto at = std::find_if(
      circuits.circuits.begin(), circuits.circuits.end(), [branch](const Circuit& circuit) {
        return std::binary_search(circuit.branches.begin(), circuit.branches.end(), branch);
      });
  return static_cast<std::size_t>(at - circuits.circuits.begin());
}

std::vector<std::optional<Passage>> passages_from(const Circuits& circuits, std::size_t branch) {
  std::vector<std::optional<Passage>> least(count_branches(circuits));
  if (branch >= least.size()) {
    throw InvalidInput("there is no branch " + std::to_string(branch) + ", counted from 0");
  }
  least[branch] = Passage{};
  std::queue<std::size_t> open({branch});
  while (!open.empty()) {
    const std::size_t here = open.front();
    open.pop();
    for (const BranchJoin& join : circuits.joins) {
      for (const std::size_t side : {0U, 1U}) {
        if (join.ends[side].branch != here) continue;
        Passage way = *least[here];
        way.dead_points += join.kind == JoinKind::dead_point ? 1 : 0;
        way.change_points += join.kind == JoinKind::bifurcation ? 1 : 0;
        const std::size_t there = join.ends[1 - side].branch;
        if (least[there] && std::pair(least[there]->dead_points, least[there]->change_points) <=
                                std::pair(way.dead_points, way.change_points)) {
          continue;
        }
        least[there] = way;
        open.push(there);
      }
    }
  }
  return least;
}

std::vector<std::size_t> first_branches(const MotionResult& motion) {
  std::vector<std::size_t> firsts;
  for (std::size_t k = 0; k < motion.branches.size(); ++k) {
    const MotionBranch& branch = motion.branches[k];
    // A motion may begin at a dead point.
    const bool is_there =
        std::abs(branch.begins - motion.from) <= kSameTime * (motion.to - motion.from);
    if (is_there) firsts.push_back(k);
  }
  return firsts;
}

MotionResult reachable_from(MotionResult motion, const Circuits& circuits,
                            const std::vector<std::string>& closures) {
  const std::vector<std::size_t> from = named_branches(motion, closures);
  std::vector<bool> is_kept(motion.branches.size(), false);
  if (!motion.all_listed) is_kept = reachable_by_sub_chains(motion, from);
  for (std::size_t k = 0; motion.all_listed && k < from.size(); ++k) {
    for (const std::size_t b : circuits.circuits[circuit_of(circuits, from[k])].branches) {
      is_kept[b] = true;
    }
  }
  std::vector<MotionBranch> kept;
  std::vector<std::string> dropped;
  for (std::size_t k = 0; k < motion.branches.size(); ++k) {
    if (is_kept[k]) {
      kept.push_back(std::move(motion.branches[k]));
    } else {
      dropped.push_back(motion.branches[k].id);
    }
  }
  motion.branches = std::move(kept);
  keep_events_of_branches(motion);
  keep_parts_of_branches(motion);
  if (!dropped.empty()) {
    motion.left_out.push_back(unreachable_branches_left_out(dropped, closures));
  }
  return motion;
}

}  // namespace moivre
