// SPDX-License-Identifier: MIT
// The bounds one after the other, the dearest last.
#include "moivre/bounds/root_bounds.h"

#include <algorithm>

#include "moivre/algebra/quotient_ring.h"
#include "moivre/expression/counted.h"
#include "moivre/numeric/invalid_input.h"
#include "moivre/polynomial/eliminate.h"
#include "moivre/start/mixed_volume.h"
#include "moivre/start/multihomogeneous.h"
#include "moivre/start/strata.h"

namespace moivre {
namespace {

// The search for cells of one lifting may cost so many multiply-adds: a few seconds.
constexpr std::uint64_t kCellWork = 4'000'000'000;
// A step costs about so many of them for each unknown and term (start/mixed_cells.h).
constexpr std::uint64_t kStepCost = 10;
// Terms that the algebra may look at: less than a second.
constexpr std::uint64_t kAlgebraTerms = 20'000'000;
// Any two seeds: what they draw has nothing in common. The first one draws the prime of the algebra
// too.
constexpr std::uint64_t kLiftingSeeds[] = {101, 202};

CellSearchOptions bounded(const System& f, const std::atomic<bool>* stop) {
  CellSearchOptions options;
  options.stop = stop;
  options.most_steps =
      kCellWork / (kStepCost * std::max<std::uint64_t>(1, f.variables.size() * term_count(f)));
  return options;
}

RootBound stable_mixed_volume_bound(const System& f, const std::atomic<bool>* stop) {
  RootBound bound{BoundKind::stable_mixed_volume, std::nullopt, ""};
  const std::vector<Support> supports = supports_of(f);
  std::optional<std::uint64_t> first;
  for (const std::uint64_t seed : kLiftingSeeds) {
    const MixedVolume volume = stable_mixed_volume(supports, seed, bounded(f, stop));
    if (!volume.value) {
      bound.missing = description(volume.end);
      return bound;
    }
    if (first && *first != *volume.value) {
      bound.missing =
          "two liftings give " + std::to_string(*first) + " and " + std::to_string(*volume.value);
      return bound;
    }
    first = volume.value;
  }
  bound.value = first;
  return bound;
}

RootBound quotient_ring_bound(const System& f, std::uint64_t known, const std::atomic<bool>* stop) {
  RootBound bound{BoundKind::quotient_ring, std::nullopt, ""};
  const QuotientRing ring = quotient_ring(f, {known, kAlgebraTerms, stop, false, kLiftingSeeds[0]});
  switch (ring.verdict) {
    case QuotientRing::Verdict::finite:
      bound.value = ring.dimension;
      break;
    case QuotientRing::Verdict::infinite:
      bound.missing = "infinite: some roots lie on curves";
      break;
    case QuotientRing::Verdict::not_found:
      bound.missing = "not found within the terms that are looked at";
      break;
  }
  return bound;
}

RootBound strata_bound(const System& f, const std::atomic<bool>* stop) {
  RootBound bound{BoundKind::strata, std::nullopt, ""};
  bound.value = most_isolated_points(f, kLiftingSeeds[0], bounded(f, stop));
  if (!bound.value) bound.missing = "a stratum of which nothing is known";
  return bound;
}

RootBound bezout(const System& f) {
  RootBound bound{BoundKind::bezout, total_degree(degrees(f)), ""};
  if (!bound.value) bound.missing = "beyond 64 bits";
  return bound;
}

RootBound multihomogeneous(const System& f) {
  RootBound bound{BoundKind::multihomogeneous, find_partition(f).paths, ""};
  if (!bound.value) bound.missing = "beyond 64 bits, or too many groups";
  return bound;
}

/// The smaller one; one that is there before one that is not.
RootBound smaller(const RootBound& a, const RootBound& b) {
  if (!a.value || !b.value) return a.value ? a : b;
  return *b.value < *a.value ? b : a;
}

void require_square(const System& f) {
  require_unbroken(broken_rules(f));
  if (f.polynomials.size() == f.variables.size()) return;
  throw InvalidInput("bounds on roots are those of square systems; this one has " +
                     counted(f.polynomials.size(), "equation") + " in " +
                     counted(f.variables.size(), "unknown"));
}

}  // namespace

std::string to_string(BoundKind kind) {
  switch (kind) {
    case BoundKind::elimination:
      return "elimination";
    case BoundKind::bezout:
      return "Bezout";
    case BoundKind::multihomogeneous:
      return "multihomogeneous";
    case BoundKind::mixed_volume:
      return "mixed volume";
    case BoundKind::stable_mixed_volume:
      return "stable mixed volume";
    case BoundKind::quotient_ring:
      return "dimension of the quotient ring";
    case BoundKind::strata:
      return "mixed volume of the strata";
  }
  return "";
}

std::string name_in_results(BoundKind kind) {
  switch (kind) {
    case BoundKind::bezout:
      return "total degree";
    case BoundKind::multihomogeneous:
      return "multihomogeneous number";
    case BoundKind::elimination:
    case BoundKind::mixed_volume:
    case BoundKind::stable_mixed_volume:
    case BoundKind::quotient_ring:
    case BoundKind::strata:
      break;
  }
  return to_string(kind);
}

std::optional<BoundKind> bound_named(const std::string& name) {
  using enum BoundKind;
  for (const BoundKind kind : {elimination, bezout, multihomogeneous, mixed_volume,
                               stable_mixed_volume, quotient_ring, strata}) {
    if (name_in_results(kind) == name) return kind;
  }
  return std::nullopt;
}

Certainty certainty_of(BoundKind kind) {
  switch (kind) {
    case BoundKind::elimination:
    case BoundKind::bezout:
    case BoundKind::multihomogeneous:
      return Certainty::theorem;
    case BoundKind::mixed_volume:
    case BoundKind::stable_mixed_volume:
    case BoundKind::strata:
      return Certainty::two_liftings;
    case BoundKind::quotient_ring:
      break;
  }
  return Certainty::drawn_prime;
}

std::string to_string(Certainty certainty) {
  switch (certainty) {
    case Certainty::theorem:
      return "theorem";
    case Certainty::two_liftings:
      return "two liftings";
    case Certainty::drawn_prime:
      return "drawn prime";
  }
  return "";
}

std::vector<RootBound> root_bounds(const System& f, const KnownRoots& known,
                                   const std::atomic<bool>* stop) {
  require_square(f);
  const Reduction reduction = eliminate(f, stop);
  if (reduction.verdict == Reduction::Verdict::solved) return {{BoundKind::elimination, 1, ""}};
  // A contradiction leaves no root, a dependence none that is isolated.
  if (reduction.verdict != Reduction::Verdict::square) {
    return {{BoundKind::elimination, 0, ""}};
  }
  const System& r = reduction.system;
  std::vector<RootBound> bounds;
  const auto is_met = [&](const RootBound& bound) {
    bounds.push_back(bound);
    return bound.value && *bound.value <= known.count(bound.kind);
  };
  if (is_met(bezout(r)) || is_met(multihomogeneous(r))) return bounds;
  RootBound volume = stable_mixed_volume_bound(r, stop);
  // What elimination fills with monomials may have a larger volume than before.
  const bool is_filled = !reduction.substitutions.empty();
  if (is_filled && (!volume.value || *volume.value > known.roots)) {
    volume = smaller(volume, stable_mixed_volume_bound(f, stop));
  }
  if (is_met(volume) || is_met(quotient_ring_bound(r, known.roots, stop))) return bounds;
  // A linear change of unknowns keeps the roots, and may shrink the polytopes.
  if (const auto pairs = isotropic_pairs(r); !pairs.empty()) {
    const RootBound isotropic = stable_mixed_volume_bound(in_isotropic(r, pairs), stop);
    const bool is_less = isotropic.value && (!volume.value || *isotropic.value < *volume.value);
    if (is_less && is_met(isotropic)) return bounds;
  }
  if (lacks_origin(f)) bounds.push_back(strata_bound(f, stop));
  return bounds;
}

RootBound root_bound(const System& f, BoundKind kind, const KnownRoots& known,
                     const std::atomic<bool>* stop) {
  require_square(f);
  switch (kind) {
    case BoundKind::elimination:
      break;
    case BoundKind::bezout:
      return bezout(f);
    case BoundKind::multihomogeneous:
      return multihomogeneous(f);
    case BoundKind::mixed_volume:
    case BoundKind::stable_mixed_volume:
      return stable_mixed_volume_bound(f, stop);
    case BoundKind::quotient_ring:
      return quotient_ring_bound(f, known.roots, stop);
    case BoundKind::strata:
      return strata_bound(f, stop);
  }
  return {kind, std::nullopt, "elimination leaves equations"};
}

StructureCounts structure_counts(const System& f, bool with_partitions, bool with_cells,
                                 const std::atomic<bool>* stop) {
  require_square(f);
  StructureCounts counts;
  if (with_partitions) {
    const PartitionSearch search = find_partition(f);
    counts.multihomogeneous = search.paths;
    counts.is_least = search.is_least;
  }
  if (with_cells) {
    const auto supports = with_origin(supports_of(f), f.variables.size()).supports;
    counts.mixed_volume = mixed_volume(supports, kLiftingSeeds[0], bounded(f, stop)).value;
  }
  return counts;
}

}  // namespace moivre
