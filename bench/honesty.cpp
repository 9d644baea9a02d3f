// SPDX-License-Identifier: MIT
// Is the accuracy that is reported true? Every root of the problem set against the same root to
// fifty digits.
//
//   honesty [--seeds N] [--threads N] [--paths N] [PROBLEM...]    names of
//   problems/polynomials/index.json
//
// Without names: every problem of at most --paths paths (total degree). Both trackers, seeds 1 to
// N. The reference of a regular root is Newton's method in multiprecision from it, with a proved
// bound; that of a singular root is the point that the index knows exactly. A root without either
// is counted as such. Ratio: reported over true error, the latter no less than the rounding of a
// double. Exit: 0 the bar is met in all, 1 it is not, 2 usage.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <exception>
#include <string>
#include <vector>

#include "moivre/multiprecision/reference_roots.h"
#include "moivre/polynomial/read.h"
#include "moivre/solver/solve.h"
#include "moivre/tracker_cvode/cvode_tracker.h"
#include "moivre/tracker_lanes/lane_tracker.h"
#include "problem_index.h"

namespace {

using moivre::Point;
using moivre::Solution;
using moivre::problems::Problem;

const std::string kFolder = MOIVRE_SOURCE_DIR "/problems/polynomials";
constexpr int kDigits = 50;
constexpr double kUnitRoundoff = 0x1p-53;
// The bar: so many roots are at least as good as they say, and the median claims no more than so
// much too little.
constexpr double kHonestShare = 0.999;
constexpr double kLargestMedian = 100;

struct Request {
  std::uint64_t seeds = 3;
  std::uint64_t paths = 1100;
  int threads = 1;
  std::vector<std::string> names;
};

/// Throws std::invalid_argument or std::out_of_range when a number is not one.
Request request_of(int argc, char** argv) {
  Request request;
  for (int k = 1; k < argc; ++k) {
    const std::string word = argv[k];
    const bool is_option = word.rfind("--", 0) == 0;
    if (is_option && k + 1 == argc) throw std::invalid_argument(word + " needs a number");
    if (word == "--seeds") {
      request.seeds = std::stoull(argv[++k]);
    } else if (word == "--threads") {
      request.threads = std::stoi(argv[++k]);
    } else if (word == "--paths") {
      request.paths = std::stoull(argv[++k]);
    } else if (is_option) {
      throw std::invalid_argument("no option " + word);
    } else {
      request.names.push_back(word);
    }
  }
  return request;
}

struct Row {
  std::uint64_t roots = 0;
  std::uint64_t without_reference = 0;
  std::uint64_t too_bold = 0;  ///< true error above the reported one
  double boldest = 0;          ///< largest true / reported
  std::vector<double> ratios;  ///< reported / true

  void compare(double reported, double error) {
    if (error > reported) ++too_bold;
    boldest = std::max(boldest, error / reported);
    ratios.push_back(reported / std::max(error, kUnitRoundoff));
  }
  double median() {
    if (ratios.empty()) return 0;
    const auto middle = ratios.begin() + static_cast<std::ptrdiff_t>(ratios.size() / 2);
    std::nth_element(ratios.begin(), middle, ratios.end());
    return *middle;
  }
  Row& operator+=(const Row& other) {
    roots += other.roots;
    without_reference += other.without_reference;
    too_bold += other.too_bold;
    boldest = std::max(boldest, other.boldest);
    ratios.insert(ratios.end(), other.ratios.begin(), other.ratios.end());
    return *this;
  }
};

double distance(const Point& a, const Point& b) {
  double largest = 0;
  for (std::size_t i = 0; i < a.size(); ++i) largest = std::max(largest, std::abs(a[i] - b[i]));
  return largest / std::max(1.0, moivre::max_norm(a));
}

void compare_singular(const Solution& root, const Problem& p, Row& row) {
  double nearest = 1;
  for (const auto& point : p.points) nearest = std::min(nearest, distance(root.x, point.x));
  // Further away it is another point than those that the index knows.
  if (nearest < 1e-2) {
    row.compare(root.accuracy, std::max(0.0, nearest - kUnitRoundoff));
  } else {
    ++row.without_reference;
  }
}

/// Regular and singular roots: their errors are of different kinds.
struct Rows {
  Row regular;
  Row singular;

