// SPDX-License-Identifier: MIT
// Sums of two sorted lists.
#include "moivre/polynomial/number_errors.h"

#include <cmath>
#include <utility>

namespace moivre {

void add(NumberErrors& sum, const Complex& factor, const NumberErrors& errors) {
  NumberErrors result;
  result.reserve(sum.size() + errors.size());
  auto next = sum.begin();
  for (const NumberError& e : errors) {
    while (next != sum.end() && next->number < e.number) result.push_back(*next++);
    const bool is_there = next != sum.end() && next->number == e.number;
    const Complex before = is_there ? (next++)->change : Complex(0);
    result.push_back({e.number, before + factor * e.change});
  }
  result.insert(result.end(), next, sum.end());
  sum = std::move(result);
}

double bound(const NumberErrors& errors) {
  double sum = 0;
  for (const NumberError& e : errors) sum += std::abs(e.change);
  return sum;
}

}  // namespace moivre
