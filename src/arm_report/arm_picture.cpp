// SPDX-License-Identifier: MIT
// A sheet of postures: what each is called, its joint values, and its skeleton.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numbers>

#include "moivre/arm_report/arm_report.h"
#include "moivre/arms/posture.h"
#include "moivre/closure_report/sheet.h"
#include "moivre/expression/counted.h"
#include "moivre/numeric/exact_displacement.h"
#include "moivre/numeric/invalid_input.h"
#include "moivre/report/number_text.h"
#include "skeleton.h"

namespace moivre {
namespace {

std::string value_text(const ArmJoint& joint, double value, bool in_degrees) {
  const bool turns = in_degrees && !joint.is_slide;
  char text[32];
  // Adding 0 takes the sign from a value that is rounded to 0.
  const double rounded =
      turns ? std::round(value * 180 / std::numbers::pi) : std::round(value * 100) / 100;
  std::snprintf(text, sizeof text, turns ? "%.0f" : "%.2f", rounded + 0.0);
  return text;
}

std::string values_text(const Arm& arm, const Eigen::VectorXd& values,
                        const std::vector<std::size_t>& beyond, bool in_degrees) {
  std::string text;
  for (std::size_t k = 0; k < arm.joints.size(); ++k) {
    const bool is_beyond = std::find(beyond.begin(), beyond.end(), k) != beyond.end();
    text += (k == 0 ? "" : " ") +
            value_text(arm.joints[k], values[static_cast<Eigen::Index>(k)], in_degrees) +
            (is_beyond ? "!" : "");
  }
  return text;
}

Panel panel_of(const Arm& arm, const Skeleton& skeleton, const ArmClosure& closure,
               bool in_degrees) {
  Panel panel{closure.id + (closure.singular ? ": singular" : ""),
              skeleton_pose(skeleton, arm, closure.values)};
  const std::string posture = to_string(posture_of(arm, closure.values));
  if (!posture.empty()) panel.notes.push_back(posture);
  panel.notes.push_back(values_text(arm, closure.in_limits, closure.beyond, in_degrees));
  return panel;
}

/// Of a set one posture is drawn.
Panel panel_of(const Arm& arm, const Skeleton& skeleton, const SelfMotion& set, bool in_degrees) {
  const std::string caption = set.within_digits     ? "moves within the digits"
                              : set.misfit > kReach ? "moves within accuracy"
                                                    : "moves, from here";
  return {caption,
          skeleton_pose(skeleton, arm, set.values),
          false,
          {values_text(arm, set.values, {}, in_degrees)}};
}

std::string summary(const Arm& arm, const ArmResult& result, bool in_degrees) {
  std::string text = counted(result.counts.complex, "complex closure") + ", " +
                     std::to_string(result.counts.real) + " real";
  if (result.counts.beyond_limits > 0) {
    text += ", " + std::to_string(result.counts.beyond_limits) + " beyond a joint's limits (!)";
  }
  if (!result.complete || !result.moves.empty() || result.closures.empty())
    text += "; " + result.message;
  text += in_degrees ? "; values in degrees of" : "; values in radians of";
  for (std::size_t k = 0; k < arm.joints.size(); ++k) {
    text += (k == 0 ? " " : ", ") + std::to_string(k + 1) + ' ' + arm.joints[k].name +
            (arm.joints[k].is_slide ? " (m)" : "");
  }
  for (const HeldJoint& joint : arm.held) {
    text += "; held: " + joint.name + " = " + exact_text(joint.value);
  }
  return text;
}

struct Scene {
  Skeleton skeleton;
  Sheet sheet;
};

Scene scene_of(const ArmReport& report, bool in_degrees) {
  if (report.results.size() != 1) {
    throw InvalidInput("a picture shows the closures of one pose, not of " +
                       std::to_string(report.results.size()));
  }
  const Arm& arm = report.arm;
  const ArmResult& result = report.results.front();
  Scene scene{make_skeleton(arm), {}};
  Sheet& sheet = scene.sheet;
  sheet.title =
      (arm.robot.empty() ? report.file : arm.robot) + ", from " + arm.base + " to " + arm.tip;
  sheet.summary = summary(arm, result, in_degrees);
  for (const ArmClosure& closure : result.closures) {
    sheet.panels.push_back(panel_of(arm, scene.skeleton, closure, in_degrees));
  }
  for (const SelfMotion& set : result.moves) {
    sheet.panels.push_back(panel_of(arm, scene.skeleton, set, in_degrees));
  }
  if (sheet.panels.empty()) {
    const Eigen::VectorXd zero =
        Eigen::VectorXd::Zero(static_cast<Eigen::Index>(arm.joints.size()));
    sheet.panels.push_back(
        {"no closure: all joints at 0", skeleton_pose(scene.skeleton, arm, zero), true});
  }
  std::vector<Eigen::VectorXd> poses;
  for (const Panel& panel : sheet.panels) poses.push_back(panel.q);
  sheet.view = {best_eye(scene.skeleton, poses), scene.skeleton.frames, true};
  return scene;
}

}  // namespace

std::string arm_svg(const ArmReport& report, bool in_degrees, Views views) {
  Scene scene = scene_of(report, in_degrees);
  scene.sheet.views = views;
  return sheet_svg(scene.sheet, scene.skeleton.mechanism);
}

std::string arm_html(const ArmReport& report, bool in_degrees) {
  const Scene scene = scene_of(report, in_degrees);
  return turning_html(scene.sheet, scene.skeleton.mechanism);
}

}  // namespace moivre
