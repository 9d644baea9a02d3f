// SPDX-License-Identifier: MIT
// Are the figures beside a root those of the root? Residual and condition, computed again.
#include <algorithm>
#include <atomic>
#include <cmath>
#include <optional>
#include <vector>

#include "bench.h"
#include "moivre/factorization/lu.h"
#include "moivre/numeric/double_double.h"
#include "moivre/numeric/threads.h"
#include "moivre/polynomial/scale.h"
#include "moivre/polynomial/tape.h"

namespace moivre {
namespace {

// A residual is computed in more digits than double and rounded; the sizes beside it lose some
// digits in long sums.
constexpr double kResidualRounding = 1e-9;
// Both are made at a point that was rounded to double: each coordinate by 2^-53 of its size, the
// value by degree times that.
constexpr double kPointRounding = 4 * 0x1p-53;
// Condition numbers are estimates, within a factor of 3 each [Higham88], and rows are scaled by
// powers of two. Rows of size 1 have the least of all; other units of the unknowns make it larger,
// by how much is not said in a result.
constexpr double kConditionFactor = 10;
// From here on the Jacobian in double tells no condition.
constexpr double kKnownCondition = 1e10;

/// The largest coefficient of each equation near 1: residuals and conditions stay, and none falls
/// below double's range.
System with_rows_near_one(const System& f) {
  Scaling rows{std::vector<int>(f.variables.size()), {}};
  for (const Polynomial& p : f.polynomials) {
    double largest = -HUGE_VAL;
    for (const Term& term : p.terms) largest = std::max(largest, log2_size(term.coefficient));
    rows.equation_log2.push_back(p.terms.empty() ? 0 : -static_cast<int>(std::floor(largest)));
  }
  return scale(f, rows);
}

class Figures {
 public:
  explicit Figures(const System& f)
      : tape_(make_tape(f)),
        exact_(round_coefficients<ComplexDoubleDouble>(tape_, f, to_complex_double_double)),
        coefficients_(complex_coefficients(tape_, f)),
        n_(tape_.variables) {
    for (const Complex& c : coefficients_) sizes_.push_back(std::abs(c));
    for (const std::uint64_t d : degrees(f)) degree_ = std::max(degree_, static_cast<double>(d));
  }

  /// max_i |F_i| / sum |terms of F_i|; NaN where double overflows.
  double residual(const Point& x) {
    std::vector<ComplexDoubleDouble> point(x.begin(), x.end());
    std::vector<ComplexDoubleDouble> registers(tape_.register_count());
    std::vector<ComplexDoubleDouble> values(tape_.equations);
    evaluate<ComplexDoubleDouble, ComplexDoubleDouble>(tape_, exact_, point, registers, values);
    measure(x, 0);
    double largest = 0;
    for (std::size_t i = 0; i < values.size(); ++i) {
      const double size = std::abs(to_complex(values[i]));
      const double share = term_sizes_[i] > 0 ? size / term_sizes_[i] : size;
      largest = share <= largest ? largest : share;
    }
    return largest;
  }

  /// What moving each coordinate by `distance` may change of the residual.
  double change(const Point& x, double distance) {
    measure(x, distance);
    std::vector<double> sums(tape_.equations);
    for (std::size_t k = 0; k < slopes_.size(); ++k) {
      sums[tape_.jacobian[k].row] += slopes_[k] * distance;
    }
    measure(x, 0);
    double largest = 0;
    for (std::size_t i = 0; i < sums.size(); ++i) {
      if (sums[i] > 0) largest = std::max(largest, sums[i] / term_sizes_[i]);
    }
    return largest;
  }

  double degree() const { return degree_; }
  bool is_square() const { return tape_.equations == n_; }

  /// Of the Jacobian with rows scaled, unknowns measured by `weights`.
  double condition(const Point& x, const std::vector<double>& weights) {
    std::vector<Complex> registers(tape_.register_count());
    std::vector<Complex> values(tape_.equations);
    std::vector<Complex> jacobian(tape_.jacobian.size());
    evaluate<Complex, Complex>(tape_, coefficients_, x, registers, values, jacobian);
    Lu lu(n_);
    std::fill(lu.matrix().begin(), lu.matrix().end(), Complex(0));
    for (std::size_t k = 0; k < jacobian.size(); ++k) {
      lu.matrix()[tape_.jacobian[k].row * n_ + tape_.jacobian[k].column] = jacobian[k];
    }
    return lu.factor(weights) ? lu.condition() : HUGE_VAL;
  }

