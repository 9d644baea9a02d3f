// SPDX-License-Identifier: MIT
// In how many ways does a robot reach each of a thousand poses? All inverse kinematics, in flat
// buffers.
#include <algorithm>
#include <iostream>
#include <map>

#include "moivre/moivre.h"

int main(int argc, char** argv) {
  const std::string file = argc > 1 ? argv[1] : "problems/robots/ur5.urdf";
  const moivre::Robot robot = moivre::read_urdf(moivre::read_source(file));
  const moivre::Arm arm = moivre::make_arm(robot, {"base_link", "tool0", {}});

  std::vector<Eigen::Isometry3d> poses;
  for (int k = 0; k < 1000; ++k) {
    Eigen::VectorXd q(6);
    for (int j = 0; j < 6; ++j) q[j] = 3 * std::sin(0.37 * k + 1.1 * j + 0.01 * k * j);
    poses.push_back(moivre::forward_kinematics(arm, q));
  }
  const auto tracker = moivre::make_lane_tracker();
  const moivre::PoseTable table = moivre::tabulate_arm_closures(arm, poses, *tracker);

  std::map<std::size_t, int> poses_with;
  double worst = 0;
  for (std::size_t k = 0; k < table.poses(); ++k) {
    ++poses_with[table.first[k + 1] - table.first[k]];
    for (std::size_t row = table.first[k]; row < table.first[k + 1]; ++row) {
      const Eigen::Map<const Eigen::VectorXd> q(table.values.data() + 6 * row, 6);
      const Eigen::Isometry3d there = moivre::forward_kinematics(arm, q);
      worst = std::max(worst, (there.matrix() - poses[k].matrix()).cwiseAbs().maxCoeff());
    }
  }
  for (const auto& [count, number] : poses_with) {
    std::cout << number << " poses have " << count << " closures\n";
  }
  std::cout << "forward kinematics returns to the pose: " << (worst < 1e-9 ? "yes" : "no") << '\n';
}
