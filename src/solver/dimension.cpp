// SPDX-License-Identifier: MIT
// The moved slice and Gauss-Newton on it.
#include "dimension.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

#include "moivre/numeric/random.h"
#include "moivre/polynomial/tape.h"

namespace moivre {
namespace {

constexpr double kSliceStep = 0.1;
constexpr double kOnTheSet = 1e-14;
// A root found further away than this many steps is not the neighbour that is looked for.
constexpr double kNeighbourhood = 8;
constexpr int kMaximumIterations = 60;
// A set nearly parallel to one plane has its neighbour too far away, and beside a root of multiplicity 8 the residual on
// one plane may be rounding: three of five decide.
constexpr int kSlices = 5;
constexpr int kAgreeing = 3;

/// F with its rows scaled by the sizes of their terms at x, and its Jacobian. Coordinates below `floor` count as of
/// that size: where one vanishes on the set, the terms would vanish with the values.
class ScaledSystem {
 public:
  ScaledSystem(const System& f, double floor)
      : floor_(floor),
        tape_(make_tape(f)),
        c_(complex_coefficients(tape_, f)),
        registers_(tape_.register_count()),
        size_registers_(tape_.register_count()),
        value_(tape_.equations),
        jacobian_(tape_.jacobian.size()),
        size_(tape_.equations) {
    for (const Complex& ck : c_) magnitude_.push_back(std::abs(ck));
  }

  void evaluate_at(const Eigen::VectorXcd& y, Eigen::VectorXcd& value, Eigen::MatrixXcd& j) {
    const auto n = static_cast<std::size_t>(y.size());
    std::vector<double> size_y(n);
    for (std::size_t i = 0; i < n; ++i) {
      size_y[i] = std::max(std::abs(y[static_cast<Eigen::Index>(i)]), floor_);
    }
    evaluate<double, double>(tape_, magnitude_, size_y, size_registers_, size_);
    evaluate<Complex, Complex>(tape_, c_, std::span<const Complex>(y.data(), n), registers_, value_,
                               jacobian_);
    const auto scale = [&](std::size_t i) { return size_[i] > 0 ? 1 / size_[i] : 1.0; };
    j.topRows(static_cast<Eigen::Index>(tape_.equations)).setZero();
    for (std::size_t i = 0; i < value_.size(); ++i) {
      value[static_cast<Eigen::Index>(i)] = value_[i] * scale(i);
    }
    for (std::size_t k = 0; k < jacobian_.size(); ++k) {
      const Tape::Entry& entry = tape_.jacobian[k];
      j(entry.row, entry.column) = jacobian_[k] * scale(entry.row);
    }
  }

 private:
  double floor_;
  Tape tape_;
  std::vector<Complex> c_;
  std::vector<double> magnitude_;
  std::vector<Complex> registers_;
  std::vector<double> size_registers_;
  std::vector<Complex> value_;
  std::vector<Complex> jacobian_;
  std::vector<double> size_;
};

double step_from(const Eigen::VectorXcd& x) {
  return kSliceStep * std::max(1.0, x.lpNorm<Eigen::Infinity>());
}

bool has_root_on_moved_slice(ScaledSystem& f, const Eigen::VectorXcd& x, std::uint64_t seed,
                             std::uint64_t slice) {
  const Eigen::Index n = x.size();
  const double step = step_from(x);
  Eigen::VectorXcd value(n + 1);
  Eigen::MatrixXcd j(n + 1, n);
  for (Eigen::Index i = 0; i < n; ++i) {
    const auto index = slice * static_cast<std::uint64_t>(n) + static_cast<std::uint64_t>(i);
    j(n, i) = random_phase(seed, RandomStream::slice, index);
  }
  const Complex target = (j.row(n) * x)(0) + step;
  Eigen::VectorXcd y = x;
  for (int k = 0; k < kMaximumIterations; ++k) {
    f.evaluate_at(y, value, j);
    value[n] = (j.row(n) * y)(0) - target;
    if (k > 0 && value.head(n).lpNorm<Eigen::Infinity>() < kOnTheSet &&
        std::abs(value[n]) < kOnTheSet * (1 + std::abs(target))) {
      return true;
    }
    const Eigen::VectorXcd dy = j.completeOrthogonalDecomposition().solve(-value);
    y += dy;
    if (!y.allFinite() || (y - x).lpNorm<Eigen::Infinity>() > kNeighbourhood * step) return false;
  }
  return false;
}

}  // namespace

bool lies_on_positive_dimensional_set(const System& f, const Point& x, std::uint64_t seed) {
  if (x.size() < 2) return false;
  const Eigen::VectorXcd point =
      Eigen::Map<const Eigen::VectorXcd>(x.data(), static_cast<Eigen::Index>(x.size()));
  ScaledSystem scaled(f, step_from(point));
  int found = 0;
  for (std::uint64_t slice = 0; slice < kSlices; ++slice) {
    found += has_root_on_moved_slice(scaled, point, seed, slice) ? 1 : 0;
  }
  return found >= kAgreeing;
}

}  // namespace moivre
