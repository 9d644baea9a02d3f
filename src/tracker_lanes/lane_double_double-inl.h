// SPDX-License-Identifier: MIT
// How do W paths have twice the digits of double? Sums hi + lo of two vectors, by error-free
// transformations in every lane.
//
//   two_sum       a + b = s + e exactly;  two_product  a b = p + e exactly, e by a fused
//                                         multiply-subtraction, or by
//                 Dekker's splitting where the machine has none (|a|, |b| < 2^995 then)
//   + - * /       of reals as in numeric/double_double.h: relative errors 2^-102 and less, of a
//                 quotient 2^-100
//   complex       products and sums of products normalize once: errors 2^-100 of the sum of the
//                 terms' magnitudes, as a scalar product in any floating arithmetic, and not of the
//                 result where terms cancel
//
// A product that goes into a sum is rounded by itself first, and nothing here depends on how a
// compiler contracts: each product is an operand of a fused operation. Sizes (squared_magnitude)
// are rounded to double.
// Sources: [Dekker71], [Knuth98].
#if defined(MOIVRE_LANE_DOUBLE_DOUBLE_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef MOIVRE_LANE_DOUBLE_DOUBLE_INL_H_
#undef MOIVRE_LANE_DOUBLE_DOUBLE_INL_H_
#else
#define MOIVRE_LANE_DOUBLE_DOUBLE_INL_H_
#endif

#include "lane_complex-inl.h"
#include "moivre/numeric/double_double.h"

