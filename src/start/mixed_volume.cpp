// SPDX-License-Identifier: MIT
// Mixed volumes and stable mixed volumes from searches for cells.
#include "moivre/start/mixed_volume.h"

#include <algorithm>
#include <stdexcept>
#include <string>

#include "moivre/start/cell_geometry.h"
#include "random_lifting.h"

namespace moivre {

namespace {

MixedVolume volume_of(const CellSearch& search) {
  MixedVolume volume;
  volume.end = search.end;
  volume.steps = search.steps;
  if (search.subdivision) volume.value = search.subdivision->mixed_volume;
  return volume;
}

/// The options for what comes after `steps` of them.
CellSearchOptions what_is_left(CellSearchOptions options, std::uint64_t steps) {
  options.most_steps -= std::min(steps, options.most_steps);
  return options;
}

}  // namespace

MixedVolume mixed_volume(const std::vector<Support>& supports, std::uint64_t seed,
                         const CellSearchOptions& options) {
  return volume_of(mixed_cells(supports, seed, options));
}

MixedVolume verified_mixed_volume(const std::vector<Support>& supports, std::uint64_t seed,
                                  const CellSearchOptions& options) {
  const MixedVolume first = mixed_volume(supports, seed, options);
  if (!first.value) return first;
  // Any other seed: the liftings of two seeds have nothing in common.
  MixedVolume second = mixed_volume(supports, ~seed, what_is_left(options, first.steps));
  second.steps += first.steps;
  if (second.value && *second.value != *first.value) {
    throw std::logic_error("two liftings give mixed volumes " + std::to_string(*first.value) +
                           " and " + std::to_string(*second.value));
  }
  return second;
}

namespace {

enum class Stability { stable, unstable, too_low };

/// By the exact inner normal for the lifting 1 at added zeros, 0 elsewhere.
Stability stability(const MixedSubdivision& coarse, const MixedCell& cell) {
  const auto negative = [](const Rational& a) { return a < Rational(0); };
  const std::vector<Rational> slacks = exact_cell_weights(coarse, cell);
  if (std::any_of(slacks.begin(), slacks.end(), negative)) return Stability::too_low;
  const std::vector<Rational> normal = inner_normal(coarse, cell);
  return std::any_of(normal.begin(), normal.end(), negative) ? Stability::unstable
                                                             : Stability::stable;
}

Lifting heights(const SupportsWithOrigin& s, std::int64_t height) {
  Lifting lifting;
  for (std::size_t i = 0; i < s.supports.size(); ++i) {
    lifting.emplace_back(s.supports[i].terms.size(), 0);
    if (s.added[i]) lifting[i][s.origin[i]] = height;
  }
  return lifting;
}

Lifting sum(Lifting a, const Lifting& b) {
  for (std::size_t i = 0; i < a.size(); ++i) {
    for (std::size_t k = 0; k < a[i].size(); ++k) a[i][k] += b[i][k];
  }
  return a;
}

/// False: the height was too low.
bool keep_stable_cells(const SupportsWithOrigin& s, MixedSubdivision& found) {
  const MixedSubdivision coarse{s.supports, heights(s, 1), {}, 0};
  std::vector<MixedCell> stable;
  found.mixed_volume = 0;
  for (const MixedCell& cell : found.cells) {
    const Stability verdict = stability(coarse, cell);
    if (verdict == Stability::too_low) return false;
    if (verdict == Stability::unstable) continue;
    stable.push_back(cell);
    found.mixed_volume += cell.volume;
  }
  found.cells = std::move(stable);
  return true;
}

}  // namespace

CellSearch stable_mixed_cells(const std::vector<Support>& supports, std::uint64_t seed,
                              const CellSearchOptions& options) {
  check_square(supports);
  const SupportsWithOrigin s = with_origin(supports, supports.size());
  std::vector<std::size_t> sizes;
  for (const Support& support : s.supports) sizes.push_back(support.terms.size());
  // Slacks of a cell for the lifting 0/1 are multiples of 1/det: det times the random part's range
  // is high enough.
  const int first_bits = kLiftingBits + 10;
  const int most_bits = 62;
  CellSearch search;
  std::uint64_t steps = 0;
  std::uint64_t attempt = 0;
  for (int bits = first_bits; bits < most_bits; ++attempt) {
    const Lifting random = random_lifting(sizes, seed, LiftingPurpose::terms, attempt);
    const Lifting lifting = sum(heights(s, std::int64_t{1} << bits), random);
    search =
        mixed_cells_of_lifting(s.supports, lifting, seed + attempt, what_is_left(options, steps));
    steps += search.steps;
    search.steps = steps;
    if (search.end == CellSearchEnd::not_generic && attempt < kMostLiftings) continue;
    if (!search.subdivision || keep_stable_cells(s, *search.subdivision)) return search;
    bits += 4;
  }
  search.subdivision.reset();
  search.end = CellSearchEnd::too_large;
  return search;
}

MixedVolume stable_mixed_volume(const std::vector<Support>& supports, std::uint64_t seed,
                                const CellSearchOptions& options) {
  return volume_of(stable_mixed_cells(supports, seed, options));
}

}  // namespace moivre
