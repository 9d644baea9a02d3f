// SPDX-License-Identifier: MIT
// What is the system? Sparse polynomials in named variables, with coefficients exactly as read.
//
//   F = (F_1, ..., F_m), F_i = sum_k c_ik * x^e_ik,  x = (x_1, ..., x_n),  c_ik a Gaussian
//   rational.
//
// Polynomials are canonical: terms sorted (graded, then lexicographic, highest first), distinct,
// none zero. A System is a value; nothing rounds a coefficient before a scalar type asks for it
// (polynomial/tape.h). The zero polynomial has no terms and degree 0. Not supported: negative
// exponents.
#pragma once

#include <array>
#include <compare>
#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "moivre/numeric/rational.h"

namespace moivre {

/// variable^exponent, exponent >= 1; `variable` counts from 0.
struct Power {
  std::uint32_t variable = 0;
  std::uint32_t exponent = 1;

  friend auto operator<=>(const Power&, const Power&) = default;
};

/// Product of powers, sorted by variable; the empty monomial is 1.
using Monomial = std::vector<Power>;

/// Sum of the exponents.
std::uint64_t degree(const Monomial& m);
/// a*b. Throws std::overflow_error when an exponent leaves 32 bits.
Monomial product(const Monomial& a, const Monomial& b);
/// Graded lexicographic, highest first: the order of the terms of a polynomial.
bool precedes(const Monomial& a, const Monomial& b);

struct MonomialOrder {
  bool operator()(const Monomial& a, const Monomial& b) const { return precedes(a, b); }
};

struct Term {
  Coefficient coefficient;
  Monomial monomial;

  friend bool operator==(const Term&, const Term&) = default;
};

struct Polynomial {
  std::vector<Term> terms;

  friend bool operator==(const Polynomial&, const Polynomial&) = default;
};

/// Monomial -> coefficient while a polynomial is put together; zero sums are dropped by
/// `to_polynomial`.
using TermMap = std::map<Monomial, Coefficient, MonomialOrder>;
Polynomial to_polynomial(TermMap terms);
/// The polynomial x_index, and the polynomial c.
Polynomial unknown(std::uint32_t index);
Polynomial constant(const Coefficient& c);
/// x_0, x_1, ...: auto [x, y] = unknowns<2>();
template <std::size_t N>
std::array<Polynomial, N> unknowns() {
  std::array<Polynomial, N> x;
  for (std::size_t j = 0; j < N; ++j) x[j] = unknown(static_cast<std::uint32_t>(j));
  return x;
}
std::vector<Polynomial> unknowns(std::size_t n);

std::uint64_t degree(const Polynomial& p);
bool is_real(const Polynomial& p);
/// All terms of one degree (the zero polynomial counts as homogeneous).
bool is_homogeneous(const Polynomial& p);

// As on paper: x*y - 1, -x, 2*x, p += x, pow(x, 3). A number of any type stands where a coefficient
// does (numeric/rational.h).
// Products and powers throw std::overflow_error when an exponent leaves 32 bits.
Polynomial operator+(const Polynomial& a, const Polynomial& b);
Polynomial operator+(const Polynomial& p, const Coefficient& c);
Polynomial operator+(const Coefficient& c, const Polynomial& p);
Polynomial operator-(const Polynomial& p);
Polynomial operator-(const Polynomial& a, const Polynomial& b);
Polynomial operator-(const Polynomial& p, const Coefficient& c);
Polynomial operator-(const Coefficient& c, const Polynomial& p);
Polynomial operator*(const Polynomial& a, const Polynomial& b);
Polynomial operator*(const Coefficient& c, const Polynomial& p);
Polynomial operator*(const Polynomial& p, const Coefficient& c);
/// Throws InvalidInput where c is zero.
Polynomial operator/(const Polynomial& p, const Coefficient& c);
Polynomial& operator+=(Polynomial& a, const Polynomial& b);
Polynomial& operator+=(Polynomial& p, const Coefficient& c);
Polynomial& operator-=(Polynomial& a, const Polynomial& b);
Polynomial& operator-=(Polynomial& p, const Coefficient& c);
Polynomial& operator*=(Polynomial& a, const Polynomial& b);
Polynomial& operator*=(Polynomial& p, const Coefficient& c);
Polynomial& operator/=(Polynomial& p, const Coefficient& c);
/// p^0 is 1. Throws InvalidInput where the exponent is negative.
Polynomial pow(const Polynomial& p, int exponent);

/// Variables that belong together: coordinates of one affine space, or homogeneous ones of one
/// projective space.
struct VariableGroup {
  std::vector<std::uint32_t> variables;  ///< ascending
  bool is_homogeneous = false;

  friend bool operator==(const VariableGroup&, const VariableGroup&) = default;
};

/// p > 0, or p >= 0, at a real root: which roots are wanted (solver/filter.h), not which there are.
struct Condition {
  Polynomial p;
  bool is_strict = true;
  std::string text;  ///< as it was typed, for messages and results
};

struct System {
  std::vector<std::string> variables;
  std::vector<Polynomial> polynomials;
  /// As declared by the file: every variable in one group; empty: none declared.
  std::vector<VariableGroup> groups = {};
  /// As typed, no number was rounded (digits.h): products of short ones are long, and exact. false:
  /// its coefficients tell.
  bool is_exact = false;
  /// By which the text divides, cleared from the equations: what makes one of them zero is no root
  /// of what was typed.
  std::vector<Polynomial> denominators = {};
  /// Inequalities that stand among the equations. solve() finds all roots whatever they say, and
  /// keep_wanted() judges them (solver/filter.h).
  std::vector<Condition> conditions = {};
  /// Equation i is 2^scaled_log2[i] times what was typed, which double does not hold
  /// (double_range.h); 0 and behind the end: it is as typed.
  std::vector<int> scaled_log2 = {};
  /// The polynomials with each number of the text that no fraction is (sqrt(2), pi), which is taken
  /// with 40 digits, changed by 1e-38 to 1e-37 of itself; empty where there is none. What both have
  /// in common does not hang on the rounding (solver/solve.h).
  std::vector<Polynomial> nudged = {};

  /// The same equations in the same unknowns. Groups tell how to look for roots, and conditions
  /// which are wanted, not which equations hold.
  friend bool operator==(const System& a, const System& b) {
    return a.variables == b.variables && a.polynomials == b.polynomials &&
           a.denominators == b.denominators;
  }
};

/// Every broken rule as a sentence, empty where there is none: names are given and differ; terms
/// are canonical, their variables are there and their exponents 1 or more; a variable is in one
/// group at most.
std::vector<std::string> broken_rules(const System& f);
/// The same of a condition in so many unknowns; its coefficients are real, too.
std::vector<std::string> broken_rules(const Condition& condition, std::size_t unknowns);
/// The polynomials in unknowns of these names, as double holds them (double_range.h). Throws
/// InvalidInput with every broken rule; names are such as an equation in a file can have, no i, pi.
System make_system(std::vector<std::string> variables, std::vector<Polynomial> polynomials);

std::vector<std::uint64_t> degrees(const System& f);
/// Bezout number: the product of the degrees; nullopt when it leaves 64 bits.
std::optional<std::uint64_t> total_degree(const std::vector<std::uint64_t>& degrees);
bool is_real(const System& f);
std::size_t term_count(const System& f);

}  // namespace moivre
