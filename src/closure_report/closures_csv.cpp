// SPDX-License-Identifier: MIT
// Closures as a table: one a line, coordinates in their order.
#include "joint_values.h"
#include "moivre/closure_report/angles.h"
#include "moivre/closure_report/closure_report.h"
#include "moivre/report/number_text.h"

namespace moivre {

std::string closures_csv(const ClosureResult& result, const Mechanism& mechanism,
                         const AngleForm& form) {
  const std::vector<Coordinate> all = coordinates(mechanism);
  std::string text = "id,path,residual,newton_iterations,smallest_singular_value";
  for (const Coordinate& coordinate : all) {
    text += ',' + column_name(coordinate.name, coordinate.kind, form);
  }
  const Eigen::VectorXd rest = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(all.size()));
  for (const JointValue& joint : joint_values(mechanism, rest)) {
    text += ',' + column_name("joint " + joint.name, joint.kind, form);
  }
  text += '\n';
  for (const Closure& closure : result.closures) {
    text += closure.id + ',' + std::to_string(closure.path) + ',' + exact_text(closure.residual) +
            ',' + std::to_string(closure.newton_iterations) + ',' +
            exact_text(closure.smallest_singular_value);
    for (std::size_t k = 0; k < all.size(); ++k) {
      text += ',' + exact_text(in_form(closure.q[static_cast<Eigen::Index>(k)], all[k].kind, form));
    }
    for (const JointValue& joint : joint_values(mechanism, closure.q)) {
      text += ',' + exact_text(in_form(joint.value, joint.kind, form));
    }
    text += '\n';
  }
  return text;
}

}  // namespace moivre
