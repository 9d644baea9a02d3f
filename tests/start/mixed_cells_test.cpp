// SPDX-License-Identifier: MIT
// Are the cells found mixed cells, are they all, and is what cannot be computed said and not
// guessed?
#include "moivre/start/mixed_cells.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <stdexcept>

#include "families.h"
#include "moivre/numeric/random.h"
#include "moivre/start/cell_geometry.h"

namespace moivre {
namespace {

MixedSubdivision found(const std::vector<Support>& supports, std::uint64_t seed) {
  CellSearch search = mixed_cells(supports, seed);
  EXPECT_EQ(search.end, CellSearchEnd::complete);
  return search.subdivision.value_or(MixedSubdivision{});
}

std::uint64_t volume(const std::vector<Support>& supports, std::uint64_t seed = 1) {
  return found(supports, seed).mixed_volume;
}

/// 0 at the two ends of each edge, > 0 elsewhere, in exact rationals.
void expect_strict(const MixedSubdivision& s, const MixedCell& cell) {
  const std::vector<Rational> w = exact_cell_weights(s, cell);
  std::size_t index = 0;
  for (std::size_t i = 0; i < s.supports.size(); ++i) {
    for (std::uint32_t k = 0; k < s.supports[i].terms.size(); ++k, ++index) {
      const bool end = k == cell.edges[i][0] || k == cell.edges[i][1];
      EXPECT_TRUE(end ? w[index].is_zero() : w[index] > Rational(0)) << i << " " << k;
    }
  }
  EXPECT_EQ(index, w.size());
}

void expect_subdivision(const MixedSubdivision& s) {
  std::uint64_t sum = 0;
  for (const MixedCell& cell : s.cells) {
    expect_strict(s, cell);
    for (const auto& edge : cell.edges) EXPECT_LT(edge[0], edge[1]);
    EXPECT_GT(cell.volume, 0u);
    sum += cell.volume;
  }
  EXPECT_EQ(sum, s.mixed_volume);
  for (std::size_t k = 1; k < s.cells.size(); ++k) {
    EXPECT_LT(s.cells[k - 1].edges, s.cells[k].edges);
  }
}

TEST(MixedCells, CyclicRootsHaveThePublishedMixedVolumes) {
  const std::uint64_t published[]{70, 156, 924, 2560};
  for (std::size_t n = 5; n <= 8; ++n) EXPECT_EQ(volume(cyclic(n)), published[n - 5]) << n;
}

TEST(MixedCells, NoonHasThreeToTheNLessTwoN) {
  std::uint64_t power = 9;
  for (std::size_t n = 3; n <= 8; ++n) {
    power *= 3;
    EXPECT_EQ(volume(noon(n)), power - 2 * n) << n;
  }
}

TEST(MixedCells, EcoHasTwoToTheNLessTwo) {
  for (std::size_t n = 4; n <= 11; ++n) EXPECT_EQ(volume(eco(n)), std::uint64_t{1} << (n - 2)) << n;
}

TEST(MixedCells, KatsuraHasTwoToTheNWithZeroAddedAndFewerWithout) {
  const std::uint64_t without_zero[]{12, 30, 54};
  for (std::size_t n = 4; n <= 6; ++n) {
    EXPECT_EQ(volume(katsura(n)), without_zero[n - 4]) << n;
    EXPECT_EQ(volume(with_origin(katsura(n), n + 1).supports), std::uint64_t{1} << n) << n;
  }
}

TEST(MixedCells, ReimerHasTheProductOfTheDegrees) {
  const std::uint64_t published[]{24, 120, 720};
  for (std::size_t n = 3; n <= 5; ++n) EXPECT_EQ(volume(reimer(n)), published[n - 3]) << n;
}

TEST(MixedCells, EveryInequalityOfEveryCellHoldsExactly) {
  for (const auto& supports : {cyclic(6), noon(5), eco(7), katsura(5), reimer(4)}) {
    for (const std::uint64_t seed : {1u, 2u, 3u}) expect_subdivision(found(supports, seed));
  }
}

TEST(MixedCells, AWrongEdgeIsSeenByTheInequalities) {
  MixedSubdivision s = found(cyclic(5), 1);
  MixedCell cell = s.cells.front();
  const std::vector<double> right = cell_weights(s, cell);
  EXPECT_GE(*std::min_element(right.begin(), right.end()), 0);
  cell.edges[0] = {0, cell.edges[0][0] == 0 && cell.edges[0][1] == 1 ? 2u : 1u};
  bool wrong = false;
  try {
    const std::vector<double> w = cell_weights(s, cell);
    wrong = *std::min_element(w.begin(), w.end()) < 0;
  } catch (const std::invalid_argument&) {
    wrong = true;
  }
  EXPECT_TRUE(wrong);
}

TEST(MixedCells, AnyLiftingGivesTheSameMixedVolume) {
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    EXPECT_EQ(volume(cyclic(7), seed), 924u) << seed;
    EXPECT_EQ(volume(katsura(6), seed), 54u) << seed;
  }
}

TEST(MixedCells, TheSeedAloneDecidesTheCells) {
  const MixedSubdivision first = found(noon(5), 7);
  const MixedSubdivision again = found(noon(5), 7);
  EXPECT_EQ(first.lifting, again.lifting);
  EXPECT_EQ(first.cells, again.cells);
  EXPECT_NE(first.lifting, found(noon(5), 8).lifting);
}

TEST(MixedCells, TheCellsOfALiftingDoNotDependOnTheWayToIt) {
  const MixedSubdivision s = found(cyclic(6), 3);
  for (const std::uint64_t seed : {1u, 5u, 99u}) {
    const CellSearch other = mixed_cells_of_lifting(s.supports, s.lifting, seed);
    ASSERT_TRUE(other.subdivision);
    EXPECT_EQ(other.subdivision->cells, s.cells);
  }
}

TEST(MixedCells, TheOrderOfTheSupportsOnlyMovesTheEdges) {
  const MixedSubdivision s = found(cyclic(6), 3);
  std::vector<Support> supports(s.supports.rbegin(), s.supports.rend());
  const Lifting lifting(s.lifting.rbegin(), s.lifting.rend());
  const CellSearch other = mixed_cells_of_lifting(supports, lifting, 1);
  ASSERT_TRUE(other.subdivision);
  std::vector<MixedCell> cells = other.subdivision->cells;
  for (MixedCell& cell : cells) std::reverse(cell.edges.begin(), cell.edges.end());
  std::sort(cells.begin(), cells.end(),
            [](const MixedCell& a, const MixedCell& b) { return a.edges < b.edges; });
  EXPECT_EQ(cells, s.cells);
}

TEST(MixedCells, LongWordsFindTheSameCellsAsShortOnes) {
  const MixedSubdivision s = found(cyclic(5), 4);
  // 70 * 2000^5 fits into 63 bits; products with slacks need 128 bits, then more.
  for (const std::uint32_t m : {10u, 300u, 2000u}) {
    const CellSearch search = mixed_cells_of_lifting(stretched(s.supports, m), s.lifting, 1);
    ASSERT_TRUE(search.subdivision) << m;
    const std::uint64_t factor = std::uint64_t{m} * m * m * m * m;
    EXPECT_EQ(search.subdivision->mixed_volume, 70 * factor);
    ASSERT_EQ(search.subdivision->cells.size(), s.cells.size());
    for (std::size_t k = 0; k < s.cells.size(); ++k) {
      EXPECT_EQ(search.subdivision->cells[k].edges, s.cells[k].edges);
      EXPECT_EQ(search.subdivision->cells[k].volume, s.cells[k].volume * factor);
    }
    expect_subdivision(*search.subdivision);
  }
}

TEST(MixedCells, ALiftingOfSixtyBitsIsNoOverflow) {
  const MixedSubdivision s = found(noon(4), 4);
  Lifting lifting = s.lifting;
  for (auto& block : lifting) {
    for (std::int64_t& omega : block)
      omega = omega * (std::int64_t{1} << 33) - (std::int64_t{1} << 62);
  }
  const CellSearch search = mixed_cells_of_lifting(s.supports, lifting, 1);
  ASSERT_TRUE(search.subdivision);
  EXPECT_EQ(search.subdivision->cells, s.cells);
  expect_subdivision(*search.subdivision);
}

TEST(MixedCells, AMixedVolumeBeyond63BitsIsSeen) {
  const std::uint32_t most = std::numeric_limits<std::uint32_t>::max();
  const std::vector<Support> square{{{{most, 0}, {0, 0}}}, {{{0, most}, {0, 0}}}};
  const CellSearch search = mixed_cells(square, 1);
  EXPECT_EQ(search.end, CellSearchEnd::too_large);
  EXPECT_FALSE(search.subdivision);
  const std::uint32_t less = 3037000499;  // the square root of 2^63, rounded down
  const std::vector<Support> fits{{{{less, 0}, {0, 0}}}, {{{0, less}, {0, 0}}}};
  EXPECT_EQ(volume(fits), std::uint64_t{less} * less);
}

TEST(MixedCells, ATiedLiftingIsSeenOrItsCellsAreStillStrict) {
  std::size_t generic = 0;
  std::size_t tied = 0;
  std::uint64_t index = 0;
  for (std::uint64_t seed = 1; seed <= 100; ++seed) {
    const std::vector<Support> supports = cyclic(5);
    Lifting lifting;
    for (const Support& support : supports) {
      lifting.emplace_back();
      for (std::size_t k = 0; k < support.terms.size(); ++k) {
        lifting.back().push_back(
            static_cast<std::int64_t>(random_bits(1, RandomStream::test, index++) % 32));
      }
    }
    const CellSearch search = mixed_cells_of_lifting(supports, lifting, seed);
    if (search.end == CellSearchEnd::not_generic) {
      ++tied;
      continue;
    }
    ++generic;
    ASSERT_TRUE(search.subdivision);
    EXPECT_EQ(search.subdivision->mixed_volume, 70u);
    expect_subdivision(*search.subdivision);
  }
  EXPECT_GT(generic, 0u);
  EXPECT_GT(tied, 0u);
}

TEST(MixedCells, AConstantLiftingIsNotGeneric) {
  const std::vector<Support> supports = noon(3);
  Lifting lifting;
  for (const Support& support : supports) lifting.emplace_back(support.terms.size(), 5);
  EXPECT_EQ(mixed_cells_of_lifting(supports, lifting, 1).end, CellSearchEnd::not_generic);
}

TEST(MixedCells, EqualTermsCountOnce) {
  std::vector<Support> supports = cyclic(5);
  for (Support& support : supports) {
    const std::vector<Exponents> terms = support.terms;
    support.terms.insert(support.terms.end(), terms.begin(), terms.end());
  }
  EXPECT_EQ(volume(supports), 70u);
}

TEST(MixedCells, SupportsOfTooLowADimensionHaveNoCell) {
  const Support line{{{1, 1, 0}, {0, 0, 0}}};
  const Support longer{{{3, 3, 0}, {1, 1, 0}, {0, 0, 0}}};
  const Support any{{{0, 1, 1}, {2, 0, 1}, {0, 0, 3}}};
  const Support constant{{{0, 0, 0}}};
  const Support monomial{{{1, 2, 3}}};
  for (const auto& supports :
       std::vector<std::vector<Support>>{{line, longer, any},
                                         {line, line, line},
                                         {any, constant, any},
                                         {any, any, monomial},
                                         {any, any, Support{}},
                                         {Support{}, Support{}, Support{}}}) {
    const MixedSubdivision s = found(supports, 1);
    EXPECT_EQ(s.mixed_volume, 0u);
    EXPECT_TRUE(s.cells.empty());
  }
}

TEST(MixedCells, TwentyVariablesOfTooLowADimensionAreQuick) {
  const std::size_t n = 20;
  std::vector<Support> supports(n);
  // No support has the last variable.
  for (Support& support : supports) {
    for (std::size_t j = 0; j + 1 < n; ++j) support.terms.push_back(unit(n, {j}));
  }
  EXPECT_EQ(volume(supports), 0u);
}

TEST(MixedCells, NoVariablesHaveOneCellAndOneVariableHasItsDegree) {
  const MixedSubdivision none = found({}, 1);
  EXPECT_EQ(none.mixed_volume, 1u);
  EXPECT_EQ(none.cells.size(), 1u);
  EXPECT_EQ(volume({Support{{{7}, {5}, {4}, {2}}}}), 5u);
}

TEST(MixedCells, RefusesSupportsThatAreNotSquareAndLiftingsOfAnotherShape) {
  EXPECT_THROW(mixed_cells({Support{{{1, 0}, {0, 0}}}}, 1), std::invalid_argument);
  EXPECT_THROW(mixed_cells_of_lifting(noon(3), {{1, 2}}, 1), std::invalid_argument);
}

TEST(MixedCells, BudgetsEndTheSearchWithTheirReason) {
  CellSearchOptions few_steps;
  few_steps.most_steps = 100;
  const CellSearch steps = mixed_cells(cyclic(7), 1, few_steps);
  EXPECT_EQ(steps.end, CellSearchEnd::too_many_steps);
  EXPECT_FALSE(steps.subdivision);
  EXPECT_EQ(steps.steps, 100u);
  CellSearchOptions few_cells;
  few_cells.most_cells = 10;
  EXPECT_EQ(mixed_cells(cyclic(7), 1, few_cells).end, CellSearchEnd::too_many_cells);
  few_cells.most_cells = found(cyclic(7), 1).cells.size();
  EXPECT_EQ(mixed_cells(cyclic(7), 1, few_cells).end, CellSearchEnd::complete);
  EXPECT_NE(std::string(description(CellSearchEnd::too_many_cells)), "");
}

TEST(MixedCells, SearchesOfTooManyPointsAreNotBegun) {
  std::vector<Support> squares;
  for (std::size_t i = 0; i < 400; ++i) {
    Exponents square(400, 0);
    square[i] = 2;
    squares.push_back({{square, Exponents(400, 0)}});
  }
  EXPECT_EQ(mixed_cells(squares, 1).end, CellSearchEnd::too_many_points);
}

TEST(MixedCells, AStopFlagInterrupts) {
  const std::atomic<bool> stop{true};
  CellSearchOptions options;
  options.stop = &stop;
  const CellSearch search = mixed_cells(cyclic(7), 1, options);
  EXPECT_EQ(search.end, CellSearchEnd::interrupted);
  EXPECT_FALSE(search.subdivision);
}

TEST(MixedCells, ProgressNeverFallsAndMayStopTheSearch) {
  std::atomic<bool> stop{false};
  std::vector<CellSearchProgress> reports;
  CellSearchOptions options;
  options.stop = &stop;
  options.progress = [&](const CellSearchProgress& p) { reports.push_back(p); };
  EXPECT_EQ(mixed_cells(cyclic(9), 1, options).end, CellSearchEnd::complete);
  ASSERT_GE(reports.size(), 2u);
  for (std::size_t k = 0; k < reports.size(); ++k) {
    EXPECT_LE(reports[k].fraction, 1);
    if (k == 0) continue;
    EXPECT_GE(reports[k].fraction, reports[k - 1].fraction);
    EXPECT_GE(reports[k].cells, reports[k - 1].cells);
  }
  options.progress = [&](const CellSearchProgress&) { stop = true; };
  EXPECT_EQ(mixed_cells(cyclic(9), 1, options).end, CellSearchEnd::interrupted);
}

}  // namespace
}  // namespace moivre
