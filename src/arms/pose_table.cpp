// SPDX-License-Identifier: MIT
// Closures of pose after pose, put row under row.
#include "moivre/arms/pose_table.h"

#include <string>

#include "moivre/numeric/invalid_input.h"

namespace moivre {
namespace {

void append(const ArmResult& result, PoseTable& table) {
  for (const ArmClosure& closure : result.closures) {
    table.values.insert(table.values.end(), closure.in_limits.begin(), closure.in_limits.end());
    table.residual.push_back(closure.residual);
    table.beyond.push_back(closure.beyond.empty() ? 0 : 1);
    table.singular.push_back(closure.singular ? 1 : 0);
  }
  table.first.push_back(table.residual.size());
  table.complete.push_back(result.complete ? 1 : 0);
  table.moves.push_back(result.moves.empty() ? 0 : 1);
}

}  // namespace

PoseTable tabulate_arm_closures(const Arm& arm, const std::vector<Eigen::Isometry3d>& poses,
                                const Tracker& tracker, const SolveOptions& options,
                                const std::atomic<bool>& stop) {
  PoseTable table;
  table.joints = arm.joints.size();
  for_each_pose(
      arm, poses, tracker, [&](ArmResult&& result) { append(result, table); }, options, stop);
  return table;
}

std::vector<Eigen::Isometry3d> poses_of(std::span<const double> matrices) {
  constexpr std::size_t kNumbers = 16;
  if (matrices.size() % kNumbers != 0) {
    throw InvalidInput("a pose is 16 numbers, a matrix row by row; " +
                       std::to_string(matrices.size()) + " are no whole poses");
  }
  std::vector<Eigen::Isometry3d> poses(matrices.size() / kNumbers);
  using RowByRow = Eigen::Matrix<double, 4, 4, Eigen::RowMajor>;
  for (std::size_t k = 0; k < poses.size(); ++k) {
    poses[k].matrix() = Eigen::Map<const RowByRow>(matrices.data() + kNumbers * k);
  }
  return poses;
}

}  // namespace moivre
