// SPDX-License-Identifier: MIT
// The system moved to the approximate root, what is not known of it, and ranks that this cannot
// take away.
#include "moivre/algebra/numerical_multiplicity.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "local_polynomial.h"
#include "moivre/factorization/rank.h"

namespace moivre {
namespace {

// Columns of the largest matrix: a few seconds.
constexpr std::size_t kMostDenseColumns = 300;
// Of a term: powers are multiplied out one by one.
constexpr std::uint64_t kMostDenseDegree = 100;
// Products and sums of double-double, of so many factors and terms.
constexpr double kRounding = 0x1p-92;
// Units of length of y, relative to max(1, |x|).
constexpr std::array<double, 5> kUnits{1, 1e-1, 1e-2, 1e-3, 1e-4};

/// F_i moved to x, and how far each coefficient may be from that at a root within the error.
struct KnownPolynomial {
  LocalPolynomial<ComplexDoubleDouble> terms;
  LocalPolynomial<double> noise;
};

/// sum over j of e (a_j + 1) |c_(a + e_j)|: for all a, what a step of e in every coordinate changes
/// to the first order.
LocalPolynomial<double> first_order(const LocalPolynomial<double>& sizes, double e) {
  LocalPolynomial<double> change;
  for (const auto& [m, c] : sizes) {
    for (std::size_t j = 0; j < m.size(); ++j) {
      if (m[j] == 0) continue;
      Exponents smaller = m;
      --smaller[j];
      add(RoundedNumbers{}, change, smaller, e * m[j] * c);
    }
  }
  return change;
}

KnownPolynomial known(const Polynomial& p, const Point& x, double error, std::uint64_t k) {
  std::vector<ComplexDoubleDouble> place(x.begin(), x.end());
  std::vector<double> far;
  for (const Complex& xi : x) far.push_back(std::abs(xi) + error);
  KnownPolynomial result;
  result.terms = moved(RoundedNumbers{}, p, place, k + 1,
                       [](const Coefficient& c) { return to_complex_double_double(c); });
  // |p|: no derivative of p within the error of x exceeds that of |p| there.
  const LocalPolynomial<double> largest =
      moved(RoundedNumbers{}, p, far, k + 2,
            [](const Coefficient& c) { return std::abs(to_complex(c)); });
  LocalPolynomial<double> sizes;
  for (const auto& [m, c] : result.terms) sizes[m] = std::abs(to_complex(c));
  result.noise = first_order(sizes, error);
  for (const auto& [m, c] : first_order(first_order(largest, error), error)) {
    add(RoundedNumbers{}, result.noise, m, c / 2);
  }
  for (const auto& [m, c] : largest) add(RoundedNumbers{}, result.noise, m, kRounding * c);
  return result;
}

class ApproximateMacaulay {
 public:
  /// Up to degree k.
  ApproximateMacaulay(const System& f, const Point& x, double error, std::uint64_t k)
      : k_(k), monomials_(monomials(x.size(), k, kMostDenseColumns)) {
    for (std::size_t c = 0; c < monomials_.size(); ++c) {
      column_[monomials_[c]] = static_cast<Eigen::Index>(c);
    }
    if (is_too_large()) return;
    for (const Polynomial& p : f.polynomials) rows_.push_back(known(p, x, error, k));
  }

  bool is_too_large() const { return monomials_.empty(); }

  /// N_k, with y measured in `unit`.
  std::uint64_t bound(double unit) const {
    const std::size_t count = monomials_.size();
    Eigen::MatrixXcd A = Eigen::MatrixXcd::Zero(static_cast<Eigen::Index>(count * rows_.size()),
                                                static_cast<Eigen::Index>(count));
    Eigen::Index row = 0;
    double noise = 0;
    for (const Exponents& factor : monomials_) {
      if (degree(factor) >= k_) break;
      for (const KnownPolynomial& p : rows_) {
        Eigen::RowVectorXcd multiple = Eigen::RowVectorXcd::Zero(A.cols());
        Eigen::RowVectorXd unknown = Eigen::RowVectorXd::Zero(A.cols());
        for (const auto& [m, c] : p.terms) enter(to_complex(c), factor, m, unit, multiple);
        for (const auto& [m, c] : p.noise) enter(c, factor, m, unit, unknown);
        const double size = multiple.norm();
        if (size <= unknown.norm()) continue;
        A.row(row++) = multiple / size;
        noise += (unknown / size).squaredNorm();
      }
    }
    return count - static_cast<std::size_t>(least_rank(A.topRows(row), std::sqrt(noise)));
  }

 private:
  /// c y^(factor + m), unless it is of a degree above k.
  template <class S, class Row>
  void enter(const S& c, const Exponents& factor, const Exponents& m, double unit, Row& row) const {
    const std::uint64_t d = degree(factor) + degree(m);
    if (d > k_) return;
    Exponents product = m;
    for (std::size_t j = 0; j < product.size(); ++j) product[j] += factor[j];
    row[column_.at(product)] = c * std::pow(unit, static_cast<double>(d));
  }

  std::uint64_t k_;
  std::vector<Exponents> monomials_;
  std::map<Exponents, Eigen::Index, LocalOrder> column_;
  std::vector<KnownPolynomial> rows_;
};

}  // namespace

std::optional<RingBound> local_ring_near(const System& f, const Point& x, double error) {
  for (const std::uint64_t d : degrees(f)) {
    if (d > kMostDenseDegree) return std::nullopt;
  }
  const double size = std::max(1.0, max_norm(x));
  std::optional<RingBound> before;
  for (std::uint64_t k = 1;; ++k) {
    const ApproximateMacaulay macaulay(f, x, error, k);
    if (macaulay.is_too_large()) return before;
    RingBound ring{std::numeric_limits<std::uint64_t>::max(), false};
    for (const double unit : kUnits) {
      ring.dimension = std::min(ring.dimension, macaulay.bound(unit * size));
      ring.is_isolated = before && ring.dimension <= before->dimension;
      if (ring.is_isolated) return ring;
    }
    before = ring;
  }
}

}  // namespace moivre
