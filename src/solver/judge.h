// SPDX-License-Identifier: MIT
// Which ends stand, and what is open? Derived from what was seen of the paths and what is proved of
// their ends; nothing is written down.
//
//   a root stands     on one ground (judged_roots.h): one path ends at a simple root, whole cycles
//                     end at a singular one, or paths end on a set
//   no end            the path was followed to none
//   no root           what was seen of its end is none: it was refuted, or it lies beside a simple
//                     root, or a path is missing or one too many for whole cycles
//   jumped            another path ends at the same simple root, or came back to the same sheet
//
// Where a count has settled the run nothing is open. Private to the module.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <vector>

#include "judged_roots.h"
#include "run.h"

namespace moivre {

enum class Question { no_end, no_root, jumped };

struct JudgedEnds {
  /// Paths that end at one point, each group ascending, and its ground.
  JudgedRoots roots;
  /// By path; these end at none of the roots as far as is known.
  std::map<std::uint64_t, Question> open;
  /// Paths that may answer a question where they are followed again: those that are open and those
  /// that they meet.
  PathSet in_doubt;
};

/// From the ends alone. Throws Interrupted.
JudgedEnds judge_ends_alone(const Run& run);

/// From the ends and the sheets to which paths have come back from them. Throws Interrupted.
JudgedEnds judge(const Run& run);

/// On what a group of paths that end at one point rests as far as is known, without looking
/// further; nothing where it may not stand.
std::optional<Ground> known_ground(const Run& run, PathGroups::Group group);

/// The paths of a group whose ends are simple roots, and those whose ends are not. Where there are
/// both, several roots lie nearer to each other than the latter are known: no path but one ends at
/// a simple root.
struct EndsOfGroup {
  std::vector<std::uint64_t> simple;
  std::vector<std::uint64_t> singular;
};
EndsOfGroup ends_of(const Run& run, PathGroups::Group group);

/// The paths of each isolated place at which several end and some show no simple root: those,
/// unless the root is known exactly. Throws Interrupted.
PathGroups clusters_at(const Run& run);

/// Open paths, but for those that the caller's budget has ended: more digits save no steps. Throws
/// Interrupted.
PathSet open_to_more_digits(const Run& run);

/// How a question that stays open is told.
FailedPath told_as_failed(const Run& run, std::uint64_t path, Question question);

}  // namespace moivre
