// SPDX-License-Identifier: MIT
// What are H, H_x and H_t at a point? The program of a homotopy, run in one scalar.
//
//   x: N, H and H_t: n, H_x: n x N
//
// Moving coefficients are evaluated anew only when t has changed.
#pragma once

#include <span>
#include <vector>

#include "moivre/homotopy/moving.h"

namespace moivre {

/// In the scalar S. Owns its memory, allocates nothing after construction; one per thread.
template <class S>
class HomotopyEvaluator {
 public:
  using Real = typename Scalar<S>::Real;
  using Program = HomotopyProgram<Real>;

  explicit HomotopyEvaluator(const Homotopy& homotopy)
      : program_(make_program<Real>(homotopy)),
        coefficients_(homotopy, program_),
        registers_(program_.register_count),
        weighted_(program_.weighted_count()) {}
  HomotopyEvaluator(const HomotopyEvaluator&) = delete;
  HomotopyEvaluator& operator=(const HomotopyEvaluator&) = delete;

  /// The frame of the path that is looked at, where the homotopy is framed; it has to stay where it
  /// is.
  void set_frame(const PathFrame* frame) {
    frame_ = frame;
    has_moved_ = false;
  }

  /// h <- H(x, t).
  void value(std::span<const S> x, const Time<S>& t, std::span<S> h) {
    move(t);
    run(x, program_.value_products);
    for (std::size_t i = 0; i < program_.values.size(); ++i) {
      const typename Program::Blend& value = program_.values[i];
      h[i] = blend(t, sum(value.f, registers_), sum(value.g, registers_)) + moving(value);
    }
  }

  /// h <- H, hx <- the n rows of H_x (row-major, N columns, so hx may be a taller matrix), ht <-
  /// H_t.
  void linearization(std::span<const S> x, const Time<S>& t, std::span<S> h, std::span<S> hx,
                     std::span<S> ht) {
    move(t);
    multiply();
    run(x, program_.products.size());
    for (std::size_t i = 0; i < program_.values.size(); ++i) {
      const typename Program::Blend& value = program_.values[i];
      const S f = sum(value.f, registers_);
      const S g = sum(value.g, registers_);
      h[i] = blend(t, f, g) + moving(value);
      ht[i] = (f - g) + moving_slope(value);
    }
    const std::size_t columns = program_.variables;
    for (const typename Program::Position& p : program_.zeros)
      hx[p.row * columns + p.column] = S(0.0);
    weigh(t);
    for (const typename Program::Entry& entry : program_.jacobian) {
      hx[entry.row * columns + entry.column] = this->entry(entry.blend, t);
    }
  }

 private:
  static S blend(const Time<S>& t, const S& f, const S& g) {
    return add_product(t.rest, g, product(t.t, f));
  }

  void move(const Time<S>& t) {
    if (program_.stands_still()) return;
    if (has_moved_ && t.t == moved_.t && t.rest == moved_.rest) return;
    coefficients_.move(t, frame_);
    moved_ = t;
    has_moved_ = true;
    has_multiples_ = false;
  }

  void multiply() {
    if (has_multiples_) return;
    coefficients_.multiply();
    has_multiples_ = true;
  }

  void run(std::span<const S> x, std::size_t products) {
    const std::size_t n = program_.variables;
    std::copy(x.begin(), x.end(), registers_.begin());
    registers_[n] = S(1.0);
    S* next = registers_.data() + n + 1;
    for (std::size_t k = 0; k < products; ++k) {
      const Tape::Product& p = program_.products[k];
      *next++ = product(registers_[p.a], registers_[p.b]);
    }
  }

  void weigh(const Time<S>& t) {
    S* next = weighted_.data();
    if (!program_.has_weighted_registers()) return;
    for (const std::uint32_t r : program_.by_t) *next++ = product(t.t, registers_[r]);
    for (const std::uint32_t r : program_.by_rest) *next++ = product(t.rest, registers_[r]);
  }

  S entry(const typename Program::Blend& b, const Time<S>& t) const {
    if (program_.has_weighted_registers()) return sum(b.f, weighted_) + moving(b);
    S total = moving(b);
    if (!b.f.is_empty()) total = add_product(t.t, sum(b.f, registers_), total);
    if (!b.g.is_empty()) total = add_product(t.rest, sum(b.g, registers_), total);
    return total;
  }

  S sum(const typename Program::Sum& terms, const std::vector<S>& r) const {
    S total(0.0);
    for (std::uint32_t k = terms.real_begin; k < terms.real_end; ++k) {
      const typename Program::RealTerm& term = program_.real_terms[k];
      total = add_product(term.c, r[term.monomial], total);
    }
    for (std::uint32_t k = terms.complex_begin; k < terms.complex_end; ++k) {
      const typename Program::ComplexTerm& term = program_.complex_terms[k];
      total = add_product(S(term.re, term.im), r[term.monomial], total);
    }
    return total;
  }

  S moving(const typename Program::Blend& b) const { return moving(b, coefficients_.c); }
  S moving_slope(const typename Program::Blend& b) const { return moving(b, coefficients_.slope); }
  S moving(const typename Program::Blend& b, const std::vector<S>& c) const {
    S total(0.0);
    for (std::uint32_t k = b.moving_begin; k < b.moving_end; ++k) {
      const typename Program::MovingTerm& term = program_.moving_terms[k];
      total = add_product(c[term.coefficient], registers_[term.monomial], total);
    }
    return total;
  }

  Program program_;
  MovingCoefficients<S> coefficients_;
  const PathFrame* frame_ = nullptr;
  Time<S> moved_{S(0.0)};
  bool has_moved_ = false;
  bool has_multiples_ = false;
  std::vector<S> registers_;
  std::vector<S> weighted_;
};

}  // namespace moivre
