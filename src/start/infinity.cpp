// SPDX-License-Identifier: MIT
// Leading forms on every set of unknowns, and the rank of random vectors from their spans.
#include "moivre/start/infinity.h"

#include <algorithm>
#include <numeric>

#include "moivre/numeric/random.h"

namespace moivre {
namespace {

// A Mersenne prime: its field is all that the ranks need.
constexpr std::uint64_t kPrime = (std::uint64_t{1} << 61) - 1;
constexpr std::uint64_t kSeed = 1;

using Row = std::vector<std::uint64_t>;

std::uint64_t times(std::uint64_t a, std::uint64_t b) {
  __extension__ using Wide = unsigned __int128;
  return static_cast<std::uint64_t>(static_cast<Wide>(a) * b % kPrime);
}

std::uint64_t inverse(std::uint64_t a) {
  std::uint64_t result = 1;
  for (std::uint64_t e = kPrime - 2; e > 0; e >>= 1) {
    if (e & 1) result = times(result, a);
    a = times(a, a);
  }
  return result;
}

/// Of independent rows; brings them to echelon form on the way.
bool are_independent(std::vector<Row>& rows, std::size_t columns) {
  std::size_t rank = 0;
  for (std::size_t j = 0; j < columns && rank < rows.size(); ++j) {
    const auto pivot = std::find_if(rows.begin() + static_cast<std::ptrdiff_t>(rank), rows.end(),
                                    [&](const Row& row) { return row[j] != 0; });
    if (pivot == rows.end()) continue;
    std::swap(rows[rank], *pivot);
    const std::uint64_t scale = inverse(rows[rank][j]);
    for (std::size_t i = rank + 1; i < rows.size(); ++i) {
      const std::uint64_t factor = times(rows[i][j], scale);
      if (factor == 0) continue;
      for (std::size_t k = j; k < columns; ++k) {
        rows[i][k] = (rows[i][k] + kPrime - times(factor, rows[rank][k])) % kPrime;
      }
    }
    ++rank;
  }
  return rank == rows.size();
}

/// A term of highest degree and the set of its unknowns.
struct LeadingTerm {
  const Exponents* exponents;
  std::uint32_t unknowns;
};

std::vector<LeadingTerm> leading_terms(const Support& support) {
  const auto degree = [](const Exponents& a) {
    return std::accumulate(a.begin(), a.end(), std::uint64_t{0});
  };
  std::uint64_t highest = 0;
  for (const Exponents& a : support.terms) highest = std::max(highest, degree(a));
  std::vector<LeadingTerm> terms;
  for (const Exponents& a : support.terms) {
    if (degree(a) < highest) continue;
    std::uint32_t unknowns = 0;
    for (std::size_t j = 0; j < a.size(); ++j) unknowns |= (a[j] > 0 ? 1U : 0U) << j;
    terms.push_back({&a, unknowns});
  }
  return terms;
}

/// A random vector of the span of the differences of the terms within `set`; empty where there is
/// no such term.
Row random_difference(const std::vector<LeadingTerm>& terms, std::uint32_t set, std::uint64_t row,
                      std::size_t n) {
  const Exponents* first = nullptr;
  Row sum(n);
  for (std::size_t k = 0; k < terms.size(); ++k) {
    if ((terms[k].unknowns & ~set) != 0) continue;
    const Exponents& a = *terms[k].exponents;
    if (first == nullptr) {
      first = &a;
      continue;
    }
    const std::uint64_t share =
        random_bits(kSeed, RandomStream::leading_forms, (row << 32) + k) % kPrime;
    for (std::size_t j = 0; j < n; ++j) {
      const std::uint64_t difference = (a[j] + kPrime - (*first)[j]) % kPrime;
      sum[j] = (sum[j] + times(share, difference)) % kPrime;
    }
  }
  return first == nullptr ? Row() : sum;
}

}  // namespace

std::optional<bool> meets_infinity(const std::vector<Support>& supports) {
  check_square(supports);
  const std::size_t n = supports.size();
  if (n > kMostUnknowns) return std::nullopt;
  std::vector<std::vector<LeadingTerm>> leading;
  for (const Support& support : supports) leading.push_back(leading_terms(support));
  for (std::uint32_t set = 1; set < (1U << n); ++set) {
    std::vector<Row> rows;
    for (std::size_t i = 0; i < n; ++i) {
      Row row = random_difference(leading[i], set, i, n);
      if (!row.empty()) rows.push_back(std::move(row));
    }
    if (are_independent(rows, n)) return true;
  }
  return false;
}

}  // namespace moivre
