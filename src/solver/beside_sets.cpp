// SPDX-License-Identifier: MIT
// Paths to sets in more digits, and what their ends there say of the ends that were told.
#include "beside_sets.h"

#include <algorithm>
#include <map>

#include "clusters.h"
#include "coincidence.h"
#include "completeness.h"
#include "ends.h"
#include "judge.h"
#include "more_digits.h"
#include "tracking.h"

namespace moivre {
namespace {

// So many that end at one point of a set, one at a time.
constexpr std::size_t kMostOfOneEnd = 4;

/// The paths to ends on sets of this kind.
PathSet paths_to_sets(const Run& run, SetHere kind) {
  PathSet paths;
  for (const auto& [group, ground] : judge(run).roots) {
    if (ground != Ground::on_set) continue;
    if (set_of(run, run.table.roots().at(group.front())) != kind) continue;
    paths.insert(group.begin(), group.end());
  }
  return paths;
}

class MeetingSheets {
 public:
  explicit MeetingSheets(Run& run) : run_(run) {
    for (const std::uint64_t path : paths()) before_.emplace(path, root(path));
  }

  /// In double-double: all, where they go together, else a few of one end. Then the first ones in
  /// more digits as long as that helps; all of them as long as a root is missing.
  void follow() {
    const Trackers& trackers = run_.setting.trackers;
    if (trackers.fine_lanes) {
      raise_together(run_, paths(), Taken::regular_ends);
    } else {
      raise_precision(run_, first_of_one_end(), Taken::regular_ends);
    }
    for (const auto& tracker : trackers.finer) {
      raise_while_it_helps(run_, *tracker, paths(), [&] { return is_root_missing(run_); });
      if (!is_root_missing(run_)) return;
    }
  }

  /// Where no simple root is proved the end is what it was. But where a path has a regular end
  /// elsewhere its circles were none: what the others of them end at is not known, nor what two end
  /// at that come to one place.
  void conclude() {
    std::map<std::uint64_t, Point> elsewhere;
    for (const auto& [path, before] : before_) {
      if (!run_.table.failures().contains(path)) continue;
      const auto last = run_.table.last_points().find(path);
      if (last != run_.table.last_points().end()) elsewhere.emplace(path, last->second);
      run_.table.enter_root(path, Root(before));
    }
    for (const auto& [path, before] : before_) {
      const auto now = run_.table.roots().find(path);
      if (now == run_.table.roots().end() || now->second.point.simple) continue;
      if (is_broken(path, elsewhere)) run_.table.refute(path);
    }
    const PathSet left = paths();
    for (const std::uint64_t path : left) {
      if (misses_a_root(path)) run_.table.refute(path);
    }
    for (const auto& [group, ground] : judge(run_).roots) {
      // Paths to a set end at different points of it: two at one may be at a multiple root.
      const bool is_crowded = group.size() > 1 && ground == Ground::on_set;
      if (!is_crowded && !left.contains(group.front())) continue;
      if (!is_exactly_isolated(run_.setting.f, root(group.front()))) continue;
      for (const std::uint64_t path : group) run_.table.refute(path);
    }
  }

 private:
  const Root& root(std::uint64_t path) const { return run_.table.roots().at(path); }

  bool misses_a_root(std::uint64_t path) const {
    const Certificate* const beside = run_.table.beside(path);
    return beside && !is_held(run_, *beside);
  }

  PathSet paths() const {
    PathSet paths = paths_to_sets(run_, SetHere::sharp);
    if (is_root_missing(run_)) return paths;
    std::erase_if(paths, [&](std::uint64_t path) {
      return root(path).winding.value_or(1) == 1 && !misses_a_root(path);
    });
    return paths;
  }

  PathSet first_of_one_end() const {
    const PathSet all = paths();
    PathSet first;
    for (const JudgedRoot& judged : judge(run_).roots) {
      for (const std::uint64_t path : judged.paths) {
        if (all.contains(path) && first.size() < kMostOfOneEnd) first.insert(path);
      }
      if (!first.empty()) break;
    }
    return first;
  }

  /// Another path of its circle ends elsewhere; or at its own place, where it does so itself.
  bool is_broken(std::uint64_t path, const std::map<std::uint64_t, Point>& elsewhere) const {
    const Root& before = before_.at(path);
    const auto own = elsewhere.find(path);
    return std::any_of(elsewhere.begin(), elsewhere.end(), [&](const auto& other) {
      if (other.first == path) return false;
      return own == elsewhere.end()
                 ? relative_distance(before.point.x, other.second) <= before.tolerance
                 : relative_distance(own->second, other.second) <= kMeanIsKnownTo;
    });
  }

  Run& run_;
  std::map<std::uint64_t, Root> before_;
};

}  // namespace

void look_beside_sets(Run& run) {
  MeetingSheets sheets(run);
  sheets.follow();
  sheets.conclude();
}

void look_at_blurred_sets(Run& run) {
  const PathSet paths = paths_to_sets(run, SetHere::blurred);
  raise_precision(run, paths, Taken::regular_ends);
  PathSet left;
  for (const std::uint64_t path : paths) {
    const auto root = run.table.roots().find(path);
    if (root != run.table.roots().end() && !root->second.point.simple) left.insert(path);
  }
  if (run.interrupted || left.size() == paths.size()) return;
  for (const std::uint64_t path : left) run.table.refute(path);
}

}  // namespace moivre
