// SPDX-License-Identifier: MIT
// What are the roots of very many members of a family, in a few flat buffers instead of a struct
// for each root?
//
//   N members, n unknowns, R roots of all together;  roots of member k: rows first[k] to first[k +
//   1]
// The same roots as solve_members(), in the same order. Members are taken a few thousand at a time,
// so that the memory is that of the table, 16 n + 19 bytes for each root.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "moivre/family/members.h"

namespace moivre {

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
