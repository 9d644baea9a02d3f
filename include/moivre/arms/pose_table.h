// SPDX-License-Identifier: MIT
// With which joint values does an arm hold very many poses, in a few flat buffers instead of a
// struct for each posture?
//
//   N poses, n joints, R closures of all together;  closures of pose k: rows first[k] to first[k +
//   1]
// The same closures as find_arm_closures(), in the same order. The memory is that of the table, 8 n
// + 10 bytes for each closure.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "moivre/arms/arm_closures.h"

namespace moivre {

struct PoseTable {
  std::size_t joints = 0;              ///< n
  std::vector<double> values;          ///< R x n, row by row: ArmClosure::in_limits
  std::vector<std::size_t> first{0};   ///< N + 1
  std::vector<double> residual;        ///< R
  std::vector<std::uint8_t> beyond;    ///< R, 1: outside a joint's limits
  std::vector<std::uint8_t> singular;  ///< R
  std::vector<std::uint8_t> complete;  ///< N, every path was decided
  std::vector<std::uint8_t> moves;     ///< N, joints may move while the tip stands still

  std::size_t poses() const { return first.size() - 1; }
};

/// A set `stop` leaves out the poses that are not begun. Throws as find_arm_closures().
PoseTable tabulate_arm_closures(const Arm& arm, const std::vector<Eigen::Isometry3d>& poses,
                                const Tracker& tracker, const SolveOptions& options = {},
                                const std::atomic<bool>& stop = std::atomic<bool>{false});

/// Poses as 4 x 4 matrices, row by row, one after another. Throws InvalidInput where they are no
/// whole matrices.
std::vector<Eigen::Isometry3d> poses_of(std::span<const double> matrices);

}  // namespace moivre
