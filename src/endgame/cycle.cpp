// SPDX-License-Identifier: MIT
// Power sums from samples, and turns around zero.
#include "cycle.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace moivre {
namespace {

// Sums beyond the m-th follow from the first m: they tell samples that are made of errors.
constexpr int kMoreSums = 2;

/// Means of z^k and of |z|^k.
struct PowerMean {
  Complex sum;
  double size = 0;
  int k = 0;
  /// In the errors of the samples: that of z^k is k times theirs.
  bool is_lost(const EndParameters& ends) const {
    return std::abs(sum) <= ends.sample_error * k * size;
  }
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

bool vanish_together(const std::vector<Complex>& z, int m, const EndParameters& ends) {
  for (int k = 1; k <= m; ++k) {
    if (!power_mean(z, k).is_lost(ends)) return false;
  }
  return limit_bound(z, m) < power_mean(z, 1).size;
}

bool end_beyond(double bound, const std::vector<Complex>& z, int m) {
  const double limit = limit_bound(z, m);
  return limit <= bound && limit < power_mean(z, 1).size;
}

bool meet_together(const std::vector<Complex>& z, const Complex& common, int m,
                   const EndParameters& ends) {
  std::vector<Complex> from_common = z;
  for (Complex& sample : from_common) sample -= common;
  for (int k = 2; k <= m + kMoreSums; ++k) {
    const PowerMean mean = power_mean(from_common, k);
    const double rounding =
        ends.rounding * k * std::abs(common) * power_mean(from_common, k - 1).size;
    if (!mean.is_lost(ends) && std::abs(mean.sum) > rounding) return false;
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