  Rows& operator+=(const Rows& other) {
    regular += other.regular;
    singular += other.singular;
    return *this;
  }
};

void compare(const moivre::System& f, const std::vector<Solution>& roots, const Problem& p,
             Rows& rows) {
  std::vector<Point> regular;
  std::vector<double> reported;
  for (const Solution& root : roots) {
    if (root.singular) {
      compare_singular(root, p, rows.singular);
    } else {
      regular.push_back(root.x);
      reported.push_back(root.accuracy);
    }
  }
  const auto references = moivre::reference_roots(f, regular, kDigits);
  for (std::size_t k = 0; k < references.size(); ++k) {
    if (references[k].converged) {
      rows.regular.compare(reported[k], references[k].forward_error);
    } else {
      ++rows.regular.without_reference;
    }
  }
  rows.regular.roots += regular.size();
  rows.singular.roots += roots.size() - regular.size();
}

void print(const std::string& name, const std::string& tracker, const char* kind, Row& row) {
  if (row.roots == 0) return;
  std::printf("%-20s %-6s %-8s %8llu %9llu %9llu %9.2g %9.2f\n", name.c_str(), tracker.c_str(),
              kind, static_cast<unsigned long long>(row.roots),
              static_cast<unsigned long long>(row.without_reference),
              static_cast<unsigned long long>(row.too_bold), row.boldest, row.median());
  std::fflush(stdout);
}

void print(const std::string& name, const std::string& tracker, Rows& rows) {
  print(name, tracker, "regular", rows.regular);
  print(name, tracker, "singular", rows.singular);
}

std::vector<Problem> chosen(const Request& request) {
  std::vector<Problem> result;
  const std::vector<Problem> index = moivre::problems::read_index(kFolder);
  for (const Problem& p : index) {
    const bool named = std::count(request.names.begin(), request.names.end(), p.name) > 0;
    const bool small = p.total_degree <= request.paths && p.same_as.empty();
    if (request.names.empty() ? small : named) result.push_back(p);
  }
  if (!request.names.empty() && result.size() != request.names.size()) {
    throw std::invalid_argument("no problem of the index among the names");
  }
  return result;
}

Rows run(const Problem& p, const moivre::Tracker& tracker, const moivre::Tracker* fallback,
         const Request& request) {
  const moivre::System f = moivre::read_system(moivre::read_source(kFolder + "/" + p.file));
  Rows rows;
  for (std::uint64_t seed = 1; seed <= request.seeds; ++seed) {
    moivre::SolveOptions options;
    options.seed = seed;
    options.threads = request.threads;
    options.fallback = fallback;
    compare(f, moivre::solve(f, tracker, options).solutions, p, rows);
  }
  print(p.name, tracker.kind(), rows);
  return rows;
}

bool is_honest(const Request& request) {
  const auto cvode = moivre::make_cvode_tracker();
  const auto lanes = moivre::make_lane_tracker();
  std::printf("%-20s %-6s %-8s %8s %9s %9s %9s %9s\n", "problem", "track", "kind", "roots",
              "no ref", "too bold", "boldest", "median");
  Rows both;
  for (const Problem& p : chosen(request)) {
    both += run(p, *cvode, nullptr, request);
    both += run(p, *lanes, cvode.get(), request);
  }
  print("all", "both", both);
  Row all = both.regular;
  all += both.singular;
  print("all", "both", "all", all);
  const auto compared = static_cast<double>(all.ratios.size());
  return static_cast<double>(all.too_bold) <= (1 - kHonestShare) * compared &&
         all.median() <= kLargestMedian;
}

}  // namespace

int main(int argc, char** argv) {
  try {
    const Request request = request_of(argc, argv);
    if (request.seeds == 0) throw std::invalid_argument("--seeds must be at least 1");
    return is_honest(request) ? 0 : 1;
  } catch (const std::exception& fault) {
    std::fprintf(stderr, "honesty: %s\n", fault.what());
    return 2;
  }
}
