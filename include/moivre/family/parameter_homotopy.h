// SPDX-License-Identifier: MIT
// Where do known roots of one member of a system go when its parameters take other values? A
// parameter homotopy from one's own starts.
//
//   F(x; p): as many equations as unknowns x, and parameters p by name;  F(x_k; p0) = 0 to some
//   digits, x_k regular
//   track   along the straight line from p0 to p1, each root to its end
//   solve   the roots of F(x; p1) that known roots lead to. From p0 they go to a random complex p*
//           first and from there to p1, so that no two meet on the way, whatever p0 and p1 are.
//           Ends are judged, refined, certified and counted as in solve().
// p0 and p1 are exact where they are given as such; start points are corrected by Newton's method
// first.
// Whether all roots of F(x; p1) are found depends on the start points: the result is complete only
// where a proved count says so.
// Edges: on a straight line between real parameters real roots may meet; track says where it broke
// off. solve does not meet them.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "moivre/family/family.h"

namespace moivre {

/// F(x; p) and what is known of it at p0.
struct ParameterProblem {
  System system;                        ///< in unknowns and parameters, in any order
  std::vector<std::string> parameters;  ///< names, in the order of p0 and p1
  ParameterValues from;                 ///< p0
  std::vector<Point> roots;             ///< at p0, each in the order of the system's unknowns
};

/// Throws InvalidInput, with every broken rule, where names, sizes or numbers do not fit. A start
/// point that is no regular root at p0 is left out, and `left_out` says how many were.
SolveResult solve(const ParameterProblem& problem, const ParameterValues& to,
                  const Tracker& tracker, const SolveOptions& options = {},
                  const std::atomic<bool>& stop = std::atomic<bool>{false});

/// The end of each root's path in its place; nullopt where the path broke off, or ends at no
/// regular root. Throws as solve().
std::vector<std::optional<Point>> track(const ParameterProblem& problem, const ParameterValues& to,
                                        const Tracker& tracker, int threads = 0,
                                        const std::atomic<bool>& stop = std::atomic<bool>{false});

}  // namespace moivre
