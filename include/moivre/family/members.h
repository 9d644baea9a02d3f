// SPDX-License-Identifier: MIT
// What are the roots of many members of a family? Few paths for each member, together in lanes that
// stay full.
//
// Every path goes from p* to its own member (Homotopy::members). There is no endgame. A member is
// done if all its paths end at different regular roots and, for a real member, every root has its
// conjugate. Any other member is solved again by solve_member(), which judges its ends; `judged`
// says so.
//
// Thread-safe; the result does not depend on the number of threads. Members are given as doubles;
// solve_member() takes exact values.
#pragma once

#include <optional>
#include <span>

#include "moivre/family/family.h"

namespace moivre {

struct MemberRoot {
  Point x;
  bool real = false;
  bool singular = false;
  std::uint64_t multiplicity = 1;
  double accuracy = 0;  ///< relative to max(1, |x|_inf)
  double condition =
      0;  ///< of the homogeneous Jacobian with its patch; as Solution's where `judged`
  std::optional<bool> certified;
};

struct MemberRoots {
  std::vector<MemberRoot> roots;  ///< in the order of the family's roots where not `judged`
  std::uint64_t at_infinity = 0;  ///< paths
  std::uint64_t failed = 0;       ///< paths
  std::uint64_t not_needed = 0;   ///< paths
  bool complete = false;          ///< every path was decided
  bool judged = false;            ///< by solve_member()
  std::optional<RootCompleteness> completeness;  ///< nullopt: no certificates were asked for

  std::uint64_t real_count() const;
};

/// As solve_members(), but a member that is not done by its paths alone stays as it is, and is not
/// complete. Ends of large condition are among its roots, and count as failed: they may be
/// singular, or lie far out.
std::vector<MemberRoots> follow_members(const Family& family, std::span<const Point> members,
                                        const Tracker& tracker, const SolveOptions& options = {},
                                        const std::atomic<bool>& stop = std::atomic<bool>{false});

/// One entry for each member, in their order. Of the options only seed, threads,
/// tolerance_level, certify, fallback, observations and progress are used; progress counts members.
/// Throws as solve_member(). A set `stop` leaves members that are not complete.
std::vector<MemberRoots> solve_members(const Family& family, std::span<const Point> members,
                                       const Tracker& tracker, const SolveOptions& options = {},
                                       const std::atomic<bool>& stop = std::atomic<bool>{false});

}  // namespace moivre
