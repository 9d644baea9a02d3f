// SPDX-License-Identifier: MIT
// Does inverse kinematics miss anything in a thousand random poses of every arm, and what does a
// pose take? A table.
//
//   arm_poses [--poses N] [--hunted N] [--starts N] [--together] [--disturbed SIZE] [NAME...]
//
//   lost     poses whose own joint values are not among the closures to 1e-9 rad
//   count    poses whose complex closures are not as many as the arm's kind has;  open: undecided
//            ones
//   own, fk  farthest own values (rad), largest miss of forward kinematics (matrix entries,
//            metres);  real: closures on the mean
//   outdone  poses, of the first --hunted ones, for which Newton's method from --starts random
//            places found one more
//   ms, worst, Newton  CPU time a pose, the longest, and that of Newton's method until it has found
//                      as many
//   alone    poses that no family answered
//   median   of the poses' times by the clock, the preparation shared among all;  slow: poses that
//            take ten times as long: most are those at which the digits leave a set open
// --together: all poses in one call, as --poses does. --disturbed: every number of every origin and
// axis off by up to SIZE, so that every arm is a general one.
// Exit: 0 nothing is lost, miscounted, open or hunted down, 1 something is, 2 usage.
#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <exception>
#include <iterator>
#include <string>
#include <vector>

#include "polish.h"
#include "robots.h"

