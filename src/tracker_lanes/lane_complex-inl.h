// SPDX-License-Identifier: MIT
// How are W complex numbers held and multiplied at once? One vector of real and one of imaginary parts.
//
// W: lanes of the target this file is compiled for. A complex number of all lanes lies in memory as W real parts
// followed by W imaginary parts. Lane-wise throughout: nothing crosses lanes, so a NaN stays in its own.
// Compiled once a target (Highway's foreach_target): no include guard in the usual sense.
// Not supported: targets whose vectors have no fixed size.
#if defined(MOIVRE_LANE_COMPLEX_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef MOIVRE_LANE_COMPLEX_INL_H_
#undef MOIVRE_LANE_COMPLEX_INL_H_
#else
#define MOIVRE_LANE_COMPLEX_INL_H_
#endif

#include <hwy/aligned_allocator.h>
#include <hwy/highway.h>

#include "moivre/numeric/complex.h"

HWY_BEFORE_NAMESPACE();
namespace moivre {
namespace HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

using Tag = hn::ScalableTag<double>;
inline constexpr std::size_t W = hn::MaxLanes(Tag());

/// W real numbers, and W claims. Highway writes + - * / and comparisons as operators, but no minus sign alone.
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
HWY_INLINE V square_root(V a) { return hn::Sqrt(a); }
HWY_INLINE bool is_nowhere(Mask mask) { return hn::AllFalse(Tag(), mask); }
HWY_INLINE V select(Mask mask, V yes, V no) { return hn::IfThenElse(mask, yes, no); }

/// W complex numbers in registers.
struct LaneComplex {
  V re, im;
};

HWY_INLINE LaneComplex load(const double* p) { return {load_real(p), load_real(p + W)}; }
HWY_INLINE void store(const LaneComplex& a, double* p) {
  store_real(a.re, p);
  store_real(a.im, p + W);
}
HWY_INLINE LaneComplex zero() { return {zeros(), zeros()}; }
HWY_INLINE LaneComplex operator+(const LaneComplex& a, const LaneComplex& b) {
  return {a.re + b.re, a.im + b.im};
}
HWY_INLINE LaneComplex operator-(const LaneComplex& a, const LaneComplex& b) {
  return {a.re - b.re, a.im - b.im};
}
HWY_INLINE LaneComplex operator-(const LaneComplex& a) { return {-a.re, -a.im}; }
HWY_INLINE LaneComplex operator*(const LaneComplex& a, const LaneComplex& b) {
  return {subtract_multiply(a.im, b.im, a.re * b.re), multiply_add(a.im, b.re, a.re * b.im)};
}
HWY_INLINE LaneComplex operator*(V a, const LaneComplex& b) { return {a * b.re, a * b.im}; }
/// sum + a b.
HWY_INLINE LaneComplex add_product(const LaneComplex& a, const LaneComplex& b,
                                   const LaneComplex& sum) {
  return {subtract_multiply(a.im, b.im, multiply_add(a.re, b.re, sum.re)),
          multiply_add(a.im, b.re, multiply_add(a.re, b.im, sum.im))};
}
HWY_INLINE LaneComplex add_product(V a, const LaneComplex& b, const LaneComplex& sum) {
  return {multiply_add(a, b.re, sum.re), multiply_add(a, b.im, sum.im)};
}
/// sum - a b.
HWY_INLINE LaneComplex subtract_product(const LaneComplex& a, const LaneComplex& b,
                                        const LaneComplex& sum) {
  return {multiply_add(a.im, b.im, subtract_multiply(a.re, b.re, sum.re)),
          subtract_multiply(a.im, b.re, subtract_multiply(a.re, b.im, sum.im))};
}
HWY_INLINE LaneComplex conj(const LaneComplex& a) { return {a.re, -a.im}; }
HWY_INLINE V squared_magnitude(const LaneComplex& a) {
  return multiply_add(a.re, a.re, a.im * a.im);
}
/// 1/a without scaling: overflows where |a|^2 does.
HWY_INLINE LaneComplex reciprocal(const LaneComplex& a) {
  const V scale = broadcast(1.0) / squared_magnitude(a);
  return {a.re * scale, -a.im * scale};
}
HWY_INLINE LaneComplex select(Mask mask, const LaneComplex& yes, const LaneComplex& no) {
  return {select(mask, yes.re, no.re), select(mask, yes.im, no.im)};
}

/// n complex numbers of every lane, in memory.
class LaneVector {
 public:
  explicit LaneVector(std::size_t n) : data_(hwy::AllocateAligned<double>(2 * W * n)) {
    std::fill_n(data_.get(), 2 * W * n, 0.0);
  }
  double* operator[](std::size_t i) { return data_.get() + 2 * W * i; }
  const double* operator[](std::size_t i) const { return data_.get() + 2 * W * i; }

  double* data() { return data_.get(); }
  const double* data() const { return data_.get(); }

  void set(std::size_t i, std::size_t lane, Complex value) {
    (*this)[i][lane] = value.real();
    (*this)[i][lane + W] = value.imag();
  }
  Complex get(std::size_t i, std::size_t lane) const {
    return {(*this)[i][lane], (*this)[i][lane + W]};
  }

 private:
  hwy::AlignedFreeUniquePtr<double[]> data_;
};

}  // namespace HWY_NAMESPACE
}  // namespace moivre
HWY_AFTER_NAMESPACE();

#endif
