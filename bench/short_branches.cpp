// SPDX-License-Identifier: MIT
// Does a motion find every branch that lives for a moment only? Random six-bars whose dead points
// are known (short_lives.h).
//
//   short_branches [--kind island|gap|fold-back]... [--share X]... [--seed S] [--first K] [--count
//   N] [--cvode] [--list] [--show]
//
// Each six-bar has two dead points that are `share` of a turn apart. It moves through one turn. A
// dead point is found where the motion has one within kSameTime of a turn. What is not found may
// still be told: the motion is not complete, or it says of a pose for an instant there. `off` is
// the largest error of a time, of a turn. With --list each six-bar that is not right is named, with
// --show the first one is written as a mechanism file.
// Exit: 0 every dead point was found, 1 some were not, 2 usage.
#include <cstdio>
#include <ctime>
#include <exception>
#include <string>
#include <vector>

#include "moivre/motion/motion.h"
#include "moivre/tracker_cvode/cvode_tracker.h"
#include "moivre/tracker_lanes/lane_tracker.h"
#include "short_lives.h"

namespace moivre::test {
namespace {

// Of a turn.
constexpr double kSameTime = 1e-9;

struct Request {
  std::vector<BriefKind> kinds;
  std::vector<double> shares;
  std::uint64_t seed = 1;
  std::uint64_t first = 0;
  std::uint64_t count = 200;
  bool by_cvode = false;
  bool lists = false;
  bool shows = false;
};

const char* name_of(BriefKind kind) {
  switch (kind) {
    case BriefKind::island:
      return "island";
    case BriefKind::gap:
      return "gap";
    case BriefKind::fold_back:
      return "fold-back";
  }
  return "";
}

constexpr std::array<BriefKind, 3> kKinds{BriefKind::island, BriefKind::gap, BriefKind::fold_back};

BriefKind kind_named(const std::string& word) {
  for (const BriefKind kind : kKinds) {
    if (word == name_of(kind)) return kind;
  }
  throw std::invalid_argument("unknown kind " + word);
}

Request request_of(int argc, char** argv) {
  Request request;
  for (int k = 1; k < argc; ++k) {
    const std::string word = argv[k];
    bool* flag = word == "--cvode"  ? &request.by_cvode
                 : word == "--list" ? &request.lists
                 : word == "--show" ? &request.shows
                                    : nullptr;
    if (flag != nullptr) {
      *flag = true;
      continue;
    }
    if (k + 1 == argc) throw std::invalid_argument(word + " needs a value");
    const std::string value = argv[++k];
    if (word == "--kind") {
      request.kinds.push_back(kind_named(value));
    } else if (word == "--share") {
      request.shares.push_back(std::stod(value));
    } else if (word == "--seed") {
      request.seed = std::stoull(value);
    } else if (word == "--first") {
      request.first = std::stoull(value);
    } else if (word == "--count") {
      request.count = std::stoull(value);
    } else {
      throw std::invalid_argument("unknown option " + word);
    }
  }
  if (request.kinds.empty()) request.kinds.assign(kKinds.begin(), kKinds.end());
  if (request.shares.empty()) request.shares = {1e-3, 1e-5, 1e-7};
  return request;
}

MotionResult motion_of(const BriefLife& brief, const Tracker& tracker) {
  MotionOptions options;
  options.to = kTurn_s;
  options.steps = 36;
  options.solve.threads = 1;
  return find_motion(mechanism_of(brief), tracker, options);
}

/// How far the nearest dead point is from a time, of a turn.
double miss(const MotionResult& motion, double time) {
  double least = 1;
  for (const MotionEvent& event : motion.events) {
    if (event.at.kind != EventKind::dead_point) continue;
    least = std::min(least, std::abs(event.at.time - time) / kTurn_s);
  }
  return least;
}

/// Whether the motion says itself that something is amiss, has an event of another kind there, or a
/// pose for an instant.
bool is_told(const MotionResult& motion, double time) {
  constexpr double kThere = 1e-6 * kTurn_s;
  if (!motion.complete) return true;
  for (const MotionEvent& event : motion.events) {
    if (std::abs(event.at.time - time) <= kThere) return true;
  }
  for (const LeftOut& out : motion.left_out) {
    if (out.why.find("an instant") != std::string::npos) return true;
  }
  return false;
}

struct Row {
  std::uint64_t found = 0, told = 0, lost = 0, incomplete = 0;
  double off = 0;
  double seconds = 0;
};

Row run(const Request& request, BriefKind kind, double share, const Tracker& tracker) {
  Row row;
  for (std::uint64_t number = request.first; number < request.first + request.count; ++number) {
    const BriefLife brief = random_brief_life(kind, share, request.seed, number);
    const std::clock_t begin = std::clock();
    const MotionResult motion = motion_of(brief, tracker);
    row.seconds += static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC;
    const double off = std::max(miss(motion, brief.times[0]), miss(motion, brief.times[1]));
    const bool is_found = off <= kSameTime;
    if (is_found) row.off = std::max(row.off, off);
    row.incomplete += motion.complete ? 0 : 1;
    ++(is_found ? row.found : is_told(motion, brief.times[0]) ? row.told : row.lost);
    if (!request.lists || (is_found && motion.complete)) continue;
    std::printf("%s %g number %llu: %.17g .. %.17g, off %.1e, %s\n", name_of(kind), share,
                static_cast<unsigned long long>(number), brief.times[0], brief.times[1], off,
                motion.message.c_str());
    for (const std::string& failure : motion.failures) std::printf("    %s\n", failure.c_str());
  }
  return row;
}

int table(const Request& request) {
  const auto tracker = request.by_cvode ? make_cvode_tracker() : make_lane_tracker();
  if (request.shows) {
    std::fputs(text_of(random_brief_life(request.kinds.front(), request.shares.front(),
                                         request.seed, request.first))
                   .c_str(),
               stdout);
    return 0;
  }
  std::printf("kind       share   six-bars  found  told  lost  incomplete      off   ms each\n");
  std::uint64_t missed = 0;
  for (const BriefKind kind : request.kinds) {
    for (const double share : request.shares) {
      const Row row = run(request, kind, share, *tracker);
      missed += row.told + row.lost + row.incomplete;
      std::printf("%-10s %-7.0e %8llu %6llu %5llu %5llu %11llu  %7.1e %9.1f\n", name_of(kind),
                  share, static_cast<unsigned long long>(request.count),
                  static_cast<unsigned long long>(row.found),
                  static_cast<unsigned long long>(row.told),
                  static_cast<unsigned long long>(row.lost),
                  static_cast<unsigned long long>(row.incomplete), row.off,
                  1e3 * row.seconds / static_cast<double>(request.count));
      std::fflush(stdout);
    }
  }
  return missed == 0 ? 0 : 1;
}

}  // namespace
}  // namespace moivre::test

int main(int argc, char** argv) {
  try {
    return moivre::test::table(moivre::test::request_of(argc, argv));
  } catch (const std::exception& error) {
    std::fprintf(stderr, "short_branches: %s\n", error.what());
    return 2;
  }
}
