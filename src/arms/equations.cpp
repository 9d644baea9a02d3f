// SPDX-License-Identifier: MIT
// The multilinear product of the outside, term by term, and linear forms of it.
#include "equations.h"

#include "exact_displacement.h"
#include "moivre/numeric/random.h"

namespace moivre {
namespace {

/// Whole numbers up to this make a random combination.
constexpr double kLargestWeight = 1 << 16;

/// Coefficients of the monomials in the tangents; bit k of the index is the exponent of t_k+1.
using Expansion = std::vector<ExactDisplacement>;

/// The outside's product backwards: what the inside's must be.
Expansion outside_product(const Loop& loop, const Cut& cut) {
  Expansion terms{ExactDisplacement{1}};
  for (const std::size_t joint : cut.outside) {
    const LoopJoint& own = loop.joints[joint];
    for (ExactDisplacement& term : terms) term = term * own.before;
    const std::size_t size = terms.size();
    for (std::size_t k = 0; k < size; ++k) terms.push_back(terms[k] * own.step);
    for (std::size_t k = 0; k < size; ++k) {
      for (Integer& part : terms[k]) part *= own.one;
    }
  }
  for (ExactDisplacement& term : terms) term = conjugate(term * loop.joints[cut.first].before);
  return terms;
}

/// Coefficients beside the largest are kept to so many bits: twice what the paths are followed with at the most.
constexpr std::size_t kBits = 256;

/// The forms of the product, all scaled by one power of two to have coefficients near 1.
std::vector<Polynomial> forms_of(const std::vector<LinearForm>& forms, const Expansion& terms) {
  std::vector<std::vector<Integer>> values;
  std::size_t bits = 0;
  for (const LinearForm& form : forms) {
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

/// `count` random combinations of the polynomials.
std::vector<Polynomial> combinations(const std::vector<Polynomial>& all, std::size_t count,
                                     std::uint64_t seed) {
  std::vector<Polynomial> mixed(count);
  std::uint64_t number = 0;
  for (Polynomial& sum : mixed) {
    for (const Polynomial& one : all) {
      // Numbers of joints come before these in the stream.
      constexpr std::uint64_t kBehindJoints = 1000;
      const double weight = random_unit(seed, RandomStream::arm, kBehindJoints + number++) - 0.5;
      const Coefficient factor{Rational(static_cast<std::int64_t>(weight * kLargestWeight)), {}};
      sum = sum + factor * one;
    }
  }
  return mixed;
}

}  // namespace

Monomial multilinear(std::size_t bits) {
  Monomial powers;
  for (std::uint32_t k = 0; bits != 0; ++k, bits >>= 1U) {
    if ((bits & 1U) != 0) powers.push_back({k, 1});
  }
  return powers;
}

System cut_equations(const Loop& loop, const Cut& cut, std::uint64_t seed) {
  System system;
  for (std::size_t k = 0; k < cut.outside.size(); ++k) {
    system.variables.push_back(std::string("t").append(std::to_string(cut.outside[k] + 1)));
  }
  if (cut.outside.empty()) return system;
  const Expansion terms = outside_product(loop, cut);
  std::vector<Polynomial> linear = forms_of(cut.forms, terms);
  const std::size_t unknowns = cut.outside.size();
  const bool needs_quadric = unknowns == 4 && cut.coordinates.size() == 4;
  if (linear.size() == unknowns && !needs_quadric) {
    system.polynomials = std::move(linear);
    return system;
  }
  system.polynomials = combinations(linear, unknowns - (needs_quadric ? 1 : 0), seed);
  if (needs_quadric) {
    const std::vector<Polynomial> x = forms_of(cut.coordinates, terms);
    system.polynomials.push_back(x[0] * x[3] + Coefficient{Rational(-1), {}} * (x[1] * x[2]));
  }
  return system;
}

}  // namespace moivre
