// SPDX-License-Identifier: MIT
// Does every file of problems/polynomials read as its index says, and is the index consistent in
// itself?
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <set>

#include "moivre/polynomial/read.h"
#include "moivre/polynomial/system.h"
#include "problem_index.h"

namespace moivre::problems {
namespace {

const std::string kFolder = MOIVRE_SOURCE_DIR "/problems/polynomials";

/// Residual of a known point, relative to the sum of the terms' moduli: a few roundings of its
/// coordinates.
constexpr double kKnownPointTolerance = 1e-14;

const std::vector<Problem>& index() {
  static const std::vector<Problem> problems = read_index(kFolder);
  return problems;
}

System read_file(const Problem& p) { return read_system(read_source(kFolder + "/" + p.file)); }

double relative_residual(const Polynomial& polynomial, const std::vector<std::complex<double>>& x) {
  std::complex<double> value = 0;
  double size = 0;
  for (const Term& term : polynomial.terms) {
    std::complex<double> product = to_complex(term.coefficient);
    for (const Power& power : term.monomial) {
      for (std::uint32_t k = 0; k < power.exponent; ++k) product *= x[power.variable];
    }
    value += product;
    size += std::abs(product);
  }
  return size == 0 ? 0 : std::abs(value) / size;
}

/// Calls check(problem) for every problem of the index; a failure names the problem.
template <class Check>
void for_each_problem(const Check& check) {
  ASSERT_FALSE(index().empty());
  for (const Problem& p : index()) {
    SCOPED_TRACE(p.name);
    check(p);
  }
}

TEST(EveryProblem, IsReadWithTheVariablesAndDegreesOfTheIndex) {
  for_each_problem([](const Problem& p) {
    const System f = read_file(p);
    EXPECT_EQ(f.variables.size(), p.variables);
    EXPECT_EQ(f.polynomials.size(), p.degrees.size());
    EXPECT_EQ(degrees(f), p.degrees);
    EXPECT_EQ(total_degree(degrees(f)), p.total_degree);
    EXPECT_EQ(term_count(f), p.terms);
    EXPECT_EQ(is_real(f), p.has_real_coefficients);
  });
}

TEST(EveryProblem, HasTheFormatOfItsText) {
  for_each_problem([](const Problem& p) {
    const PolynomialFormat expected =
        p.format == "bertini" ? PolynomialFormat::bertini : PolynomialFormat::phcpack;
    EXPECT_EQ(detect_format(read_source(kFolder + "/" + p.file).text), expected);
  });
}

TEST(EveryProblem, CountsEachRootOnceAndEachPathOnce) {
  for_each_problem([](const Problem& p) {
    RootCounts sums;
    for (const MultiplicityCount& count : p.roots.multiplicities) {
      sums.with_multiplicity += count.multiplicity * count.points;
      sums.distinct += count.points;
      if (count.multiplicity == 1) sums.regular = count.points;
    }
    EXPECT_EQ(sums.with_multiplicity, p.roots.with_multiplicity);
    EXPECT_EQ(sums.distinct, p.roots.distinct);
    EXPECT_EQ(sums.regular, p.roots.regular);
    EXPECT_LE(p.roots.far, p.roots.regular);
    EXPECT_LE(p.roots.real, p.roots.distinct);
    EXPECT_EQ(p.at_infinity.has_value(), p.dimension < 1);
    if (p.at_infinity) {
      EXPECT_EQ(*p.at_infinity + p.roots.with_multiplicity, p.total_degree);
    }
  });
}

TEST(EveryProblem, HasNonRealRootsInPairsWhereItIsReal) {
  for_each_problem([](const Problem& p) {
    if (p.has_real_coefficients) {
      EXPECT_EQ((p.roots.distinct - p.roots.real) % 2, 0U);
    }
  });
}

TEST(EveryProblem, HasItsKnownPointsAmongItsRoots) {
  for_each_problem([](const Problem& p) {
    const System f = read_file(p);
    for (const KnownPoint& point : p.points) {
      ASSERT_EQ(point.x.size(), p.variables);
      for (const Polynomial& polynomial : f.polynomials) {
        EXPECT_LE(relative_residual(polynomial, point.x), kKnownPointTolerance);
      }
      EXPECT_TRUE(std::any_of(p.roots.multiplicities.begin(), p.roots.multiplicities.end(),
                              [&](const MultiplicityCount& count) {
                                return count.multiplicity == point.multiplicity;
                              }));
    }
  });
}

TEST(EveryProblem, SaysHowItsCountsWereChecked) {
  for_each_problem([](const Problem& p) { EXPECT_FALSE(p.verified.empty()); });
}

TEST(EveryProblem, CitesWhatTheReferencesList) {
  const std::string references = read_source(MOIVRE_SOURCE_DIR "/docs/references.md").text;
  for_each_problem([&](const Problem& p) {
    for (const std::string& key : p.citations) {
      EXPECT_NE(references.find("**[" + key + "]**"), std::string::npos) << key;
    }
  });
}

TEST(ProblemIndex, ListsEveryFileOfTheFolderOnce) {
  std::set<std::string> in_folder;
  for (const auto& file : std::filesystem::directory_iterator(kFolder)) {
    const std::string name = file.path().filename().string();
    if (name != "index.json") in_folder.insert(name);
  }
  std::set<std::string> listed;
  for (const Problem& p : index()) {
    EXPECT_TRUE(listed.insert(p.file).second) << p.file << " stands twice";
  }
  EXPECT_EQ(listed, in_folder);
}

TEST(ProblemIndex, GivesTheSameSystemInBothFormats) {
  int pairs = 0;
  for (const Problem& p : index()) {
    if (p.same_as.empty()) continue;
    const auto twin = std::find_if(index().begin(), index().end(),
                                   [&](const Problem& q) { return q.name == p.same_as; });
    ASSERT_NE(twin, index().end()) << p.same_as;
    EXPECT_EQ(read_file(p), read_file(*twin)) << p.name;
    ++pairs;
  }
  EXPECT_GE(pairs, 1);
}

}  // namespace
}  // namespace moivre::problems
