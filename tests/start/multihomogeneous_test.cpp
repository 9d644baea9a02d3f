// SPDX-License-Identifier: MIT
// Are the numbers by groups those that are published, and does the search find the least?
#include "moivre/start/multihomogeneous.h"

#include <gtest/gtest.h>

#include <limits>
#include <stdexcept>

#include "moivre/polynomial/read.h"
#include "systems.h"

namespace moivre {
namespace {

System problem(const std::string& name) {
  return read_system(read_source(MOIVRE_SOURCE_DIR "/problems/polynomials/" + name + ".phc"));
}

std::uint64_t number(const System& f, const Partition& groups) {
  return multihomogeneous_number(f, groups).value();
}

/// The sum over all ways of giving every equation one group, without a table.
std::uint64_t summed(const GroupDegrees& d, std::vector<std::size_t> left, std::size_t i = 0) {
  if (i == d.size()) return 1;
  std::uint64_t sum = 0;
  for (std::size_t j = 0; j < left.size(); ++j) {
    if (left[j] == 0) continue;
    --left[j];
    sum += d[i][j] * summed(d, left, i + 1);
    ++left[j];
  }
  return sum;
}

TEST(MultihomogeneousNumber, IsTheTotalDegreeForOneGroup) {
  for (const char* name : {"puma", "eco-6", "cyclic-5", "griewank-osborne"}) {
    const System f = problem(name);
    EXPECT_EQ(multihomogeneous_number(f, one_group(f.variables.size())), total_degree(degrees(f)))
        << name;
  }
}

TEST(MultihomogeneousNumber, IsTheCoefficientOfTheProduct) {
  const GroupDegrees d{{2, 1, 0}, {0, 3, 1}, {1, 1, 2}, {4, 0, 1}, {1, 2, 2}};
  const Partition groups{{0, 4}, {1, 2}, {3}};
  EXPECT_EQ(multihomogeneous_number(d, groups), summed(d, {2, 2, 1}));
}

TEST(MultihomogeneousNumber, OfAnEigenvalueProblemIsNAndNotTwoToTheN) {
  for (const std::uint32_t n : {2U, 3U, 7U, 12U}) {
    const System f = eigenvalues(n);
    Partition groups = one_group(n);
    groups.back().pop_back();
    groups.push_back({n - 1});
    EXPECT_EQ(number(f, groups), n);
    EXPECT_EQ(number(f, one_group(n)), std::uint64_t{1} << (n - 1));
    EXPECT_EQ(find_partition(f).paths, n);
  }
}

// The published numbers: cassou in PHCpack's collection; the five-link's 96 in Wampler's isotropic
// coordinates; the others [Verschelde99].
TEST(MultihomogeneousNumber, MeetsPublishedNumbers) {
  EXPECT_EQ(number(cassou(), {{0}, {1, 2, 3}}), 368U);
  EXPECT_EQ(number(problem("griewank-osborne"), {{0}, {1}}), 5U);
  EXPECT_EQ(number(problem("puma"), {{0, 1}, {2, 3, 6, 7}, {4, 5}}), 16U);
  EXPECT_EQ(number(problem("kin1"), {{0, 1}, {2, 3, 4, 5, 6, 7}, {8, 9}, {10, 11}}), 320U);
}

TEST(MultihomogeneousNumber, OfZeroSaysThatThereIsNoIsolatedRoot) {
  const System f = read_system({"file", "2\nx^2+0*y-1;\nx^3-x;\n"});
  EXPECT_EQ(number(f, {{0}, {1}}), 0U);
  EXPECT_EQ(find_partition(f).paths, 0U);
}

TEST(MultihomogeneousNumber, BeyondSixtyFourBitsIsSeen) {
  const std::uint64_t top = std::numeric_limits<std::uint64_t>::max();
  const std::uint64_t half = std::uint64_t{1} << 32;
  EXPECT_EQ(multihomogeneous_number(GroupDegrees{{half}, {half}}, {{0, 1}}), std::nullopt);
  EXPECT_EQ(multihomogeneous_number(GroupDegrees{{half, 1}, {1, half}}, {{0}, {1}}), std::nullopt);
  EXPECT_EQ(multihomogeneous_number(GroupDegrees{{half, 1}, {1, half - 1}}, {{0}, {1}}),
            top - half + 2);
  // Where the last equations alone would overflow, but are never chosen so, the number stands.
  EXPECT_EQ(multihomogeneous_number(GroupDegrees{{0, 1}, {top, 3}}, {{0}, {1}}), std::nullopt);
  EXPECT_EQ(multihomogeneous_number(GroupDegrees{{1, 0, 0}, {top, 2, 0}, {0, top - 1, 5}},
                                    {{0}, {1}, {2}}),
            10U);
}

TEST(MultihomogeneousNumber, WithoutATableOfBoundedSizeIsNotFound) {
  const std::size_t n = 30;
  GroupDegrees d(n, std::vector<std::uint64_t>(n, 1));
  Partition own;
  for (std::uint32_t v = 0; v < n; ++v) own.push_back({v});
  EXPECT_EQ(multihomogeneous_number(d, own), std::nullopt);
}

TEST(MultihomogeneousNumber, RefusesGroupsThatAreNone) {
  const System f = cassou();
  EXPECT_THROW(group_degrees(f, {{0, 1}, {2}}), std::invalid_argument);
  EXPECT_THROW(group_degrees(f, {{0, 1}, {1, 2, 3}}), std::invalid_argument);
  EXPECT_THROW(group_degrees(f, {{0, 1}, {2, 3, 4}}), std::invalid_argument);
  EXPECT_THROW(multihomogeneous_number(GroupDegrees{{1, 1}}, {{0}, {1}}), std::invalid_argument);
}

TEST(PartitionSearch, FindsTheLeastNumbersKnown) {
  const std::pair<const char*, std::uint64_t> known[]{
      {"puma", 16},      {"kin1", 320},      {"ipp2", 320},      {"rbpl24", 80},    {"eco-8", 256},
      {"fbrfive12", 96}, {"chandra-8", 128}, {"cyclic-7", 5040}, {"katsura-8", 256}};
  for (const auto& [name, paths] : known)
    EXPECT_EQ(find_partition(problem(name)).paths, paths) << name;
  const PartitionSearch search = find_partition(cassou());
  EXPECT_EQ(search.paths, 368U);
  EXPECT_EQ(search.groups, (Partition{{0}, {1, 2, 3}}));
  EXPECT_TRUE(search.is_least);
  EXPECT_EQ(search.tried, 15U);
}

TEST(PartitionSearch, PrefersFewGroups) {
  const PartitionSearch search = find_partition(problem("cyclic-5"));
  EXPECT_EQ(search.paths, 120U);
  EXPECT_EQ(search.groups, one_group(5));
}

// Linear equations in unknowns of their own change no number, but leave too many unknowns to try
// all partitions.
TEST(PartitionSearch, FindsTheSameAmongMoreUnknownsThanItCanTryAll) {
  for (const char* name :
       {"puma", "eco-5", "eco-6", "griewank-osborne", "morgan-wampler-7", "noon-4"}) {
    System f = problem(name);
    const PartitionSearch small = find_partition(f);
    EXPECT_EQ(small.is_least, f.variables.size() < kExhaustiveUnknowns) << name;
    while (f.variables.size() <= kExhaustiveUnknowns + 2) {
      const auto v = static_cast<std::uint32_t>(f.variables.size());
      f.variables.push_back("extra" + std::to_string(v));
      f.polynomials.push_back(unknown(v) + constant({-1, 0}));
    }
    const PartitionSearch large = find_partition(f);
    EXPECT_FALSE(large.is_least) << name;
    EXPECT_EQ(large.paths, small.paths) << name;
  }
}

TEST(PartitionSearch, TriesTheGroupsThatAreDeclared) {
  System f = problem("kin1");
  f.groups = {{{2, 3, 4, 5, 6, 7}, false}, {{8, 9}, false}, {{0, 1}, false}, {{10, 11}, true}};
  EXPECT_EQ(declared_partition(f), (Partition{{0, 1}, {2, 3, 4, 5, 6, 7}, {8, 9}, {10, 11}}));
  EXPECT_LE(find_partition(f).paths, 320U);
  f.groups.pop_back();
  EXPECT_THROW(declared_partition(f), std::invalid_argument);
  f.groups.clear();
  EXPECT_EQ(declared_partition(f), std::nullopt);
}

TEST(PartitionSearch, EndsForManyUnknowns) {
  const std::uint32_t n = 70;
  const System f = eigenvalues(n);
  const PartitionSearch search = find_partition(f);
  EXPECT_EQ(search.paths, n);
  EXPECT_FALSE(search.is_least);
}

// Partitions of many unknowns take long to make: their number is what the search is bounded by.
TEST(PartitionSearch, TriesFewerPartitionsOfMoreUnknowns) {
  System f;
  for (std::uint32_t v = 0; v < 400; ++v) {
    f.variables.push_back("x" + std::to_string(v));
    f.polynomials.push_back(unknown(v) * unknown(v) + constant({-1, 0}));
  }
  EXPECT_LE(find_partition(f).tried, 5000U);
}

// The degrees of its groups alone take longer than the search may.
TEST(PartitionSearch, HasOneGroupOfEquationsWithHalfAMillionTerms) {
  constexpr std::uint32_t kUnknowns = 100;
  Polynomial dense;
  for (std::uint32_t v = 0; v < kUnknowns; ++v) {
    for (std::uint32_t w = v + 1; w < kUnknowns; ++w) {
      dense.terms.push_back({{1, 0}, {{v, 1}, {w, 1}}});
    }
  }
  System f;
  for (std::uint32_t v = 0; v < kUnknowns; ++v) f.variables.push_back("x" + std::to_string(v));
  f.polynomials.assign(kUnknowns, dense);
  EXPECT_EQ(find_partition(f).groups, one_group(kUnknowns));
}

TEST(PartitionSearch, RefusesSystemsThatAreNotSquareOrHoldAZero) {
  EXPECT_THROW(find_partition(System{}), std::invalid_argument);
  EXPECT_THROW(find_partition(System{{"x", "y"}, {unknown(0)}}), std::invalid_argument);
  EXPECT_THROW(find_partition(System{{"x"}, {Polynomial{}}}), std::invalid_argument);
}

}  // namespace
}  // namespace moivre
