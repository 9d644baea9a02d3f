// SPDX-License-Identifier: MIT
// How is inverse kinematics reported? As a table of joint values for people, as JSON and CSV for
// programs, as pictures.
//
//   text  every closure a line, joint values in radians (or metres) within the limits where whole
//         turns bring them there
//   JSON  docs/json.md shows it: `coordinates` has turns in (-pi, pi], `in_limits` what a
//         controller takes
//   CSV   one closure per line: pose, id, then the joints as in_limits; with all turns a line for
//         each choice of them; last the joint that is held at many values, where there is one
// A list of results stands for a file of poses; `is_list` says whether there was one, or a single
// pose.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "moivre/arms/arm_closures.h"
#include "moivre/closure_report/sheet.h"
#include "moivre/report/text_sink.h"

namespace moivre {

struct ArmReport {
  std::string file;  ///< of the robot, as the user named it
  Arm arm;
  std::vector<ArmResult> results;  ///< a pose each
  bool is_list = false;
  /// An arm for each result, with one joint held at another value (arms/held_range.h); empty: `arm`
  /// for all.
  std::vector<Arm> swept = {};
  /// Where the arm stands, a value for each joint: closures are in the order of their distance from
  /// there.
  std::optional<Eigen::VectorXd> stands = std::nullopt;
  bool has_all_turns = false;  ///< every choice of whole turns within the limits is told
  double parse_s = 0;
  double total_s = 0;
};

/// The arm that the k-th result is of.
const Arm& arm_of(const ArmReport& report, std::size_t k);

/// The joint that was held at many values; nothing where there is none.
std::optional<HeldJoint> swept_joint(const ArmReport& report, std::size_t k);

/// Whether every path of every pose was decided.
bool is_complete(const ArmReport& report);

std::string arm_text(const ArmReport& report);
std::string arm_json(const ArmReport& report);
std::string arm_csv(const ArmReport& report, bool in_degrees);
/// The same, pose by pose.
void write_arm_json(const TextSink& sink, const ArmReport& report);
void write_arm_csv(const TextSink& sink, const ArmReport& report, bool in_degrees);

/// The skeletons of all closures of one pose, side by side from where they differ most, as a
/// picture and as a page that the mouse turns. Throw std::invalid_argument where there are several
/// poses.
std::string arm_svg(const ArmReport& report, bool in_degrees, Views views = Views::standing);
std::string arm_html(const ArmReport& report, bool in_degrees);

}  // namespace moivre
