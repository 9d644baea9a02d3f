// SPDX-License-Identifier: MIT
// What does a member of a learned family cost, thousands at once, in lanes? A table: microseconds,
// counts, members in doubt.
//
//   family_members [--members N] [--direct N] [--threads N] [--certify] [NAME...]
//
//   four-bar      two unit vectors, crank and link lengths as parameters: 2 roots
//   jansen        Jansen's leg, six unit vectors, crank and dimensions as parameters: 8
//   seven-link-*  Assur structures, link vectors and their conjugates as parameters: 14, 16, 18
//   6R            general arm in its unknown axes, pose as parameters: 16;  stewart: Dietmaier's
//                 platform, legs as parameters: 40
//
// us: wall microseconds a member, cpu us: CPU time of all threads, which a busy machine changes
// less; wrong: members without the generic count; judged: those that the ordinary solve had to
// decide; other real: of the first --direct members, those with another number of real roots than a
// solve from the ordinary start finds. Members are random, of real linkages.
// Exit: 0 every count is generic, 1 some is not, 2 usage.
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <exception>
#include <functional>
#include <string>
#include <vector>

#include "family_problems.h"
#include "moivre/family/learn.h"
#include "moivre/family/members.h"
#include "moivre/numeric/stopwatch.h"
#include "moivre/tracker_lanes/lane_tracker.h"

namespace moivre {
namespace {

struct Request {
  std::size_t members = 10000;
  std::size_t direct = 0;
  int threads = 1;
  bool certify = false;
  std::vector<std::string> names;
};

Request request_of(int argc, char** argv) {
  Request request;
  for (int k = 1; k < argc; ++k) {
    const std::string word = argv[k];
    if (word == "--certify") {
      request.certify = true;
    } else if (word == "--members" && k + 1 < argc) {
      request.members = std::stoul(argv[++k]);
    } else if (word == "--direct" && k + 1 < argc) {
      request.direct = std::stoul(argv[++k]);
    } else if (word == "--threads" && k + 1 < argc) {
      request.threads = std::stoi(argv[++k]);
    } else {
      request.names.push_back(word);
    }
  }
  return request;
}

bool is_wanted(const Request& request, const std::string& name) {
  return request.names.empty() ||
         std::find(request.names.begin(), request.names.end(), name) != request.names.end();
}

/// As the reader of roots counts: those of a family of closures have no coordinate 0.
std::uint64_t real_roots(const Family& family, const SolveResult& result) {
  return static_cast<std::uint64_t>(
      std::count_if(result.solutions.begin(), result.solutions.end(), [&](const Solution& root) {
        const bool has_zero =
            std::any_of(root.x.begin(), root.x.end(), [](const Complex& xj) { return xj == 0.0; });
        return root.real && !root.singular && !(family.nonzero && has_zero);
      }));
}

/// Of the first members, those whose real roots a solve from the ordinary start counts otherwise.
std::size_t other_real_counts(const Family& family, const std::vector<Point>& members,
                              const std::vector<MemberRoots>& results, std::size_t count) {
  const auto lanes = make_lane_tracker();
  std::size_t others = 0;
  for (std::size_t k = 0; k < std::min(count, members.size()); ++k) {
    const SolveResult direct = solve(member_system(family, exact_values(members[k])), *lanes);
    others += results[k].real_count() == real_roots(family, direct) ? 0 : 1;
  }
  return others;
}

/// False where a member has not the generic count.
bool measure(const FamilyProblem& problem, const Request& request) {
  const auto lanes = make_lane_tracker();
  SolveOptions options;
  options.threads = request.threads;
  const Stopwatch learning;
  const Family family = learn(problem.family, *lanes, options);
  const double learn_s = learning.total();
  std::vector<Point> members;
  for (std::size_t k = 0; k < request.members; ++k) members.push_back(problem.member(k));
  options.certify = request.certify;
  const Stopwatch watch;
  const std::clock_t begin = std::clock();
  const auto results = solve_members(family, members, *lanes, options);
  const double us = 1e6 * watch.total() / static_cast<double>(members.size());
  const double cpu_us = 1e6 * static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC /
                        static_cast<double>(members.size());
  std::size_t wrong = 0;
  std::size_t judged = 0;
  for (const MemberRoots& result : results) {
    wrong += result.failed > 0 || result.roots.size() != problem.roots ? 1 : 0;
    judged += result.judged ? 1 : 0;
  }
  wrong += family.roots.size() == problem.roots ? 0 : members.size();
  const std::size_t others = other_real_counts(family, members, results, request.direct);
  std::printf("%-14s %6zu %8.1f %8.1f %9.2f %7zu %7zu %11zu\n", problem.name.c_str(),
              family.roots.size(), us, cpu_us, learn_s * 1e3, wrong, judged, others);
  return wrong == 0 && others == 0;
}

}  // namespace
}  // namespace moivre

int main(int argc, char** argv) {
  try {
    const moivre::Request request = moivre::request_of(argc, argv);
    std::printf("%-14s %6s %8s %8s %9s %7s %7s %11s\n", "family", "roots", "us", "cpu us",
                "learn ms", "wrong", "judged", "other real");
    bool right = true;
    for (const moivre::FamilyProblem& problem : moivre::family_problems()) {
      if (moivre::is_wanted(request, problem.name)) right &= moivre::measure(problem, request);
    }
    return right ? 0 : 1;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 2;
  }
}
