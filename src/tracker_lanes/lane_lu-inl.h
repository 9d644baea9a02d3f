// SPDX-License-Identifier: MIT
// How are W linear systems solved at once? Gaussian elimination with pivoting in every lane by
// itself, rows exchanged by selection, without a branch on any lane's numbers but one: an exchange
// that no lane wants is skipped.
//
//   P J = L U in each lane; J: n x n, with two right-hand sides as further columns, so that
//   elimination and exchanges carry them along and only the back substitution is left.
//   Pivot: the row at hand unless another is larger by 1/kPivotThreshold; growth stays bounded by
//   (1 + 1/kPivotThreshold)^(n-1), and lanes rarely exchange rows.
//   Elimination goes row by row of what is left; substitution takes inner products, two rows and
//   two right-hand sides at once, so that four sums in registers hide the multiply-add's latency.
//
// Singular or not finite: the lane's solutions are infinite or NaN, other lanes are untouched.
// Source: [Higham02, ch. 9].
#if defined(MOIVRE_LANE_LU_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef MOIVRE_LANE_LU_INL_H_
#undef MOIVRE_LANE_LU_INL_H_
#else
#define MOIVRE_LANE_LU_INL_H_
#endif

#include <algorithm>
#include <limits>
#include <vector>

#include "lane_complex-inl.h"

HWY_BEFORE_NAMESPACE();
namespace moivre {
namespace HWY_NAMESPACE {

/// |pivot| over the column's largest: below it rows are exchanged.
inline constexpr double kPivotThreshold = 0.1;

template <class R>
class LaneLu {
 public:
  explicit LaneLu(std::size_t n)
      : n_(n), columns_(n + 2), a_(n * columns_), reciprocal_(n), masks_(n * n) {
    exchanges_.reserve(n * n / 2 + 1);
  }

  /// Entry (i, j) of J; columns n and n + 1 are the appended right-hand sides.
  LaneCell<R>& at(std::size_t i, std::size_t j) { return a_[i * columns_ + j]; }

  void factor() {
    exchanges_.clear();
    V least = broadcast(std::numeric_limits<double>::max());
    for (std::size_t k = 0; k < n_; ++k) {
      exchange_rows(k);
      least = smaller(squared_magnitude(load(at(k, k))), least);
      const LaneComplex<R> inverse = reciprocal(load(at(k, k)));
      store(inverse, reciprocal_[k]);
      eliminate_below(k, inverse);
    }
    store_real(least, least_squared_pivot_.at);
  }

  /// Of the last factor(), in each lane; where it underflows the solutions are lost.
  V least_squared_pivot() const { return least_squared_pivot_.value(); }

  /// x, y <- J^{-1} b for the two appended right-hand sides.
  void solve_appended(LaneVector<R>& x, LaneVector<R>& y) {
    for (std::size_t k = 0; k < n_; ++k) {
      store(load(at(k, n_)), x[k]);
      store(load(at(k, n_ + 1)), y[k]);
    }
    substitute_back(x, y);
  }

  /// b <- J^{-1} b and c <- J^{-1} c.
  void solve(LaneVector<R>& b, LaneVector<R>& c) {
    for (const Exchange& e : exchanges_) {
      exchange(e, b);
      exchange(e, c);
    }
    substitute_forward(b, c);
    substitute_back(b, c);
  }

 private:
  struct Exchange {
    std::uint32_t upper, lower, mask;
  };

  // Rows with a zero in all lanes, as most are where J is sparse, have nothing to be taken from.
  void eliminate_below(std::size_t k, const LaneComplex<R>& inverse) {
    std::size_t waiting = n_;
    for (std::size_t i = k + 1; i < n_; ++i) {
      if (is_everywhere(squared_magnitude(load(at(i, k))) == zeros())) continue;
      if (waiting == n_) {
        waiting = i;
      } else {
        eliminate_two(k, waiting, i, inverse);
        waiting = n_;
      }
    }
    if (waiting < n_) eliminate(k, waiting, inverse);
  }

  // Takes row k's multiple from row i; two rows at once read row k once.
  void eliminate(std::size_t k, std::size_t i, const LaneComplex<R>& inverse) {
    const LaneComplex<R> l = load(at(i, k)) * inverse;
    store(l, at(i, k));
    const LaneCell<R>* u = &at(k, k + 1);
    LaneCell<R>* row = &at(i, k + 1);
    for (std::size_t j = k + 1; j < columns_; ++j, ++u, ++row) {
      store(subtract_product(l, load(*u), load(*row)), *row);
    }
  }
  void eliminate_two(std::size_t k, std::size_t i0, std::size_t i1, const LaneComplex<R>& inverse) {
    const LaneComplex<R> l0 = load(at(i0, k)) * inverse;
    const LaneComplex<R> l1 = load(at(i1, k)) * inverse;
    store(l0, at(i0, k));
    store(l1, at(i1, k));
    const LaneCell<R>* u = &at(k, k + 1);
    LaneCell<R>* row0 = &at(i0, k + 1);
    LaneCell<R>* row1 = &at(i1, k + 1);
    for (std::size_t j = k + 1; j < columns_; ++j, ++u, ++row0, ++row1) {
      const LaneComplex<R> uj = load(*u);
      store(subtract_product(l0, uj, load(*row0)), *row0);
      store(subtract_product(l1, uj, load(*row1)), *row1);
    }
  }

