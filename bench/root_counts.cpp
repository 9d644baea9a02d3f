// SPDX-License-Identifier: MIT
// Is every root found, whatever the seed? A table of roots, failures, retracks, steps and CPU time over many seeds.
//
//   root_counts [--tracker cvode|lanes] [--seeds N] [--threads N] [PROBLEM...]
//                                                         names of problems/polynomials/index.json
//
// A run is short when it is not complete, or when roots, with multiplicity, differ from the index. Roots and real roots
// are the least and the most of all seeds; steps are accepted and rejected ones of all seeds; CPU seconds are a seed's mean.
// Lanes have CVODE as their fallback; handed: paths that went to it.
// Exit: 0 every run found every root, 1 some run was short, 2 usage.
#include <algorithm>
#include <cstdio>
#include <ctime>
#include <exception>
#include <string>
#include <vector>

#include "moivre/polynomial/read.h"
#include "moivre/solver/solve.h"
#include "moivre/tracker_cvode/cvode_tracker.h"
#include "moivre/tracker_lanes/lane_tracker.h"
#include "problem_index.h"

namespace {

using moivre::SolveResult;
using moivre::problems::Problem;

const std::string kFolder = MOIVRE_SOURCE_DIR "/problems/polynomials";

struct Request {
  std::uint64_t seeds = 20;
  int threads = 1;
  bool in_lanes = false;
  std::vector<std::string> names{"katsura-6", "katsura-8", "katsura-10", "cyclic-5",
                                 "cyclic-6",  "cyclic-7",  "noon-4",     "noon-5",
                                 "reimer-4",  "reimer-5",  "puma",       "dense-complex-8-2"};
};

/// Throws std::invalid_argument or std::out_of_range when a number is not one.
Request request_of(int argc, char** argv) {
  Request request;
  std::vector<std::string> names;
  for (int k = 1; k < argc; ++k) {
    const std::string word = argv[k];
    const bool is_option = word == "--seeds" || word == "--threads" || word == "--tracker";
    if (is_option && k + 1 == argc) throw std::invalid_argument(word + " needs a value");
    if (word == "--seeds") {
      request.seeds = std::stoull(argv[++k]);
    } else if (word == "--threads") {
      request.threads = std::stoi(argv[++k]);
    } else if (word == "--tracker") {
      const std::string kind = argv[++k];
      if (kind != "cvode" && kind != "lanes") throw std::invalid_argument("no tracker: " + kind);
      request.in_lanes = kind == "lanes";
    } else {
      names.push_back(word);
    }
  }
  if (!names.empty()) request.names = names;
  return request;
}

/// One row of the table.
struct Row {
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

  void add(const SolveResult& result, const Problem& p, double seconds) {
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
    if (!result.complete || roots != p.roots.with_multiplicity || real != p.roots.real ||
        result.solutions.size() != p.roots.distinct) {
      short_seeds.push_back(result.seed);
    }
  }
};

double cpu_seconds() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

Row run(const Problem& p, const Request& request) {
  const moivre::System f = moivre::read_system(moivre::read_source(kFolder + "/" + p.file));
  const auto cvode = moivre::make_cvode_tracker();
  const auto lanes = moivre::make_lane_tracker();
  Row row;
  for (std::uint64_t seed = 1; seed <= request.seeds; ++seed) {
    moivre::SolveOptions options;
    options.seed = seed;
    options.threads = request.threads;
    if (request.in_lanes) options.fallback = cvode.get();
    const double begin = cpu_seconds();
    const SolveResult result = moivre::solve(f, request.in_lanes ? *lanes : *cvode, options);
    row.add(result, p, cpu_seconds() - begin);
  }
  return row;
}

std::string span(std::uint64_t least, std::uint64_t most) {
  return least == most ? std::to_string(least)
                       : std::to_string(least) + ".." + std::to_string(most);
}

void print(const Problem& p, const Row& row, std::uint64_t seeds) {
  const std::string roots = span(row.fewest, row.most);
  const std::string real = span(row.fewest_real, row.most_real);
  std::printf(
      "%-20s %8llu %12s %12s %7llu %9llu %7llu %10llu %9.4f  %s", p.name.c_str(),
      static_cast<unsigned long long>(p.roots.with_multiplicity), roots.c_str(), real.c_str(),
      static_cast<unsigned long long>(row.failed), static_cast<unsigned long long>(row.retracked),
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
  std::printf("%-20s %8s %12s %12s %7s %9s %7s %10s %9s  %s\n", "problem", "expected", "roots",
              "real", "failed", "retracked", "handed", "steps", "cpu_s", "found");
  bool all = true;
  for (const std::string& name : request.names) {
    const auto p =
        std::find_if(index.begin(), index.end(), [&](const Problem& q) { return q.name == name; });
    if (p == index.end()) throw std::invalid_argument("no problem of the index: " + name);
    const Row row = run(*p, request);
    print(*p, row, request.seeds);
    all = all && row.short_seeds.empty();
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
