// SPDX-License-Identifier: MIT
// Sparse Gaussian elimination modulo a prime.
#include "moivre/polynomial/modular.h"

#include <algorithm>

namespace moivre {

ModularRow ModularRows::sparse(const std::vector<WideSum>& values, std::size_t first) const {
  ModularRow row;
  for (std::size_t column = first; column < values.size(); ++column) {
    const Residue value = field_.reduced(values[column]);
    if (value != 0) row.emplace_back(column, value);
  }
  return row;
}

// Products are summed up as they are, and reduced before they are too many, or looked at.
ModularRow ModularRows::rest_of(const ModularRow& row) const {
  if (row.empty()) return {};
  std::vector<WideSum> rest(std::max(pivots_.size(), row.back().first + 1));
  for (const auto& [column, value] : row) rest[column] = value;
  std::size_t first = row.front().first;
  int products = 0;
  for (; first < rest.size(); ++first) {
    const Residue leading = field_.reduced(rest[first]);
    if (leading == 0) continue;
    if (first >= pivots_.size() || pivots_[first].empty()) break;
    if (++products > PrimeField::kMostProducts) {
      for (std::size_t column = first; column < rest.size(); ++column) {
        rest[column] = field_.reduced(rest[column]);
      }
      products = 1;
    }
    const WideSum multiple = field_.minus(leading);
    for (const auto& [column, value] : pivots_[first]) rest[column] += multiple * value;
  }
  return sparse(rest, first);
}

std::optional<std::size_t> ModularRows::add(const ModularRow& row) {
  ModularRow left = rest_of(row);
  if (left.empty()) return std::nullopt;
  const Residue unit = field_.inverse(left.front().second);
  for (auto& [column, value] : left) value = field_.times(value, unit);
  const std::size_t first = left.front().first;
  if (pivots_.size() <= left.back().first) pivots_.resize(left.back().first + 1);
  pivots_[first] = std::move(left);
  ++rank_;
  return first;
}

}  // namespace moivre
