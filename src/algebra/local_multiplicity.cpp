// SPDX-License-Identifier: MIT
// The system moved to the root, its multiples by monomials as rows, columns by ascending degree.
#include "moivre/algebra/local_multiplicity.h"

#include <algorithm>
#include <stdexcept>

#include "local_polynomial.h"
#include "moivre/polynomial/modular.h"

namespace moivre {
namespace {

// Columns of the largest matrix: dense rows of so many numbers are reduced in a tenth of a second.
constexpr std::size_t kMostColumns = 500;
// Of a term: powers are multiplied out one by one.
constexpr std::uint64_t kMostDegree = 1000;

class Macaulay {
 public:
  /// Up to degree k.
  Macaulay(const PrimeField& field, const System& f, const std::vector<Residue>& x, std::uint64_t k)
      : field_(field), k_(k), monomials_(monomials(x.size(), k, kMostColumns)) {
    for (std::size_t c = 0; c < monomials_.size(); ++c) column_[monomials_[c]] = c;
    for (const Polynomial& p : f.polynomials) {
      rows_.push_back(
          moved(field, p, x, k, [&](const Coefficient& c) { return field.residue(c); }));
    }
  }

  std::size_t columns() const { return monomials_.size(); }
  bool has_root() const {
    return std::all_of(rows_.begin(), rows_.end(), [](const LocalPolynomial<Residue>& p) {
      return p.empty() || degree(p.begin()->first) > 0;
    });
  }

  /// Up to the least j <= k with dim D_j = dim D_{j-1}, or to k where there is none.
  LocalRing ring() const {
    ModularRows reduced(field_);
    std::vector<std::uint64_t> dimension(k_ + 1);  // first columns of each degree that no row has
    for (const Exponents& m : monomials_) ++dimension[degree(m)];
    for (const Exponents& factor : monomials_) {
      for (const LocalPolynomial<Residue>& p : rows_) {
        const auto first = reduced.add(multiple(factor, p));
        if (first) --dimension[degree(monomials_[*first])];
      }
    }
    LocalRing ring;
    for (const std::uint64_t more : dimension) {
      if (more == 0) {
        ring.is_isolated = true;
        return ring;
      }
      ring.dimension += more;
    }
    ring.grows_steadily = dimension[k_] == dimension[k_ - 1] && dimension[k_] < k_;
    return ring;
  }

 private:
  ModularRow multiple(const Exponents& factor, const LocalPolynomial<Residue>& p) const {
    ModularRow row;
    for (const auto& [m, c] : p) {
      if (degree(m) + degree(factor) > k_) break;
      Exponents product = m;
      for (std::size_t j = 0; j < product.size(); ++j) product[j] += factor[j];
      row.emplace_back(column_.at(product), c);
    }
    std::sort(row.begin(), row.end());
    return row;
  }

  PrimeField field_;
  std::uint64_t k_;
  std::vector<Exponents> monomials_;
  std::map<Exponents, std::size_t, LocalOrder> column_;
  std::vector<LocalPolynomial<Residue>> rows_;
};

/// The least degree from k on with at least so many monomials in n unknowns, or the last one with
/// no more than kMostColumns; nullopt where k has more. One matrix tells dim D_j of every j up to
/// its degree: where each has twice the columns of the one before, all cost about as much as the
/// last.
std::optional<std::uint64_t> next_degree(std::size_t n, std::uint64_t k, std::size_t columns) {
  // (n + k choose n), by one more factor each.
  const auto count = [n](std::uint64_t d) {
    std::uint64_t product = 1;
    for (std::uint64_t j = 1; j <= n && product <= kMostColumns; ++j) {
      product = product * (d + j) / j;
    }
    return product;
  };
  if (count(k) > kMostColumns) return std::nullopt;
  while (count(k) < columns && count(k + 1) <= kMostColumns) ++k;
  return k;
}

}  // namespace

std::optional<LocalRing> local_ring(const System& f, const std::vector<Coefficient>& x) {
  for (const std::uint64_t d : degrees(f)) {
    if (d > kMostDegree) return std::nullopt;
  }
  const PrimeField field(f);
  std::vector<Residue> root;
  for (const Coefficient& xi : x) root.push_back(field.residue(xi));
  std::optional<LocalRing> ring;
  std::size_t columns = 0;
  for (std::uint64_t k = 2;; ++k) {
    const auto next = next_degree(x.size(), k, 2 * columns);
    if (!next) return ring;
    k = *next;
    const Macaulay macaulay(field, f, root, k);
    if (!macaulay.has_root()) return std::nullopt;
    ring = macaulay.ring();
    if (ring->is_isolated) return ring;
    columns = macaulay.columns();
  }
}

std::optional<std::uint64_t> local_multiplicity(const System& f,
                                                const std::vector<Coefficient>& x) {
  const std::optional<LocalRing> ring = local_ring(f, x);
  return ring && ring->is_isolated ? std::optional(ring->dimension) : std::nullopt;
}

}  // namespace moivre
