// SPDX-License-Identifier: MIT
// Do loops of members find the published numbers of roots from one random root, with every seed? A
// table: counts, standing, seconds.
//
//   monodromy [--seeds N] [--first SEED] [--threads N] [NAME...]
//
//   four-bar 2, seven-link-* 14, 16, 18, 6R 16, stewart 40   as in bench/family
//   nine-link 56                                             Assur structure 4/4
//   cyclic-7 924                                             every coefficient is a parameter
//   three-conics 184                                         conics that touch three conics and
//   pass through two points
//   five-conics 3264, nine-point 8652                        problems/families; only where they are
//   named
//
// found: seeds with the published number, all of them certified; complete: those with a proof or a
// trace test that holds.
// Exit: 0 every count is the published one, 1 some is not, 2 usage.
#include <cstdio>
#include <exception>
#include <string>
#include <vector>

#include "family_problems.h"
#include "loop_problems.h"
#include "moivre/family/learn.h"
#include "moivre/numeric/stopwatch.h"
#include "moivre/tracker_lanes/lane_tracker.h"

namespace moivre {
namespace {

struct Request {
  std::uint64_t seeds = 20;
  std::uint64_t first = 1;
  int threads = 1;
  std::vector<std::string> names;
};

Request request_of(int argc, char** argv) {
  Request request;
  for (int k = 1; k < argc; ++k) {
    const std::string word = argv[k];
    if (word == "--seeds" && k + 1 < argc) {
      request.seeds = std::stoull(argv[++k]);
    } else if (word == "--first" && k + 1 < argc) {
      request.first = std::stoull(argv[++k]);
    } else if (word == "--threads" && k + 1 < argc) {
      request.threads = std::stoi(argv[++k]);
    } else {
      request.names.push_back(word);
    }
  }
  return request;
}

struct LoopProblem {
  std::string name;
  std::size_t roots;
  Family family;
};

std::vector<LoopProblem> small_problems() {
  std::vector<LoopProblem> problems;
  for (FamilyProblem& problem : family_problems()) {
    problems.push_back({problem.name, problem.roots, std::move(problem.family)});
  }
  const std::string folder = MOIVRE_SOURCE_DIR "/problems/polynomials/";
  problems.push_back({"nine-link", 56, nine_link()});
  problems.push_back(
      {"cyclic-7", 924, coefficient_family(read_system(read_source(folder + "cyclic-7.phc")))});
  problems.push_back({"three-conics", 184, conics_that_touch(3)});
  return problems;
}

std::vector<LoopProblem> large_problems() {
  return {{"five-conics", 3264, declared_family("five-conics.bertini")},
          {"nine-point", 8652, declared_family("nine-point.bertini")}};
}

/// False where a seed has not the published number.
bool measure(const LoopProblem& problem, const Request& request) {
  const auto lanes = make_lane_tracker();
  std::uint64_t found = 0;
  std::uint64_t complete = 0;
  std::string standing = "no random root";
  const Stopwatch watch;
  for (std::uint64_t seed = request.first; seed < request.first + request.seeds; ++seed) {
    const auto pair = random_pair(problem.family, seed);
    if (!pair) continue;
    MonodromyOptions options;
    options.seed = seed;
    options.threads = request.threads;
    const Family family = learn_by_monodromy(problem.family, *pair, *lanes, options);
    const bool has_all =
        family.roots.size() == problem.roots && family.learning.certified == problem.roots;
    if (has_all) ++found;
    if (has_all && family.learning.complete) ++complete;
    standing = family.learning.standing;
  }
  std::printf("%-14s %6zu %6llu %9llu %9.2f  %s\n", problem.name.c_str(), problem.roots,
              static_cast<unsigned long long>(found), static_cast<unsigned long long>(complete),
              watch.total() / static_cast<double>(request.seeds), standing.c_str());
  std::fflush(stdout);
  return found == request.seeds;
}

int run(const Request& request) {
  std::printf("%-14s %6s %6s %9s %9s  %s\n", "family", "roots", "found", "complete", "s a seed",
              "standing with the last seed");
  bool is_right = true;
  const auto is_named = [&](const LoopProblem& problem) {
    return std::find(request.names.begin(), request.names.end(), problem.name) !=
           request.names.end();
  };
  for (const LoopProblem& problem : small_problems()) {
    if (request.names.empty() || is_named(problem))
      is_right = measure(problem, request) && is_right;
  }
  for (const LoopProblem& problem : large_problems()) {
    if (is_named(problem)) is_right = measure(problem, request) && is_right;
  }
  return is_right ? 0 : 1;
}

}  // namespace
}  // namespace moivre

int main(int argc, char** argv) {
  try {
    return moivre::run(moivre::request_of(argc, argv));
  } catch (const std::exception& error) {
    std::fprintf(stderr, "monodromy: %s\n", error.what());
    return 2;
  }
}
