// SPDX-License-Identifier: MIT
// The search for mixed cells: liftings until one is generic, words until one is long enough.
#include "moivre/start/mixed_cells.h"

#include <algorithm>

#include "cell_search.h"
#include "cell_stages.h"
#include "moivre/numeric/invalid_input.h"
#include "random_lifting.h"

namespace moivre {

const char* description(CellSearchEnd end) {
  switch (end) {
    case CellSearchEnd::complete:
      return "complete";
    case CellSearchEnd::interrupted:
      return "interrupted";
    case CellSearchEnd::too_many_cells:
      return "more mixed cells than allowed";
    case CellSearchEnd::too_many_steps:
      return "more steps of the search for mixed cells than allowed";
    case CellSearchEnd::too_many_points:
      return "more points than a search for mixed cells keeps";
    case CellSearchEnd::too_large:
      return "a mixed volume beyond 2^63";
    case CellSearchEnd::not_generic:
      return "a lifting that is not generic";
  }
  return "";
}

namespace {

// A gigabyte: some three hundred unknowns.
constexpr std::uint64_t kMostPoints = std::uint64_t{1} << 24;

std::vector<std::size_t> sizes_of(const std::vector<Support>& supports) {
  std::vector<std::size_t> sizes;
  for (const Support& support : supports) sizes.push_back(support.terms.size());
  return sizes;
}

void check_shape(const std::vector<Support>& supports, const Lifting& lifting) {
  bool fits = lifting.size() == supports.size();
  for (std::size_t i = 0; fits && i < supports.size(); ++i) {
    fits = lifting[i].size() == supports[i].terms.size();
  }
  if (!fits) throw InvalidInput("the lifting has not one number for every term");
}

/// The subdivision of supports that need no search.
bool is_trivial(const std::vector<Support>& supports, MixedSubdivision& subdivision) {
  if (supports.empty()) {
    subdivision.cells = {MixedCell{{}, 1}};
    subdivision.mixed_volume = 1;
    return true;
  }
  return std::any_of(supports.begin(), supports.end(),
                     [](const Support& support) { return support.terms.size() < 2; });
}

template <class Word>
CellSearchEnd walk(const CellStages& stages, const std::vector<std::size_t>& sizes,
                   const CellSearchOptions& options, std::uint64_t& steps,
                   MixedSubdivision& subdivision) {
  CellWalk<Word> cells(stages, sizes, options, steps);
  const CellSearchEnd end = cells.run();
  subdivision.cells = std::move(cells.cells());
  subdivision.mixed_volume = cells.volume();
  return end;
}

CellSearchEnd walk_in_any_word(const CellStages& stages, const CellSearchOptions& options,
                               std::uint64_t& steps, MixedSubdivision& subdivision) {
  std::vector<std::size_t> sizes;
  for (const std::size_t support : stages.order) {
    sizes.push_back(subdivision.supports[support].terms.size());
  }
  return in_shortest_word(
      [&](auto word) { return walk<decltype(word)>(stages, sizes, options, steps, subdivision); });
}

CellSearchEnd searched(const std::vector<Support>& supports, const Lifting& lifting,
                       std::uint64_t seed, const CellSearchOptions& options, std::uint64_t& steps,
                       MixedSubdivision& subdivision) {
  if (points_of_stages(supports) > kMostPoints) return CellSearchEnd::too_many_points;
  const auto stages = make_stages(supports, lifting, seed, options.stop);
  if (!stages) return CellSearchEnd::interrupted;
  return walk_in_any_word(*stages, options, steps, subdivision);
}

}  // namespace

CellSearch mixed_cells_of_lifting(const std::vector<Support>& supports, const Lifting& lifting,
                                  std::uint64_t seed, const CellSearchOptions& options) {
  check_square(supports);
  check_shape(supports, lifting);
  CellSearch search;
  MixedSubdivision subdivision{supports, lifting, {}, 0};
  if (!is_trivial(supports, subdivision)) {
    try {
      search.end = searched(supports, lifting, seed, options, search.steps, subdivision);
    } catch (const NotGeneric&) {
      search.end = CellSearchEnd::not_generic;
    }
  }
  if (search.end != CellSearchEnd::complete) return search;
  std::sort(subdivision.cells.begin(), subdivision.cells.end(),
            [](const MixedCell& a, const MixedCell& b) { return a.edges < b.edges; });
  search.subdivision = std::move(subdivision);
  return search;
}

CellSearch mixed_cells(const std::vector<Support>& supports, std::uint64_t seed,
                       const CellSearchOptions& options) {
  check_square(supports);
  CellSearch search;
  std::uint64_t steps = 0;
  for (std::uint64_t attempt = 0; attempt < kMostLiftings; ++attempt) {
    const Lifting lifting =
        random_lifting(sizes_of(supports), seed, LiftingPurpose::terms, attempt);
    CellSearchOptions left = options;
    left.most_steps -= std::min(steps, left.most_steps);
    search = mixed_cells_of_lifting(supports, lifting, seed + attempt, left);
    steps += search.steps;
    if (search.end != CellSearchEnd::not_generic) break;
  }
  search.steps = steps;
  return search;
}

}  // namespace moivre
