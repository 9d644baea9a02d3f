// SPDX-License-Identifier: MIT
// Is every root found, whatever the seed, the tracker and the start? A table of roots, failures,
// retracks, steps and CPU time.
//
//   root_counts [--tracker cvode|lanes|both] [--start KIND|all] [--seeds N] [--threads N]
//   [PROBLEM...]
//                                                         names of problems/polynomials/index.json
//
// KIND: auto (the default), total-degree, multihomogeneous, polyhedral; all: the last three, each
// by itself.
// A run is short when it is not complete, when roots, with multiplicity, differ from the index, or
// when a root is apart:
// farther from every root of the problem's first run than both are known. Roots and real roots are
// the least and the most of all seeds; steps are accepted and rejected ones of all seeds; CPU
// seconds are a seed's mean.
// Lanes have CVODE as their fallback; handed: paths that went to it.
// Exit: 0 every run found every root, 1 some run was short, 2 usage.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <ctime>
#include <exception>
#include <optional>
#include <string>
#include <vector>

#include "moivre/polynomial/read.h"
#include "moivre/solver/solve.h"
#include "moivre/tracker_cvode/cvode_tracker.h"
#include "moivre/tracker_lanes/lane_tracker.h"
#include "problem_index.h"

namespace {

using moivre::SolveResult;
using moivre::StartKind;
using moivre::problems::Problem;

const std::string kFolder = MOIVRE_SOURCE_DIR "/problems/polynomials";

struct Request {
  std::uint64_t seeds = 20;
  int threads = 1;
  std::vector<bool> in_lanes{false};  ///< one for each tracker
  std::vector<StartKind> starts{StartKind::automatic};
  std::vector<std::string> names{"katsura-6", "katsura-8", "katsura-10", "cyclic-5",
                                 "cyclic-6",  "cyclic-7",  "noon-4",     "noon-5",
                                 "reimer-4",  "reimer-5",  "puma",       "dense-complex-8-2"};
};

std::vector<bool> trackers_of(const std::string& word) {
  if (word == "both") return {false, true};
  if (word != "cvode" && word != "lanes") throw std::invalid_argument("no tracker: " + word);
  return {word == "lanes"};
}

std::vector<StartKind> starts_of(const std::string& word) {
  if (word == "all") {
    return {StartKind::total_degree, StartKind::multihomogeneous, StartKind::polyhedral};
  }
  const std::optional<StartKind> kind = moivre::start_kind(word);
  if (!kind) throw std::invalid_argument("no start: " + word);
  return {*kind};
}

/// Throws std::invalid_argument or std::out_of_range when a number is not one.
Request request_of(int argc, char** argv) {
  Request request;
  std::vector<std::string> names;
  for (int k = 1; k < argc; ++k) {
    const std::string word = argv[k];
    const bool is_option =
        word == "--seeds" || word == "--threads" || word == "--tracker" || word == "--start";
    if (is_option && k + 1 == argc) throw std::invalid_argument(word + " needs a value");
    if (word == "--seeds") {
      request.seeds = std::stoull(argv[++k]);
    } else if (word == "--threads") {
      request.threads = std::stoi(argv[++k]);
    } else if (word == "--tracker") {
      request.in_lanes = trackers_of(argv[++k]);
    } else if (word == "--start") {
      request.starts = starts_of(argv[++k]);
    } else {
      names.push_back(word);
    }
  }
  if (!names.empty()) request.names = names;
  return request;
}

using Roots = std::vector<moivre::Solution>;

bool is_near(const moivre::Solution& a, const moivre::Solution& b) {
  double distance = 0;
  double size = 1;
  for (std::size_t i = 0; i < a.x.size(); ++i) {
    distance = std::max(distance, std::abs(a.x[i] - b.x[i]));
    size = std::max(size, std::abs(a.x[i]));
  }
  return distance <= (a.accuracy + b.accuracy) * size;
}

/// How many of the roots are none of the others.
std::uint64_t count_apart(const Roots& roots, const Roots& others) {
  return static_cast<std::uint64_t>(std::count_if(roots.begin(), roots.end(), [&](const auto& a) {
    return std::none_of(others.begin(), others.end(), [&](const auto& b) { return is_near(a, b); });
  }));
}

/// One row of the table: a problem, a tracker and a start.
struct Row {
  std::uint64_t apart = 0;
  std::uint64_t fewest = ~std::uint64_t{0};
  std::uint64_t most = 0;
  std::uint64_t fewest_real = ~std::uint64_t{0};
  std::uint64_t most_real = 0;
  std::uint64_t failed = 0;
  std::uint64_t retracked = 0;
  std::uint64_t handed_over = 0;
  std::uint64_t steps = 0;
  double cpu_s = 0;
  std::vector<std::uint64_t> short_seeds;

