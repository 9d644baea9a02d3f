// SPDX-License-Identifier: MIT
// Robot, poses, closures, reports.
#include "arm_closures.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <sstream>
#include <stdexcept>

#include "command_line.h"
#include "interruption.h"
#include "joint_value.h"
#include "moivre/arm_report/arm_report.h"
#include "moivre/arms/held_range.h"
#include "moivre/arms/poses.h"
#include "moivre/arms/turns.h"
#include "moivre/expression/counted.h"
#include "moivre/expression/joined.h"
#include "moivre/numeric/stopwatch.h"
#include "moivre/urdf/mechanism_text.h"
#include "moivre/urdf/read.h"
#include "output.h"
#include "progress_line.h"

namespace moivre {
namespace {

/// Heading in --help.
constexpr const char* kRobots = "Robots (URDF)";

/// JOINT=...: a joint's name may have an equals sign, what is behind the last one has none.
struct JointSetting {
  std::string joint, behind;
};

/// Both are empty where the form is another one.
JointSetting joint_setting(const std::string& setting) {
  const std::size_t equals = setting.rfind('=');
  if (equals == std::string::npos || equals == 0) return {};
  return {setting.substr(0, equals), setting.substr(equals + 1)};
}

/// Of a joint that the robot has, and that moves: others are refused elsewhere.
std::string unit_fault_of(const Robot& robot, const std::string& name,
                          const TypedJointValue& value) {
  const auto joint = joint_named(robot, name);
  if (!joint || !is_moving(robot.joints[*joint])) return "";
  return unit_fault(value, robot.joints[*joint].type == RobotJointType::prismatic);
}

constexpr const char* kUnitsOfValues = " (30deg, 0.5rad, 0.2m, 120mm; radians or metres without)";

std::vector<HeldJoint> held_joints(const Robot& robot, const std::vector<std::string>& settings) {
  std::vector<HeldJoint> held;
  std::vector<std::string> faults;
  for (const std::string& setting : settings) {
    const auto& [joint, behind] = joint_setting(setting);
    const auto value = read_joint_value(behind);
    if (!value) {
      faults.push_back(setting + " is not JOINT=VALUE with a finite number" + kUnitsOfValues);
      continue;
    }
    const std::string fault = unit_fault_of(robot, joint, *value);
    if (!fault.empty()) faults.push_back(setting + ": " + fault);
    held.push_back({joint, value->value});
  }
  if (!faults.empty()) throw std::invalid_argument(joined(faults, "; "));
  return held;
}

/// JOINT=FROM:TO:N.
HeldRange held_range(const Robot& robot, const std::string& setting) {
  const auto& [joint, behind] = joint_setting(setting);
  const std::size_t first = std::min(behind.find(':'), behind.size());
  const std::size_t second = std::min(behind.find(':', first + 1), behind.size());
  const std::string_view text = behind;
  const auto from = read_joint_value(text.substr(0, first));
  const auto to = read_joint_value(
      text.substr(std::min(first + 1, text.size()), second - std::min(first + 1, second)));
  const std::string_view typed_count = text.substr(std::min(second + 1, text.size()));
  long long count = 0;
  const char* const end = typed_count.data() + typed_count.size();
  const auto read = std::from_chars(typed_count.data(), end, count);
  if (!from || !to || read.ec != std::errc() || read.ptr != end || count < 1) {
    throw std::invalid_argument("--sweep-hold: " + setting +
                                " is not JOINT=FROM:TO:N with finite numbers" + kUnitsOfValues +
                                " and N from 1 on");
  }
  for (const TypedJointValue& value : {*from, *to}) {
    const std::string fault = unit_fault_of(robot, joint, value);
    if (!fault.empty()) throw std::invalid_argument("--sweep-hold: " + setting + ": " + fault);
  }
  return {.joint = joint,
          .from = from->value,
          .to = to->value,
          .count = static_cast<std::size_t>(count)};
}

std::optional<std::string> chosen(const std::string& name) {
  return name.empty() ? std::nullopt : std::optional(name);
}

TypedPose only_pose(const std::string& text) {
  const auto poses = read_poses({"--pose", text});
  if (poses.size() > 1) {
    throw std::invalid_argument("--pose takes one pose, --poses a file of many");
  }
  return poses.front();
}

/// As typed, with the accuracy that was asked for instead of that of the digits.
std::vector<TypedPose> typed_poses(const ArmOptions& options) {
  if (options.pose.empty() == options.poses.empty()) {
    throw std::invalid_argument(
        options.pose.empty()
            ? "a robot needs the pose of its tip: --pose \"x y z qw qx qy qz\", or --poses FILE"
            : "--pose and --poses are given, one of them is enough");
  }
  if (options.poses.empty()) return {only_pose(options.pose)};
  return read_poses(read_source(options.poses));
}

std::vector<TypedPose> chosen_poses(const ArmOptions& options) {
  std::vector<TypedPose> poses = typed_poses(options);
  if (!options.pose_accuracy) return poses;
  if (!(*options.pose_accuracy >= 0) || !std::isfinite(*options.pose_accuracy)) {
    throw std::invalid_argument("--pose-accuracy is metres and radians, 0 or more");
  }
  for (TypedPose& pose : poses) pose.accuracy = *options.pose_accuracy;
  return poses;
}

/// Where the arm stands.
std::optional<Eigen::VectorXd> standing(const ArmOptions& options, const Arm& arm) {
  if (options.nearest.empty()) return std::nullopt;
  std::string text = options.nearest;
  std::replace(text.begin(), text.end(), ',', ' ');
  std::istringstream words(text);
  std::vector<double> values;
  for (std::string word; words >> word;) {
    const auto value = read_joint_value(word);
    if (!value) {
      throw std::invalid_argument("--nearest: " + word + " is no finite number" + kUnitsOfValues);
    }
    if (values.size() < arm.joints.size()) {
      const ArmJoint& joint = arm.joints[values.size()];
      const std::string fault = unit_fault(*value, joint.is_slide);
      if (!fault.empty()) {
        throw std::invalid_argument("--nearest: " + joint.name + ", " + word + ": " + fault);
      }
    }
    values.push_back(value->value);
  }
  if (values.size() != arm.joints.size()) {
    throw std::invalid_argument("--nearest has " + counted(values.size(), "value") +
                                ", the chain has " + counted(arm.joints.size(), "free joint"));
  }
  return Eigen::Map<const Eigen::VectorXd>(values.data(), std::ssize(values));
}

void require_one_to_draw(const ArmRun& run, std::size_t poses) {
  const bool is_drawn = !run.svg.empty() || !run.html.empty();
  if (!is_drawn || poses == 1) return;
  throw std::invalid_argument("--svg and --html show the closures of one pose, not of " +
                              std::to_string(poses));
}

}  // namespace

void add_robot_options(CLI::App& command, ArmOptions& options) {
  const std::string group = kRobots;
  command.add_option("--tip", options.tip, "link that takes the pose; default: the only leaf")
      ->type_name("LINK")
      ->group(group);
  command
      .add_option("--pose", options.pose,
                  "pose of the tip in the base's frame: \"x y z qw qx qy qz\", metres and a unit "
                  "quaternion")
      ->group(group);
  command
      .add_option(
          "--hold", options.held,
          "hold a joint at this value, radians or metres, or with its unit (30deg, 120mm); may be "
          "repeated")
      ->type_name("JOINT=VALUE")
      ->group(group);
  command
      .add_option("--loops", options.loops,
                  "side file (.toml) that closes loops: points of links, joints and drivers; the "
                  "robot is then treated as a mechanism")
      ->type_name("PATH")
      ->group(group);
}

void add_arm_options(CLI::App& command, ArmOptions& options) {
  command.add_option("--base", options.base, "link that is fixed; default: the root")
      ->type_name("LINK")
      ->group(kRobots);
  add_robot_options(command, options);
  command.add_option("--poses", options.poses, "file of poses, one per line (CSV)")
      ->type_name("PATH")
      ->group(kRobots);
  command
      .add_option("--pose-accuracy", options.pose_accuracy,
                  "how well the pose is known, metres and radians: closures and sets miss it by no "
                  "more; default: by its digits")
      ->type_name("X")
      ->group(kRobots);
  command
      .add_option("--sweep-hold", options.sweep_hold,
                  "hold a joint at N values from FROM to TO, radians or metres, or with their unit "
                  "(30deg): the closures of one pose at each of them")
      ->type_name("JOINT=FROM:TO:N")
      ->group(kRobots);
  command
      .add_option("--nearest", options.nearest,
                  "closures in the order of their distance from these joint values, radians and "
                  "metres, or with their units, in the order of the chain: \"q1 q2 ...\"; whole "
                  "turns as there")
      ->type_name("VALUES")
      ->group(kRobots);
  command
      .add_option("--limits", options.limits,
                  "wrap: every choice of whole turns that the joints' limits allow")
      ->type_name("wrap")
      ->check(CLI::IsMember({"wrap"}))
      ->group(kRobots);
}

bool are_given(const ArmOptions& options) {
  return !options.sweep_hold.empty() || !options.base.empty() || !options.tip.empty() ||
         !options.pose.empty() || !options.poses.empty() || !options.nearest.empty() ||
         !options.limits.empty() || !options.held.empty() || !options.loops.empty();
}

std::string robot_as_mechanism(const std::string& file, const Source& source,
                               const ArmOptions& options) {
  const Robot robot = read_urdf(source);
  RobotChanges changes;
  require_all({[&] { changes.held = held_joints(robot, options.held); },
               [&] {
                 if (!options.pose.empty()) changes.pose = only_pose(options.pose).pose;
               },
               [&] {
                 if (options.base.empty() || options.base == robot.links[robot.root].name) return;
                 throw std::invalid_argument("--base: the ground of the mechanism is the root, " +
                                             robot.links[robot.root].name);
               },
               [&] {
                 if (options.poses.empty()) return;
                 throw std::invalid_argument(
                     "--poses is for arms without loops; give one pose by --pose");
               },
               [&] {
                 if (options.sweep_hold.empty()) return;
                 throw std::invalid_argument("--sweep-hold is for arms without loops");
               },
               [&] {
                 if (options.tip.empty() || !options.pose.empty()) return;
                 throw std::invalid_argument("--tip needs --pose, which says where it is to be");
               }});
  changes.tip = chosen(options.tip);
  if (!options.loops.empty()) changes.loops = read_source(options.loops);
  return mechanism_text(robot, options.loops.empty() ? file : file + " and " + options.loops,
                        changes);
}

bool is_robot(const std::string& file, const Source& source) {
  return file.ends_with(".urdf") || looks_like_xml(source.text);
}

int run_arm(const ArmRun& run, const Source& source) {
  const Stopwatch watch;
  const Robot robot = read_urdf(source);
  ArmReport report;
  std::vector<TypedPose> poses;
  std::unique_ptr<Tracker> tracker;
  require_all({[&] {
                 const ArmChoice choice{chosen(run.arm.base), chosen(run.arm.tip),
                                        held_joints(robot, run.arm.held)};
                 if (!run.arm.sweep_hold.empty()) {
                   report.swept = arms_along(robot, choice, held_range(robot, run.arm.sweep_hold));
                 }
                 report.arm = report.swept.empty() ? make_arm(robot, choice) : report.swept.front();
                 report.stands = standing(run.arm, report.arm);
                 report.has_all_turns = run.arm.limits == "wrap";
                 if (report.has_all_turns) require_few_turns(report.arm);
               },
               [&] {
                 poses = chosen_poses(run.arm);
                 require_one_to_draw(run, poses.size());
                 if (report.swept.empty()) return;
                 if (!run.arm.poses.empty()) {
                   throw std::invalid_argument("--sweep-hold is of one pose: --pose, not --poses");
                 }
                 require_one_to_draw(run, report.swept.size());
               },
               [&] { tracker = make_tracker(run.tracker); }});
  Output json(run.json);
  Output csv(run.csv);
  Output svg(run.svg);
  Output html(run.html);
  report.file = run.file;
  report.is_list = !run.arm.poses.empty() || !report.swept.empty();
  report.parse_s = watch.total();
  KeptRun kept(run.ledger, {run.file, run.arm.poses});
  if (const auto code = kept.deliver_again({&json, &csv, &svg, &html}, run.quiet)) return *code;

  SolveOptions options;
  options.seed = run.start.seed;
  options.start = kind_of(run.start);
  options.threads = run.threads;
  const std::unique_ptr<Tracker> fallback = make_fallback(run.tracker);
  options.fallback = fallback.get();
  ProgressLine line(!run.quiet);
  options.observations = kept.observations();
  if (line.is_active() || kept.is_kept()) {
    options.progress = [&](const Progress& progress) {
      line.show(progress);
      kept.tell(progress);
    };
  }
  const Interruption interruption(run.time_limit);
  const std::atomic<bool>& stop = interruption.stop();
  report.results =
      report.swept.empty()
          ? find_arm_closures(report.arm, poses, *tracker, options, stop)
          : find_closures_of_each(report.swept, poses.front(), *tracker, options, stop);
  if (report.stands) {
    for (ArmResult& result : report.results) {
      sort_by_distance(report.arm, *report.stands, result.closures);
    }
  }
  report.total_s = watch.total();
  line.end();
  const std::size_t asked = report.swept.empty() ? poses.size() : report.swept.size();
  const bool complete = is_complete(report) && report.results.size() == asked;
  return kept.deliver(
      {{&json, [&](const TextSink& sink) { write_arm_json(sink, report); }},
       {&csv, [&](const TextSink& sink) { write_arm_csv(sink, report, run.in_degrees); }},
       {&svg,
        [&] {
          return arm_svg(report, run.in_degrees, run.three_views ? Views::three : Views::standing);
        }},
       {&html, [&] { return arm_html(report, run.in_degrees); }}},
      run.quiet, [&] { return arm_text(report); },
      complete ? "" : "some paths are undecided, or the run was interrupted",
      complete ? kDecided : kUndecided);
}

}  // namespace moivre
