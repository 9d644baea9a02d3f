// SPDX-License-Identifier: MIT
// What does a lane interpreter run? The tapes of F and G as one, coefficients rounded, written out in the order of use.
//
//   Real: what coefficients are rounded to, double or DoubleDouble
//   products: as in polynomial/tape.h, shared by F and G
//   values: H_i from F_i and G_i;  jacobian: H_ij likewise, where not structurally zero;  zeros: the others
#pragma once

#include <cstdint>
#include <vector>

#include "moivre/homotopy/homotopy.h"

namespace moivre {

template <class Real>
struct LaneProgram {
  struct RealTerm {
    Real c;
    std::uint32_t monomial;
  };
  struct ComplexTerm {
    Real re, im;
    std::uint32_t monomial;
  };
  /// A sum of terms c r_m.
  struct Sum {
    std::uint32_t real_begin = 0, real_end = 0;
    std::uint32_t complex_begin = 0, complex_end = 0;
    bool is_empty() const { return real_begin == real_end && complex_begin == complex_end; }
  };
  /// t f + (1 - t) g.
  struct Blend {
    Sum f, g;
  };
  struct Position {
    std::uint32_t row, column;
  };
  /// Of H_x: a blend of registers, or where the program has weighted registers, blend.f over those and no blend.g.
  struct Entry {
    std::uint32_t row, column;
    Blend blend;
  };

  std::uint32_t variables = 0;
  std::uint32_t register_count = 0;
  std::vector<Tape::Product> products;
  std::uint32_t value_products = 0;  ///< the first so many products are all that the values need
  std::vector<RealTerm> real_terms;
  std::vector<ComplexTerm> complex_terms;
  std::vector<Blend> values;
  std::vector<std::uint32_t>
      by_t;  ///< registers whose products by t are the first weighted registers
  std::vector<std::uint32_t> by_rest;  ///< by 1 - t, those that follow
  std::vector<Entry> jacobian;         ///< entries with equally many terms one after another
  std::vector<Position> zeros;

  bool has_weighted_registers() const { return !by_t.empty(); }
  std::size_t weighted_count() const { return by_t.size() + by_rest.size(); }
};

/// For double and DoubleDouble.
template <class Real>
LaneProgram<Real> make_lane_program(const Homotopy& homotopy);

}  // namespace moivre
