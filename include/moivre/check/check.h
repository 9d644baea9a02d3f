// SPDX-License-Identifier: MIT
// Is a result true? Every claim that can be verified is judged from the exact coefficients of the
// system.
//
// A claim holds (proved, or recomputed), is refuted, or is open: not verifiable here.
//   root          a regular root exists: Krawczyk's test (certify/certifier.h) from the doubles of
//                 the result
//   accuracy      that root lies within what is stated; refuted where none does: exact Taylor sums
//                 (moivre/polynomial/exclusion.h)
//   distinct      no two entries are one root
//   real          roots called real are real, roots called not real are not
//   multiplicity  of a singular root: holds where exact algebra counts it, or a cluster's roots are
//                 proved; refuted where regular roots are proved that no other entry lists, or none
//                 is near; else open, a claim of proof but for a cluster's
//   residual, condition   recomputed
//   system, reduced, start, paths, complete   facts and sums; the conjugate of a root of a real
//                                             system is a root
//   certified, completeness   proved again here; completeness by a bound of bounds/root_bounds.h
//                             that the distinct roots meet
//   bound         its value is the number of the roots, and that of its kind
//   inequality    every root meets the conditions of the file; open on the boundary, as far as what
//                 is proved of the root tells
//   plane         every equation is zero on the coordinate plane, of the dimension that is stated
// A list of PHCpack claims roots, each listed once, and how many there are. It knows no conditions.
//
// The judge shares reading, the tape, the certificates and the bounds with the solver, but nothing
// that follows a path.
// Edges: if a system is not square or has homogeneous groups, the square system of
// polynomial/square_up.h or patches.h is judged.
// If that proves nothing about the file's own system, roots are open; they are refuted if an
// equation of the file excludes them.
// A result whose unknowns are not those of the system belongs to another file. It is refuted and
// judged no further.
#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "moivre/bounds/root_bounds.h"
#include "moivre/check/claims.h"
#include "moivre/polynomial/system.h"

namespace moivre {

enum class ClaimKind {
  system,
  reduced,
  start,
  paths,
  complete,
  root,
  accuracy,
  distinct,
  real,
  multiplicity,
  residual,
  condition,
  digits,
  certified,
  completeness,
  bound,
  inequality,
  plane
};
std::string to_string(ClaimKind kind);

/// A claim that does not hold, or cannot be verified, and why.
struct Finding {
  ClaimKind claim = ClaimKind::system;
  std::optional<std::size_t> root;  ///< number of the root in the result, from 1
  std::string why;
};

struct ClaimTally {
  ClaimKind claim = ClaimKind::system;
  std::size_t holds = 0, refuted = 0, open = 0;
};

/// Numbers of roots of the result by what is proved about them.
struct RootTally {
  std::size_t listed = 0;
  std::size_t certified = 0;  ///< a regular root is proved to lie near, within a ball of its own
  std::size_t distinct = 0;   ///< different ones among these
  std::uint64_t counted =
      0;  ///< multiplicities, by exact algebra, of singular roots that are known exactly
  std::size_t counted_points = 0;  ///< of these
  std::size_t real = 0;            ///< of the distinct ones, proved
  std::size_t not_real = 0;
  std::size_t doubled = 0;    ///< proved to be an earlier one of the list
  std::size_t not_roots = 0;  ///< proved to have no root near
  std::size_t unproved = 0;   ///< said to be certified; neither a root nor none is proved near
};

struct Judgement {
  ClaimForm form = ClaimForm::solve_json;
  bool is_judged_whole = true;  ///< false: of another file, its roots were not looked at
  std::string stand_in;         ///< which square system stands for the file's; empty: its own
  RootTally roots;
  std::vector<RootBound> bounds;
  std::optional<BoundKind> proved_by;  ///< the distinct roots meet this bound: they are all
  std::vector<ClaimTally> claims;      ///< of every kind that is claimed
  std::vector<Finding> refuted;
  std::vector<Finding> open;
  std::size_t unverified_proofs = 0;  ///< of the open claims: what is said to be proved
  bool interrupted = false;           ///< by the stop flag: what was not judged is in no list

  bool holds() const { return refuted.empty(); }
  /// No claim is refuted, and what is said to be proved is.
  bool proofs_hold() const { return holds() && unverified_proofs == 0 && !interrupted; }
};

/// Once `stop` is set the judgement ends with what was judged.
Judgement check(const System& f, const Claims& claims,
                const std::atomic<bool>& stop = std::atomic<bool>{false});

}  // namespace moivre
