// SPDX-License-Identifier: MIT
// How are W complex numbers held and multiplied at once? One real number of every lane, and one
// imaginary.
//
// W: lanes of the target this file is compiled for. V: W doubles, a vector. R: a real number of
// every lane in the precision that paths are followed in, V itself here; the kernels take it as
// their parameter. In memory (LaneCell) a complex number of all lanes is the words of its real
// parts, W doubles each, and then those of its imaginary ones.
// Sizes, weights and steps are V whatever R is. Lane-wise throughout: nothing crosses lanes, so a
// NaN stays in its own.
// Compiled once a target (Highway's foreach_target): no include guard in the usual sense.
// Not supported: targets whose vectors have no fixed size.
#if defined(MOIVRE_LANE_COMPLEX_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef MOIVRE_LANE_COMPLEX_INL_H_
#undef MOIVRE_LANE_COMPLEX_INL_H_
#else
#define MOIVRE_LANE_COMPLEX_INL_H_
#endif

#include <hwy/highway.h>

#include <vector>

#include "moivre/numeric/complex.h"

HWY_BEFORE_NAMESPACE();
namespace moivre {
namespace HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

using Tag = hn::ScalableTag<double>;
inline constexpr std::size_t W = hn::MaxLanes(Tag());

/// W real numbers, and W claims. Highway writes + - * / and comparisons as operators, but no minus
/// sign alone.
using V = hn::Vec<Tag>;
using Mask = hn::Mask<Tag>;

HWY_INLINE V zeros() { return hn::Zero(Tag()); }
HWY_INLINE V broadcast(double a) { return hn::Set(Tag(), a); }
HWY_INLINE V load_real(const double* p) { return hn::Load(Tag(), p); }
HWY_INLINE void store_real(V a, double* p) { hn::Store(a, Tag(), p); }
HWY_INLINE V operator-(V a) { return hn::Neg(a); }
/// a b + c and c - a b, rounded once where the machine can.
HWY_INLINE V multiply_add(V a, V b, V c) { return hn::MulAdd(a, b, c); }
HWY_INLINE V subtract_multiply(V a, V b, V c) { return hn::NegMulAdd(a, b, c); }
HWY_INLINE V larger(V a, V b) { return hn::Max(a, b); }
HWY_INLINE V smaller(V a, V b) { return hn::Min(a, b); }
HWY_INLINE V square_root(V a) { return hn::Sqrt(a); }
HWY_INLINE bool is_nowhere(Mask mask) { return hn::AllFalse(Tag(), mask); }
HWY_INLINE bool is_everywhere(Mask mask) { return hn::AllTrue(Tag(), mask); }
HWY_INLINE V select(Mask mask, V yes, V no) { return hn::IfThenElse(mask, yes, no); }

/// W real numbers in memory.
struct LaneReals {
  HWY_ALIGN double at[W] = {};
  V value() const { return load_real(at); }
};

/// What the kernels need to know of R: doubles a real number, what one lane holds, and how doubles
/// and what a lane holds become an R.
template <class R>
struct LaneScalar;

template <>
struct LaneScalar<V> {
  static constexpr std::size_t kWords = 1;
  using Real = double;
  using Number = Complex;
  static HWY_INLINE V widen(V a) { return a; }
  static HWY_INLINE V spread(double a) { return broadcast(a); }
};

/// A real number, rounded to double.
HWY_INLINE V rounded(V a) { return a; }

/// W complex numbers in registers.
template <class R>
struct LaneComplex {
  R re, im;
};

/// W complex numbers in memory.
template <class R>
struct LaneCell {
  static constexpr std::size_t kWords = LaneScalar<R>::kWords;
  HWY_ALIGN double at[2 * kWords][W];
};

HWY_INLINE LaneComplex<V> load(const LaneCell<V>& cell) {
  return {load_real(cell.at[0]), load_real(cell.at[1])};
}
HWY_INLINE void store(const LaneComplex<V>& a, LaneCell<V>& cell) {
  store_real(a.re, cell.at[0]);
  store_real(a.im, cell.at[1]);
}
/// One lane's number.
inline void put(const Complex& value, std::size_t lane, LaneCell<V>& cell) {
  cell.at[0][lane] = value.real();
  cell.at[1][lane] = value.imag();
}
inline Complex take(const LaneCell<V>& cell, std::size_t lane) {
  return {cell.at[0][lane], cell.at[1][lane]};
}
template <class R>
HWY_INLINE LaneComplex<R> zero() {
  return {LaneScalar<R>::widen(zeros()), LaneScalar<R>::widen(zeros())};
}
template <class R>
HWY_INLINE LaneComplex<R> one() {
  return {LaneScalar<R>::widen(broadcast(1.0)), LaneScalar<R>::widen(zeros())};
}
template <class R>
HWY_INLINE LaneComplex<R> operator+(const LaneComplex<R>& a, const LaneComplex<R>& b) {
  return {a.re + b.re, a.im + b.im};
}
template <class R>
HWY_INLINE LaneComplex<R> operator-(const LaneComplex<R>& a, const LaneComplex<R>& b) {
  return {a.re - b.re, a.im - b.im};
}
template <class R>
HWY_INLINE LaneComplex<R> operator-(const LaneComplex<R>& a) {
  return {-a.re, -a.im};
}
template <class R>
HWY_INLINE LaneComplex<R> conj(const LaneComplex<R>& a) {
  return {a.re, -a.im};
}
template <class R>
HWY_INLINE LaneComplex<R> select(Mask mask, const LaneComplex<R>& yes, const LaneComplex<R>& no) {
  return {select(mask, yes.re, no.re), select(mask, yes.im, no.im)};
}

HWY_INLINE LaneComplex<V> operator*(const LaneComplex<V>& a, const LaneComplex<V>& b) {
  return {subtract_multiply(a.im, b.im, a.re * b.re), multiply_add(a.im, b.re, a.re * b.im)};
}
HWY_INLINE LaneComplex<V> operator*(V a, const LaneComplex<V>& b) { return {a * b.re, a * b.im}; }
/// sum + a b.
HWY_INLINE LaneComplex<V> add_product(const LaneComplex<V>& a, const LaneComplex<V>& b,
                                      const LaneComplex<V>& sum) {
  return {subtract_multiply(a.im, b.im, multiply_add(a.re, b.re, sum.re)),
          multiply_add(a.im, b.re, multiply_add(a.re, b.im, sum.im))};
}
HWY_INLINE LaneComplex<V> add_product(V a, const LaneComplex<V>& b, const LaneComplex<V>& sum) {
  return {multiply_add(a, b.re, sum.re), multiply_add(a, b.im, sum.im)};
}
/// sum - a b.
HWY_INLINE LaneComplex<V> subtract_product(const LaneComplex<V>& a, const LaneComplex<V>& b,
                                           const LaneComplex<V>& sum) {
  return {multiply_add(a.im, b.im, subtract_multiply(a.re, b.re, sum.re)),
          subtract_multiply(a.im, b.re, subtract_multiply(a.re, b.im, sum.im))};
}
HWY_INLINE V squared_magnitude(const LaneComplex<V>& a) {
  return multiply_add(a.re, a.re, a.im * a.im);
}
/// 1/a without scaling: overflows where |a|^2 does.
HWY_INLINE LaneComplex<V> reciprocal(const LaneComplex<V>& a) {
  const V scale = broadcast(1.0) / squared_magnitude(a);
  return {a.re * scale, -a.im * scale};
}

/// n complex numbers of every lane, in memory.
template <class R>
class LaneVector {
 public:
  using Number = typename LaneScalar<R>::Number;

  explicit LaneVector(std::size_t n) : data_(n) {}
  LaneCell<R>& operator[](std::size_t i) { return data_[i]; }
  const LaneCell<R>& operator[](std::size_t i) const { return data_[i]; }

  void set(std::size_t i, std::size_t lane, const Number& value) { put(value, lane, data_[i]); }
  Number get(std::size_t i, std::size_t lane) const { return take(data_[i], lane); }

 private:
  std::vector<LaneCell<R>> data_;  // cells are aligned as their type says
};

}  // namespace HWY_NAMESPACE
}  // namespace moivre
HWY_AFTER_NAMESPACE();

#endif
