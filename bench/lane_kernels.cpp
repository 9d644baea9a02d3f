// SPDX-License-Identifier: MIT
// How close do the lanes' kernels come to what one core can do? Counted flops over time, as a share
// of the FMA peak.
//
//   lane_kernels FILE.phc     the file's total-degree homotopy, not eliminated; one thread, every
//                             target of the machine
//   lane_kernels_native FILE.phc     the same compiled with -march=native and without run-time
//                                    dispatch
//
// Flops are those of the mathematics: a complex product 6, a complex product added to a sum 8, real
// times complex added 4;
// pivot search, exchanges of rows and weights count nothing, so a share of 1 is out of reach. The
// peak is measured:
// independent multiply-adds in registers. CPU time, the fastest of some rounds, warm caches.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "bench/lane_kernels.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include <algorithm>
#include <cstdio>
#include <ctime>

#include "lane_step-inl.h"
#include "moivre/polynomial/read.h"
#include "moivre/start/total_degree.h"

#ifndef MOIVRE_BENCH_LANE_KERNELS_ONCE
#define MOIVRE_BENCH_LANE_KERNELS_ONCE
namespace moivre {
namespace {

constexpr double kLeastSeconds = 0.02;  // long against the clock's resolution
constexpr int kRounds = 7;              // the fastest counts: others were disturbed

/// Seconds of one call.
template <class F>
double cost(F&& call) {
  double best = 1;
  for (int round = 0; round < kRounds; ++round) {
    const std::clock_t begin = std::clock();
    double seconds = 0;
    long calls = 0;
    while (seconds < kLeastSeconds) {
      for (int k = 0; k < 100; ++k) call();
      calls += 100;
      seconds = static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC;
    }
    best = std::min(best, seconds / static_cast<double>(calls));
  }
  return best;
}

double flops(const HomotopyProgram<double>::Sum& sum) {
  return 4.0 * (sum.real_end - sum.real_begin) + 8.0 * (sum.complex_end - sum.complex_begin);
}

std::uint32_t moving_terms(const HomotopyProgram<double>::Blend& blend) {
  return blend.moving_end - blend.moving_begin;
}

/// Of LaneHomotopy::linearize in one lane.
double linearization_flops(const HomotopyProgram<double>& program) {
  double count = 6.0 * static_cast<double>(program.products.size());
  for (const HomotopyProgram<double>::Blend& value : program.values) {
    count += flops(value.f) + flops(value.g) + 14 + 2 + 16.0 * moving_terms(value);
  }
  count += 6.0 * static_cast<double>(program.weighted_count());
  const double blending = program.has_weighted_registers() ? 0 : 6;
  for (const HomotopyProgram<double>::Entry& entry : program.jacobian) {
    count += flops(entry.blend.f) + blending + 8.0 * moving_terms(entry.blend);
    if (!entry.blend.g.is_empty()) count += flops(entry.blend.g) + 8;
  }
  return count;
}

/// Of LaneHomotopy::expand in one lane.
double expansion_flops(const HomotopyProgram<double>& program) {
  double count = (6.0 + 14.0) * static_cast<double>(program.value_products);
  for (const HomotopyProgram<double>::Blend& value : program.values) {
    count += 2 * (flops(value.f) + flops(value.g)) + 14 + 2 + 22 + 24.0 * moving_terms(value);
  }
  return count;
}

/// Of LaneLu::factor in one lane, with `appended` right-hand sides.
double factorization_flops(std::size_t n, std::size_t appended) {
  double count = 0;
  for (std::size_t k = 0; k < n; ++k) {
    const double rows = static_cast<double>(n - k - 1);
    count += 6 + rows * (6 + 8 * (rows + static_cast<double>(appended)));
  }
  return count;
}

void print(const char* kernel, double flops_of_lane, std::size_t lanes, double seconds,
           double peak) {
  const double rate = flops_of_lane * static_cast<double>(lanes) / seconds;
  std::printf("  %-22s %9.0f flops/lane %8.0f ns %7.2f Gflop/s  %5.1f %% of peak\n", kernel,
              flops_of_lane, seconds * 1e9, rate * 1e-9, 100 * rate / peak);
}

}  // namespace
}  // namespace moivre
#endif

