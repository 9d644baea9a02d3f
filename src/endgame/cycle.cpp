// SPDX-License-Identifier: MIT
// Power sums from samples, and turns around zero.
#include "cycle.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace moivre {
namespace {

// Relative error of a sample of what has to vanish: of z^k it is k times as large.
constexpr double kSampleError = 1e-10;
// Of a sample itself: what is left of its difference from a common point that it nearly is.
constexpr double kRounding = 1e-14;
// Sums beyond the m-th follow from the first m: they tell samples that are made of errors.
constexpr int kMoreSums = 2;
// Limits that are to be 0 are known to lie so much nearer to 0 than the samples do.
constexpr double kNearer = 0.5;
constexpr double kMuchNearer = 1e-3;

/// Means of z^k and of |z|^k.
struct PowerMean {
  Complex sum;
  double size = 0;
  int k = 0;
  bool is_lost() const { return std::abs(sum) <= kSampleError * k * size; }
};

PowerMean power_mean(const std::vector<Complex>& z, int k) {
  PowerMean mean;
  mean.k = k;
  for (const Complex& sample : z) {
    mean.sum += std::pow(sample, k);
    mean.size += std::pow(std::abs(sample), k);
  }
  mean.sum /= static_cast<double>(z.size());
  mean.size /= static_cast<double>(z.size());
  return mean;
}

}  // namespace

double limit_bound(const std::vector<Complex>& z, int m) {
  double bound = 0;
  for (int k = 1; k <= m; ++k) {
    bound = std::max(bound, std::pow(m * std::abs(power_mean(z, k).sum), 1.0 / k));
  }
  return 2 * bound;
}

bool vanish_together(const std::vector<Complex>& z, int m) {
  for (int k = 1; k <= m; ++k) {
    if (!power_mean(z, k).is_lost()) return false;
  }
  return limit_bound(z, m) <= kNearer * power_mean(z, 1).size;
}

bool end_beyond(double bound, const std::vector<Complex>& z, int m) {
  const double limit = limit_bound(z, m);
  return limit <= bound && limit <= kMuchNearer * power_mean(z, 1).size;
}

bool meet_together(const std::vector<Complex>& z, const Complex& common, int m) {
  std::vector<Complex> from_common = z;
  for (Complex& sample : from_common) sample -= common;
  for (int k = 2; k <= m + kMoreSums; ++k) {
    const PowerMean mean = power_mean(from_common, k);
    const double rounding = kRounding * k * std::abs(common) * power_mean(from_common, k - 1).size;
    if (!mean.is_lost() && std::abs(mean.sum) > rounding) return false;
  }
  return true;
}

std::vector<double> valuations(const std::vector<Point>& samples, std::size_t homogenizing, int m) {
  const auto turns_of = [&](std::size_t j) {
    double angle = 0;
    for (std::size_t k = 0; k < samples.size(); ++k) {
      const Complex& before = samples[(k + samples.size() - 1) % samples.size()][j];
      angle += std::arg(samples[k][j] / before);
    }
    return std::round(angle / (2 * std::numbers::pi));
  };
  const double homogenizing_turns = turns_of(homogenizing);
  std::vector<double> result;
  for (std::size_t j = 0; j < samples.front().size(); ++j) {
    if (j != homogenizing) result.push_back((turns_of(j) - homogenizing_turns) / m);
  }
  return result;
}

}  // namespace moivre
