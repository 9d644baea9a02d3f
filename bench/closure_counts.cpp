// SPDX-License-Identifier: MIT
// Is every closure found, whatever the seed and the tracker, and how exactly does each satisfy Phi?
// A table over many seeds.
//
//   closure_counts [--seeds N] [FILE...]     names of problems/mechanisms, without ending
//
// A run is short when it is not complete, or when its closures, complex or real, or its paths are
// not the published ones.
// residual: the largest |Phi_i| / (sum of the magnitudes of the terms of Phi_i) over all rows,
// closures and seeds;
// ms: the mean of the time find_closures takes, on one thread.
// Exit: 0 every run found every closure with residuals of at most 1e-12, 1 some run did not, 2
// usage.
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <exception>
#include <memory>
#include <numbers>
#include <string>
#include <vector>

#include "mechanisms.h"
#include "moivre/mechanism/phi.h"
#include "moivre/tracker_cvode/cvode_tracker.h"
#include "moivre/tracker_lanes/lane_tracker.h"
#include "published_counts.h"

namespace {

using moivre::ClosureResult;
using moivre::PublishedCount;

constexpr double kLargestResidual = 1e-12;

struct Request {
  std::uint64_t seeds = 20;
  std::vector<std::string> files;
};

/// Throws std::invalid_argument or std::out_of_range when a number is not one.
Request request_of(int argc, char** argv) {
  Request request;
  for (int k = 1; k < argc; ++k) {
    const std::string word = argv[k];
    if (word != "--seeds") {
      request.files.push_back(word);
    } else if (k + 1 == argc) {
      throw std::invalid_argument("--seeds needs a number");
    } else {
      request.seeds = std::stoull(argv[++k]);
    }
  }
  return request;
}

/// One row of the table.
struct Row {
  std::uint64_t fewest_paths = ~std::uint64_t{0};
  std::uint64_t most_paths = 0;
  double residual = 0;
  double seconds = 0;
  std::vector<std::uint64_t> short_seeds;

  void add(const ClosureResult& result, const moivre::Phi& phi, const PublishedCount& published) {
    fewest_paths = std::min(fewest_paths, result.paths.tracked);
    most_paths = std::max(most_paths, result.paths.tracked);
    for (const moivre::Closure& closure : result.closures) {
      residual = std::max(residual, moivre::scaled_residual(phi, closure.q, result.time));
    }
    seconds += result.time_s.total;
    const bool is_found = result.complete && result.counts.complex == published.complex &&
                          result.counts.real == published.real &&
                          result.paths.tracked <= published.most_paths;
    if (!is_found) short_seeds.push_back(result.seed);
  }
};

Row run(const PublishedCount& published, const moivre::Tracker& tracker, std::uint64_t seeds) {
  moivre::Mechanism mechanism = moivre::mechanism_file(published.file);
  if (published.driver_deg) {
    mechanism = moivre::driven_from(mechanism, *published.driver_deg * std::numbers::pi / 180);
  }
  const moivre::Phi phi(mechanism);
  Row row;
  for (std::uint64_t seed = 1; seed <= seeds; ++seed) {
    moivre::ClosureOptions options;
    options.solve.seed = seed;
    options.solve.threads = 1;
    row.add(moivre::find_closures(mechanism, tracker, options), phi, published);
  }
  return row;
}

bool print(const PublishedCount& published, const std::string& tracker, const Row& row,
           std::uint64_t seeds) {
  const std::string paths =
      row.fewest_paths == row.most_paths
          ? std::to_string(row.most_paths)
          : std::to_string(row.fewest_paths) + ".." + std::to_string(row.most_paths);
  std::printf("%-26s %-6s %8llu %5llu %6s  %8.1e %7.2f  %s", name_of(published).c_str(),
              tracker.c_str(), static_cast<unsigned long long>(published.complex),
              static_cast<unsigned long long>(published.real), paths.c_str(), row.residual,
              1e3 * row.seconds / static_cast<double>(seeds),
              row.short_seeds.empty() ? "all" : "SHORT, seeds");
  for (const std::uint64_t seed : row.short_seeds) {
    std::printf(" %llu", static_cast<unsigned long long>(seed));
  }
  std::printf("\n");
  std::fflush(stdout);
  return row.short_seeds.empty() && row.residual <= kLargestResidual;
}

bool find_all(const Request& request) {
  std::printf("%-26s %-6s %8s %5s %6s  %8s %7s  %s\n", "mechanism", "by", "complex", "real",
              "paths", "residual", "ms", "found");
  const auto cvode = moivre::make_cvode_tracker();
  const auto lanes = moivre::make_lane_tracker();
  bool all = true;
  for (const PublishedCount& published : moivre::published_counts()) {
    const bool is_wanted = request.files.empty() ||
                           std::find(request.files.begin(), request.files.end(), published.file) !=
                               request.files.end();
    if (!is_wanted) continue;
    for (const moivre::Tracker* tracker : {cvode.get(), lanes.get()}) {
      const Row row = run(published, *tracker, request.seeds);
      all = print(published, tracker->kind(), row, request.seeds) && all;
    }
  }
  return all;
}

}  // namespace

int main(int argc, char** argv) {
  try {
    return find_all(request_of(argc, argv)) ? 0 : 1;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "closure_counts: %s\n", error.what());
    return 2;
  }
}
