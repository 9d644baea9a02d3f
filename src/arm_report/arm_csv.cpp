// SPDX-License-Identifier: MIT
// Joint values as a table: one closure a line.
#include <numbers>

#include "listed.h"
#include "moivre/arm_report/arm_report.h"
#include "moivre/report/csv_cell.h"
#include "moivre/report/number_text.h"
#include "moivre/report/text_pieces.h"

namespace moivre {

void write_arm_csv(const TextSink& sink, const ArmReport& report, bool in_degrees) {
  const std::string unit = in_degrees ? " [deg]" : " [rad]";
  TextPieces text(sink);
  text += "pose,id,path,residual,newton_iterations,smallest_singular_value,within_limits";
  for (const ArmJoint& joint : report.arm.joints) {
    text += ',' + csv_cell(joint.name + (joint.is_slide ? "" : unit));
  }
  if (const auto swept = swept_joint(report, 0)) text += ',' + csv_cell(swept->name + " held");
  text += "\n";
  const auto add_line = [&](std::size_t pose, const ArmClosure& closure,
                            const Eigen::VectorXd& values) {
    text += std::to_string(pose) + ',' + closure.id + ',' + std::to_string(closure.path) + ',' +
            exact_text(closure.residual) + ',' + std::to_string(closure.newton_iterations) + ',' +
            exact_text(closure.smallest_singular_value) + ',' +
            (closure.beyond.empty() ? "true" : "false");
    for (std::size_t k = 0; k < report.arm.joints.size(); ++k) {
      const double value = values[static_cast<Eigen::Index>(k)];
      const bool turns = in_degrees && !report.arm.joints[k].is_slide;
      text += ',' + exact_text(turns ? value * 180 / std::numbers::pi : value);
    }
    if (const auto swept = swept_joint(report, pose)) text += ',' + exact_text(swept->value);
    text += "\n";
  };
  for (std::size_t pose = 0; pose < report.results.size(); ++pose) {
    for (const ListedPosture& line : listed(report, report.results[pose])) {
      add_line(pose, *line.closure, line.values);
    }
  }
  text.flush();
}

std::string arm_csv(const ArmReport& report, bool in_degrees) {
  return whole_text([&](const TextSink& sink) { write_arm_csv(sink, report, in_degrees); });
}

}  // namespace moivre
