// SPDX-License-Identifier: MIT
// How are Arb's complex balls a scalar of tapes? A value that owns its acb_t and knows its
// precision.
//
// A ball is a rectangle here, two real balls; Arb rounds outward by itself [Johansson17]. A result
// has the higher precision of its operands; S(double) is exact and brings none. Memory is FLINT's,
// which keeps some for each thread.
#pragma once

// FLINT 3 has taken Arb in, and its headers.
#if __has_include(<flint/acb.h>)
#include <flint/acb.h>
#include <flint/acb_mat.h>
#else
#include <acb.h>
#include <acb_mat.h>
#endif
#include <flint/flint.h>
#include <flint/fmpz.h>

#include <algorithm>
#include <utility>

namespace moivre {

class ArbBall {
 public:
  ArbBall() { acb_init(value_); }
  explicit ArbBall(double value) : ArbBall() { acb_set_d(value_, value); }
  ArbBall(const ArbBall& other) : bits_(other.bits_) {
    acb_init(value_);
    acb_set(value_, other.value_);
  }
  ArbBall(ArbBall&& other) noexcept : ArbBall() { swap(other); }
  ArbBall& operator=(ArbBall other) noexcept {
    swap(other);
    return *this;
  }
  ~ArbBall() { acb_clear(value_); }

  acb_ptr get() { return value_; }
  acb_srcptr get() const { return value_; }
  slong bits() const { return bits_; }
  void set_bits(slong bits) { bits_ = bits; }

  ArbBall& operator+=(const ArbBall& other) {
    bits_ = std::max(bits_, other.bits_);
    acb_add(value_, value_, other.value_, std::max(bits_, kLeastBits));
    return *this;
  }

 private:
  static constexpr slong kLeastBits = 53;

  void swap(ArbBall& other) noexcept {
    acb_swap(value_, other.value_);
    std::swap(bits_, other.bits_);
  }

  friend ArbBall product(const ArbBall& a, const ArbBall& b) {
    ArbBall result;
    result.bits_ = std::max(a.bits_, b.bits_);
    acb_mul(result.value_, a.value_, b.value_, std::max(result.bits_, kLeastBits));
    return result;
  }

  acb_t value_;
  slong bits_ = 0;
};

/// An upper bound on a modulus, as FLINT keeps it.
class ArbSize {
 public:
  ArbSize() { mag_init(value_); }
  /// At least `value`, which must not be negative.
  explicit ArbSize(double value) : ArbSize() { mag_set_d(value_, value); }
  ArbSize(const ArbSize&) = delete;
  ArbSize& operator=(const ArbSize&) = delete;
  ~ArbSize() { mag_clear(value_); }

  mag_ptr get() { return value_; }
  mag_srcptr get() const { return value_; }

  /// At least this; infinity where no double is.
  double upper() const {
    // mag_get_d gives 0 below this size.
    constexpr double kSmallest = 0x1p-999;
    const double value = mag_get_d(value_);
    return value == 0 && !mag_is_zero(value_) ? kSmallest : value;
  }

 private:
  mag_t value_;
};

}  // namespace moivre
