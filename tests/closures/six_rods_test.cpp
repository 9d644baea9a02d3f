// SPDX-License-Identifier: MIT
// Are the forty poses of the general platform its poses, all of them, and does every platform take
// as many paths?
#include <gtest/gtest.h>

#include <algorithm>

#include "mechanisms.h"
#include "moivre/formulation/formulation.h"
#include "moivre/numeric/random.h"
#include "moivre/polynomial/value.h"
#include "moivre/solver/solve.h"

namespace moivre {
namespace {

constexpr std::size_t kAllPoses = 40;
const std::vector<std::string> kPlatforms{"dietmaier",    "planar-platform", "platform-6-4",
                                          "platform-6-3", "octahedral-3-3",  "delta"};

Formulation platform(const std::string& file) { return formulate(mechanism_file(file), 0); }

Formulation::GeneralMember general_of(const Formulation& formulation) {
  return formulation.theorem.value().general();
}

double apart(const Point& a, const Point& b) {
  double largest = 0;
  for (std::size_t k = 0; k < a.size(); ++k) largest = std::max(largest, std::abs(a[k] - b[k]));
  return largest / std::max(1.0, max_norm(b));
}

double relative_residual(const System& f, const Point& x) {
  double largest = 0;
  for (const Polynomial& p : f.polynomials) {
    largest = std::max(largest, std::abs(value_at(p, x)) / term_size(p, x));
  }
  return largest;
}

SolveResult solved_anew(const System& f, std::uint64_t seed) {
  SolveOptions options;
  options.seed = seed;
  options.threads = 1;
  options.start = StartKind::polyhedral;
  return solve(f, *make_cvode_tracker(), options);
}

TEST(SixRodsInGeneral, AreSatisfiedByTheirPosesInTheUnitsOfAnyPlatform) {
  for (const std::string& file : kPlatforms) {
    const Formulation formulation = platform(file);
    const auto general = general_of(formulation);
    ASSERT_EQ(general.roots.size(), kAllPoses) << file;
    for (const Point& x : general.roots) {
      EXPECT_LT(relative_residual(general.system, x), 1e-13) << file;
    }
  }
}

// From another start, which knows nothing of the table.
TEST(SixRodsInGeneral, HaveNoOtherPosesThanTheKnown) {
  const Formulation formulation = platform("planar-platform");
  const auto general = general_of(formulation);
  for (std::uint64_t seed = 1; seed <= 3; ++seed) {
    const SolveResult anew = solved_anew(general.system, seed);
    EXPECT_TRUE(anew.complete);
    ASSERT_EQ(anew.solutions.size(), kAllPoses);
    for (const Point& known : general.roots) {
      const auto is_it = [&](const Solution& root) { return apart(root.x, known) < 1e-9; };
      EXPECT_EQ(std::count_if(anew.solutions.begin(), anew.solutions.end(), is_it), 1);
    }
  }
}

/// Six random combinations of the equations of many platforms; patch and quadric as they are.
System of_the_span(std::uint64_t seed) {
  System mixed = platform(kPlatforms.front()).system;
  std::uint64_t drawn = 0;
  const auto random_rational = [&] {
    return Rational(
               static_cast<std::int64_t>(random_bits(seed, RandomStream::test, drawn++) % 2000),
               1000) -
           1;
  };
  constexpr std::size_t kFirstRod = 2;
  for (std::size_t i = kFirstRod; i < mixed.polynomials.size(); ++i) {
    Polynomial sum;
    for (const std::string& file : kPlatforms) {
      const System system = platform(file).system;
      for (std::size_t k = kFirstRod; k < system.polynomials.size(); ++k) {
        sum = sum + Coefficient{random_rational(), random_rational()} * system.polynomials[k];
      }
    }
    mixed.polynomials[i] = sum;
  }
  return mixed;
}

// The start follows straight lines of coefficients, on which the equations are those of no rods.
TEST(SixRodsInGeneral, LieInASpanWhoseGeneralSystemsHaveFortyRoots) {
  for (std::uint64_t seed = 1; seed <= 3; ++seed) {
    const SolveResult result = solved_anew(of_the_span(seed), seed);
    EXPECT_TRUE(result.complete);
    EXPECT_EQ(result.solutions.size(), kAllPoses) << "seed " << seed;
  }
}

TEST(SixRodsInGeneral, LeadToAllPosesByFortyPaths) {
  for (const std::string& file : kPlatforms) {
    const ClosureResult result = closures_of(mechanism_file(file), 7);
    EXPECT_TRUE(result.complete) << file;
    EXPECT_EQ(result.paths.tracked, kAllPoses) << file;
    EXPECT_EQ(result.start.source, StartSource::family) << file;
  }
}

// Griffis and Duffy's platform: elimination alone tells that its equations depend on each other.
TEST(SixRodsInGeneral, AreNotFollowedWhereEliminationDecides) {
  const ClosureResult result = closures_of(mechanism_file("griffis-duffy"));
  EXPECT_EQ(result.paths.tracked, 0u);
  EXPECT_TRUE(result.moves);
}

TEST(SixRodsInGeneral, GiveWayToTheStartThatIsAskedFor) {
  ClosureOptions options;
  options.solve.start = StartKind::polyhedral;
  const ClosureResult result =
      find_closures(mechanism_file("dietmaier"), *make_cvode_tracker(), options);
  EXPECT_EQ(result.start.source, StartSource::polyhedral);
  EXPECT_EQ(result.counts.complex, kAllPoses);
}

}  // namespace
}  // namespace moivre
