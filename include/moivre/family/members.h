// SPDX-License-Identifier: MIT
// Which members of a family are requested, and what are their roots? Of one, by as many paths as a
// generic member has roots; of many, together in lanes that stay full; of very many, in a few flat
// buffers.
//
// Values typed as "a=1, b=2/3", or a table with a column for each parameter:
// A value is an expression whose only name is i, the imaginary unit: 3.1, 1/3, 2e-3 - i. It is
// exact; in a table it is rounded to double.
// Every fault is named: in one std::invalid_argument, or, of a table, in one ParseError with line
// and column.
//
// One member:
//   H(x, t) = F(x; (1 - t) p* + t p),  t from 0 to 1, from the roots at p*
//
// p* is a random complex member, so that no path meets another before t = 1. Ends are judged,
// refined, certified and counted as in solve(). If p is special, roots meet or go to infinity, and
// the counts show it. Rows and unknowns are scaled for the system at p.
//
// Completeness:
//   proved   as many roots are certified as the bound allows that was met by the learning
//   shown    every path was decided, every regular root is certified, and the learning is complete
//   open     neither
//
// Many members:
// Every path goes from p* to its own member (Homotopy::members). There is no endgame. A member is
// done if all its paths end at different regular roots and, for a real member, every root has its
// conjugate. Any other member is solved again by solve_member(), which judges its ends; `judged`
// says so.
//
// Thread-safe; the result does not depend on the number of threads. Members are given as doubles;
// solve_member() takes exact values.
//
// A table:
//   N members, n unknowns, R roots of all together;  roots of member k: rows first[k] to first[k +
//   1]
// The same roots as solve_members(), in the same order. Members are taken a few thousand at a time,
// so that the memory is that of the table, 16 n + 19 bytes for each root.
#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "moivre/expression/source.h"
#include "moivre/family/family.h"

namespace moivre {

/// Throws std::invalid_argument: what is no number, unknown names, names given twice, and every
/// parameter without a value.
ParameterValues values_at(const Family& family, const std::string& text);

/// Members, a row each. The head names the parameters, in any order; columns are separated by
/// commas. Blank lines and lines that begin with # are skipped.
std::vector<Point> read_members(const Source& source, const Family& family);

/// Throws std::invalid_argument when p has another size than the family, or options are out of
/// range.
SolveResult solve_member(const Family& family, const ParameterValues& p, const Tracker& tracker,
                         const SolveOptions& options = {},
                         const std::atomic<bool>& stop = std::atomic<bool>{false});

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

struct MemberTable {
  std::size_t unknowns = 0;             ///< n
  std::vector<Complex> points;          ///< R x n, row by row
  std::vector<std::size_t> first{0};    ///< N + 1
  std::vector<double> accuracy;         ///< R, as MemberRoot's
  std::vector<std::uint8_t> real;       ///< R, 1: all coordinates are
  std::vector<std::uint8_t> singular;   ///< R
  std::vector<std::uint8_t> certified;  ///< R, 0 also where no certificates were asked for
  std::vector<std::uint8_t> complete;   ///< N, every path was decided
  std::vector<RootCompleteness>
      completeness;  ///< N, open also where no certificates were asked for

  std::size_t members() const { return first.size() - 1; }
};

/// parameters: N x k numbers, row by row. Throws as solve_members(), and InvalidInput where they
/// are no whole rows. A set `stop` leaves members without roots that are not complete.
MemberTable solve_member_table(const Family& family, std::span<const Complex> parameters,
                               const Tracker& tracker, const SolveOptions& options = {},
                               const std::atomic<bool>& stop = std::atomic<bool>{false});

}  // namespace moivre
