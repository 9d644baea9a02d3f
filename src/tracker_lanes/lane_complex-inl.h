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
using V = hn::Vec<Tag>;
using Mask = hn::Mask<Tag>;
inline constexpr std::size_t W = hn::MaxLanes(Tag());

/// W complex numbers in registers.
struct LaneComplex {
  V re, im;
};

HWY_INLINE LaneComplex load(const double* p) {
  return {hn::Load(Tag(), p), hn::Load(Tag(), p + W)};
}
HWY_INLINE void store(const LaneComplex& a, double* p) {
  hn::Store(a.re, Tag(), p);
  hn::Store(a.im, Tag(), p + W);
}
HWY_INLINE LaneComplex zero() { return {hn::Zero(Tag()), hn::Zero(Tag())}; }
HWY_INLINE LaneComplex operator+(const LaneComplex& a, const LaneComplex& b) {
  return {hn::Add(a.re, b.re), hn::Add(a.im, b.im)};
}
HWY_INLINE LaneComplex operator-(const LaneComplex& a, const LaneComplex& b) {
  return {hn::Sub(a.re, b.re), hn::Sub(a.im, b.im)};
}
HWY_INLINE LaneComplex operator-(const LaneComplex& a) { return {hn::Neg(a.re), hn::Neg(a.im)}; }
HWY_INLINE LaneComplex operator*(const LaneComplex& a, const LaneComplex& b) {
  return {hn::NegMulAdd(a.im, b.im, hn::Mul(a.re, b.re)),
          hn::MulAdd(a.im, b.re, hn::Mul(a.re, b.im))};
}
HWY_INLINE LaneComplex operator*(V a, const LaneComplex& b) {
  return {hn::Mul(a, b.re), hn::Mul(a, b.im)};
}
/// sum + a b.
HWY_INLINE LaneComplex add_product(const LaneComplex& a, const LaneComplex& b,
                                   const LaneComplex& sum) {
  return {hn::NegMulAdd(a.im, b.im, hn::MulAdd(a.re, b.re, sum.re)),
          hn::MulAdd(a.im, b.re, hn::MulAdd(a.re, b.im, sum.im))};
}
HWY_INLINE LaneComplex add_product(V a, const LaneComplex& b, const LaneComplex& sum) {
  return {hn::MulAdd(a, b.re, sum.re), hn::MulAdd(a, b.im, sum.im)};
}
/// sum - a b.
HWY_INLINE LaneComplex subtract_product(const LaneComplex& a, const LaneComplex& b,
                                        const LaneComplex& sum) {
  return {hn::MulAdd(a.im, b.im, hn::NegMulAdd(a.re, b.re, sum.re)),
          hn::NegMulAdd(a.im, b.re, hn::NegMulAdd(a.re, b.im, sum.im))};
}
HWY_INLINE LaneComplex conj(const LaneComplex& a) { return {a.re, hn::Neg(a.im)}; }
HWY_INLINE V squared_magnitude(const LaneComplex& a) {
  return hn::MulAdd(a.re, a.re, hn::Mul(a.im, a.im));
}
/// 1/a without scaling: overflows where |a|^2 does.
HWY_INLINE LaneComplex reciprocal(const LaneComplex& a) {
  const V scale = hn::Div(hn::Set(Tag(), 1.0), squared_magnitude(a));
  return {hn::Mul(a.re, scale), hn::Mul(hn::Neg(a.im), scale)};
}
HWY_INLINE LaneComplex select(Mask mask, const LaneComplex& yes, const LaneComplex& no) {
  return {hn::IfThenElse(mask, yes.re, no.re), hn::IfThenElse(mask, yes.im, no.im)};
}

/// n complex numbers of every lane, in memory.
class LaneVector {
 public:
  explicit LaneVector(std::size_t n) : data_(hwy::AllocateAligned<double>(2 * W * n)) {
    std::fill_n(data_.get(), 2 * W * n, 0.0);
  }
  double* operator[](std::size_t i) { return data_.get() + 2 * W * i; }
  const double* operator[](std::size_t i) const { return data_.get() + 2 * W * i; }

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
