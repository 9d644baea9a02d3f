// SPDX-License-Identifier: MIT
// Power sums from samples, and turns around zero.
#include "cycle.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace moivre {
namespace {

// Sums beyond the m-th follow from the first m: they tell samples that are made of errors.
constexpr int kMoreSums = 2;

/// Means of z^k and of |z|^k, k = 0, 1, ..., of samples in units of the largest: none of their
/// powers overflows, and not all of them vanish.
class PowerMeans {
 public:
  PowerMeans(const std::vector<Complex>& z, int highest) {
    for (const Complex& sample : z) unit_ = std::max(unit_, modulus(sample));
    const double inverse = unit_ > 0 ? 1 / unit_ : 0;
    const double share = 1 / static_cast<double>(z.size());
    means_.resize(static_cast<std::size_t>(highest) + 1);
    for (const Complex& sample : z) {
      const Complex scaled = inverse * sample;
      const double size = modulus(scaled);
      Complex power = share;
      double size_of_power = share;
      for (Mean& mean : means_) {
        mean.sum += power;
        mean.size += size_of_power;
        power = product(power, scaled);
        size_of_power *= size;
      }
    }
  }

  /// In the errors of the samples: that of z^k is k times theirs.
  bool is_lost(int k, const EndParameters& ends) const {
    return sum(k) <= ends.sample_error * k * size(k);
  }
  /// |p_k(0)|, in units to the k.
  double sum(int k) const { return modulus(at(k).sum); }
  double size(int k) const { return at(k).size; }
  double unit() const { return unit_; }

  /// Of the limits, in units.
  double limit_bound(int m) const {
    double bound = 0;
    for (int k = 1; k <= m; ++k) bound = std::max(bound, std::pow(m * sum(k), 1.0 / k));
    return 2 * bound;
  }

 private:
  struct Mean {
    Complex sum;
    double size = 0;
  };
  const Mean& at(int k) const { return means_[static_cast<std::size_t>(k)]; }

  double unit_ = 0;
  std::vector<Mean> means_;
};

/// The points of one turn, e^{-2 pi i k / samples}.
std::vector<Complex> unit_roots(std::size_t samples) {
  const double step = 2 * std::numbers::pi / static_cast<double>(samples);
  std::vector<Complex> roots;
  for (std::size_t k = 0; k < samples; ++k) {
    roots.push_back(std::polar(1.0, -step * static_cast<double>(k)));
  }
  return roots;
}

/// Coefficient of order -j of a function with these samples on one turn, times their number.
Complex laurent_of_pole(const std::vector<Complex>& p, std::size_t j,
                        const std::vector<Complex>& turn) {
  Complex sum;
  const std::size_t count = p.size();
  for (std::size_t i = 0; i < count; ++i) {
    sum = add_product(p[i], turn[(count - j) * i % count], sum);
  }
  return sum;
}

/// What all numbers may change in the sum of z^k, in units: |sum_i k z_i^{k-1} dz_i| of each.
/// powers: z^{k-1}.
double change_of_sum(const std::vector<Complex>& powers,
                     const std::vector<std::vector<Complex>>& changes, int k) {
  double all = 0;
  for (const std::vector<Complex>& change : changes) {
    Complex sum;
    for (std::size_t i = 0; i < powers.size(); ++i) sum = add_product(powers[i], change[i], sum);
    all += k * modulus(sum);
  }
  return all;
}

}  // namespace

double limit_bound(const std::vector<Complex>& z, int m) {
  const PowerMeans means(z, m);
  return means.unit() * means.limit_bound(m);
}

bool vanish_together(const std::vector<Complex>& z, int m, const EndParameters& ends) {
  const PowerMeans means(z, m);
  for (int k = 1; k <= m; ++k) {
    if (!means.is_lost(k, ends)) return false;
  }
  return means.limit_bound(m) < means.size(1);
}

SumsAndErrors sums_and_errors(const std::vector<Complex>& z, int m, double known,
                              const EndParameters& ends,
                              const std::vector<std::vector<Complex>>& changes) {
  SumsAndErrors worst;
  double unit = 0;
  for (const Complex& sample : z) unit = std::max(unit, modulus(sample));
  if (unit == 0) return worst;
  const auto samples = static_cast<std::size_t>(ends.samples);
  const std::vector<Complex> turn = unit_roots(samples);
  std::vector<Complex> powers(z.size(), Complex(1));
  for (int k = 1; k <= m; ++k) {
    const double changed = change_of_sum(powers, changes, k) / unit;
    std::vector<Complex> p(samples);
    double size = 0;
    for (std::size_t i = 0; i < z.size(); ++i) {
      powers[i] = product(powers[i], z[i] / unit);
      p[i % samples] += powers[i];
      size += modulus(powers[i]);
    }
    // Coefficients that differ by `samples` in their order are one: of order -1 and -2 are also
    // those that the sum is wrong by, or nearly.
    const double seen = modulus(laurent_of_pole(p, 1, turn)) + modulus(laurent_of_pole(p, 2, turn));
    const double rounding = k * std::max(known, std::numeric_limits<double>::epsilon()) * size;
    const double error = std::max(seen, rounding);
    const double sum = std::max(0.0, modulus(laurent_of_pole(p, 0, turn)) - changed);
    worst.sum = std::max(worst.sum, sum / error);
    worst.error = std::max(worst.error, error / (k * size));
  }
  return worst;
}

bool end_beyond(double bound, const std::vector<Complex>& z, int m) {
  const PowerMeans means(z, m);
  const double limit = means.limit_bound(m);
  return means.unit() * limit <= bound && limit < means.size(1);
}

bool meet_together(const std::vector<Complex>& z, const Complex& common, int m,
                   const EndParameters& ends) {
  std::vector<Complex> from_common = z;
  for (Complex& sample : from_common) sample -= common;
  const PowerMeans means(from_common, m + kMoreSums);
  for (int k = 2; k <= m + kMoreSums; ++k) {
    // Of one more factor z - common.
    const double rounding = ends.rounding * k * modulus(common) * means.size(k - 1);
    if (!means.is_lost(k, ends) && means.unit() * means.sum(k) > rounding) return false;
  }
  return true;
}

std::vector<int> turns_around_zero(const std::vector<Point>& samples) {
  // Of the polygon of samples: its edges that cross the positive half of the real axis, by
  // direction.
  std::vector<int> turns(samples.front().size());
  const Point* before = &samples.back();
  for (const Point& sample : samples) {
    for (std::size_t j = 0; j < turns.size(); ++j) {
      const Complex a = (*before)[j];
      const Complex b = sample[j];
      const double area = a.real() * b.imag() - a.imag() * b.real();
      if (a.imag() <= 0 && b.imag() > 0 && area > 0) ++turns[j];
      if (a.imag() > 0 && b.imag() <= 0 && area < 0) --turns[j];
    }
    before = &sample;
  }
  return turns;
}

std::vector<double> valuations(const std::vector<Point>& samples, std::size_t homogenizing, int m) {
  const std::vector<int> turns = turns_around_zero(samples);
  std::vector<double> result;
  for (std::size_t j = 0; j < turns.size(); ++j) {
    if (j != homogenizing) {
      result.push_back(static_cast<double>(turns[j] - turns[homogenizing]) / m);
    }
  }
  return result;
}

}  // namespace moivre