  void exchange_rows(std::size_t k) {
    const V own = squared_magnitude(load(at(k, k)));
    V largest = own;
    for (std::size_t i = k + 1; i < n_; ++i) {
      largest = larger(squared_magnitude(load(at(i, k))), largest);
    }
    Mask wanted = largest * broadcast(kPivotThreshold * kPivotThreshold) > own;
    for (std::size_t i = k + 1; i < n_ && !is_nowhere(wanted); ++i) {
      const Mask here = hn::And(wanted, squared_magnitude(load(at(i, k))) == largest);
      if (is_nowhere(here)) continue;
      wanted = hn::AndNot(here, wanted);
      exchange(k, i, here);
    }
  }

  void exchange(std::size_t k, std::size_t i, Mask mask) {
    const auto slot = static_cast<std::uint32_t>(exchanges_.size());
    exchanges_.push_back({static_cast<std::uint32_t>(k), static_cast<std::uint32_t>(i), slot});
    store_real(select(mask, broadcast(1.0), zeros()), masks_[slot].at[0]);
    LaneCell<R>* upper = &at(k, 0);
    LaneCell<R>* lower = &at(i, 0);
    for (std::size_t j = 0; j < columns_; ++j, ++upper, ++lower) {
      const LaneComplex<R> a = load(*upper);
      const LaneComplex<R> b = load(*lower);
      store(select(mask, b, a), *upper);
      store(select(mask, a, b), *lower);
    }
  }

  void exchange(const Exchange& e, LaneVector<R>& b) const {
    const Mask mask = load_real(masks_[e.mask].at[0]) > zeros();
    const LaneComplex<R> upper = load(b[e.upper]);
    const LaneComplex<R> lower = load(b[e.lower]);
    store(select(mask, lower, upper), b[e.upper]);
    store(select(mask, upper, lower), b[e.lower]);
  }

  struct Sums {
    LaneComplex<R> b0, b1, c0, c1;  // of the rows 0 and 1
  };
  HWY_INLINE Sums begin_rows(std::size_t i0, std::size_t i1, const LaneVector<R>& b,
                             const LaneVector<R>& c) const {
    return {load(b[i0]), load(b[i1]), load(c[i0]), load(c[i1])};
  }
  HWY_INLINE void subtract_column(std::size_t i0, std::size_t i1, std::size_t j,
                                  const LaneVector<R>& b, const LaneVector<R>& c,
                                  Sums& sums) const {
    const LaneComplex<R> bj = load(b[j]);
    const LaneComplex<R> cj = load(c[j]);
    const LaneComplex<R> a0 = load(a_[i0 * columns_ + j]);
    const LaneComplex<R> a1 = load(a_[i1 * columns_ + j]);
    sums.b0 = subtract_product(a0, bj, sums.b0);
    sums.b1 = subtract_product(a1, bj, sums.b1);
    sums.c0 = subtract_product(a0, cj, sums.c0);
    sums.c1 = subtract_product(a1, cj, sums.c1);
  }

  void substitute_forward(LaneVector<R>& b, LaneVector<R>& c) const {
    for (std::size_t i = 0; i < n_; i += 2) {
      const std::size_t next = std::min(i + 1, n_ - 1);  // the last row twice where n is odd
      Sums sums = begin_rows(i, next, b, c);
      for (std::size_t j = 0; j < i; ++j) subtract_column(i, next, j, b, c, sums);
      store(sums.b0, b[i]);
      store(sums.c0, c[i]);
      if (next == i) return;
      const LaneComplex<R> l = load(a_[next * columns_ + i]);
      store(subtract_product(l, sums.b0, sums.b1), b[next]);
      store(subtract_product(l, sums.c0, sums.c1), c[next]);
    }
  }

  void substitute_back(LaneVector<R>& b, LaneVector<R>& c) const {
    for (std::size_t k = n_; k > 0; k -= std::min<std::size_t>(k, 2)) {
      const std::size_t i = k - 1;
      const std::size_t above = i == 0 ? 0 : i - 1;  // the first row twice where n is odd
      Sums sums = begin_rows(i, above, b, c);
      for (std::size_t j = n_; --j > i;) subtract_column(i, above, j, b, c, sums);
      const LaneComplex<R> inverse = load(reciprocal_[i]);
      const LaneComplex<R> bi = sums.b0 * inverse;
      const LaneComplex<R> ci = sums.c0 * inverse;
      store(bi, b[i]);
      store(ci, c[i]);
      if (above == i) return;
      const LaneComplex<R> u = load(a_[above * columns_ + i]);
      const LaneComplex<R> inverse_above = load(reciprocal_[above]);
      store(subtract_product(u, bi, sums.b1) * inverse_above, b[above]);
      store(subtract_product(u, ci, sums.c1) * inverse_above, c[above]);
    }
  }

  std::size_t n_;
  std::size_t columns_;
  LaneVector<R> a_;           // n x (n + 2), L below the diagonal (unit), U on and above
  LaneVector<R> reciprocal_;  // 1/U_kk
  LaneReals least_squared_pivot_;
  LaneVector<V> masks_;              // of the exchanges made
  std::vector<Exchange> exchanges_;  // in their order
};

}  // namespace HWY_NAMESPACE
}  // namespace moivre
HWY_AFTER_NAMESPACE();

#endif
