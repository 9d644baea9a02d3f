// SPDX-License-Identifier: MIT
// Rank modulo a prime by sparse Gaussian elimination.
#include "modular_rank.h"

#include <algorithm>
#include <cstddef>
#include <map>
#include <utility>

#include "moivre/numeric/integer.h"

namespace moivre {
namespace {

constexpr std::uint64_t kPrime = (std::uint64_t{1} << 61) - 31;
constexpr std::uint64_t kRootOfMinusOne = 583529827753931384;

__extension__ using Wide = unsigned __int128;

constexpr std::uint64_t times(std::uint64_t a, std::uint64_t b) {
  return static_cast<std::uint64_t>(Wide{a} * b % kPrime);
}
static_assert(times(kRootOfMinusOne, kRootOfMinusOne) == kPrime - 1, "not a root of -1");

constexpr std::uint64_t plus(std::uint64_t a, std::uint64_t b) { return (a + b) % kPrime; }

/// Fermat: a^(p-2) a = 1.
std::uint64_t inverse(std::uint64_t a) {
  std::uint64_t result = 1;
  for (std::uint64_t e = kPrime - 2; e != 0; e >>= 1) {
    if (e & 1) result = times(result, a);
    a = times(a, a);
  }
  return result;
}

std::uint64_t residue(const Integer& a) {
  const auto size = static_cast<std::uint64_t>(Integer(abs(a) % kPrime));
  return a < 0 && size != 0 ? kPrime - size : size;
}

std::uint64_t residue(const GaussianInteger& a) {
  return plus(residue(a.re), times(kRootOfMinusOne, residue(a.im)));
}

/// Column and nonzero value, sorted by column.
using SparseRow = std::vector<std::pair<std::size_t, std::uint64_t>>;

/// row - multiple * pivot
SparseRow reduced(const SparseRow& row, const SparseRow& pivot, std::uint64_t multiple) {
  SparseRow result;
  const std::uint64_t negative = multiple == 0 ? 0 : kPrime - multiple;
  auto a = row.begin();
  auto b = pivot.begin();
  while (a != row.end() || b != pivot.end()) {
    if (b == pivot.end() || (a != row.end() && a->first < b->first)) {
      result.push_back(*a++);
    } else if (a == row.end() || b->first < a->first) {
      result.emplace_back(b->first, times(negative, b->second));
      ++b;
    } else {
      const std::uint64_t value = plus(a->second, times(negative, b->second));
      if (value != 0) result.emplace_back(a->first, value);
      ++a;
      ++b;
    }
  }
  return result;
}

}  // namespace

std::size_t modular_rank(const std::vector<const IntegerPolynomial*>& rows, std::uint64_t degree) {
  std::map<Monomial, std::size_t, MonomialOrder> columns;
  std::map<std::size_t, SparseRow> pivots;  // by first column, where the value is 1
  for (const IntegerPolynomial* p : rows) {
    SparseRow row;
    for (const auto& [m, c] : p->terms) {
      if (moivre::degree(m) != degree) continue;
      const std::size_t column = columns.try_emplace(m, columns.size()).first->second;
      const std::uint64_t value = residue(c);
      if (value != 0) row.emplace_back(column, value);
    }
    std::sort(row.begin(), row.end());
    while (!row.empty()) {
      const auto pivot = pivots.find(row.front().first);
      if (pivot == pivots.end()) break;
      row = reduced(row, pivot->second, row.front().second);
    }
    if (row.empty()) continue;
    const std::uint64_t unit = inverse(row.front().second);
    for (auto& [column, value] : row) value = times(value, unit);
    pivots.emplace(row.front().first, std::move(row));
  }
  return pivots.size();
}

}  // namespace moivre
