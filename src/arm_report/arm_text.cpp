// SPDX-License-Identifier: MIT
// Inverse kinematics for people: the answer, and a table of joint values.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string_view>

#include "listed.h"
#include "moivre/arm_report/arm_report.h"
#include "moivre/arms/posture.h"
#include "moivre/arms/turns.h"
#include "moivre/expression/counted.h"
#include "moivre/report/number_text.h"
#include "moivre/report/text_blocks.h"

namespace moivre {
namespace {

/// As wide as "-3.141593", two blanks before it.
constexpr std::size_t kWidth = 11;

std::string padded(const std::string& text, std::size_t width) {
  return std::string(width > text.size() ? width - text.size() : 1, ' ') + text;
}

std::string fixed_text(double x) {
  char text[32];
  std::snprintf(text, sizeof text, "%.6f", x);
  return std::string_view(text) == "-0.000000" ? "0.000000" : text;
}

std::string two_digits(double x) {
  char text[32];
  std::snprintf(text, sizeof text, "%.2g", x);
  return text;
}

/// Two digits, and a 0 for rounding.
std::string rounded_text(double x) {
  constexpr double kRounding = 1e-9;
  return two_digits(std::abs(x) < kRounding ? 0 : x);
}

/// A miss of both kinds, as it is compared with an accuracy: next to nothing is not nothing.
std::string miss_text(double x) { return two_digits(x) + " rad or arm's lengths"; }

std::size_t width_of(const ArmJoint& joint) { return std::max(kWidth, joint.name.size() + 2); }

std::string table_head(const Arm& arm) {
  std::string text = "  ";
  for (const ArmJoint& joint : arm.joints) text += padded(joint.name, width_of(joint));
  return text + '\n';
}

/// `values`: the closure's joints, with the whole turns that the line shows.
std::string closure_line(const ArmClosure& closure, const Eigen::VectorXd& values, const Arm& arm,
                         const ArmReport& report) {
  std::string text = closure.id + std::string(closure.id.size() < 2 ? 1 : 0, ' ');
  bool was_beyond = false;
  for (std::size_t k = 0; k < arm.joints.size(); ++k) {
    const bool is_beyond =
        std::find(closure.beyond.begin(), closure.beyond.end(), k) != closure.beyond.end();
    const std::string value = fixed_text(values[static_cast<Eigen::Index>(k)]);
    // The mark stands in the next column's blanks.
    text += padded(value, width_of(arm.joints[k]) - (was_beyond ? 1 : 0)) + (is_beyond ? "!" : "");
    was_beyond = is_beyond;
  }
  // A mark keeps the column's width.
  const std::string posture = to_string(posture_of(arm, closure.values));
  if (!posture.empty()) text += (was_beyond ? " " : "  ") + posture;
  if (closure.singular) text += "  singular";
  if (report.stands) {
    text += "  distance " + rounded_text(distance_from(arm, values, *report.stands));
  }
  if (closure.within_digits) {
    text += "  within the digits alone, misses by " + miss_text(closure.residual);
  }
  if (!closure.beyond.empty()) text += "  beyond limits";
  return text + '\n';
}

std::string answer(const ArmResult& result) {
  std::string text = counted(result.counts.complex, "complex closure") + ", " +
                     std::to_string(result.counts.real) + " real";
  if (result.counts.beyond_limits > 0) {
    text += ", " + std::to_string(result.counts.beyond_limits) + " beyond a joint's limits";
  }
  return text + "; " + result.message + '\n';
}

std::string paths_text(const ArmResult& result) {
  if (result.stages.empty()) return "";
  return counted(result.paths.tracked, "path") + " (" + to_string(result.start.source) + ", " +
         result.tracker + ", seed " + std::to_string(result.seed) +
         "): " + std::to_string(result.paths.finite) + " finite, " +
         std::to_string(result.paths.at_infinity) + " at infinity, " +
         std::to_string(result.paths.failed) + " failed" +
         (result.paths.not_needed == 0
              ? ""
              : ", " + std::to_string(result.paths.not_needed) + " not needed") +
         "; " + counted(result.counts.rejected, "root") + " no closure\n";
}

/// "translation (0, 0, 1), rotation (0.1, 0, 0)", without a part that is none.
std::string twist_text(const Twist& twist) {
  constexpr double kNone = 1e-6;
  const auto part = [](const char* name, const Eigen::Vector3d& v) {
    return std::string(name) + " (" + rounded_text(v.x()) + ", " + rounded_text(v.y()) + ", " +
           rounded_text(v.z()) + ")";
  };
  std::string text;
  if (twist.translation.norm() > kNone) text = part("translation", twist.translation);
  if (twist.rotation.norm() <= kNone) return text;
  return text + (text.empty() ? "" : ", ") + part("rotation", twist.rotation);
}

/// The joints that take part, "joint4 0.71, joint6 -0.71".
std::string joints_text(const Eigen::VectorXd& rates, const Arm& arm) {
  constexpr double kNone = 1e-3;
  std::string text;
  for (std::size_t k = 0; k < arm.joints.size(); ++k) {
    const double rate = rates[static_cast<Eigen::Index>(k)];
    if (std::abs(rate) <= kNone) continue;
    text += (text.empty() ? "" : ", ") + arm.joints[k].name + ' ' + rounded_text(rate);
  }
  return text;
}

/// What is lost at singular closures, or nearly.
std::string weakest_text(const ArmResult& result, const Arm& arm) {
  // Joints are a thousand times as fast there as the tip, in arm's lengths.
  constexpr double kNearlySingular = 1e-3;
  std::string text;
  for (const ArmClosure& closure : result.closures) {
    if (closure.smallest_singular_value > kNearlySingular) continue;
    text += closure.id + " is singular, or nearly (smallest singular value " +
            rounded_text(closure.smallest_singular_value) + "): the tip hardly moves under " +
            joints_text(closure.weakest.joints, arm) + "; it can hardly move along " +
            twist_text(closure.weakest.tip) + '\n';
  }
  return text;
}

/// "joint_4 + joint_6 = 0.3".
std::string relation_text(const JointRelation& relation, const Arm& arm) {
  std::string text;
  for (std::size_t k = 0; k < arm.joints.size(); ++k) {
    const double factor = relation.factors[static_cast<Eigen::Index>(k)];
    if (factor == 0) continue;
    const std::string sign =
        factor < 0 ? (text.empty() ? "-" : " - ") : (text.empty() ? "" : " + ");
    const double size = std::abs(factor);
    text += sign + (size == 1 ? "" : fixed_text(size) + ' ') + arm.joints[k].name;
  }
  return text + " = " + fixed_text(relation.value);
}

std::string set_text(const SelfMotion& set, const Arm& arm) {
  const std::string misses = "(it misses by " + miss_text(set.misfit) + ") ";
  std::string text = set.within_digits     ? "within the digits of the file's numbers " + misses
                     : set.misfit > kReach ? "within the accuracy of the pose " + misses
                                           : std::string();
  text += "the tip stands while the joints move";
  if (set.dimension > 1) text += " (" + std::to_string(set.dimension) + " freedoms)";
  text += ", from here\n  ";
  const auto line = [&](const Eigen::VectorXd& values) {
    std::string joints;
    for (std::size_t k = 0; k < arm.joints.size(); ++k) {
      joints += padded(fixed_text(values[static_cast<Eigen::Index>(k)]), width_of(arm.joints[k]));
    }
    return joints + '\n';
  };
  Eigen::VectorXd placed = set.values;
  place_in_limits(arm, placed);
  text += line(placed) + "along\n";
  for (Eigen::Index k = 0; k < set.directions.cols(); ++k) {
    text += "  " + line(set.directions.col(k));
  }
  for (const JointRelation& relation : set.relations) {
    text += "  " + relation_text(relation, arm) + '\n';
  }
  return text + "there the tip cannot move by " + twist_text(set.lost) + '\n';
}

std::string moves_text(const ArmResult& result, const Arm& arm) {
  std::string text;
  for (const SelfMotion& set : result.moves) text += set_text(set, arm);
  return text;
}

std::string result_text(const ArmResult& result, const Arm& arm, const ArmReport& report) {
  std::string text = answer(result);
  if (!result.closures.empty()) text += table_head(arm);
  for (const ListedPosture& line : listed(report, result)) {
    text += closure_line(*line.closure, line.values, arm, report);
  }
  return text + weakest_text(result, arm) + moves_text(result, arm);
}

std::string heading(const ArmReport& report) {
  const Arm& arm = report.arm;
  std::string text = arm.robot + " (" + report.file + "), from " + arm.base + " to " + arm.tip +
                     ", joint values in radians";
  text += has_slides(arm) ? " and metres\n" : "\n";
  for (const HeldJoint& joint : arm.held) {
    if (const auto swept = swept_joint(report, 0); swept && swept->name == joint.name) continue;
    text += "held: " + joint.name + " = " + exact_text(joint.value) +
            (joint.is_beyond_limits ? ", beyond its limits\n" : "\n");
  }
  return text;
}

}  // namespace

std::string arm_text(const ArmReport& report) {
  std::string text = heading(report);
  if (!report.is_list && report.results.size() == 1) {
    const ArmResult& only = report.results.front();
    return text + result_text(only, report.arm, report) + '\n' + paths_text(only) +
           left_out_text(only.left_out);
  }
  for (std::size_t k = 0; k < report.results.size(); ++k) {
    const auto swept = swept_joint(report, k);
    text += '\n' +
            (swept ? swept->name + " = " + exact_text(swept->value) : "pose " + std::to_string(k)) +
            ": " + result_text(report.results[k], arm_of(report, k), report);
  }
  return text;
}

}  // namespace moivre
