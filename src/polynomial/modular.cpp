// SPDX-License-Identifier: MIT
// Sparse Gaussian elimination modulo a prime.
#include "modular.h"

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

/// row - multiple * pivot
ModularRow reduced(const ModularRow& row, const ModularRow& pivot, Residue multiple) {
  ModularRow result;
  const Residue negative = multiple == 0 ? 0 : kPrime - multiple;
  auto a = row.begin();
  auto b = pivot.begin();
  while (a != row.end() || b != pivot.end()) {
    if (b == pivot.end() || (a != row.end() && a->first < b->first)) {
      result.push_back(*a++);
    } else if (a == row.end() || b->first < a->first) {
      result.emplace_back(b->first, times(negative, b->second));
      ++b;
    } else {
      const Residue value = plus(a->second, times(negative, b->second));
      if (value != 0) result.emplace_back(a->first, value);
      ++a;
      ++b;
    }
  }
  return result;
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

ModularRow ModularRows::rest_of(ModularRow row) const {
  while (!row.empty()) {
    const auto pivot = pivots_.find(row.front().first);
    if (pivot == pivots_.end()) break;
    row = reduced(row, pivot->second, row.front().second);
  }
  return row;
}

const std::size_t* ModularRows::add(ModularRow row) {
  row = rest_of(std::move(row));
  if (row.empty()) return nullptr;
  const Residue unit = inverse(row.front().second);
  for (auto& [column, value] : row) value = times(value, unit);
  const std::size_t first = row.front().first;
  return &pivots_.emplace(first, std::move(row)).first->first;
}

}  // namespace moivre
