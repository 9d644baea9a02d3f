// SPDX-License-Identifier: MIT
// Inner normals and weights of mixed cells, from the edges alone, in exact integers.
#include "moivre/start/cell_geometry.h"

#include <algorithm>
#include <limits>

#include "exact_inverse.h"
#include "exact_word.h"
#include "moivre/numeric/integer.h"
#include "moivre/numeric/invalid_input.h"

namespace moivre {

namespace {

/// Of det > 0 and integers: alpha = normal / det, w = slacks / det.
template <class Word>
struct ScaledGeometry {
  Word det;
  std::vector<Word> normal;
  std::vector<Word> slacks;
};

void check_cell(const MixedSubdivision& subdivision, const MixedCell& cell) {
  bool fits = cell.edges.size() == subdivision.supports.size();
  for (std::size_t i = 0; fits && i < cell.edges.size(); ++i) {
    const std::size_t terms = subdivision.supports[i].terms.size();
    fits = cell.edges[i][0] < terms && cell.edges[i][1] < terms;
  }
  if (!fits) throw InvalidInput("the cell is not one of these supports");
}

template <class Word>
std::vector<Word> scaled_normal_of(const MixedSubdivision& s, const MixedCell& cell,
                                   const ScaledInverse<Word>& v) {
  const std::size_t n = s.supports.size();
  std::vector<Word> normal(n, Word(0));
  for (std::size_t i = 0; i < n; ++i) {
    const Int128 fall = Int128{s.lifting[i][cell.edges[i][0]]} - s.lifting[i][cell.edges[i][1]];
    const double bound = std::abs(approximate(fall)) * magnitude(v.inverse);
    require_room(Word(), static_cast<double>(n) * bound);
    for (std::size_t j = 0; j < n; ++j) normal[j] += v.inverse[j * n + i] * as_word<Word>(fall);
  }
  return normal;
}

template <class Word>
Word height(const Word& det, const std::vector<Word>& normal, const Exponents& term,
            std::int64_t lifting) {
  double bound = approximate(det) * std::abs(static_cast<double>(lifting));
  for (std::size_t j = 0; j < term.size(); ++j) bound += std::abs(approximate(normal[j])) * term[j];
  require_room(Word(), 2 * bound);
  Word sum = det * Word(lifting);
  for (std::size_t j = 0; j < term.size(); ++j) sum += normal[j] * Word(std::int64_t{term[j]});
  return sum;
}

template <class Word>
ScaledGeometry<Word> scaled_geometry(const MixedSubdivision& s, const MixedCell& cell) {
  const std::size_t n = s.supports.size();
  const std::vector<std::int64_t> v = edge_matrix(s, cell);
  const auto inverse = scaled_inverse<Word>(v, n);
  if (!inverse) throw InvalidInput("the cell has no volume");
  ScaledGeometry<Word> geometry{inverse->det, scaled_normal_of(s, cell, *inverse), {}};
  for (std::size_t i = 0; i < n; ++i) {
    const std::vector<Exponents>& terms = s.supports[i].terms;
    const auto height_of = [&](std::size_t k) {
      return height(geometry.det, geometry.normal, terms[k], s.lifting[i][k]);
    };
    const Word least = height_of(cell.edges[i][0]);
    for (std::size_t k = 0; k < terms.size(); ++k) geometry.slacks.push_back(height_of(k) - least);
  }
  return geometry;
}

template <class Word>
std::vector<Rational> ratios(const std::vector<Word>& numerators, const Word& denominator) {
  std::vector<Rational> result;
  for (const Word& a : numerators) result.push_back(ratio(to_integer(a), to_integer(denominator)));
  return result;
}

/// a/d rounded once.
template <class Word>
double rounded(const Word& a, const Word& d) {
  const double exact_in_double = 0x1p53;
  if (std::abs(approximate(a)) < exact_in_double && approximate(d) < exact_in_double) {
    return approximate(a) / approximate(d);
  }
  return to_double(ratio(to_integer(a), to_integer(d)));
}

}  // namespace

std::vector<std::int64_t> edge_matrix(const MixedSubdivision& subdivision, const MixedCell& cell) {
  check_cell(subdivision, cell);
  std::vector<std::int64_t> v;
  for (std::size_t i = 0; i < cell.edges.size(); ++i) {
    const Exponents& a = subdivision.supports[i].terms[cell.edges[i][0]];
    const Exponents& b = subdivision.supports[i].terms[cell.edges[i][1]];
    for (std::size_t j = 0; j < a.size(); ++j) v.push_back(std::int64_t{b[j]} - a[j]);
  }
  return v;
}

std::vector<Rational> inner_normal(const MixedSubdivision& subdivision, const MixedCell& cell) {
  return in_shortest_word([&](auto word) {
    const auto geometry = scaled_geometry<decltype(word)>(subdivision, cell);
    return ratios(geometry.normal, geometry.det);
  });
}

std::vector<Rational> exact_cell_weights(const MixedSubdivision& subdivision,
                                         const MixedCell& cell) {
  return in_shortest_word([&](auto word) {
    const auto geometry = scaled_geometry<decltype(word)>(subdivision, cell);
    return ratios(geometry.slacks, geometry.det);
  });
}

std::vector<double> cell_weights(const MixedSubdivision& subdivision, const MixedCell& cell) {
  return in_shortest_word([&](auto word) {
    const auto geometry = scaled_geometry<decltype(word)>(subdivision, cell);
    std::vector<double> weights;
    for (const auto& w : geometry.slacks) weights.push_back(rounded(w, geometry.det));
    return weights;
  });
}

double least_positive_weight(std::span<const double> weights) {
  double least = std::numeric_limits<double>::infinity();
  for (const double w : weights) {
    if (w > 0) least = std::min(least, w);
  }
  return least;
}

}  // namespace moivre
