// SPDX-License-Identifier: MIT
// The bounds of module bounds on a member, and its quotient ring.
#include "known_counts.h"

#include "moivre/algebra/quotient_ring.h"

namespace moivre {
namespace {

/// With z x_1 ... x_n - 1: no coordinate of a root is 0.
System without_zeros(System f) {
  const std::size_t n = f.variables.size();
  TermMap terms;
  Monomial product;
  for (std::size_t j = 0; j <= n; ++j) product.push_back({static_cast<std::uint32_t>(j), 1});
  terms[product] = Coefficient{1, 0};
  terms[{}] = Coefficient{-1, 0};
  f.variables.emplace_back("z");
  f.polynomials.push_back(to_polynomial(std::move(terms)));
  return f;
}

}  // namespace

KnownCounts known_counts(const Family& family, const Point& p, const std::atomic<bool>* stop) {
  const std::uint64_t roots = family.roots.size();
  const System member = member_system(family, exact_values(p));
  KnownCounts known;
  for (const RootBound& bound : root_bounds(member, {roots, roots}, stop)) {
    if (bound.value == roots) {
      known.met = MetBound{bound.kind, roots};
    }
    if (bound.kind == BoundKind::quotient_ring && !family.nonzero) known.by_algebra = bound.value;
  }
  return known;
}

std::optional<std::uint64_t> roots_by_algebra(const Family& family, const Point& p) {
  System member = member_system(family, exact_values(p));
  if (family.nonzero) member = without_zeros(std::move(member));
  const QuotientRing ring = quotient_ring(member, {.known = family.roots.size()});
  if (ring.verdict != QuotientRing::Verdict::finite) return std::nullopt;
  return ring.dimension;
}

}  // namespace moivre
