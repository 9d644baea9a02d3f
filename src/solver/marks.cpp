// SPDX-License-Identifier: MIT
// Marks of points, and the search among them by their real parts.
#include "marks.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

#include "moivre/numeric/near_points.h"

namespace moivre {
namespace {

// Marks are not to depend on a run's seed: whoever looks one up needs none.
constexpr std::uint64_t kSeed = 1;

// Points are known to this, relative, where they are compared.
constexpr double kMarkTolerance = 1e-7;

}  // namespace

double tolerance_at(Complex mark) { return kMarkTolerance * std::max(1.0, std::abs(mark)); }

Complex mark_of(const Point& x) {
  Complex mark = 0;
  for (std::size_t j = 0; j + 1 < x.size(); ++j) {
    const Complex log_z = std::log(x[j]) - std::log(x.back());
    mark += random_phase(kSeed, RandomStream::mark, 2 * j) * std::polar(1.0, log_z.imag());
    mark += random_phase(kSeed, RandomStream::mark, 2 * j + 1) * log_z.real();
  }
  return mark;
}

void Marks::set(std::uint64_t path, Complex mark) {
  // A coordinate is 0: such points are not told apart.
  if (!std::isfinite(mark.real()) || !std::isfinite(mark.imag())) return forget(path);
  constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
  if (path >= marks_.size()) marks_.resize(path + 1, Complex(kNone, kNone));
  marks_[path] = mark;
}

void Marks::forget(std::uint64_t path) {
  constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
  if (path < marks_.size()) marks_[path] = Complex(kNone, kNone);
}

std::vector<std::uint64_t> Marks::shared() const {
  std::vector<double> numbers;
  for (const Complex mark : marks_) numbers.push_back(mark.real());
  const NearNumbers near(numbers);
  std::set<std::uint64_t> result;
  for (std::uint64_t a = 0; a < marks_.size(); ++a) {
    const double most = tolerance_at(marks_[a]);
    near.visit_near(numbers[a], most, [&](std::uint64_t b) {
      if (a != b && std::abs(marks_[a] - marks_[b]) <= most) result.insert({a, b});
    });
  }
  return {result.begin(), result.end()};
}

}  // namespace moivre
