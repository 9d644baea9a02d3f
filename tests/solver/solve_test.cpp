// SPDX-License-Identifier: MIT
// Does solve() answer degenerate, refused, interrupted and ordinary systems as its header says,
// whatever the threads?
#include "moivre/solver/solve.h"

#include <gtest/gtest.h>

#include "moivre/certify/certifier.h"
#include "problem_set.h"

namespace moivre {
namespace {

using test::distance;
using test::expect_conservation;
using test::expect_counts_of_index;
using test::problem;
using test::read;
using test::solve_with_cvode;
using test::system_of;
using test::with_seed;

/// Everything but the times; bit for bit.
void expect_same_bytes(const SolveResult& a, const SolveResult& b) {
  EXPECT_EQ(a.complete, b.complete);
  EXPECT_EQ(a.message, b.message);
  EXPECT_EQ(a.completeness, b.completeness);
  EXPECT_EQ(a.paths, b.paths);
  EXPECT_EQ(a.work.accepted, b.work.accepted);
  EXPECT_EQ(a.work.rejected, b.work.rejected);
  ASSERT_EQ(a.failures.size(), b.failures.size());
  for (std::size_t k = 0; k < a.failures.size(); ++k) {
    EXPECT_EQ(a.failures[k].path, b.failures[k].path);
    EXPECT_EQ(a.failures[k].failure, b.failures[k].failure);
    EXPECT_EQ(a.failures[k].t, b.failures[k].t);
  }
  ASSERT_EQ(a.solutions.size(), b.solutions.size());
  for (std::size_t k = 0; k < a.solutions.size(); ++k) {
    const Solution& s = a.solutions[k];
    const Solution& r = b.solutions[k];
    EXPECT_EQ(s.path, r.path);
    EXPECT_EQ(s.x, r.x);
    EXPECT_EQ(s.real, r.real);
    EXPECT_EQ(s.singular, r.singular);
    EXPECT_EQ(s.multiplicity, r.multiplicity);
    EXPECT_EQ(s.winding, r.winding);
    EXPECT_EQ(s.residual, r.residual);
    EXPECT_EQ(s.accuracy, r.accuracy);
    EXPECT_EQ(s.condition, r.condition);
    EXPECT_EQ(s.certified, r.certified);
  }
}

TEST(Solve, FindsTheFourRootsOfAHyperbolaAndACircle) {
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    const SolveResult result =
        solve_with_cvode(read("2\n x^2 + y^2 - 5;\n x*y - 2;\n"), with_seed(seed));
    expect_conservation(result);
    EXPECT_TRUE(result.complete);
    EXPECT_EQ(result.seed, seed);
    for (const Point& x : {Point{1, 2}, Point{2, 1}, Point{-1, -2}, Point{-2, -1}}) {
      EXPECT_EQ(test::solutions_near(result, x, 1e-15), 1U);
    }
  }
}

TEST(Solve, GivesTheSameBytesOnOneTwoAndFourThreads) {
  for (const char* name : {"katsura-5", "noon-3", "multiplicity-4", "griewank-osborne"}) {
    SCOPED_TRACE(name);
    const System f = system_of(problem(name));
    const SolveResult one = solve_with_cvode(f, with_seed(3, 1));
    for (const int threads : {2, 4}) {
      const SolveResult many = solve_with_cvode(f, with_seed(3, threads));
      EXPECT_EQ(many.time.threads, threads);
      expect_same_bytes(one, many);
    }
  }
}

TEST(Solve, GivesTheSameBytesForTheSameSeedOnly) {
  const System f = system_of(problem("katsura-5"));
  const SolveResult first = solve_with_cvode(f, with_seed(3));
  expect_same_bytes(first, solve_with_cvode(f, with_seed(3)));
  const SolveResult other = solve_with_cvode(f, with_seed(4));
  EXPECT_NE(first.work.accepted, other.work.accepted);
}

TEST(Solve, FindsTheSameRootsWhateverTheOrderOfTheEquations) {
  for (const char* name : {"cyclic-5", "katsura-5", "multiplicity-5", "reimer-3"}) {
    SCOPED_TRACE(name);
    System f = system_of(problem(name));
    const SolveResult forward = solve_with_cvode(f);
    std::reverse(f.polynomials.begin(), f.polynomials.end());
    const SolveResult backward = solve_with_cvode(f);
    ASSERT_EQ(forward.solutions.size(), backward.solutions.size());
    for (const Solution& s : forward.solutions) {
      const double within = 4 * s.accuracy + (s.singular ? 1e-6 : 1e-13);
      EXPECT_EQ(test::solutions_near(backward, s.x, within), 1U);
    }
  }
}

TEST(Solve, FindsConjugateClosedRootsOfRealSystems) {
  for (const char* name : {"cyclic-5", "katsura-5", "dense-real-3-4", "multiplicity-4"}) {
    SCOPED_TRACE(name);
    const SolveResult result = solve_with_cvode(system_of(problem(name)));
    for (const Solution& s : result.solutions) {
      Point image = s.x;
      for (Complex& xi : image) xi = std::conj(xi);
      const auto partner = std::find_if(
          result.solutions.begin(), result.solutions.end(),
          [&](const Solution& r) { return distance(r.x, image) <= 2 * (r.accuracy + s.accuracy); });
      ASSERT_NE(partner, result.solutions.end());
      EXPECT_EQ(partner->path == s.path, s.real);
      EXPECT_EQ(partner->multiplicity, s.multiplicity);
      if (s.real) {
        EXPECT_EQ(s.x, image);
      }
    }
  }
}

TEST(Solve, SaysThatParallelLinesHaveNoRoot) {
  const SolveResult result = solve_with_cvode(system_of(problem("parallel-lines")));
  EXPECT_TRUE(result.complete);
  EXPECT_TRUE(result.solutions.empty());
  EXPECT_EQ(result.paths.tracked, 0U);
  expect_conservation(result);
}

TEST(Solve, TracksParallelLinesToInfinityWhereNothingIsEliminated) {
  SolveOptions options = with_seed(1);
  options.eliminate = false;
  const SolveResult result = solve_with_cvode(system_of(problem("parallel-lines")), options);
  EXPECT_TRUE(result.complete);
  EXPECT_EQ(result.paths.tracked, 1U);
  EXPECT_EQ(result.paths.at_infinity, 1U);
}

TEST(Solve, SaysThatADuplicatedEquationIsolatesNoRoot) {
  const SolveResult result = solve_with_cvode(system_of(problem("duplicated-equation")));
  EXPECT_TRUE(result.complete);
  EXPECT_TRUE(result.solutions.empty());
  EXPECT_EQ(result.message,
            "the equations depend on each other: every root lies on a set of positive dimension, "
            "none is isolated");
  expect_conservation(result);
}

TEST(Solve, CountsPathsThatEndOnACurveOfRoots) {
  for (std::uint64_t seed = 1; seed <= 3; ++seed) {
    // The line x = 0 and the point (1, 2).
    const SolveResult result =
        solve_with_cvode(read("2\n x*(y - 2);\n x*(x + y - 3)*(y + 7);\n"), with_seed(seed));
    expect_conservation(result);
    EXPECT_TRUE(result.complete);
    EXPECT_GT(result.paths.on_positive_dimensional, 0U);
    ASSERT_EQ(result.solutions.size(), 1U);
    EXPECT_LT(distance(result.solutions[0].x, {1, 2}), 1e-15);
  }
}

TEST(Solve, TellsNoIsolatedRootWhereCurvesCross) {
  // Every root of cyclic-4 lies on its two curves; at eight points more paths end than one to a
  // point.
  for (const std::uint64_t seed : {15U, 27U, 41U, 49U, 59U, 64U, 79U, 91U}) {
    const SolveResult result = solve_with_cvode(system_of(problem("cyclic-4")), with_seed(seed));
    expect_conservation(result);
    EXPECT_TRUE(result.complete) << "seed " << seed;
    EXPECT_TRUE(result.solutions.empty()) << "seed " << seed;
  }
}

TEST(Solve, SquaresUpMoreEquationsThanUnknownsAndCountsWhatThatAdds) {
  // (1, 2) and (-1, -2) satisfy all three; the squared-up quadrics have two more roots.
  const System f = read("3 2\n x^2 + y^2 - 5;\n x*y - 2;\n 2*x^2 - x*y;\n");
  for (const std::uint64_t seed : {1UL, 2UL, 3UL}) {
    const SolveResult result = solve_with_cvode(f, with_seed(seed));
    EXPECT_TRUE(result.complete);
    EXPECT_EQ(result.solutions.size(), 2U);
    EXPECT_EQ(result.excess, 2U);
    EXPECT_EQ(result.paths.finite, 4U);
  }
  const SolveResult none = solve_with_cvode(read("3 2\n x^2 + y^2 - 5;\n x*y - 2;\n x + y - 9;\n"));
  EXPECT_TRUE(none.complete);
  EXPECT_TRUE(none.solutions.empty());
}

TEST(Solve, SaysOfEquationsBesideEliminatedUnknownsWhetherTheyHold) {
  const auto message = [](const char* text) {
    const SolveResult result = solve_with_cvode(read(text), {});
    expect_conservation(result);
    EXPECT_TRUE(result.complete) << text;
    return result.message;
  };
  EXPECT_EQ(message("x = 1\nx = 1\n"), "every unknown was eliminated: one root");
  const char* const none =
      "every unknown was eliminated: the root of the combinations is none of the file";
  EXPECT_EQ(message("x = 1\nx = 2\n"), none);
  EXPECT_EQ(message("x = 1\n1 = 2\n"), none);
  EXPECT_EQ(message("0 = 0\n"),
            "the equations have no unknowns, and hold: one root, the empty point");
  EXPECT_EQ(message("1 = 0\n0 = 0\n"),
            "the equations have no unknowns, and contradict each other: no root");
}

TEST(Solve, TellsNoRootOfEquationsThatContradictEachOtherByLessThanRounding) {
  for (const char* text :
       {"3 2\n x^2 - 2;\n y - x^3;\n x*y - 4 + 1/10^17;\n",
        "2 1\n x^2 - 2;\n x^3 - 2*x - 1/10^40;\n", "2 1\n x - 1;\n x - 1 - 1/10^18;\n"}) {
    for (const std::uint64_t seed : {1UL, 2UL, 3UL}) {
      const SolveResult result = solve_with_cvode(read(text), with_seed(seed));
      EXPECT_TRUE(!result.complete || result.solutions.empty()) << text << seed;
    }
  }
}

TEST(Solve, SaysWhereCombinationsMayHaveARootMoreOftenThanTheFile) {
  const SolveResult result = solve_with_cvode(read("3 2\n x^2;\n y^2;\n x*y;\n"));
  EXPECT_TRUE(result.complete);
  EXPECT_TRUE(std::any_of(result.left_out.begin(), result.left_out.end(), [](const LeftOut& left) {
    return left.what == "multiplicities of the file's equations" &&
           left.why.ends_with("counts 3 roots of the file with their multiplicities");
  }));
}

TEST(Solve, TellsARootBeyondDoubleAsNone) {
  for (const char* text : {"1\n 1e-200*x - 1e200;\n", "2\n y - 1e200*x;\n x - 1e200;\n"}) {
    const SolveResult result = solve_with_cvode(read(text));
    EXPECT_FALSE(result.complete);
    EXPECT_TRUE(result.solutions.empty());
    EXPECT_EQ(result.paths.failed, 1U);
    EXPECT_EQ(result.failures.size(), 1U);
  }
}

// Dense matrices of 1500 unknowns would be gigabytes.
TEST(Solve, ProvesTheRootOfManyLinearEquationsByTheirElimination) {
  constexpr int kLength = 1500;
  std::string text = std::to_string(kLength) + "\nx1 - 1/3;\n";
  for (int k = 2; k <= kLength; ++k) {
    text += "x" + std::to_string(k) + " - x" + std::to_string(k - 1) + " - 1/3;\n";
  }
  const SolveResult result = solve_with_cvode(read(text));
  ASSERT_EQ(result.solutions.size(), 1U);
  EXPECT_EQ(result.completeness, RootCompleteness::proved);
  const Solution& root = result.solutions.front();
  EXPECT_EQ(root.certified, true);
  EXPECT_TRUE(root.real);
  EXPECT_GT(root.accuracy, 0);
  EXPECT_LT(root.accuracy, 0x1p-52);
  for (int k = 1; k <= kLength; ++k) {
    const Rational off = Rational(root.x[static_cast<std::size_t>(k - 1)].real()) - Rational(k) / 3;
    EXPECT_LE(std::abs(to_double(off)), root.accuracy * std::max(1.0, max_norm(root.x)));
  }
}

TEST(Solve, ARootThatDoubleTakesForZeroIsProvedNearIt) {
  const SolveResult result = solve_with_cvode(read("2\n 1e200*x - 1e-200;\n y - x - 1;\n"));
  ASSERT_EQ(result.solutions.size(), 1U);
  EXPECT_EQ(result.completeness, RootCompleteness::proved);
  EXPECT_EQ(result.solutions.front().x[0], 0.0);
  EXPECT_GT(result.solutions.front().accuracy, 0);
}

TEST(Solve, KnowsHowExactlyRootsAreKnownWhoseSquaresAreBeyondDouble) {
  if (!proves_beyond_double()) GTEST_SKIP() << "needs more digits";
  for (const char* text : {"1\n x - 1e155;\n", "1\n 1e-200*x^2 - 3*x + 1e200;\n"}) {
    const SolveResult result = solve_with_cvode(read(text));
    EXPECT_TRUE(result.complete);
    for (const Solution& root : result.solutions) {
      EXPECT_GT(root.accuracy, 0);
      EXPECT_LT(root.accuracy, 1e-15);
    }
  }
}

TEST(Solve, CutsFewerEquationsThanUnknownsWhereThatIsAskedFor) {
  SolveOptions options = with_seed(1);
  options.slice = true;
  // The twisted cubic has degree 3.
  const SolveResult result = solve_with_cvode(read("2 3\n y - x^2;\n z - x*y;\n"), options);
  EXPECT_TRUE(result.complete);
  EXPECT_EQ(result.solutions.size(), 3U);
}

TEST(Solve, RefusesFewerEquationsThanUnknownsWithTheReason) {
  try {
    solve_with_cvode(read("1 2\n x*y - 1;\n"));
    FAIL() << "an underdetermined system was taken";
  } catch (const std::invalid_argument& refusal) {
    EXPECT_TRUE(
        std::string(refusal.what())
            .ends_with(
                ": it is underdetermined: its roots form sets of dimension 1 or more, and none is "
                "isolated. `slice` cuts them by random linear equations"))
        << refusal.what();
  }
}

TEST(Solve, NamesTheUnknownsWhereThereAreMoreThanEquations) {
  try {
    solve_with_cvode(read("2xy = 3; x + y = 4;"));
    FAIL() << "an underdetermined system was taken";
  } catch (const std::invalid_argument& refusal) {
    EXPECT_TRUE(std::string(refusal.what())
                    .starts_with("the system has 2 equations in 3 unknowns (xy, x, y; `xy` is one "
                                 "name: a product is written `x*y`): it is underdetermined"))
        << refusal.what();
  }
}

TEST(Solve, NamesEveryOptionThatIsOutOfRange) {
  SolveOptions options;
  options.threads = -1;
  options.maximum_tolerance_level = -1;
  options.endgame.ends.samples = 5;
  options.endgame.ends.maximum_winding = 0;
  EXPECT_EQ(validate(options).size(), 4U);
  EXPECT_TRUE(validate(SolveOptions{}).empty());
  EXPECT_THROW(solve_with_cvode(read("1\n x - 1;\n"), options), std::invalid_argument);
}

TEST(Solve, GivesTheOneRootOfASystemWithoutUnknowns) {
  const SolveResult result = solve_with_cvode(System{});
  EXPECT_TRUE(result.complete);
  EXPECT_EQ(result.solutions.size(), 1U);
  expect_conservation(result);
}

TEST(Solve, GivesTheRootOfALinearSystemWithoutTracking) {
  const SolveResult result = solve_with_cvode(read("2\n x + y - 3;\n x - y - 1;\n"));
  EXPECT_TRUE(result.complete);
  ASSERT_EQ(result.solutions.size(), 1U);
  EXPECT_EQ(result.solutions[0].x, (Point{2, 1}));
  EXPECT_EQ(result.work.accepted, 0U);
  expect_conservation(result);
}

TEST(Solve, FindsTheSameRootsWithAndWithoutPresolve) {
  for (const char* name : {"badvars", "two-link", "katsura-5"}) {
    SCOPED_TRACE(name);
    const System f = system_of(problem(name));
    const SolveResult with = solve_with_cvode(f);
    SolveOptions options = with_seed(1);
    options.eliminate = false;
    const SolveResult without = solve_with_cvode(f, options);
    EXPECT_EQ(with.solutions.size(), without.solutions.size());
    for (const Solution& s : with.solutions) {
      EXPECT_EQ(test::solutions_near(without, s.x, 1e-12), 1U);
    }
  }
}

TEST(Solve, ReportsWhatIsFinishedWhenItIsStopped) {
  constexpr std::uint64_t kFinished = 10;
  const System f = system_of(problem("katsura-6"));
  const SolveResult whole = solve_with_cvode(f);
  std::atomic<bool> stop{false};
  SolveOptions options = with_seed(1);
  options.progress = [&](const Progress& progress) {
    if (progress.done == kFinished) stop = true;
  };
  const SolveResult part = solve(f, *make_cvode_tracker(), options, stop);
  EXPECT_FALSE(part.complete);
  EXPECT_EQ(part.message, "interrupted: what is finished is reported");
  EXPECT_EQ(part.paths.tracked, kFinished);
  EXPECT_EQ(part.solutions.size(), kFinished);
  expect_conservation(part);
  for (const Solution& s : part.solutions) {
    EXPECT_EQ(test::solutions_near(whole, s.x, 1e-13), 1U);
  }
}

TEST(Solve, DoesNothingWhenItIsStoppedBeforehand) {
  const std::atomic<bool> stop{true};
  const SolveResult result =
      solve(system_of(problem("katsura-5")), *make_cvode_tracker(), with_seed(1), stop);
  EXPECT_FALSE(result.complete);
  EXPECT_EQ(result.paths.tracked, 0U);
  EXPECT_TRUE(result.solutions.empty());
}

TEST(Solve, TellsItsProgressPathByPath) {
  std::uint64_t calls = 0;
  Progress last;
  SolveOptions options = with_seed(1, 2);
  options.start = StartKind::total_degree;
  options.progress = [&](const Progress& progress) {
    EXPECT_EQ(progress.done, ++calls);
    last = progress;
  };
  solve_with_cvode(system_of(problem("noon-3")), options);
  EXPECT_EQ(last.done, last.total);
  EXPECT_EQ(last.total, 27U);
  EXPECT_EQ(last.finite, 21U);
}

// At y = -20 the third equation is 1e-25.
TEST(Solve, DropsARootAtWhichASpareEquationIsOffByLessThanDoubleSees) {
  const System f = read(
      "3 2\n x - 5/3 + (y - 7/6)*(y + 20);\n (y - 7/6)*(y + 20);\n"
      " (x - 5/3)*(y + 1) + 8/10^26*(y - 7/6);\n");
  for (const std::uint64_t seed : {1U, 2U, 3U}) {
    const SolveResult result = solve_with_cvode(f, with_seed(seed));
    EXPECT_TRUE(result.complete) << result.message;
    ASSERT_EQ(result.solutions.size(), 1U);
    EXPECT_NEAR(result.solutions.front().x[1].real(), 7.0 / 6, 1e-12);
  }
}

TEST(Solve, FailsForPrecisionWhereCirclesMayNotClose) {
  SolveOptions options = with_seed(1);
  options.endgame.ends.maximum_winding = 1;
  options.maximum_tolerance_level = 0;
  // With more digits the quotient ring tells all roots, and no circle is needed.
  options.precision = Precision::double_precision;
  const SolveResult result = solve_with_cvode(read("1\n (x^2 - 2)^2*(x - i);\n"), options);
  EXPECT_FALSE(result.complete);
  EXPECT_EQ(result.paths.failed, 4U);
  for (const FailedPath& path : result.failures) EXPECT_EQ(path.failure, Failure::precision);
  expect_conservation(result);
}

TEST(Solve, FailsAtTheStepLimitAndSaysHowFarEachPathCame) {
  CvodeOptions cvode;
  cvode.maximum_steps = 3;
  SolveOptions options = with_seed(1);
  options.start = StartKind::total_degree;
  const SolveResult result =
      solve(system_of(problem("noon-3")), *make_cvode_tracker(cvode), options);
  EXPECT_FALSE(result.complete);
  EXPECT_EQ(result.paths.failed, 27U);
  expect_conservation(result);
  for (const FailedPath& path : result.failures) {
    EXPECT_EQ(path.failure, Failure::step_limit);
    EXPECT_LT(std::abs(path.t), 1);
  }
}

TEST(SolveResult, SaysThatSolveWasNotRun) {
  const SolveResult result;
  EXPECT_FALSE(result.complete);
  EXPECT_EQ(result.message, "solve() was not run");
}

}  // namespace
}  // namespace moivre
