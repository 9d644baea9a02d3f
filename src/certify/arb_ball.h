// SPDX-License-Identifier: MIT
// How are Arb's complex balls a scalar of tapes? A value that owns its acb_t and knows its precision.
//
// A ball is a rectangle here, two real balls; Arb rounds outward by itself [Johansson17]. A result has the higher precision
// of its operands; S(double) is exact and brings none. Memory is FLINT's, which keeps some for each thread.
#pragma once

#include <algorithm>
#include <utility>

#include "arb_library.h"

namespace moivre {

class ArbBall {
 public:
  ArbBall() { arb().acb_init(value_); }
  explicit ArbBall(double value) : ArbBall() { arb().acb_set_d(value_, value); }
  ArbBall(const ArbBall& other) : bits_(other.bits_) {
    arb().acb_init(value_);
    arb().acb_set(value_, other.value_);
  }
  ArbBall(ArbBall&& other) noexcept : ArbBall() { swap(other); }
  ArbBall& operator=(ArbBall other) noexcept {
    swap(other);
    return *this;
  }
  ~ArbBall() { arb().acb_clear(value_); }

  acb_ptr get() { return value_; }
  acb_srcptr get() const { return value_; }
  slong bits() const { return bits_; }
  void set_bits(slong bits) { bits_ = bits; }

  ArbBall& operator+=(const ArbBall& other) {
    bits_ = std::max(bits_, other.bits_);
    arb().acb_add(value_, value_, other.value_, std::max(bits_, kLeastBits));
    return *this;
  }

 private:
  static constexpr slong kLeastBits = 53;

  void swap(ArbBall& other) noexcept {
    arb().acb_swap(value_, other.value_);
    std::swap(bits_, other.bits_);
  }

  friend ArbBall product(const ArbBall& a, const ArbBall& b) {
    ArbBall result;
    result.bits_ = std::max(a.bits_, b.bits_);
    arb().acb_mul(result.value_, a.value_, b.value_, std::max(result.bits_, kLeastBits));
    return result;
  }

  acb_t value_;
  slong bits_ = 0;
};

/// An upper bound on a modulus, as FLINT keeps it.
class ArbSize {
 public:
  ArbSize() { arb().mag_init(value_); }
  /// At least `value`, which must not be negative.
  explicit ArbSize(double value) : ArbSize() { arb().mag_set_d(value_, value); }
  ArbSize(const ArbSize&) = delete;
  ArbSize& operator=(const ArbSize&) = delete;
  ~ArbSize() { arb().mag_clear(value_); }

  mag_ptr get() { return value_; }
  mag_srcptr get() const { return value_; }

  /// At least this; infinity where no double is.
  double upper() const {
    // mag_get_d gives 0 below this size.
    constexpr double kSmallest = 0x1p-999;
    const double value = arb().mag_get_d(value_);
    return value == 0 && !arb().mag_is_zero(value_) ? kSmallest : value;
  }

 private:
  mag_t value_;
};

}  // namespace moivre
