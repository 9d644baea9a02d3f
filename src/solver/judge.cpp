// SPDX-License-Identifier: MIT
// The laws of ends: group by group, then sheet by sheet.
#include "judge.h"

#include <algorithm>
#include <utility>

#include "certificates.h"

namespace moivre {
namespace {

/// One path at a simple root, whole cycles at a singular one, or ends on a set. `set`: whether the
/// singular ends lie on one, where that is known.
std::optional<Ground> ground_of(const Run& run, const EndsOfGroup& ends, PathGroups::Group group,
                                std::optional<SetHere> set) {
  if (ends.singular.empty())
    return group.size() == 1 ? std::optional(Ground::proved) : std::nullopt;
  if (!ends.simple.empty() || !set) return std::nullopt;
  if (*set != SetHere::none) return Ground::on_set;
  if (group.size() == 1 || !cycles(run.table, group)) return std::nullopt;
  const bool is_exact = run.table.roots().at(group.front()).is_exact;
  return is_exact ? Ground::exact : Ground::whole_cycles;
}

/// Throws Interrupted.
std::optional<Ground> ground_of(const Run& run, const EndsOfGroup& ends, PathGroups::Group group) {
  const bool are_singular = ends.simple.empty() && !ends.singular.empty();
  if (!are_singular) return ground_of(run, ends, group, std::nullopt);
  return ground_of(run, ends, group, set_of(run, run.table.roots().at(group.front())));
}

/// Of the paths of a group that does not stand the first one to a simple root has its root.
void open(const EndsOfGroup& ends, JudgedEnds& judged) {
  for (const std::uint64_t path : ends.singular) judged.open[path] = Question::no_root;
  if (ends.simple.empty()) return;
  judged.roots.add(ends.simple.front(), Ground::proved);
  for (std::size_t k = 1; k < ends.simple.size(); ++k) {
    judged.open[ends.simple[k]] = Question::jumped;
  }
}

/// Of ends on a set only those of the paths themselves are open; elsewhere the whole group that one
/// of them is part of.
void open_shared_sheets(const PathSet& shared, JudgedEnds& judged) {
  const auto is_shared = [&](std::uint64_t path) { return shared.contains(path); };
  JudgedRoots left;
  left.reserve(judged.roots.size(), judged.roots.path_count());
  for (const auto& [group, ground] : judged.roots) {
    if (std::none_of(group.begin(), group.end(), is_shared)) {
      left.add(group, ground);
      continue;
    }
    for (const std::uint64_t path : group) {
      if (is_shared(path) || ground != Ground::on_set) judged.open[path] = Question::no_root;
    }
    std::vector<std::uint64_t> others(group.begin(), group.end());
    std::erase_if(others, [&](std::uint64_t path) { return judged.open.contains(path); });
    if (!others.empty()) left.add(others, ground);
  }
  judged.roots = std::move(left);
  for (const std::uint64_t path : shared) {
    Question& question = judged.open.try_emplace(path, Question::jumped).first->second;
    if (question == Question::no_root) question = Question::jumped;
  }
  judged.in_doubt.insert(shared.begin(), shared.end());
}

}  // namespace

EndsOfGroup ends_of(const Run& run, PathGroups::Group group) {
  EndsOfGroup ends;
  for (const std::uint64_t path : group) {
    (run.table.roots().at(path).point.simple ? ends.simple : ends.singular).push_back(path);
  }
  return ends;
}

JudgedEnds judge_ends_alone(const Run& run) {
  JudgedEnds judged;
  for (const auto& [path, failure] : run.table.failures()) {
    judged.open.emplace(path, Question::no_end);
    judged.in_doubt.insert(path);
  }
  for (const std::uint64_t path : run.table.refuted()) {
    judged.open.emplace(path, Question::no_root);
    judged.in_doubt.insert(path);
  }
  const PathGroups groups = groups_of(run);
  judged.roots.reserve(groups.size(), groups.path_count());
  for (const PathGroups::Group group : groups) {
    const EndsOfGroup ends = ends_of(run, group);
    if (const auto ground = ground_of(run, ends, group)) {
      judged.roots.add(group, *ground);
      continue;
    }
    open(ends, judged);
    judged.in_doubt.insert(group.begin(), group.end());
  }
  return judged;
}

JudgedEnds judge(const Run& run) {
  JudgedEnds judged = judge_ends_alone(run);
  const std::vector<std::uint64_t> shared = run.sheets.shared();
  if (!run.is_settled && !shared.empty()) {
    open_shared_sheets(PathSet(shared.begin(), shared.end()), judged);
  }
  return judged;
}

std::optional<Ground> known_ground(const Run& run, PathGroups::Group group) {
  const Root& first = run.table.roots().at(group.front());
  const std::optional<SetHere> set = first.is_exact ? SetHere::none : first.on_set;
  return ground_of(run, ends_of(run, group), group, set);
}

PathGroups clusters_at(const Run& run) {
  PathGroups clusters;
  for (const PathGroups::Group group : groups_of(run)) {
    const EndsOfGroup ends = ends_of(run, group);
    if (group.size() == 1 || ends.singular.empty()) continue;
    const Root& end = run.table.roots().at(ends.singular.front());
    if (!end.is_exact && !is_on_set(run, end)) clusters.add(ends.singular);
  }
  return clusters;
}

PathSet open_to_more_digits(const Run& run) {
  PathSet paths;
  for (const auto& [path, question] : judge(run).open) {
    const bool is_ended = question == Question::no_end &&
                          run.table.failures().at(path).failure == Failure::step_limit;
    if (!is_ended) paths.insert(path);
  }
  return paths;
}

FailedPath told_as_failed(const Run& run, std::uint64_t path, Question question) {
  if (question == Question::no_end) return run.table.failures().at(path);
  return {path, question == Question::jumped ? Failure::jumped : Failure::precision, 1};
}

}  // namespace moivre
