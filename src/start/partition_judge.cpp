// SPDX-License-Identifier: MIT
// Numbers of partitions, each found once; degrees by group, each found once.
#include "partition_judge.h"

#include <algorithm>
#include <limits>

#include "exponent_table.h"

namespace moivre {
namespace {

/// Looking for monomials that divide another takes the square of their number; longer equations are
/// left as they are.
constexpr std::size_t kThinnedTerms = 1000;

bool divides(const Monomial& a, const Monomial& b) {
  auto q = b.begin();
  for (const Power& p : a) {
    while (q != b.end() && q->variable < p.variable) ++q;
    if (q == b.end() || q->variable != p.variable || q->exponent < p.exponent) return false;
  }
  return true;
}

std::vector<Monomial> largest_monomials(const Polynomial& p) {
  std::vector<Monomial> kept;
  for (const Term& term : p.terms) {  // a divisor stands behind its multiples
    const bool is_spare = p.terms.size() <= kThinnedTerms &&
                          std::any_of(kept.begin(), kept.end(),
                                      [&](const Monomial& m) { return divides(term.monomial, m); });
    if (!is_spare) kept.push_back(term.monomial);
  }
  return kept;
}

}  // namespace

PartitionJudge::PartitionJudge(const System& f) : unknowns_(f.variables.size()) {
  for (const Polynomial& p : f.polynomials) supports_.push_back(largest_monomials(p));
}

const std::vector<std::uint64_t>& PartitionJudge::column(const std::vector<std::uint32_t>& group) {
  const auto [place, is_new] = columns_.try_emplace(group);
  if (!is_new) return place->second;
  std::vector<bool> holds(unknowns_, false);
  for (const std::uint32_t v : group) holds[v] = true;
  for (const std::vector<Monomial>& support : supports_) {
    std::uint64_t degree = 0;
    for (const Monomial& m : support) {
      std::uint64_t sum = 0;
      for (const Power& power : m) sum += holds[power.variable] ? power.exponent : 0;
      degree = std::max(degree, sum);
      work_ += m.size();
    }
    place->second.push_back(degree);
  }
  return place->second;
}

double PartitionJudge::fresh_number(const Partition& groups) {
  ++tried_;
  work_ += std::max(kOverhead, kOverheadOfUnknown * unknowns_);
  const auto shape = exponent_table(groups);
  if (!shape) return std::numeric_limits<double>::infinity();
  std::vector<const std::vector<std::uint64_t>*> degrees;
  for (const auto& group : groups) degrees.push_back(&column(group));
  work_ += shape->entries * groups.size();
  return completions(
             *shape, 1.0, [&](std::uint64_t i, std::size_t j) { return (*degrees[j])[i]; },
             [](std::uint64_t d, double count) { return static_cast<double>(d) * count; },
             [](double a, double b) { return a + b; })
      .back();
}

void PartitionJudge::keep_best(const Partition& groups, double number) {
  const bool is_better =
      best_.empty() || number < least_ || (number == least_ && groups.size() < best_.size());
  if (!is_better) return;
  best_ = groups;
  least_ = number;
}

void PartitionJudge::try_once(const Partition& groups) { keep_best(groups, fresh_number(groups)); }

double PartitionJudge::number(const Partition& groups) {
  const auto [place, is_new] = numbers_.try_emplace(groups, 0.0);
  if (is_new) {
    place->second = fresh_number(groups);
    keep_best(groups, place->second);
  } else if (kOverheadOfUnknown * unknowns_ > kOverhead) {
    work_ += kOverheadOfUnknown * unknowns_;
  }
  return place->second;
}

}  // namespace moivre
