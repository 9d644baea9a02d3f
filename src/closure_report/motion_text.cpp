// SPDX-License-Identifier: MIT
// A motion for people: branches from where to where, events with the drivers' values, what the
// checkpoints say.
#include <algorithm>
#include <cmath>

#include "circuits_report.h"
#include "id_list.h"
#include "moivre/closure_report/motion_report.h"
#include "moivre/expression/counted.h"
#include "moivre/expression/joined.h"
#include "moivre/mechanism/closure_id.h"
#include "moivre/report/number_text.h"
#include "moivre/report/text_blocks.h"
#include "pose_text.h"

namespace moivre {
namespace {

std::string place_text(double time, const std::string& drivers) {
  constexpr int kDigits = 8;
  return "t = " + short_text(time, kDigits) + " s" + (drivers.empty() ? "" : " (" + drivers + ")");
}

/// With the drivers that move: those that stand are told once, at the head.
std::string moving_place(const Mechanism& mechanism, double time) {
  return place_text(time, moving_drivers_text(mechanism, time));
}

std::string branch_text(const MotionBranch& branch, const MotionResult& result,
                        const Mechanism& mechanism) {
  const auto kind_at = [&](const std::optional<std::size_t>& event) {
    return event ? ", " + to_string(result.events[*event].at.kind) : std::string();
  };
  std::string text = "branch " + branch.id + (branch.id == result.drawn ? ", as drawn" : "") +
                     ": from " + moving_place(mechanism, branch.begins) +
                     kind_at(branch.begin_event) + "\n  to " +
                     moving_place(mechanism, branch.ends) + kind_at(branch.end_event) + "; " +
                     counted(branch.samples.size(), "sample") + ", " +
                     counted(static_cast<std::uint64_t>(branch.steps), "step");
  if (branch.retracked > 0) {
    text += ", followed again " + counted(static_cast<std::uint64_t>(branch.retracked), "time") +
            " with shorter steps";
  }
  return text + (branch.complete ? "\n" : "; " + branch.message + '\n');
}

/// Where an event's time is known to fewer digits than are printed.
std::string doubt_text(const BranchEvent& event) {
  constexpr double kPrinted = 1e-8;
  if (event.uncertainty <= kPrinted * std::max(1.0, std::abs(event.time))) return "";
  return " to within " + rough_text(event.uncertainty) + " s";
}

std::string event_text(const MotionEvent& event, const Mechanism& mechanism) {
  std::string text = to_string(event.at.kind);
  if (!event.at.joint.empty()) text += " of " + event.at.joint;
  text += " at " + moving_place(mechanism, event.at.time) + doubt_text(event.at) + ": ";
  if (!event.ending.empty())
    text += id_list(event.ending) + " end" + (event.ending.size() == 1 ? "s" : "");
  if (!event.ending.empty() && !event.beginning.empty()) text += ", ";
  if (!event.beginning.empty()) {
    text += id_list(event.beginning) + " begin" + (event.beginning.size() == 1 ? "s" : "");
  }
  return text + '\n';
}

std::vector<std::string> sorted(std::vector<std::string> ids) {
  std::sort(ids.begin(), ids.end());
  return ids;
}

bool is_alike(const Checkpoint& a, const Checkpoint& b) {
  return a.agrees && b.agrees && a.counts.complex == b.counts.complex &&
         a.counts.real == b.counts.real && sorted(a.branches) == sorted(b.branches);
}

std::string verdict_text(const Checkpoint& row) {
  if (row.agrees) return "agrees";
  return row.message == kNotCompared ? row.message : "DOES NOT AGREE: " + row.message;
}

/// Neighbours with the same counts and branches share a line.
std::string checkpoints_text(const std::vector<Checkpoint>& all, const Mechanism& mechanism) {
  std::string text;
  std::size_t next = 0;
  for (std::size_t k = 0; k < all.size(); k = next) {
    for (next = k + 1; next < all.size() && is_alike(all[k], all[next]);) ++next;
    const Checkpoint& first = all[k];
    std::vector<std::string> ids;
    for (const std::string& id : sorted(first.branches)) ids.push_back(id.empty() ? "-" : id);
    text += next == k + 1
                ? "checkpoint " + moving_place(mechanism, first.time)
                : counted(next - k, "checkpoint") + ' ' + moving_place(mechanism, first.time) +
                      " .. " + moving_place(mechanism, all[next - 1].time);
    text += ": " + counts_text(first.counts) + fitted_text(first.counts) +
            (ids.empty() ? "" : " (" + id_list(ids) + ")") + "; " + verdict_text(first) + '\n';
  }
  return text;
}

/// Branches, events, circuits and checkpoints.
std::string course_text(const MotionResult& result, const Mechanism& mechanism) {
  std::string text = result.branches.empty() ? "" : "\n";
  for (const MotionBranch& branch : result.branches) {
    text += branch_text(branch, result, mechanism);
  }
  if (!result.events.empty()) text += '\n';
  for (const MotionEvent& event : result.events) text += event_text(event, mechanism);
  text += circuits_text(find_circuits(mechanism, result), result, mechanism);
  if (!result.checkpoints.empty()) text += '\n';
  return text + checkpoints_text(result.checkpoints, mechanism);
}

/// What the whole does is one of each.
std::string sub_chains_text(const MotionResult& result) {
  std::vector<std::string> counts;
  for (const MotionSubChain& part : result.sub_chains) {
    counts.push_back(std::to_string(part.motion.branches.size()));
  }
  std::string text = std::to_string(counts.size()) + " independent sub-chains, of " +
                     joined(counts, ", ") +
                     " branches: a branch of the whole is one of each, as long as all exist\n";
  if (!result.drawn.empty()) text += "as drawn: branch " + result.drawn + " of the whole\n";
  for (std::size_t k = 0; k < result.sub_chains.size(); ++k) {
    const auto& [chain, motion] = result.sub_chains[k];
    text += "\nsub-chain " + std::to_string(k + 1) + ", " + joined(chain.bodies, ", ");
    if (!motion.branches.empty()) {
      const std::string& id = motion.branches.front().id;
      text += "; its branch " + id + " is --closure " + sub_chain_name(k, id);
    }
    text += '\n' + course_text(motion, chain.mechanism);
  }
  return text;
}

}  // namespace

std::string motion_text(const MotionResult& result, const Mechanism& mechanism,
                        const std::string& file) {
  std::string text = (mechanism.title.empty() ? file : mechanism.title + " (" + file + ")") + '\n';
  text += warnings_text(mechanism) + idle_text(result.idle) +
          counted(result.branches.size(), "branch", "branches") +
          (result.all_listed ? "" : " listed, of more,") + " from " +
          place_text(result.from, drivers_text(mechanism, result.from)) + " to " +
          moving_place(mechanism, result.to) + '\n' + result.message + '\n';
  text += result.sub_chains.empty() ? course_text(result, mechanism) : sub_chains_text(result);
  for (const std::string& failure : result.failures) text += "failed: " + failure + '\n';
  return text + left_out_text(result.left_out);
}

}  // namespace moivre
