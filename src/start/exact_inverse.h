// SPDX-License-Identifier: MIT
// What is the inverse of an integer matrix, exactly? Its determinant and its adjugate, without
// fractions.
//
//   V: n x n, row by row;  det = |det V|;  inverse = det V^{-1}, integers, row by row.
// Jordan's elimination of (V | 1) in which every number is a minor of it: divisions leave no
// remainder [Bareiss68].
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "exact_word.h"

namespace moivre {

template <class Word>
struct ScaledInverse {
  Word det = 1;
  std::vector<Word> inverse;
};

/// nullopt where det V = 0. Throws WordTooShort.
template <class Word>
std::optional<ScaledInverse<Word>> scaled_inverse(std::span<const std::int64_t> v, std::size_t n) {
  const std::size_t width = 2 * n;
  std::vector<Word> m(n * width, Word(0));
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t j = 0; j < n; ++j) m[i * width + j] = Word(v[i * n + j]);
    m[i * width + n + i] = 1;
  }
  require_room(Word(), magnitude(m));
  Word last = 1;  // the pivot before, positive
  for (std::size_t k = 0; k < n; ++k) {
    std::size_t row = k;
    while (row < n && m[row * width + k] == 0) ++row;
    if (row == n) return std::nullopt;
    Word* const pivot = &m[k * width];
    if (row != k) std::swap_ranges(pivot, pivot + width, &m[row * width]);
    const bool negative = pivot[k] < 0;
    for (std::size_t j = 0; negative && j < width; ++j) pivot[j] = -pivot[j];
    const Word p = pivot[k];
    const ExactDivisor<Word> divisor(last);
    for (std::size_t i = 0; i < n; ++i) {
      if (i == k) continue;
      const Word q = m[i * width + k];
      eliminate(p, &m[i * width], pivot, q, width, divisor);
    }
    last = p;
  }
  ScaledInverse<Word> result;
  result.det = last;
  for (std::size_t i = 0; i < n; ++i) {
    result.inverse.insert(result.inverse.end(), &m[i * width + n], &m[i * width] + width);
  }
  return result;
}

}  // namespace moivre
