// SPDX-License-Identifier: MIT
// Which monomials does a polynomial have? Its support: the exponent vectors of its terms, in the
// polynomial's order.
//
//   A_i = {a_i1, a_i2, ...}: n integers >= 0 each, a_ik the exponents of term k of F_i.
//
// Coefficients do not matter here: what is computed from supports holds for generic coefficients on
// them. A support that is made by hand may have terms in any order. The roots with zero coordinates
// are counted too when every support has the exponent vector 0 [LiWang96]: `with_origin`. Not
// supported: negative exponents.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "moivre/polynomial/system.h"

namespace moivre {

/// Exponents of one term, one for each variable.
using Exponents = std::vector<std::uint32_t>;

/// The exponent vectors of one polynomial, term by term.
struct Support {
  std::vector<Exponents> terms;

  friend bool operator==(const Support&, const Support&) = default;
};

std::vector<Support> supports_of(const System& f);

struct SupportsWithOrigin {
  std::vector<Support> supports;
  std::vector<std::size_t> origin;  ///< index of the term 0 of each support
  std::vector<bool> added;          ///< true: it was missing and is now the last term
};

/// Adds 0 to every support of n variables that lacks it. Throws std::invalid_argument when a term
/// has not n exponents.
SupportsWithOrigin with_origin(std::vector<Support> supports, std::size_t n);

/// Throws std::invalid_argument unless there are as many supports as each term has exponents.
void check_square(const std::vector<Support>& supports);

}  // namespace moivre