namespace moivre::test {
namespace {

struct Request {
  std::uint64_t poses = 1000;
  std::uint64_t hunted = 0;
  std::uint64_t starts = 500;
  bool together = false;
  double disturbed = 0;
  std::vector<std::string> names;
};

Request request_of(int argc, char** argv) {
  Request request;
  for (int k = 1; k < argc; ++k) {
    const std::string word = argv[k];
    const bool has_value = k + 1 < argc;
    if (word == "--together") {
      request.together = true;
    } else if (word == "--poses" && has_value) {
      request.poses = std::stoull(argv[++k]);
    } else if (word == "--hunted" && has_value) {
      request.hunted = std::stoull(argv[++k]);
    } else if (word == "--starts" && has_value) {
      request.starts = std::stoull(argv[++k]);
    } else if (word == "--disturbed" && has_value) {
      request.disturbed = std::stod(argv[++k]);
    } else {
      request.names.push_back(word);
    }
  }
  return request;
}

struct Kind {
  std::string name;
  Robot robot;
  ArmChoice choice;
  std::uint64_t complex = 16;
};

std::vector<Kind> kinds() {
  return {
      {"general-6r", robot_of(general_arm(1)), {}, 16},
      {"manseur-doty", robot_of(kManseurDoty), {}, 16},
      {"puma560", robot_of("puma560"), {}, 8},
      {"ur5", robot_of("ur5"), {std::nullopt, "tool0", {}}, 8},
      {"kr6", robot_of(kKr6), {}, 8},
      {"tx2-60", robot_of(kTx2), {}, 8},
      {"irb120", robot_of(kIrb120), {}, 8},
      {"xarm5", robot_of(kXarm5), {}, 4},
      {"kinova", robot_of("kinova_j2s6s200"), {std::nullopt, "j2s6s200_end_effector", {}}, 8},
      {"panda-7", robot_of("panda"), {std::nullopt, "panda_hand_tcp", {{"panda_joint7", 0.3}}}, 8},
      {"panda-3",
       robot_of("panda"),
       {std::nullopt, "panda_hand_tcp", {{"panda_joint3", 0.3}}},
       16}};
}

double cpu_ms() { return 1e3 * static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

/// What is printed of one arm.
struct Tally {
  std::uint64_t lost = 0, miscounted = 0, open = 0, real = 0, outdone = 0;
  double own = 0, fk = 0, ms = 0, worst_ms = 0, newton_ms = 0;
  std::vector<double> seconds;  ///< of each pose

  void take(const Arm& arm, const ArmResult& result, const Eigen::VectorXd& values,
            std::uint64_t complex) {
    const double far = least_distance(arm, result, values);
    lost += far < 1e-9 ? 0 : 1;
    if (far < 1e-9) own = std::max(own, far);
    fk = std::max(fk, worst_miss(arm, result));
    miscounted += result.counts.complex == complex ? 0 : 1;
    open += result.complete ? 0 : 1;
    real += result.counts.real;
    seconds.push_back(result.time_s.total);
  }

  double median() {
    const auto middle = seconds.begin() + std::ssize(seconds) / 2;
    std::nth_element(seconds.begin(), middle, seconds.end());
    return *middle;
  }

  std::uint64_t slow() {
    constexpr double kSlow = 10;
    const double most = kSlow * median();
    return static_cast<std::uint64_t>(
        std::count_if(seconds.begin(), seconds.end(), [&](double s) { return s > most; }));
  }
};

/// Newton's method from random starts: does it end anywhere that is no closure, and how long does
/// it take to find them all?
void hunt(const Arm& arm, const ArmResult& result, std::uint64_t pose, std::uint64_t starts,
          Tally& tally) {
  constexpr double kSame = 1e-6;
  std::vector<Eigen::VectorXd> found;
  const double begin = cpu_ms();
  double until_all = 0;
  bool is_outdone = false;
  for (std::uint64_t k = 0; k < starts; ++k) {
    const Polished there =
        polish(arm, result.pose, random_values(arm, 12, pose * starts + k), true);
    if (there.residual > kReach) continue;
    is_outdone = is_outdone || least_distance(arm, result, there.values) > kSame;
    const bool is_new = std::none_of(found.begin(), found.end(), [&](const Eigen::VectorXd& other) {
      return distance(arm, other, there.values) < kSame;
    });
    if (!is_new) continue;
    found.push_back(there.values);
    until_all = cpu_ms() - begin;
  }
  tally.outdone += is_outdone ? 1 : 0;
  // Where it has not found all, it would have needed longer than this.
  tally.newton_ms += found.size() < result.closures.size() ? cpu_ms() - begin : until_all;
}

bool measure(const Kind& kind, const Request& request) {
  const bool is_disturbed = request.disturbed > 0;
  const Arm arm =
      make_arm(is_disturbed ? disturbed(kind.robot, request.disturbed) : kind.robot, kind.choice);
  const std::uint64_t complex = is_disturbed ? 16 : kind.complex;
  Tally tally;
  std::vector<Eigen::VectorXd> own;
  std::vector<Eigen::Isometry3d> poses;
  for (std::uint64_t k = 0; k < request.poses; ++k) {
    own.push_back(random_values(arm, 11, k));
    poses.push_back(forward_kinematics(arm, own.back()));
  }
  const double begin = cpu_ms();
  std::vector<ArmResult> results;
  if (request.together) results = find_arm_closures(arm, poses, lanes(), one_thread());
  for (std::uint64_t k = results.size(); k < poses.size(); ++k) {
    const double before = cpu_ms();
    results.push_back(find_arm_closures(arm, poses[k], lanes(), one_thread(k + 1)));
    tally.worst_ms = std::max(tally.worst_ms, cpu_ms() - before);
  }
  tally.ms = (cpu_ms() - begin) / static_cast<double>(poses.size());
  std::uint64_t alone = 0;
  for (std::size_t k = 0; k < poses.size(); ++k) {
    tally.take(arm, results[k], own[k], complex);
    alone += results[k].start.source == StartSource::approach ? 1 : 0;
  }
  const std::uint64_t hunted = std::min<std::uint64_t>(request.hunted, poses.size());
  for (std::uint64_t k = 0; k < hunted; ++k) hunt(arm, results[k], k, request.starts, tally);
  const double n = static_cast<double>(poses.size());
  std::printf(
      "%-13s %5zu %4llu %5llu %5llu %8.1e %8.1e %5.2f %7llu %8.3f %8.1f %8.1f %6llu %8.4f %5llu\n",
      kind.name.c_str(), poses.size(), static_cast<unsigned long long>(tally.lost),
      static_cast<unsigned long long>(tally.miscounted),
      static_cast<unsigned long long>(tally.open), tally.own, tally.fk,
      static_cast<double>(tally.real) / n, static_cast<unsigned long long>(tally.outdone), tally.ms,
      tally.worst_ms, hunted > 0 ? tally.newton_ms / static_cast<double>(hunted) : 0,
      static_cast<unsigned long long>(alone), 1e3 * tally.median(),
      static_cast<unsigned long long>(tally.slow()));
  std::fflush(stdout);
  return tally.lost + tally.miscounted + tally.open + tally.outdone == 0;
}

int run(const Request& request) {
  std::printf("%-13s %5s %4s %5s %5s %8s %8s %5s %7s %8s %8s %8s %6s %8s %5s\n", "arm", "poses",
              "lost", "count", "open", "own", "fk", "real", "outdone", "ms", "worst", "Newton",
              "alone", "median", "slow");
  bool right = true;
  for (const Kind& kind : kinds()) {
    const bool is_wanted = request.names.empty() ||
                           std::count(request.names.begin(), request.names.end(), kind.name) > 0;
    if (is_wanted) right &= measure(kind, request);
  }
  return right ? 0 : 1;
}

}  // namespace
}  // namespace moivre::test

int main(int argc, char** argv) {
  try {
    return moivre::test::run(moivre::test::request_of(argc, argv));
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 2;
  }
}
