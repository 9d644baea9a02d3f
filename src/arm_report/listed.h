// SPDX-License-Identifier: MIT
// Which lines does a list of joint values have, and in which order?
//
// One for each closure, or, where all turns are told, for each choice of whole turns that the
// limits allow; with a place where the arm stands, in the order of their distance from there.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "moivre/arm_report/arm_report.h"

namespace moivre {

struct ListedPosture {
  const ArmClosure* closure = nullptr;
  Eigen::VectorXd values;  ///< in_limits, with the whole turns of this line
};

/// Of one result of the report. They point into it.
std::vector<ListedPosture> listed(const ArmReport& report, const ArmResult& result);

}  // namespace moivre
