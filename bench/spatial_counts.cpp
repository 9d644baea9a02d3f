// SPDX-License-Identifier: MIT
// Is every closure of the spatial mechanisms found, whatever the seed and the tracker, also with
// every dimension a little off?
//
//   spatial_counts [--seeds N] [--turned] [--off SHARE]... [FILE...]     names of
//   problems/mechanisms, without ending
//
// off: every dimension is off by up to this share, at random by the seed
// (tests/closures/spatial_counts.h); 0, 1e-2 and 1e-9 where no --off is given. --turned: as typed,
// but in frames turned at random by the seed; without mechanisms whose angles are driven.
// A run is short when it is not complete, or a closure that may have a certificate has none, or
// when its closures are not those of the mechanism, or of its general class; as typed, also when
// real closures, paths or the dimension of a motion are not those expected.
// residual: of Phi, the largest over all closures and seeds; ms: the mean of the time find_closures
// takes, on one thread. Each short seed stands with the complex closures found there, ? where paths
// failed.
// Exit: 0 every run found every closure with residuals of at most 1e-12, 1 some run did not, 2
// usage.
#include "spatial_counts.h"

#include <algorithm>
#include <cstdio>
#include <exception>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include "mechanisms.h"
#include "moivre/tracker_cvode/cvode_tracker.h"
#include "moivre/tracker_lanes/lane_tracker.h"

namespace {

using moivre::ClosureResult;
using moivre::Mechanism;
using moivre::SpatialCount;

constexpr double kLargestResidual = 1e-12;

struct Request {
  std::uint64_t seeds = 20;
  bool turned = false;
  std::vector<double> shares;
  std::vector<std::string> files;
};

/// Throws std::invalid_argument or std::out_of_range when a number is not one.
Request request_of(int argc, char** argv) {
  Request request;
  for (int k = 1; k < argc; ++k) {
    const std::string word = argv[k];
    const bool is_option = word == "--seeds" || word == "--off";
    if (word == "--turned") {
      request.turned = true;
    } else if (!is_option) {
      request.files.push_back(word);
    } else if (k + 1 == argc) {
      throw std::invalid_argument(word + " needs a number");
    } else if (word == "--seeds") {
      request.seeds = std::stoull(argv[++k]);
    } else {
      request.shares.push_back(std::stod(argv[++k]));
    }
  }
  if (request.turned) request.shares = {0};
  if (request.shares.empty()) request.shares = {0, 1e-2, 1e-9};
  return request;
}

/// One row of the table.
struct Row {
  std::uint64_t fewest_paths = ~std::uint64_t{0};
  std::uint64_t most_paths = 0;
  double residual = 0;
  double seconds = 0;
  std::vector<std::string> short_seeds;

  void add(const ClosureResult& result) {
    fewest_paths = std::min(fewest_paths, result.paths.tracked);
    most_paths = std::max(most_paths, result.paths.tracked);
    for (const moivre::Closure& closure : result.closures) {
      residual = std::max(residual, closure.residual);
    }
    seconds += result.time_s.total;
  }
};

/// Where certificates can be had at all.
bool is_certified(const ClosureResult& result) {
  return !result.completeness || *result.completeness != moivre::RootCompleteness::open ||
         result.moves;
}

bool is_as_typed(const ClosureResult& result, const SpatialCount& count) {
  const std::uint64_t dimension = result.moves ? result.moves->dimension : 0;
  return result.complete && is_certified(result) && result.counts.complex == count.complex &&
         result.counts.real == count.real && result.paths.tracked <= count.most_paths &&
         dimension == count.dimension;
}

bool is_general(const ClosureResult& result, const SpatialCount& count) {
  return result.complete && is_certified(result) && !result.moves &&
         result.counts.complex == count.disturbed;
}

Mechanism changed(const Mechanism& typed, double share, bool is_turned, std::uint64_t seed) {
  if (is_turned) return moivre::turned(typed, seed);
  return share > 0 ? moivre::disturbed(typed, share, seed) : typed;
}

bool has_driven_angle(const Mechanism& mechanism) {
  return std::any_of(
      mechanism.drivers.begin(), mechanism.drivers.end(),
      [](const moivre::Driver& driver) { return driver.kind == moivre::DriverKind::angle; });
}

Row run(const SpatialCount& count, double share, const moivre::Tracker& tracker,
        const Request& request) {
  const Mechanism typed = moivre::mechanism_file(count.file);
  Row row;
  for (std::uint64_t seed = 1; seed <= request.seeds; ++seed) {
    const Mechanism mechanism = changed(typed, share, request.turned, seed);
    moivre::ClosureOptions options;
    options.solve.seed = seed;
    options.solve.threads = 1;
    const ClosureResult result = moivre::find_closures(mechanism, tracker, options);
    row.add(result);
    if (share > 0 ? is_general(result, count) : is_as_typed(result, count)) continue;
    row.short_seeds.push_back(std::to_string(seed) + " (" + std::to_string(result.counts.complex) +
                              (result.complete ? ")" : "?)"));
  }
  return row;
}

bool print(const SpatialCount& count, double share, const std::string& tracker, const Row& row,
           std::uint64_t seeds) {
  const std::string paths =
      row.fewest_paths == row.most_paths
          ? std::to_string(row.most_paths)
          : std::to_string(row.fewest_paths) + ".." + std::to_string(row.most_paths);
  std::printf("%-18s %5.0e %-6s %8llu %9s  %8.1e %8.1f  %s", count.file.c_str(), share,
              tracker.c_str(),
              static_cast<unsigned long long>(share > 0 ? count.disturbed : count.complex),
              paths.c_str(), row.residual, 1e3 * row.seconds / static_cast<double>(seeds),
              row.short_seeds.empty() ? "all" : "SHORT, seeds");
  for (const std::string& seed : row.short_seeds) std::printf(" %s", seed.c_str());
  std::printf("\n");
  std::fflush(stdout);
  return row.short_seeds.empty() && row.residual <= kLargestResidual;
}

bool find_all(const Request& request) {
  std::printf("%-18s %5s %-6s %8s %9s  %8s %8s  %s\n", "mechanism", "off", "by", "complex", "paths",
              "residual", "ms", "found");
  const auto cvode = moivre::make_cvode_tracker();
  const auto lanes = moivre::make_lane_tracker();
  bool all = true;
  for (const SpatialCount& count : moivre::spatial_counts()) {
    const bool is_wanted =
        request.files.empty() ||
        std::find(request.files.begin(), request.files.end(), count.file) != request.files.end();
    if (!is_wanted || (request.turned && has_driven_angle(moivre::mechanism_file(count.file)))) {
      continue;
    }
    for (const double share : request.shares) {
      for (const moivre::Tracker* tracker : {cvode.get(), lanes.get()}) {
        const Row row = run(count, share, *tracker, request);
        all = print(count, share, tracker->kind(), row, request.seeds) && all;
      }
    }
  }
  return all;
}

}  // namespace

int main(int argc, char** argv) {
  try {
    return find_all(request_of(argc, argv)) ? 0 : 1;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "spatial_counts: %s\n", error.what());
    return 2;
  }
}
