// SPDX-License-Identifier: MIT
// Do closures hold on linkages that nobody tuned them to? Random ones, judged by their own pose and
// by Newton's method.
//
//   random_linkages [--space planar|spatial] [--assemblies] [--seed S] [--first K] [--count N]
//   [--starts N] [--cvode] [--show]
//
// A linkage is right where its own pose, which is isolated, is among the closures, closures are
// different poses that satisfy every constraint, another random seed counts as many complex ones,
// and Newton's method from random starts, rounds of N until one brings nothing new, comes to no
// regular pose that is not among them. With --assemblies groups on cranks are drawn, with gears and
// idle wheels (random_assemblies.h). Printed: every linkage that is not right, with its number, and
// the sums. With --show the first linkage as a mechanism file.
// Exit: 0 none is wrong, 1 some are, 2 usage.
#include <cstdio>
#include <ctime>
#include <exception>
#include <string>

#include "linkage_judge.h"
#include "moivre/tracker_cvode/cvode_tracker.h"
#include "moivre/tracker_lanes/lane_tracker.h"

namespace moivre::test {
namespace {

struct Request {
  Space space = Space::planar;
  std::uint64_t seed = 1;
  std::uint64_t first = 0;
  std::uint64_t count = 100;
  std::uint64_t starts = 100;
  bool by_cvode = false;
  bool shows = false;
  bool has_assemblies = false;
};

/// As it is solved, and as Newton's method searches it.
Assembly drawn(const Request& request, std::uint64_t number) {
  if (request.has_assemblies) return random_assembly(request.seed, number);
  const Mechanism linkage = random_linkage(request.space, request.seed, number);
  return {linkage, linkage};
}

Request request_of(int argc, char** argv) {
  Request request;
  for (int k = 1; k < argc; ++k) {
    const std::string word = argv[k];
    if (word == "--cvode" || word == "--show" || word == "--assemblies") {
      (word == "--show"    ? request.shows
       : word == "--cvode" ? request.by_cvode
                           : request.has_assemblies) = true;
      continue;
    }
    if (k + 1 == argc) throw std::invalid_argument(word + " needs a value");
    const std::string value = argv[++k];
    if (word == "--space") {
      request.space = value == "spatial" ? Space::spatial : Space::planar;
    } else if (word == "--seed") {
      request.seed = std::stoull(value);
    } else if (word == "--first") {
      request.first = std::stoull(value);
    } else if (word == "--count") {
      request.count = std::stoull(value);
    } else if (word == "--starts") {
      request.starts = std::stoull(value);
    } else {
      throw std::invalid_argument("unknown option " + word);
    }
  }
  return request;
}

std::string text_of(const Eigen::Vector3d& v, Space space) {
  char text[96];
  if (space == Space::planar) {
    std::snprintf(text, sizeof text, "[%.17g, %.17g]", v.x(), v.y());
  } else {
    std::snprintf(text, sizeof text, "[%.17g, %.17g, %.17g]", v.x(), v.y(), v.z());
  }
  return text;
}

std::string text_of(double number) {
  char text[32];
  std::snprintf(text, sizeof text, "%.17g", number);
  return text;
}

std::string told(const Mechanism& mechanism) {
  std::string text;
  for (const Joint& joint : mechanism.joints) {
    text += " " + to_string(joint.type) + "(" + std::to_string(joint.at[0].body) + "," +
            std::to_string(joint.at[1].body) + ")";
  }
  for (const Driver& driver : mechanism.drivers) {
    text += " " + to_string(driver.kind) + " " + driver.name;
  }
  return text;
}

std::string joint_text(const Mechanism& mechanism, const Joint& joint) {
  const auto body = [&](std::size_t k) { return mechanism.bodies[joint.at[k].body].name; };
  const auto point = [&](std::size_t k) {
    return body(k) + "." + mechanism.bodies[joint.at[k].body].points[joint.at[k].point].name;
  };
  std::string text =
      "[[joint]]\ntype = \"" + to_string(joint.type) + "\"\nname = \"" + joint.name + "\"\n";
  if (joint.type == JointType::gear) {
    return text + "bodies = [\"" + body(0) + "\", \"" + body(1) + "\"]\nratio = [" +
           std::to_string(joint.gear.teeth[0]) + ", " + std::to_string(joint.gear.teeth[1]) +
           "]\ncarrier = \"" + mechanism.bodies[joint.gear.carrier].name + "\"\n";
  }
  text += "at = [\"" + point(0) + "\", \"" + point(1) + "\"]\n";
  const bool is_planar = mechanism.space == Space::planar;
  if (is_planar && has_slide(joint.type))
    text += "along = " + text_of(joint.axis[0], mechanism.space) + "\n";
  if (!is_planar && axis_count(joint.type) == 1)
    text += "axis = " + text_of(joint.axis[0], mechanism.space) + "\n";
  if (!is_planar && axis_count(joint.type) == 2) {
    text += "axis = [" + text_of(joint.axis[0], mechanism.space) + ", " +
            text_of(joint.axis[1], mechanism.space) + "]\n";
  }
  if (joint.type == JointType::rod) text += "length = " + text_of(joint.length) + "\n";
  if (joint.type == JointType::screw) text += "pitch = " + text_of(joint.pitch) + "\n";
  return text;
}

/// As a mechanism file.
std::string file_of(const Mechanism& mechanism) {
  std::string text = mechanism.space == Space::spatial ? "space = \"spatial\"\n" : "";
  for (std::size_t k = 0; k < mechanism.bodies.size(); ++k) {
    text += (k == 0 ? "[ground.points]\n" : "[body." + mechanism.bodies[k].name + ".points]\n");
    for (const BodyPoint& point : mechanism.bodies[k].points) {
      text += point.name + " = " + text_of(point.at, mechanism.space) + "\n";
    }
  }
  for (const Joint& joint : mechanism.joints) text += joint_text(mechanism, joint);
  for (const Driver& driver : mechanism.drivers) {
    const bool is_slide = driver.kind == DriverKind::slide;
    const bool by_joint = is_slide || mechanism.space == Space::spatial;
    text += "[[driver]]\n" + to_string(driver.kind) + " = " +
            (by_joint ? "\"" + driver.name + "\""
                      : "[\"" + mechanism.bodies[driver.bodies[0]].name + "\", \"" +
                            mechanism.bodies[driver.bodies[1]].name + "\"]") +
            "\nstart = " + text_of(std::get<Parabola>(driver.law).start) + "\n";
  }
  return text;
}

struct Sums {
  std::uint64_t right = 0, undecided = 0, moves = 0, wrong = 0;
  std::uint64_t closures = 0, by_newton = 0;  ///< of those that are right
};

void judge(const Request& request, std::uint64_t number, Sums& sums) {
  const Assembly linkage = drawn(request, number);
  const auto tracker = request.by_cvode ? make_cvode_tracker() : make_lane_tracker();
  const auto solve = [&](std::uint64_t seed) {
    ClosureOptions options;
    options.solve.threads = 1;
    options.solve.seed = seed;
    return find_closures(linkage.mechanism, *tracker, options);
  };
  const std::clock_t begin = std::clock();
  std::string what;
  std::string message;
  double seconds = 0;
  try {
    const ClosureResult result = solve(number + 1);
    seconds = static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC;
    message = result.message;
    const ClosureResult again = solve(number + 1000003);
    if (result.moves) {
      what = "moves";
      ++sums.moves;
    } else if (!result.complete) {
      what = "undecided";
      ++sums.undecided;
    } else {
      const auto by_newton =
          poses_by_newton(linkage.plain, request.starts, Draw(request.seed, number + 1000003));
      what = fault_of(linkage.plain, result, again, by_newton);
      ++(what.empty() ? sums.right : sums.wrong);
      if (what.empty()) sums.closures += result.closures.size();
      if (what.empty()) sums.by_newton += by_newton.size();
    }
  } catch (const std::exception& error) {
    what = error.what();
    ++sums.wrong;
  }
  constexpr double kLong = 2;
  if (what.empty() && seconds < kLong) return;
  std::printf("%llu: %s (%s, %.2f s)%s\n", static_cast<unsigned long long>(number), what.c_str(),
              message.c_str(), seconds, told(linkage.mechanism).c_str());
  std::fflush(stdout);
}

int run(const Request& request) {
  if (request.shows) {
    std::printf("%s", file_of(drawn(request, request.first).mechanism).c_str());
    return 0;
  }
  Sums sums;
  for (std::uint64_t k = 0; k < request.count; ++k) judge(request, request.first + k, sums);
  const auto count = [](std::uint64_t n) { return static_cast<unsigned long long>(n); };
  std::printf("%llu right, %llu undecided, %llu move, %llu wrong\n", count(sums.right),
              count(sums.undecided), count(sums.moves), count(sums.wrong));
  std::printf("of %llu closures of those that are right Newton's method found %llu\n",
              count(sums.closures), count(sums.by_newton));
  return sums.wrong == 0 ? 0 : 1;
}

}  // namespace
}  // namespace moivre::test

int main(int argc, char** argv) {
  try {
    return moivre::test::run(moivre::test::request_of(argc, argv));
  } catch (const std::exception& error) {
    std::fprintf(stderr, "random_linkages: %s\n", error.what());
    return 2;
  }
}
