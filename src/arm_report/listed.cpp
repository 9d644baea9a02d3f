// SPDX-License-Identifier: MIT
// Closures and their turns, the nearest first.
#include "listed.h"

#include <algorithm>

#include "moivre/arms/turns.h"

namespace moivre {

std::vector<ListedPosture> listed(const ArmReport& report, const ArmResult& result) {
  std::vector<ListedPosture> lines;
  for (const ArmClosure& closure : result.closures) {
    if (!report.has_all_turns) {
      lines.push_back({&closure, closure.in_limits});
      continue;
    }
    for (Eigen::VectorXd& values : all_turns(report.arm, closure.in_limits)) {
      lines.push_back({&closure, std::move(values)});
    }
  }
  if (!report.stands || !report.has_all_turns) return lines;
  std::stable_sort(lines.begin(), lines.end(), [&](const ListedPosture& a, const ListedPosture& b) {
    return is_nearer(report.arm, a.values, b.values, *report.stands);
  });
  return lines;
}

}  // namespace moivre
