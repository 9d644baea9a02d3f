// SPDX-License-Identifier: MIT
// The multilinear product of the outside, term by term, and linear forms of it.
#include "equations.h"

namespace moivre {
namespace {

using Row = std::vector<Integer>;

Row row_of(const ExactDisplacement& form, const std::vector<ExactDisplacement>& terms) {
  Row row;
  for (const ExactDisplacement& term : terms) row.push_back(value(form, term));
  return row;
}

std::size_t bits_of(const Row& row) {
  std::size_t bits = 0;
  for (const Integer& x : row) bits = std::max(bits, bit_length(x));
  return bits;
}

/// The row's polynomial, scaled by a power of two so that a number of `bits` bits is near 1.
/// Nothing is rounded: exact algebra would count what was left of roots at infinity.
Polynomial polynomial_of(const Row& row, std::size_t bits) {
  // Over a power of two a number counts as rounded (moivre/polynomial/digits.h); these are not.
  const Integer scale = Integer(3) << static_cast<unsigned>(bits);
  TermMap map;
  for (std::size_t k = 0; k < row.size(); ++k) {
    if (row[k] != 0) map[multilinear(k)] = {ratio(row[k], scale), {}};
  }
  return to_polynomial(std::move(map));
}

/// Each form's value on the product; forms may be thousands of digits apart.
std::vector<Polynomial> values_of(const std::vector<ExactDisplacement>& forms,
                                  const std::vector<ExactDisplacement>& terms) {
  std::vector<Polynomial> polynomials;
  for (const ExactDisplacement& form : forms) {
    const Row row = row_of(form, terms);
    polynomials.push_back(polynomial_of(row, bits_of(row)));
  }
  return polynomials;
}

/// a b = c d of the coordinates in W: all four of one scale.
Polynomial quadric_of(const std::vector<ExactDisplacement>& coordinates,
                      const std::vector<ExactDisplacement>& terms) {
  std::vector<Row> rows;
  std::size_t bits = 0;
  for (const ExactDisplacement& form : coordinates) {
    rows.push_back(row_of(form, terms));
    bits = std::max(bits, bits_of(rows.back()));
  }
  std::vector<Polynomial> x;
  for (const Row& row : rows) x.push_back(polynomial_of(row, bits));
  return x[0] * x[3] + Coefficient{Rational(-1), {}} * (x[1] * x[2]);
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

std::vector<ExactDisplacement> of_one_size(std::vector<ExactDisplacement> forms) {
  std::size_t most = 0;
  for (const ExactDisplacement& form : forms) most = std::max(most, bit_length(largest_part(form)));
  for (ExactDisplacement& form : forms) {
    const auto shift = static_cast<unsigned>(most - bit_length(largest_part(form)));
    form = mapped(form, [shift](const Integer& part) { return Integer(part << shift); });
  }
  return forms;
}

System cut_equations(const Loop& loop, const Cut& cut, std::uint64_t seed) {
  System system;
  system.variables = tangent_names(cut);
  const std::size_t unknowns = cut.outside.size();
  const auto terms = outside_product(loop, cut, &LoopJoint::exact);
  const bool needs_quadric = unknowns == 4 && cut.coordinates.size() == 4;
  const std::size_t linear = unknowns - (needs_quadric ? 1 : 0);
  system.polynomials = values_of(
      cut.forms.size() == linear ? cut.forms : combinations(of_one_size(cut.forms), linear, seed),
      terms);
  if (needs_quadric) system.polynomials.push_back(quadric_of(cut.coordinates, terms));
  return system;
}

}  // namespace moivre