HWY_BEFORE_NAMESPACE();
namespace moivre {
namespace HWY_NAMESPACE {

/// W double-doubles hi + lo.
struct LaneDoubleDouble {
  V hi, lo;
};

template <>
struct LaneScalar<LaneDoubleDouble> {
  static constexpr std::size_t kWords = 2;
  using Real = DoubleDouble;
  using Number = ComplexDoubleDouble;
  static HWY_INLINE LaneDoubleDouble widen(V a) { return {a, zeros()}; }
  static HWY_INLINE LaneDoubleDouble spread(const DoubleDouble& a) {
    return {broadcast(a.hi), broadcast(a.lo)};
  }
};

HWY_INLINE V rounded(const LaneDoubleDouble& a) { return a.hi; }

HWY_INLINE LaneDoubleDouble two_sum(V a, V b) {
  const V sum = a + b;
  const V part = sum - a;
  return {sum, (a - (sum - part)) + (b - part)};
}
/// As two_sum, for |a| >= |b|.
HWY_INLINE LaneDoubleDouble quick_two_sum(V a, V b) {
  const V sum = a + b;
  return {sum, b - (sum - a)};
}

#if HWY_NATIVE_FMA
/// a b rounded, in a form that no compiler fuses with the sum that it goes into.
HWY_INLINE V rounded_product(V a, V b) { return hn::MulAdd(a, b, zeros()); }
/// a b - p, for p = rounded_product(a, b): exact.
HWY_INLINE V product_error(V a, V b, V p) { return hn::MulSub(a, b, p); }
#else
HWY_INLINE V rounded_product(V a, V b) { return a * b; }
HWY_INLINE LaneDoubleDouble halves(V a) {
  constexpr double kSplitter = 134217729;  // 2^27 + 1: two factors of 26 bits
  const V scaled = broadcast(kSplitter) * a;
  const V high = scaled - (scaled - a);
  return {high, a - high};
}
HWY_INLINE V product_error(V a, V b, V p) {
  const LaneDoubleDouble x = halves(a);
  const LaneDoubleDouble y = halves(b);
  return ((x.hi * y.hi - p) + x.hi * y.lo + x.lo * y.hi) + x.lo * y.lo;
}
#endif

HWY_INLINE LaneDoubleDouble two_product(V a, V b) {
  const V p = rounded_product(a, b);
  return {p, product_error(a, b, p)};
}

HWY_INLINE LaneDoubleDouble operator-(const LaneDoubleDouble& a) { return {-a.hi, -a.lo}; }
HWY_INLINE LaneDoubleDouble operator+(const LaneDoubleDouble& a, const LaneDoubleDouble& b) {
  LaneDoubleDouble s = two_sum(a.hi, b.hi);
  const LaneDoubleDouble t = two_sum(a.lo, b.lo);
  s = quick_two_sum(s.hi, s.lo + t.hi);
  return quick_two_sum(s.hi, s.lo + t.lo);
}
HWY_INLINE LaneDoubleDouble operator-(const LaneDoubleDouble& a, const LaneDoubleDouble& b) {
  return a + (-b);
}
HWY_INLINE LaneDoubleDouble operator*(const LaneDoubleDouble& a, const LaneDoubleDouble& b) {
  const LaneDoubleDouble p = two_product(a.hi, b.hi);
  return quick_two_sum(p.hi, multiply_add(a.lo, b.hi, multiply_add(a.hi, b.lo, p.lo)));
}
HWY_INLINE LaneDoubleDouble operator*(V a, const LaneDoubleDouble& b) {
  const LaneDoubleDouble p = two_product(a, b.hi);
  return quick_two_sum(p.hi, multiply_add(a, b.lo, p.lo));
}
/// By long division, three digits of double each.
HWY_INLINE LaneDoubleDouble operator/(const LaneDoubleDouble& a, const LaneDoubleDouble& b) {
  const V first = a.hi / b.hi;
  const LaneDoubleDouble rest = a - first * b;
  const V second = rest.hi / b.hi;
  const V third = (rest - second * b).hi / b.hi;
  return quick_two_sum(first, second) + LaneDoubleDouble{third, zeros()};
}
HWY_INLINE LaneDoubleDouble select(Mask mask, const LaneDoubleDouble& yes,
                                   const LaneDoubleDouble& no) {
  return {select(mask, yes.hi, no.hi), select(mask, yes.lo, no.lo)};
}

using FineComplex = LaneComplex<LaneDoubleDouble>;

HWY_INLINE FineComplex load(const LaneCell<LaneDoubleDouble>& cell) {
  return {{load_real(cell.at[0]), load_real(cell.at[1])},
          {load_real(cell.at[2]), load_real(cell.at[3])}};
}
HWY_INLINE void store(const FineComplex& a, LaneCell<LaneDoubleDouble>& cell) {
  store_real(a.re.hi, cell.at[0]);
  store_real(a.re.lo, cell.at[1]);
  store_real(a.im.hi, cell.at[2]);
  store_real(a.im.lo, cell.at[3]);
}
inline void put(const ComplexDoubleDouble& value, std::size_t lane,
                LaneCell<LaneDoubleDouble>& cell) {
  cell.at[0][lane] = value.re.hi;
  cell.at[1][lane] = value.re.lo;
  cell.at[2][lane] = value.im.hi;
  cell.at[3][lane] = value.im.lo;
}
inline ComplexDoubleDouble take(const LaneCell<LaneDoubleDouble>& cell, std::size_t lane) {
  return {{cell.at[0][lane], cell.at[1][lane]}, {cell.at[2][lane], cell.at[3][lane]}};
}

/// sum + a b + c d, the errors gathered and added once.
HWY_INLINE LaneDoubleDouble add_products(const LaneDoubleDouble& a, const LaneDoubleDouble& b,
                                         const LaneDoubleDouble& c, const LaneDoubleDouble& d,
                                         const LaneDoubleDouble& sum) {
  const LaneDoubleDouble p = two_product(a.hi, b.hi);
  const LaneDoubleDouble q = two_product(c.hi, d.hi);
  const LaneDoubleDouble pq = two_sum(p.hi, q.hi);
  const LaneDoubleDouble all = two_sum(sum.hi, pq.hi);
  const V left = multiply_add(a.lo, b.hi, multiply_add(a.hi, b.lo, p.lo));
  const V right = multiply_add(c.lo, d.hi, multiply_add(c.hi, d.lo, q.lo));
  return quick_two_sum(all.hi, (left + right) + (all.lo + (pq.lo + sum.lo)));
}
/// a b + c d.
HWY_INLINE LaneDoubleDouble sum_of_products(const LaneDoubleDouble& a, const LaneDoubleDouble& b,
                                            const LaneDoubleDouble& c, const LaneDoubleDouble& d) {
  const LaneDoubleDouble p = two_product(a.hi, b.hi);
  const LaneDoubleDouble q = two_product(c.hi, d.hi);
  const LaneDoubleDouble pq = two_sum(p.hi, q.hi);
  const V left = multiply_add(a.lo, b.hi, multiply_add(a.hi, b.lo, p.lo));
  const V right = multiply_add(c.lo, d.hi, multiply_add(c.hi, d.lo, q.lo));
  return quick_two_sum(pq.hi, (left + right) + pq.lo);
}
/// sum + a b, of one real factor.
HWY_INLINE LaneDoubleDouble add_product(const LaneDoubleDouble& a, const LaneDoubleDouble& b,
                                        const LaneDoubleDouble& sum) {
  const LaneDoubleDouble p = two_product(a.hi, b.hi);
  const LaneDoubleDouble all = two_sum(sum.hi, p.hi);
  const V low = multiply_add(a.lo, b.hi, multiply_add(a.hi, b.lo, p.lo));
  return quick_two_sum(all.hi, low + (all.lo + sum.lo));
}

HWY_INLINE FineComplex operator*(const FineComplex& a, const FineComplex& b) {
  return {sum_of_products(a.re, b.re, -a.im, b.im), sum_of_products(a.re, b.im, a.im, b.re)};
}
HWY_INLINE FineComplex operator*(V a, const FineComplex& b) { return {a * b.re, a * b.im}; }
HWY_INLINE FineComplex add_product(const FineComplex& a, const FineComplex& b,
                                   const FineComplex& sum) {
  return {add_products(a.re, b.re, -a.im, b.im, sum.re),
          add_products(a.re, b.im, a.im, b.re, sum.im)};
}
HWY_INLINE FineComplex add_product(const LaneDoubleDouble& a, const FineComplex& b,
                                   const FineComplex& sum) {
  return {add_product(a, b.re, sum.re), add_product(a, b.im, sum.im)};
}
HWY_INLINE FineComplex add_product(V a, const FineComplex& b, const FineComplex& sum) {
  return add_product(LaneDoubleDouble{a, zeros()}, b, sum);
}
HWY_INLINE FineComplex subtract_product(const FineComplex& a, const FineComplex& b,
                                        const FineComplex& sum) {
  return add_product(-a, b, sum);
}
HWY_INLINE V squared_magnitude(const FineComplex& a) {
  return multiply_add(a.re.hi, a.re.hi, a.im.hi * a.im.hi);
}
/// 1/a without scaling: overflows where |a|^2 does.
HWY_INLINE FineComplex reciprocal(const FineComplex& a) {
  const LaneDoubleDouble size = sum_of_products(a.re, a.re, a.im, a.im);
  return {a.re / size, -a.im / size};
}

}  // namespace HWY_NAMESPACE
}  // namespace moivre
HWY_AFTER_NAMESPACE();

#endif