  /// first: the roots of the problem's first run.
  void add(const SolveResult& result, const Roots& first, const Problem& p, double seconds) {
    const std::uint64_t apart_here = count_apart(result.solutions, first);
    apart += apart_here;
    std::uint64_t roots = 0;
    std::uint64_t real = 0;
    for (const moivre::Solution& s : result.solutions) {
      roots += s.multiplicity;
      if (s.real) ++real;
    }
    fewest = std::min(fewest, roots);
    most = std::max(most, roots);
    fewest_real = std::min(fewest_real, real);
    most_real = std::max(most_real, real);
    failed += result.paths.failed;
    retracked += result.paths.retracked;
    handed_over += result.paths.handed_over;
    steps += result.work.accepted + result.work.rejected;
    cpu_s += seconds;
    if (!result.complete || apart_here > 0 || roots != p.roots.with_multiplicity ||
        real != p.roots.real || result.solutions.size() != p.roots.distinct) {
      short_seeds.push_back(result.seed);
    }
  }
};

double cpu_seconds() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

/// first: set by the problem's first run.
Row run(const Problem& p, bool in_lanes, StartKind start, const Request& request,
        std::optional<Roots>& first) {
  const moivre::System f = moivre::read_system(moivre::read_source(kFolder + "/" + p.file));
  const auto cvode = moivre::make_cvode_tracker();
  const auto lanes = moivre::make_lane_tracker();
  Row row;
  for (std::uint64_t seed = 1; seed <= request.seeds; ++seed) {
    moivre::SolveOptions options;
    options.seed = seed;
    options.threads = request.threads;
    options.start = start;
    options.second_start = start == StartKind::automatic;
    if (in_lanes) options.fallback = cvode.get();
    const double begin = cpu_seconds();
    const SolveResult result = moivre::solve(f, in_lanes ? *lanes : *cvode, options);
    const double seconds = cpu_seconds() - begin;
    if (!first) first = result.solutions;
    row.add(result, *first, p, seconds);
  }
  return row;
}

std::string span(std::uint64_t least, std::uint64_t most) {
  return least == most ? std::to_string(least)
                       : std::to_string(least) + ".." + std::to_string(most);
}

void print(const Problem& p, bool in_lanes, StartKind start, const Row& row, std::uint64_t seeds) {
  const std::string roots = span(row.fewest, row.most);
  const std::string real = span(row.fewest_real, row.most_real);
  std::printf(
      "%-20s %-7s %-16s %8llu %12s %12s %5llu %7llu %9llu %7llu %10llu %9.4f  %s", p.name.c_str(),
      in_lanes ? "lanes" : "cvode", moivre::to_string(start).c_str(),
      static_cast<unsigned long long>(p.roots.with_multiplicity), roots.c_str(), real.c_str(),
      static_cast<unsigned long long>(row.apart), static_cast<unsigned long long>(row.failed),
      static_cast<unsigned long long>(row.retracked),
      static_cast<unsigned long long>(row.handed_over), static_cast<unsigned long long>(row.steps),
      row.cpu_s / static_cast<double>(seeds), row.short_seeds.empty() ? "all" : "SHORT, seeds");
  for (const std::uint64_t seed : row.short_seeds) {
    std::printf(" %llu", static_cast<unsigned long long>(seed));
  }
  std::printf("\n");
  std::fflush(stdout);
}

bool find_all(const Request& request) {
  const std::vector<Problem> index = moivre::problems::read_index(kFolder);
  std::printf("%-20s %-7s %-16s %8s %12s %12s %5s %7s %9s %7s %10s %9s  %s\n", "problem", "tracker",
              "start", "expected", "roots", "real", "apart", "failed", "retracked", "handed",
              "steps", "cpu_s", "found");
  bool all = true;
  for (const std::string& name : request.names) {
    const auto p =
        std::find_if(index.begin(), index.end(), [&](const Problem& q) { return q.name == name; });
    if (p == index.end()) throw std::invalid_argument("no problem of the index: " + name);
    std::optional<Roots> first;
    for (const StartKind start : request.starts) {
      for (const bool in_lanes : request.in_lanes) {
        const Row row = run(*p, in_lanes, start, request, first);
        print(*p, in_lanes, start, row, request.seeds);
        all = all && row.short_seeds.empty();
      }
    }
  }
  return all;
}

}  // namespace

int main(int argc, char** argv) {
  try {
    const Request request = request_of(argc, argv);
    if (request.seeds == 0) throw std::invalid_argument("--seeds must be at least 1");
    return find_all(request) ? 0 : 1;
  } catch (const std::exception& fault) {
    std::fprintf(stderr, "root_counts: %s\n", fault.what());
    return 2;
  }
}
