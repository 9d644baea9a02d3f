// SPDX-License-Identifier: MIT
// What does an interpreter of homotopies run? The tape with its coefficients rounded, written out
// in the order of use.
//
//   Real: what coefficients are rounded to, double or a type of more digits
//   products: as in polynomial/tape.h
//   values: H_i;  jacobian: H_ij where not structurally zero;  zeros: the others.  Each is a blend
//
//       t sum c r  +  (1 - t) sum c r  +  sum c(t) r          r: registers
//
// On a straight line, a term that only one end has keeps its coefficient; its sum shares the factor
// t or 1 - t. A real coefficient then costs half as much as a complex one. All other terms, and all
// terms of a framed homotopy, have moving coefficients. They are evaluated once for each t
// (homotopy/moving.h); those of the Jacobian are integer multiples of those of the values.
#pragma once

#include <cstdint>
#include <vector>

#include "moivre/homotopy/homotopy.h"

namespace moivre {

template <class Real>
struct HomotopyProgram {
  struct RealTerm {
    Real c;
    std::uint32_t monomial;
  };
  struct ComplexTerm {
    Real re, im;
    std::uint32_t monomial;
  };
  struct MovingTerm {
    std::uint32_t coefficient, monomial;
  };
  /// A sum of terms c r_m that stand still.
  struct Sum {
    std::uint32_t real_begin = 0, real_end = 0;
    std::uint32_t complex_begin = 0, complex_end = 0;
    bool is_empty() const { return real_begin == real_end && complex_begin == complex_end; }
  };
  /// t f + (1 - t) g + what moves.
  struct Blend {
    Sum f, g;
    std::uint32_t moving_begin = 0, moving_end = 0;
  };
  struct Position {
    std::uint32_t row, column;
  };
  /// Of H_x. Where the program has weighted registers, blend.f is over those and blend.g is empty.
  struct Entry {
    std::uint32_t row, column;
    Blend blend;
  };
  /// A moving coefficient of a value: its term, and the coefficients at both ends.
  struct Moving {
    std::uint32_t term;
    Real f_re, f_im, g_re, g_im;
  };
  /// One of an entry of H_x: `factor` times the coefficient `base`.
  struct Multiple {
    std::uint32_t base;
    double factor;
  };

  CoefficientLaw law = CoefficientLaw::straight;
  bool is_framed = false;
  std::uint32_t variables = 0;
  std::uint32_t register_count = 0;
  std::vector<Tape::Product> products;
  std::uint32_t value_products = 0;  ///< the first so many products are all that the values need
  std::vector<RealTerm> real_terms;
  std::vector<ComplexTerm> complex_terms;
  std::vector<MovingTerm> moving_terms;
  std::vector<Moving> moving;       ///< the first moving coefficients
  std::vector<Multiple> multiples;  ///< those that follow
  std::vector<Blend> values;
  std::vector<std::uint32_t>
      by_t;  ///< registers whose products by t are the first weighted registers
  std::vector<std::uint32_t> by_rest;  ///< by 1 - t, those that follow
  std::vector<Entry> jacobian;         ///< entries with equally many terms one after another
  std::vector<Position> zeros;

  bool has_weighted_registers() const { return !by_t.empty(); }
  std::size_t weighted_count() const { return by_t.size() + by_rest.size(); }
  std::size_t moving_count() const { return moving.size() + multiples.size(); }
  bool stands_still() const { return moving.empty(); }
};

/// Instantiated for double and DoubleDouble; for other types by whoever includes
/// homotopy/write_program.h.
template <class Real>
HomotopyProgram<Real> make_program(const Homotopy& homotopy);

}  // namespace moivre
