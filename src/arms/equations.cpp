// SPDX-License-Identifier: MIT
// The multilinear product of the outside, term by term, and linear forms of it.
#include "equations.h"

namespace moivre {
namespace {

/// Coefficients beside the largest are kept to so many bits: twice what the paths are followed with at the most.
constexpr std::size_t kBits = 256;

/// The forms' values on the product, all scaled by one power of two to have coefficients near 1.
std::vector<Polynomial> values_of(const std::vector<ExactDisplacement>& forms,
                                  const std::vector<ExactDisplacement>& terms) {
  std::vector<std::vector<Integer>> values;
  std::size_t bits = 0;
  for (const ExactDisplacement& form : forms) {
    std::vector<Integer>& row = values.emplace_back();
    for (const ExactDisplacement& term : terms) {
      row.push_back(value(form, term));
      bits = std::max(bits, bit_length(row.back()));
    }
  }
  const std::size_t dropped = bits > kBits ? bits - kBits : 0;
  const Integer unit = Integer(1) << static_cast<unsigned>(dropped);
  // Over a power of two a number counts as rounded (moivre/polynomial/digits.h); these are not.
  const Integer scale = Integer(3) << static_cast<unsigned>(bits - dropped);
  std::vector<Polynomial> polynomials;
  for (const std::vector<Integer>& row : values) {
    TermMap map;
    for (std::size_t k = 0; k < row.size(); ++k) {
      const Integer kept = row[k] / unit;
      if (kept != 0) map[multilinear(k)] = {ratio(kept, scale), {}};
    }
    polynomials.push_back(to_polynomial(std::move(map)));
  }
  return polynomials;
}

}  // namespace

Monomial multilinear(std::size_t bits) {
  Monomial powers;
  for (std::uint32_t k = 0; bits != 0; ++k, bits >>= 1U) {
    if ((bits & 1U) != 0) powers.push_back({k, 1});
  }
  return powers;
}

std::vector<std::string> tangent_names(const Cut& cut) {
  std::vector<std::string> names;
  for (const std::size_t joint : cut.outside) {
    names.push_back(std::string("t").append(std::to_string(joint + 1)));
  }
  return names;
}

System cut_equations(const Loop& loop, const Cut& cut, std::uint64_t seed) {
  System system;
  system.variables = tangent_names(cut);
  const std::size_t unknowns = cut.outside.size();
  if (unknowns == 0) return system;
  const auto terms = outside_product(loop, cut, &LoopJoint::exact);
  const bool needs_quadric = unknowns == 4 && cut.coordinates.size() == 4;
  const std::size_t linear = unknowns - (needs_quadric ? 1 : 0);
  system.polynomials = values_of(
      cut.forms.size() == linear ? cut.forms : combinations(cut.forms, linear, seed), terms);
  if (needs_quadric) {
    const std::vector<Polynomial> x = values_of(cut.coordinates, terms);
    system.polynomials.push_back(x[0] * x[3] + Coefficient{Rational(-1), {}} * (x[1] * x[2]));
  }
  return system;
}

}  // namespace moivre
