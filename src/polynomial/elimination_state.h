// SPDX-License-Identifier: MIT
// How far has an elimination come? Equations on their way, and what is asked of each again and
// again.
//
// Sizes are log2, of a coefficient times the size of its unknown. Private to the module.
#pragma once

#include <atomic>
#include <cstdint>
#include <memory>
#include <optional>
#include <set>
#include <vector>

#include "moivre/polynomial/eliminate.h"
#include "moivre/polynomial/integer_polynomial.h"

namespace moivre::elimination {

/// So many terms of an equation hold the unknown to this power.
struct Occurrence {
  std::uint32_t variable = 0;
  std::uint32_t exponent = 0;
  double count = 0;
};

/// An unknown that a linear equation may be solved for.
struct Divisor {
  std::uint32_t variable = 0;
  double size_log2 = 0;  ///< relative to the largest one of the equation
};

/// An equation, and what is asked of it again and again.
struct RowFacts {
  IntegerPolynomial p;
  std::uint64_t degree = 0;
  double work = 0;                      // of its terms
  std::vector<Occurrence> occurrences;  // by unknown, then by exponent
  std::vector<Divisor> divisors;        // of a linear equation
};

/// An equation on its way; `origin` is its number in the file. States share what they have in
/// common.
struct Row {
  std::shared_ptr<const RowFacts> equation;
  std::size_t origin = 0;

  const IntegerPolynomial& p() const { return equation->p; }
  std::uint64_t degree() const { return equation->degree; }
};

struct State {
  std::vector<Row> rows;
  std::vector<bool> is_eliminated;  // one for each unknown
  std::vector<Substitution> substitutions;
  std::vector<Omission> combinations;
  std::vector<std::size_t> dependent;        // origins of the equations that became 0 = 0
  std::optional<std::size_t> contradiction;  // origin of the one that became c = 0
  std::set<std::uint64_t> independent;       // degrees whose highest parts are known to be so
};

/// What does not change from move to move.
struct Limits {
  std::size_t bits = 0;
  std::vector<int> variable_log2;  // sizes of the unknowns, for the choice of pivots
  const std::atomic<bool>* stop = nullptr;

  bool is_over() const { return stop != nullptr && stop->load(std::memory_order_relaxed); }
};

/// Of an equation in its place.
std::shared_ptr<const RowFacts> facts_of_row(IntegerPolynomial p, const Limits& limits);

Substitution to_substitution(const AffineForm& form);

std::vector<std::uint64_t> degrees_of(const std::vector<Row>& rows);

/// Unknowns that are not eliminated.
double unknowns_left(const State& s);

}  // namespace moivre::elimination
