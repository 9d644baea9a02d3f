// SPDX-License-Identifier: MIT
// Hashes of points, and the search among them by their real parts.
#include "point_hash.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

#include "moivre/numeric/near_points.h"

namespace moivre {
namespace {

// Hashes are not to depend on a run's seed: whoever looks one up needs none.
constexpr std::uint64_t kSeed = 1;

// Points are known to this, relative, where they are compared.
constexpr double kHashTolerance = 1e-7;

// Of a point that is not compared.
constexpr Complex kNone{std::numeric_limits<double>::quiet_NaN(),
                        std::numeric_limits<double>::quiet_NaN()};

}  // namespace

double tolerance_at(Complex hash) { return kHashTolerance * std::max(1.0, std::abs(hash)); }

Complex hash_of(const Point& x) {
  Complex hash = 0;
  for (std::size_t j = 0; j + 1 < x.size(); ++j) {
    const Complex log_z = std::log(x[j]) - std::log(x.back());
    hash += random_phase(kSeed, RandomStream::mark, 2 * j) * std::polar(1.0, log_z.imag());
    hash += random_phase(kSeed, RandomStream::mark, 2 * j + 1) * log_z.real();
  }
  return hash;
}

void PointHashes::set(std::uint64_t path, Complex hash) {
  // A coordinate is 0: such points are not told apart.
  if (!std::isfinite(hash.real()) || !std::isfinite(hash.imag())) return forget(path);
  if (path >= hashes_.size()) hashes_.resize(path + 1, kNone);
  hashes_[path] = hash;
}

void PointHashes::forget(std::uint64_t path) {
  if (path < hashes_.size()) hashes_[path] = kNone;
}

std::vector<std::uint64_t> PointHashes::shared() const {
  std::vector<double> numbers;
  for (const Complex hash : hashes_) numbers.push_back(hash.real());
  const NearNumbers near(numbers);
  std::set<std::uint64_t> result;
  for (std::uint64_t a = 0; a < hashes_.size(); ++a) {
    const double most = tolerance_at(hashes_[a]);
    near.visit_near(numbers[a], most, [&](std::uint64_t b) {
      if (a != b && std::abs(hashes_[a] - hashes_[b]) <= most) result.insert({a, b});
    });
  }
  return {result.begin(), result.end()};
}

}  // namespace moivre
