// SPDX-License-Identifier: MIT
// How is F evaluated fast, in any scalar? A straight-line program for F and its Jacobian with
// shared products.
//
//   registers r:  r_0..r_{n-1} = x,  r_n = 1,  then r_k = r_a * r_b, one product a line
//                                              (monomials, shared)
//   values:       F_i   = sum over terms of   c_k * r_m
//   Jacobian:     F_ij  = sum over terms of   c_k' * r_m'     only where it is not structurally
//                                             zero
//
// x: n, F: m, Jacobian: the structural nonzeros, in row order. c: the coefficients of F's terms in
// order, then those of the Jacobian with their exponents as factors (`Coefficients`). They are
// input, so that a homotopy can move them. They are rounded from the exact system once for each
// scalar type. The program is immutable and shared; a thread owns its registers.
// A scalar S needs S(double), +=, and product(S, S) and product(C, S) for its coefficient type C. A
// truncated power series in t is such a scalar: Taylor terms need no second program
// [GriewankWalther08, ch. 13].
// Not supported: negative exponents. Source: [GriewankWalther08].
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "moivre/numeric/complex.h"
#include "moivre/polynomial/system.h"

namespace moivre {

struct Tape {
  struct Product {
    std::uint32_t a, b;  ///< registers multiplied into the next register
  };
  struct Summand {
    std::uint32_t coefficient, monomial;  ///< c index, register
  };
  struct Entry {
    std::uint32_t row, column;
    std::uint32_t begin, end;  ///< its summands
  };

  std::uint32_t variables = 0;
  std::uint32_t equations = 0;
  std::vector<Product> products;
  std::uint32_t value_products = 0;  ///< the first so many products are all that the values need
  std::vector<Summand> value_summands;
  std::vector<std::uint32_t> value_begin;  ///< equations + 1 offsets into value_summands
  std::vector<Summand> jacobian_summands;
  std::vector<Entry> jacobian;  ///< structural nonzeros in row order
  /// Where each coefficient comes from: term `term` of the system (counted over all polynomials),
  /// times `factor`.
  struct Origin {
    std::uint32_t equation, term, factor;
  };
  std::vector<Origin> coefficients;

  std::size_t register_count() const { return variables + 1 + products.size(); }
};

/// Compiles F. Throws std::invalid_argument when F has more than 2^32 - 1 registers.
Tape make_tape(const System& f);

/// Coefficients in tape order, rounded once by `round(Coefficient) -> C`.
template <class C, class Round>
std::vector<C> round_coefficients(const Tape& tape, const System& f, Round round) {
  std::vector<C> c;
  c.reserve(tape.coefficients.size());
  for (const Tape::Origin& origin : tape.coefficients) {
    const Coefficient& exact = f.polynomials[origin.equation].terms[origin.term].coefficient;
    if (origin.factor == 1) {
      c.push_back(round(exact));
    } else {
      const Rational factor(origin.factor);
      c.push_back(round(Coefficient{exact.re * factor, exact.im * factor}));
    }
  }
  return c;
}
std::vector<Complex> complex_coefficients(const Tape& tape, const System& f);
/// Requires is_real(f).
std::vector<double> real_coefficients(const Tape& tape, const System& f);

namespace detail {

template <class S>
void run_products(const Tape& tape, std::span<const S> x, std::size_t count, std::span<S> r) {
  for (std::size_t i = 0; i < tape.variables; ++i) r[i] = x[i];
  r[tape.variables] = S(1.0);
  std::size_t next = tape.variables + 1;
  for (std::size_t k = 0; k < count; ++k, ++next) {
    r[next] = product(r[tape.products[k].a], r[tape.products[k].b]);
  }
}

template <class S, class C>
S sum(std::span<const Tape::Summand> summands, std::span<const C> c, std::span<const S> r) {
  S total = S(0.0);
  for (const Tape::Summand& s : summands) total += product(c[s.coefficient], r[s.monomial]);
  return total;
}

template <class S, class C>
void sum_values(const Tape& tape, std::span<const C> c, std::span<const S> r, std::span<S> value) {
  const std::span<const Tape::Summand> all(tape.value_summands);
  for (std::size_t i = 0; i < tape.equations; ++i) {
    const auto begin = tape.value_begin[i];
    value[i] = sum<S, C>(all.subspan(begin, tape.value_begin[i + 1] - begin), c, r);
  }
}

}  // namespace detail

/// value <- F(x). r: register_count() registers of scratch.
template <class S, class C>
void evaluate(const Tape& tape, std::span<const C> c, std::span<const S> x, std::span<S> r,
              std::span<S> value) {
  detail::run_products<S>(tape, x, tape.value_products, r);
  detail::sum_values<S, C>(tape, c, r, value);
}

/// value <- F(x), jacobian <- the structural nonzeros of F_x(x), in the order of tape.jacobian.
template <class S, class C>
void evaluate(const Tape& tape, std::span<const C> c, std::span<const S> x, std::span<S> r,
              std::span<S> value, std::span<S> jacobian) {
  detail::run_products<S>(tape, x, tape.products.size(), r);
  detail::sum_values<S, C>(tape, c, r, value);
  const std::span<const Tape::Summand> all(tape.jacobian_summands);
  for (std::size_t k = 0; k < tape.jacobian.size(); ++k) {
    const Tape::Entry& entry = tape.jacobian[k];
    jacobian[k] = detail::sum<S, C>(all.subspan(entry.begin, entry.end - entry.begin), c, r);
  }
}

}  // namespace moivre