 private:
  /// Sums of the terms' sizes and those of the derivatives at |x_j| + distance.
  void measure(const Point& x, double distance) {
    std::vector<double> point;
    for (const Complex& xj : x) point.push_back(std::abs(xj) + distance);
    std::vector<double> registers(tape_.register_count());
    term_sizes_.resize(tape_.equations);
    slopes_.resize(tape_.jacobian.size());
    evaluate<double, double>(tape_, sizes_, point, registers, term_sizes_, slopes_);
  }

  Tape tape_;
  std::vector<ComplexDoubleDouble> exact_;
  std::vector<Complex> coefficients_;
  std::vector<double> sizes_, term_sizes_, slopes_;
  std::size_t n_;
  double degree_ = 1;
};

/// Of one root what is stated and can be computed again.
struct Found {
  std::optional<double> residual;
  double slack = 0;             ///< of the residual
  std::optional<double> least;  ///< condition, rows of size 1
  double other = 0;  ///< condition in other units, where the least does not reach what is stated
};

/// bases: the system of which a root's condition is stated.
Found found_of(const Bench& bench, Figures& figures, Figures& bases, std::size_t k) {
  const RootClaim& root = bench.claims.roots[k];
  Found found;
  if (root.residual) {
    found.residual = figures.residual(root.x);
    found.slack = kResidualRounding * *found.residual + kPointRounding * figures.degree();
    // Imaginary parts of real roots were set to 0 behind the residual.
    if (root.real == true) found.slack += figures.change(root.x, bench.entries[k].reach);
  }
  const bool is_proved = bench.entries[k].certificate.holds_root();
  if (!figures.is_square() || !root.condition || !is_proved) return found;
  std::vector<double> weights(root.x.size(), 1.0);
  found.least = bases.condition(root.x, weights);
  if (*root.condition <= kConditionFactor * *found.least) return found;
  for (std::size_t j = 0; j < weights.size(); ++j) {
    if (root.x[j] != Complex(0)) weights[j] = std::abs(root.x[j]);
  }
  found.other = bases.condition(root.x, weights);
  return found;
}

void judge_residual(const Bench& bench, const Found& found, std::size_t k) {
  if (!found.residual) return;
  const double stated = *bench.claims.roots[k].residual;
  if (std::isnan(*found.residual + found.slack)) {
    return bench.verdicts.leave_open(ClaimKind::residual, "beyond the range of double", k + 1);
  }
  bench.verdicts.judge(ClaimKind::residual, std::abs(stated - *found.residual) <= found.slack,
                       rough(stated) + " is stated, " + rough(*found.residual) + " is found",
                       k + 1);
}

void judge_condition(const Bench& bench, const Found& found, std::size_t k) {
  if (!found.least) return;
  const double stated = *bench.claims.roots[k].condition;
  if (!(*found.least < kKnownCondition)) {
    return bench.verdicts.leave_open(ClaimKind::condition, "too large to be found again in double",
                                     k + 1);
  }
  if (stated > kConditionFactor * std::max(*found.least, found.other)) {
    return bench.verdicts.leave_open(ClaimKind::condition,
                                     "larger than is found, as other units may make it", k + 1);
  }
  bench.verdicts.judge(ClaimKind::condition, stated * kConditionFactor >= *found.least,
                       rough(stated) + " is stated, " + rough(*found.least) + " is found", k + 1);
}

/// Of every root, by all threads.
std::vector<Found> found_figures(const Bench& bench) {
  // Fewer are computed before a thread has begun.
  constexpr std::size_t kOfAThread = 256;
  const Figures figures(with_rows_near_one(bench.f));
  const Figures bases(
      with_rows_near_one(bench.stand_in.sheets > 1 ? bench.stand_in.system : bench.f));
  std::vector<Found> found(bench.entries.size());
  const auto most = static_cast<std::size_t>(thread_count(0));
  std::atomic<std::size_t> next{0};
  on_threads(static_cast<int>(std::min(most, 1 + found.size() / kOfAThread)), [&] {
    Figures own = figures;
    Figures own_bases = bases;
    for (std::size_t k = next++; k < found.size() && !bench.stop; k = next++) {
      found[k] = found_of(bench, own, own_bases, k);
    }
  });
  bench.require_time();
  return found;
}

}  // namespace

void judge_figures(const Bench& bench) {
  if (bench.is_list()) return;
  const std::vector<Found> found = found_figures(bench);
  for (std::size_t k = 0; k < bench.entries.size(); ++k) {
    bench.require_time();
    judge_residual(bench, found[k], k);
    judge_condition(bench, found[k], k);
  }
}

}  // namespace moivre