HWY_BEFORE_NAMESPACE();
namespace moivre {
namespace HWY_NAMESPACE {

/// Flop/s of multiply-adds that wait for nothing. Every chain begins with a number of its own:
/// equal ones would be one.
double measure_peak() {
  constexpr std::size_t kChains = 12;  // latency times throughput of FMA units, and some
  constexpr int kTurns = 256;
  LaneVector<V> start(kChains);
  for (std::size_t k = 0; k < kChains; ++k) {
    for (std::size_t lane = 0; lane < W; ++lane) {
      start.set(k, lane, Complex(1.0 + 0.1 * static_cast<double>(k + lane), 0));
    }
  }
  LaneVector<V> sink(kChains);
  const V a = hn::Set(Tag(), 0.999);
  const V b = hn::Set(Tag(), 0.001);
  const double seconds = cost([&]() HWY_ATTR {
    V s0 = load_real(start[0].at[0]), s1 = load_real(start[1].at[0]),
      s2 = load_real(start[2].at[0]);
    V s3 = load_real(start[3].at[0]), s4 = load_real(start[4].at[0]),
      s5 = load_real(start[5].at[0]);
    V s6 = load_real(start[6].at[0]), s7 = load_real(start[7].at[0]),
      s8 = load_real(start[8].at[0]);
    V s9 = load_real(start[9].at[0]), s10 = load_real(start[10].at[0]),
      s11 = load_real(start[11].at[0]);
    for (int k = 0; k < kTurns; ++k) {
      s0 = hn::MulAdd(s0, a, b);
      s1 = hn::MulAdd(s1, a, b);
      s2 = hn::MulAdd(s2, a, b);
      s3 = hn::MulAdd(s3, a, b);
      s4 = hn::MulAdd(s4, a, b);
      s5 = hn::MulAdd(s5, a, b);
      s6 = hn::MulAdd(s6, a, b);
      s7 = hn::MulAdd(s7, a, b);
      s8 = hn::MulAdd(s8, a, b);
      s9 = hn::MulAdd(s9, a, b);
      s10 = hn::MulAdd(s10, a, b);
      s11 = hn::MulAdd(s11, a, b);
    }
    store(LaneComplex<V>{s0, s1}, sink[0]);
    store(LaneComplex<V>{s2, s3}, sink[1]);
    store(LaneComplex<V>{s4, s5}, sink[2]);
    store(LaneComplex<V>{s6, s7}, sink[3]);
    store(LaneComplex<V>{s8, s9}, sink[4]);
    store(LaneComplex<V>{s10, s11}, sink[5]);
  });
  return 2.0 * static_cast<double>(kChains) * kTurns * static_cast<double>(W) / seconds;
}

void report(const Homotopy& homotopy, const TotalDegreeStart& start) {
  const HomotopyProgram<double> program = make_program<double>(homotopy);
  const std::size_t coordinates = homotopy.coordinates();
  const std::size_t n = homotopy.equations();
  LanePath<V> path(coordinates);
  LaneTime<V> time;
  LaneReals h;
  for (std::size_t lane = 0; lane < W; ++lane) {
    Point x = start_point(start, lane % start.paths);
    const double norm = euclidean_norm(x);
    for (Complex& xi : x) xi /= norm;
    path.place(lane, x);
    time.set(lane, PathTime(0.3 + 0.01 * static_cast<double>(lane)), 1);
  }
  const double peak = measure_peak();
  std::printf("%s, %zu lanes, n = %zu, peak %.1f Gflop/s\n", hwy::TargetName(HWY_TARGET), W, n,
              peak * 1e-9);

  LaneHomotopy<V> evaluator(homotopy, program);
  LaneLu<V> lu(coordinates);
  LaneVector<V> x(coordinates);
  LaneVector<V> hx(coordinates);
  LaneVector<V> ht(coordinates);
  LaneVector<V> slope(coordinates);
  path.predict(h.value(), x);
  const double linearization = cost([&]() HWY_ATTR { evaluator.linearize(x, time, hx, lu, ht); });
  print("tape: H, H_x, H_t", linearization_flops(program), W, linearization, peak);
  const double expansion = cost([&]() HWY_ATTR { evaluator.expand(x, ht, time, hx, slope); });
  print("tape: H and slope", expansion_flops(program), W, expansion, peak);

  LaneStep<V> step(homotopy, program);
  const double factorization = cost([&]() HWY_ATTR {
                                 evaluator.linearize(x, time, hx, lu, ht);
                                 for (std::size_t j = 0; j < coordinates; ++j)
                                   store(load(path.patch()[j]), lu.at(n, j));
                                 lu.factor();
                               }) -
                               linearization;
  print("LU, two columns more", factorization_flops(coordinates, 2), W, factorization, peak);
  const double m = static_cast<double>(coordinates);
  const double solve = cost([&]() HWY_ATTR { lu.solve(hx, ht); });
  print("triangular solves", 2 * (8 * m * (m - 1) + 6 * m), W, solve, peak);
  const double prediction = cost([&]() HWY_ATTR { path.predict(h.value(), x); });
  print("predictor", 6 * 4 * m, W, prediction, peak);
  const double whole = cost([&]() HWY_ATTR { step.take(path, h, time); });
  const double all = linearization_flops(program) + expansion_flops(program) +
                     factorization_flops(coordinates, 2) + 3 * (8 * m * (m - 1) + 6 * m) +
                     6 * 4 * m;
  print("a whole step", all, W, whole, peak);
}

}  // namespace HWY_NAMESPACE
}  // namespace moivre
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
#include <hwy/targets.h>

#include <exception>

namespace moivre {
namespace {

HWY_EXPORT(report);

void run(const char* file) {
  const System f = read_system(read_source(file));
  const TotalDegreeStart start = total_degree_start(degrees(f), 1);
  const Homotopy homotopy(f, start_system(start, f.variables));
  const std::int64_t all = hwy::SupportedTargets() & HWY_TARGETS;
  for (std::int64_t rest = all; rest != 0; rest &= rest - 1) {
    hwy::SetSupportedTargetsForTest(rest & -rest);
    hwy::GetChosenTarget().Update(hwy::SupportedTargets());
    HWY_DYNAMIC_DISPATCH(report)(homotopy, start);
  }
}

}  // namespace
}  // namespace moivre

int main(int argc, char** argv) {
  if (argc != 2) {
    std::fprintf(stderr, "usage: lane_kernels FILE.phc\n");
    return 1;
  }
  try {
    moivre::run(argv[1]);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "lane_kernels: %s\n", error.what());
    return 1;
  }
  return 0;
}
#endif
