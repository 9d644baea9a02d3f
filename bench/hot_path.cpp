// SPDX-License-Identifier: MIT
// Where does the time of a path go? Counted calls of each kernel times its cost in a tight loop.
//
//   hot_path FILE.phc     one thread, CVODE tracker, the default options; no elimination
//
// share of a kernel = calls that solve() counted * seconds of one call on the same homotopy /
// seconds of solve(), all of them CPU time. The kernels are timed one by one with warm caches, so
// the shares are lower bounds; what is left over is CVODE itself with vectors, norms, endgame and
// refinement. A triangular solve is counted for every linearization and for every H alone. The
// system is tracked as it stands in the file, so that it is the one timed.
#include <algorithm>
#include <cstdio>
#include <ctime>
#include <exception>

#include "moivre/factorization/lu.h"
#include "moivre/homotopy/evaluator.h"
#include "moivre/polynomial/read.h"
#include "moivre/solver/solve.h"
#include "moivre/start/total_degree.h"
#include "moivre/tracker_cvode/cvode_tracker.h"

namespace moivre {
namespace {

constexpr double kLeastSeconds = 0.05;  // long against the clock's resolution
constexpr int kBatch = 100;             // calls between two looks at the clock
constexpr int kRounds = 5;              // the fastest counts: others were disturbed

/// CPU seconds of this process.
double cpu_seconds() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

/// Seconds of one call.
template <class F>
double cost(F&& call) {
  double best = 1;
  for (int round = 0; round < kRounds; ++round) {
    const double begin = cpu_seconds();
    double seconds = 0;
    long calls = 0;
    while (seconds < kLeastSeconds) {
      for (int k = 0; k < kBatch; ++k) call();
      calls += kBatch;
      seconds = cpu_seconds() - begin;
    }
    best = std::min(best, seconds / static_cast<double>(calls));
  }
  return best;
}

struct Costs {
  double value = 0;
  double linearization = 0;
  double factorization = 0;
  double solve = 0;
};

Costs measure(const System& f, std::uint64_t seed) {
  const TotalDegreeStart start = total_degree_start(degrees(f), seed);
  const Homotopy homotopy(f, start_system(start, f.variables));
  const std::size_t n = homotopy.equations();
  HomotopyEvaluator<Complex> evaluator(homotopy);
  const Point x = start_point(start, 0);
  const PathTime t(Complex(0.5));
  Point h(n), ht(n), hx(n * (n + 1)), b(n + 1, 1.0);
  Costs costs;
  costs.value = cost([&] { evaluator.value(x, t, h); });
  costs.linearization = cost([&] { evaluator.linearization(x, t, h, hx, ht); });
  Lu lu(n + 1);
  const auto fill = [&] {
    std::copy(hx.begin(), hx.end(), lu.matrix().begin());
    for (std::size_t j = 0; j <= n; ++j) lu.matrix()[n * (n + 1) + j] = std::conj(x[j]);
  };
  costs.factorization = cost([&] {
    fill();
    lu.factor();
  });
  costs.solve = cost([&] {
    std::fill(b.begin(), b.end(), Complex(1));
    lu.solve(b);
  });
  return costs;
}

void print(const char* kernel, std::uint64_t calls, double seconds_of_one, double total) {
  const double seconds = static_cast<double>(calls) * seconds_of_one;
  std::printf("%-34s %10llu calls %9.1f ns %6.1f %%\n", kernel,
              static_cast<unsigned long long>(calls), 1e9 * seconds_of_one, 100 * seconds / total);
}

int run(const char* file) {
  const System f = read_system(read_source(file));
  SolveOptions options;
  options.threads = 1;
  options.eliminate = options.scale = false;
  const double begin = cpu_seconds();
  const SolveResult result = solve(f, *make_cvode_tracker(), options);
  const double total = cpu_seconds() - begin;
  const WorkCount& work = result.work.work;
  const Costs costs = measure(f, options.seed);
  const auto paths = static_cast<double>(result.paths.tracked);
  std::printf("%s: %.0f paths, %.1f us and %.1f steps a path, %llu failed\n", file, paths,
              1e6 * total / paths, static_cast<double>(result.work.accepted) / paths,
              static_cast<unsigned long long>(result.paths.failed));
  std::printf("share = counted calls x cost of one in a tight loop / CPU time of solve()\n");
  const std::uint64_t solves = work.values + work.fine_values + work.linearizations;
  print("tape: H alone", work.values, costs.value, total);
  print("tape: H, its Jacobian, H_t", work.linearizations, costs.linearization, total);
  print("LU factorization", work.factorizations, costs.factorization, total);
  print("triangular solves", solves, costs.solve, total);
  const double known = static_cast<double>(work.values) * costs.value +
                       static_cast<double>(work.linearizations) * costs.linearization +
                       static_cast<double>(work.factorizations) * costs.factorization +
                       static_cast<double>(solves) * costs.solve;
  std::printf("%-34s %36.1f %%\n", "CVODE itself and the rest", 100 * (1 - known / total));
  return result.complete ? 0 : 2;
}

}  // namespace
}  // namespace moivre

int main(int argc, char** argv) {
  if (argc != 2) {
    std::fprintf(stderr, "usage: hot_path FILE\n");
    return 1;
  }
  try {
    return moivre::run(argv[1]);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
  }
}
