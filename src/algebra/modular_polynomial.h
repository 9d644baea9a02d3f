// SPDX-License-Identifier: MIT
// How is a polynomial modulo the prime reduced by others? Term after term in the degree reverse
// lexicographic order.
//
// Not supported: more than 15 unknowns, degrees beyond 255. Private to the module.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include "moivre/polynomial/prime_field.h"
#include "moivre/polynomial/system.h"

namespace moivre {

/// The degree, then the exponents; what is beyond the unknowns is 0.
struct DegreeAndExponents {
  static constexpr std::size_t kMostUnknowns = 15;
  static constexpr std::uint64_t kMostDegree = 255;

  std::array<std::uint8_t, 1 + kMostUnknowns> at{};

  std::uint64_t degree() const { return at[0]; }
  bool operator==(const DegreeAndExponents&) const = default;
};

/// By degree; of one degree, who has more of the first unknown is smaller.
bool is_smaller(const DegreeAndExponents& a, const DegreeAndExponents& b);
bool divides(const DegreeAndExponents& a, const DegreeAndExponents& b);
/// Of a multiple by its divisor.
DegreeAndExponents quotient(const DegreeAndExponents& multiple, const DegreeAndExponents& divisor);
/// nullopt beyond the largest degree, as in all that follows.
std::optional<DegreeAndExponents> lcm(const DegreeAndExponents& a, const DegreeAndExponents& b);
bool are_coprime(const DegreeAndExponents& a, const DegreeAndExponents& b);

/// Terms in descending order; empty: 0. Those that reduce others have 1 as first coefficient.
using ModularPolynomial = std::vector<std::pair<DegreeAndExponents, Residue>>;

/// With 1 as first coefficient, but for 0.
ModularPolynomial monic(const PrimeField& field, ModularPolynomial p);

/// In kMostUnknowns at most; monic.
std::optional<ModularPolynomial> modular(const PrimeField& field, const Polynomial& p);

/// How many terms may still be looked at.
class TermBudget {
 public:
  explicit TermBudget(std::uint64_t terms) : left_(terms) {}
  void spend(std::uint64_t terms) { left_ -= terms < left_ ? terms : left_; }
  bool is_used_up() const { return left_ == 0; }
  std::uint64_t left() const { return left_; }

 private:
  std::uint64_t left_;
};

/// No term of what is left is a multiple of a leading monomial of `basis`. nullopt, too, where the
/// budget is used up.
std::optional<ModularPolynomial> reduced(const PrimeField& field, ModularPolynomial p,
                                         const std::vector<const ModularPolynomial*>& basis,
                                         TermBudget& budget);

/// p + c m q; nullopt, too, where the budget is used up.
std::optional<ModularPolynomial> sum(const PrimeField& field, const ModularPolynomial& p, Residue c,
                                     const DegreeAndExponents& m, const ModularPolynomial& q,
                                     TermBudget& budget);

/// The difference of the multiples that have the least common multiple as leading monomial.
std::optional<ModularPolynomial> s_polynomial(const PrimeField& field, const ModularPolynomial& p,
                                              const ModularPolynomial& q);

}  // namespace moivre
