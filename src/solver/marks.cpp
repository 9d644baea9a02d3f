// SPDX-License-Identifier: MIT
// Marks of points, and the search among them along the real axis.
#include "marks.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "moivre/numeric/random.h"

namespace moivre {
namespace {

// Marks are not to depend on a run's seed: whoever looks one up needs none.
constexpr std::uint64_t kSeed = 1;

// Points are known to this, relative, where they are compared.
constexpr double kMarkTolerance = 1e-7;

bool are_one(Complex a, Complex b) { return std::abs(a - b) <= tolerance_at(a); }

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
  std::vector<std::uint64_t> order(marks_.size());
  std::iota(order.begin(), order.end(), std::uint64_t{0});
  std::erase_if(order, [&](std::uint64_t path) { return std::isnan(marks_[path].real()); });
  std::sort(order.begin(), order.end(),
            [&](std::uint64_t a, std::uint64_t b) { return marks_[a].real() < marks_[b].real(); });
  std::vector<std::uint64_t> result;
  for (std::size_t i = 0; i < order.size(); ++i) {
    const Complex mark = marks_[order[i]];
    for (std::size_t k = i + 1; k < order.size(); ++k) {
      if (marks_[order[k]].real() - mark.real() > tolerance_at(mark)) break;
      if (are_one(mark, marks_[order[k]])) result.insert(result.end(), {order[i], order[k]});
    }
  }
  std::sort(result.begin(), result.end());
  result.erase(std::unique(result.begin(), result.end()), result.end());
  return result;
}

}  // namespace moivre
