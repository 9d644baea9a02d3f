// SPDX-License-Identifier: MIT
// Sparse Gaussian elimination modulo a prime.
#include "modular.h"

#include <algorithm>
#include <stdexcept>

#include "moivre/numeric/integer.h"

namespace moivre {
namespace {

constexpr std::uint64_t kRootOfMinusOne = 583529827753931384;

static_assert(times(kRootOfMinusOne, kRootOfMinusOne) == kPrime - 1, "not a root of -1");

Residue residue(const Integer& a) {
  const auto size = static_cast<Residue>(Integer(abs(a) % kPrime));
  return a < 0 && size != 0 ? kPrime - size : size;
}

Residue residue(const Rational& a) {
  if (a.is_zero()) return 0;
  const Residue below = residue(denominator(a));
  if (below == 0) throw std::invalid_argument("a denominator that the prime divides");
  return times(residue(numerator(a)), inverse(below));
}

}  // namespace

// Fermat: a^(p-2) a = 1.
Residue inverse(Residue a) {
  Residue result = 1;
  for (std::uint64_t e = kPrime - 2; e != 0; e >>= 1) {
    if (e & 1) result = times(result, a);
    a = times(a, a);
  }
  return result;
}

Residue residue(const GaussianInteger& a) {
  return plus(residue(a.re), times(kRootOfMinusOne, residue(a.im)));
}

Residue residue(const Coefficient& a) {
  return plus(residue(a.re), times(kRootOfMinusOne, residue(a.im)));
}

std::optional<Residue> residue_if_faithful(const Coefficient& a) {
  for (const Rational* part : {&a.re, &a.im}) {
    if (!part->is_zero() && denominator(*part) % kPrime == 0) return std::nullopt;
  }
  const Residue image = residue(a);
  if (image == 0 && !(a == Coefficient{})) return std::nullopt;
  return image;
}

namespace {

/// The nonzero entries from a column on.
ModularRow sparse(const std::vector<WideSum>& values, std::size_t first) {
  ModularRow row;
  for (std::size_t column = first; column < values.size(); ++column) {
    const Residue value = reduced(values[column]);
    if (value != 0) row.emplace_back(column, value);
  }
  return row;
}

}  // namespace

// Products are summed up as they are, and reduced before they are too many, or looked at.
ModularRow ModularRows::rest_of(const ModularRow& row) const {
  if (row.empty()) return {};
  std::vector<WideSum> rest(std::max(pivots_.size(), row.back().first + 1));
  for (const auto& [column, value] : row) rest[column] = value;
  std::size_t first = row.front().first;
  int products = 0;
  for (; first < rest.size(); ++first) {
    const Residue leading = reduced(rest[first]);
    if (leading == 0) continue;
    if (first >= pivots_.size() || pivots_[first].empty()) break;
    if (++products > kMostProducts) {
      for (std::size_t column = first; column < rest.size(); ++column) {
        rest[column] = reduced(rest[column]);
      }
      products = 1;
    }
    const WideSum multiple = minus(leading);
    for (const auto& [column, value] : pivots_[first]) rest[column] += multiple * value;
  }
  return sparse(rest, first);
}

std::optional<std::size_t> ModularRows::add(const ModularRow& row) {
  ModularRow left = rest_of(row);
  if (left.empty()) return std::nullopt;
  const Residue unit = inverse(left.front().second);
  for (auto& [column, value] : left) value = times(value, unit);
  const std::size_t first = left.front().first;
  if (pivots_.size() <= left.back().first) pivots_.resize(left.back().first + 1);
  pivots_[first] = std::move(left);
  ++rank_;
  return first;
}

}  // namespace moivre
