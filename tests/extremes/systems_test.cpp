// SPDX-License-Identifier: MIT
// Does each extreme system give the right answer with both trackers, or an honest failure?
// Multiprecision is the judge.
//
// Whatever the case: the account is closed, every root called simple is one by Smale's alpha test,
// no two are the same, and none is further from the truth than its accuracy says; a root called
// singular is where the index has one.
#include <gtest/gtest.h>

#include <map>

#include "moivre/certify/certifier.h"
#include "moivre/multiprecision/reference_roots.h"
#include "moivre/polynomial/square_up.h"
#include "moivre/solver/trace.h"
#include "moivre/tracker_lanes/lane_tracker.h"
#include "problem_set.h"

namespace moivre {
namespace {

const std::string kFolder = MOIVRE_SOURCE_DIR "/problems/extremes/";
/// Of a root's true value: an isolated root is as far from its double as is told, to 15 digits of
/// that distance.
constexpr int kDigits = 40;
/// Two roots this near to each other, relative to their size, are one: below what any case holds.
constexpr double kSame = 1e-12;

struct Case {
  std::string name;
  std::string file;
  std::string expect;
  std::uint64_t simple = 0;
  std::vector<std::uint64_t> multiple;
  std::vector<std::vector<double>> multiple_at;
};

std::vector<Case> cases() {
  std::ifstream file(kFolder + "index.json");
  const nlohmann::json index = nlohmann::json::parse(file);
  std::vector<Case> all;
  for (const nlohmann::json& entry : index.at("systems")) {
    if (!entry.at("test").get<bool>()) continue;
    all.push_back({entry.at("name"), entry.at("file"), entry.at("expect"),
                   entry.value("simple", std::uint64_t{0}),
                   entry.value("multiple", std::vector<std::uint64_t>{}),
                   entry.value("multiple_at", std::vector<std::vector<double>>{})});
  }
  return all;
}

void PrintTo(const Case& c, std::ostream* out) { *out << c.name; }

Point rounded(const std::vector<ComplexDoubleDouble>& x) {
  Point point;
  for (const ComplexDoubleDouble& xi : x) point.push_back(to_complex(xi));
  return point;
}

/// Largest difference of a coordinate, relative to that coordinate.
double apart(const Point& x, const Point& y) {
  double largest = 0;
  for (std::size_t i = 0; i < x.size(); ++i) {
    const double size = std::max(std::abs(x[i]), std::abs(y[i]));
    if (size > 0) largest = std::max(largest, std::abs(x[i] - y[i]) / size);
  }
  return largest;
}

/// Judges the roots of one system; what it proved for one tracker it knows for the next.
class Judge {
 public:
  explicit Judge(const System& f) : f_(f) {}

  /// Every root called simple is a root, known as well as it says, and no other's twin.
  void expect_true_roots(const SolveResult& result);

 private:
  /// In every coordinate at a root that was proved: it needs no proof of its own.
  bool is_proved(const Solution& s) const {
    return std::any_of(proved_.begin(), proved_.end(), [&](const Point& root) {
      return apart(s.x, root) <= kSame && test::distance(s.x, root) <= s.accuracy;
    });
  }

  const System& f_;
  std::vector<Point> proved_;
};

void Judge::expect_true_roots(const SolveResult& result) {
  std::vector<Point> points;
  std::vector<Point> to_prove;
  std::vector<double> accuracy;
  for (const Solution& s : result.solutions) {
    if (s.singular) continue;
    points.push_back(s.x);
    if (is_proved(s)) continue;
    to_prove.push_back(s.x);
    accuracy.push_back(s.accuracy);
  }
  const bool is_over = f_.polynomials.size() > f_.variables.size();
  const System g = is_over ? square_up(f_, 1) : f_;
  const std::vector<ReferenceRoot> roots = reference_roots(g, to_prove, kDigits);
  for (std::size_t k = 0; k < roots.size(); ++k) {
    ASSERT_TRUE(roots[k].converged) << "root " << k;
    EXPECT_LE(roots[k].forward_error, accuracy[k]) << "root " << k;
    proved_.push_back(rounded(roots[k].nearest));
  }
  for (std::size_t k = 0; k < points.size(); ++k) {
    for (std::size_t other = 0; other < k; ++other) {
      EXPECT_GT(apart(points[k], points[other]), kSame) << "roots " << k << " and " << other;
    }
  }
}

/// Every root called singular is one of the index, known as well as it says.
void expect_singular_roots_of_the_index(const Case& c, const SolveResult& result) {
  for (const Solution& s : result.solutions) {
    if (!s.singular) continue;
    EXPECT_TRUE(std::any_of(c.multiple_at.begin(), c.multiple_at.end(),
                            [&](const auto& at) {
                              return test::distance(s.x, Point(at.begin(), at.end())) <= s.accuracy;
                            }))
        << "a singular root at " << s.x[0];
  }
}

/// Multiplicities of the singular roots, ascending; and the number of the others.
std::pair<std::vector<std::uint64_t>, std::uint64_t> counts(const SolveResult& result) {
  std::vector<std::uint64_t> multiple;
  for (const Solution& s : result.solutions) {
    if (s.singular) multiple.push_back(s.multiplicity);
  }
  std::sort(multiple.begin(), multiple.end());
  return {multiple, result.solutions.size() - multiple.size()};
}

void expect_answer(const Case& c, const SolveResult& result) {
  const auto [multiple, simple] = counts(result);
  if (c.expect == "all" || (c.expect == "honest" && result.complete)) {
    EXPECT_TRUE(result.complete) << result.message;
    EXPECT_EQ(simple, c.simple);
    EXPECT_EQ(multiple, c.multiple);
  } else if (c.expect == "honest") {
    EXPECT_GT(result.paths.failed, 0U);
    EXPECT_LE(simple, c.simple);
    EXPECT_TRUE(multiple.empty());
  } else if (c.expect == "cluster") {
    ASSERT_TRUE(result.complete) << result.message;
    EXPECT_EQ(test::sum_of_multiplicities(result), c.simple);
  } else {
    EXPECT_TRUE(result.complete) << result.message;
    EXPECT_TRUE(result.solutions.empty());
    EXPECT_TRUE(c.expect == "set" || result.paths.finite == 0);
  }
}

class Extreme : public testing::TestWithParam<Case> {};

TEST_P(Extreme, IsAnsweredRightlyOrHonestly) {
  const Case& c = GetParam();
  const System f = read_system(read_source(kFolder + c.file));
  std::vector<std::unique_ptr<Tracker>> trackers;
  trackers.push_back(make_cvode_tracker());
  trackers.push_back(make_lane_tracker());
  Judge judge(f);
  for (const auto& tracker : trackers) {
    SCOPED_TRACE(tracker->kind());
    if (c.expect == "refused") {
      EXPECT_THROW(solve(f, *tracker, test::with_seed(1)), std::invalid_argument);
      continue;
    }
    const SolveResult result = solve(f, *tracker, test::with_seed(1));
    test::expect_conservation(result);
    judge.expect_true_roots(result);
    expect_singular_roots_of_the_index(c, result);
    if (!result.complete && !proves_beyond_double()) continue;
    expect_answer(c, result);
  }
}

/// Cyclic n-roots: sums of the products of k neighbours on a circle of n unknowns, and the product
/// of all of them less 1.
System cyclic(int n) {
  std::string text = std::to_string(n) + "\n";
  for (int k = 1; k <= n; ++k) {
    for (int first = 0; first < (k == n ? 1 : n); ++first) {
      text += first == 0 ? "" : " + ";
      for (int i = 0; i < k; ++i) text += (i ? "*z" : "z") + std::to_string((first + i) % n);
    }
    text += k == n ? " - 1;\n" : ";\n";
  }
  return test::read(text);
}

// 40320 paths, the most of them to curves and to infinity; whoever stops them has an account of
// what was finished. Ends that wait for a proof are no part of it. CVODE takes twenty times as long
// for a path.
TEST(CyclicEight, InterruptedItTellsNoRootThatIsNone) {
  const System f = cyclic(8);
  const auto cvode = make_cvode_tracker();
  const auto lanes = make_lane_tracker();
  for (const auto& [tracker, patience] : {std::pair(cvode.get(), 50U), {lanes.get(), 200U}}) {
    SCOPED_TRACE(tracker->kind());
    std::atomic<bool> stop{false};
    SolveOptions options = test::with_seed(1);
    options.start = StartKind::total_degree;
    options.progress = [&stop, most = patience](const Progress& progress) {
      stop = progress.done >= most;
    };
    const SolveResult result = solve(f, *tracker, options, stop);
    EXPECT_EQ(result.start.paths, 40320U);
    EXPECT_FALSE(result.complete);
    EXPECT_GE(result.paths.tracked, patience / 2);
    test::expect_conservation(result);
    Judge(f).expect_true_roots(result);
    expect_singular_roots_of_the_index({}, result);
  }
}

// The fourfold roots are isolated and known to nobody exactly: paths to them land there in more
// digits as on simple roots, which says nothing against them.
TEST(CyclicNine, HasAllItsRootsAndEveryPathIsDecided) {
  const SolveResult result = solve(cyclic(9), *make_lane_tracker(), test::with_seed(1, 2));
  EXPECT_TRUE(result.complete) << result.message;
  EXPECT_EQ(result.paths.finite + result.paths.at_infinity, 11016U);
  std::map<std::uint64_t, std::size_t> roots;
  for (const Solution& root : result.solutions) ++roots[root.multiplicity];
  EXPECT_EQ(roots, (std::map<std::uint64_t, std::size_t>{{1, 5994}, {4, 162}}));
}

// Winding numbers of nine and more: all circles are near singular points, where Newton's method
// refuses what CVODE's tolerance allows. Each took it 10000 steps and more, and failed. Alone; in a
// run their cycles share them.
TEST(CyclicNine, PathsToInfinityTakeCvodeFewSteps) {
  const std::atomic<bool> go_on{false};
  const System f = cyclic(9);
  const auto tracker = make_cvode_tracker();
  for (const std::uint64_t path : {37U, 67U, 191U, 218U, 276U, 319U, 363U, 507U, 516U, 567U}) {
    const Trace trace = trace_path(f, *tracker, test::with_seed(1), path, go_on);
    EXPECT_EQ(trace.end.status, PathStatus::at_infinity) << path;
    EXPECT_LT(trace.end.count.accepted, 4500U) << path;
  }
}

// Beyond a size of 1e4 a row of degree 40 is less than 1e-154, whose square is no double.
TEST(DegreeForty, LanesSeeEachPathEndAtInfinity) {
  const System f = test::read("3\nx^40 - (3*x-1)^2;\ny*(x+1) - 1;\nz*(x+2) - 1;\n");
  SolveOptions options;
  options.start = StartKind::total_degree;
  options.every_path = true;
  for (options.seed = 1; options.seed <= 3; ++options.seed) {
    SCOPED_TRACE(options.seed);
    const SolveResult result = solve(f, *make_lane_tracker(), options);
    EXPECT_EQ(result.solutions.size(), 40U);
    EXPECT_EQ(result.paths.at_infinity, 120U);
    EXPECT_LT(result.paths.retracked, 40U);
  }
}

/// One unknown, and n fractions of it, by total degree: most paths go to infinity, slowly. All
/// roots are found, by proof.
SolveResult solved_with_fractions(const std::string& equation, int n) {
  std::string text = std::to_string(n + 1) + "\n" + equation + ";\n";
  for (int i = 1; i <= n; ++i) {
    text += "y" + std::to_string(i) + "*(x+" + std::to_string(i) + ") - 1;\n";
  }
  SolveOptions options = test::with_seed(1, 2);
  options.start = StartKind::total_degree;
  SolveResult result = solve(test::read(text), *make_lane_tracker(), options);
  test::expect_conservation(result);
  EXPECT_EQ(result.completeness, RootCompleteness::proved);
  return result;
}

// Two roots 2e-63 apart have no proof in double. To follow 163 800 paths to infinity takes twenty
// times as long as to ask algebra for two roots.
TEST(ManyPathsToInfinity, WaitUntilAlgebraWasAskedForTheRootsThatAreMissing) {
  const SolveResult result = solved_with_fractions("x^40 - (1000*x-1)^2", 12);
  EXPECT_EQ(result.solutions.size(), 40U);
  EXPECT_EQ(result.paths.by_count, 2U);
  EXPECT_EQ(result.paths.at_infinity, 0U);
  EXPECT_EQ(result.paths.not_needed, result.start.paths - 40U);
}

// Of 16 unknowns algebra has no ring. The two paths to roots 2e-15 apart wait at small points, and
// are followed on with the first of the 131 070.
TEST(ManyPathsToInfinity, AreNotNeededOnceProofsPartTheClusterThatMakesTheRootsAsManyAsTheBound) {
  const SolveResult result = solved_with_fractions("x^4 - (100000*x-1)^2", 15);
  EXPECT_EQ(result.solutions.size(), 4U);
  EXPECT_EQ(result.paths.by_count, 0U);
  EXPECT_LT(result.paths.at_infinity, 1000U);
}

/// The discretized H-equation: 2 n H_i - c H_i (1 + sum_j i/(i+j) H_j) - 2 n, j = 1..n-1
/// [Chandrasekhar60].
System chandra(int n) {
  std::string text = std::to_string(n) + "\n";
  for (int i = 1; i <= n; ++i) {
    const std::string H = "H" + std::to_string(i);
    text += std::to_string(2 * n) + "*" + H + " - 0.51234*" + H + "*(1";
    for (int j = 1; j < n; ++j) {
      text += " + (" + std::to_string(i) + "/" + std::to_string(i + j) + ")*H" + std::to_string(j);
    }
    text += ") - " + std::to_string(2 * n) + ";\n";
  }
  return test::read(text);
}

// Roots up to 5e6; one half of the 1024 paths goes to infinity.
TEST(ChandraTen, HasEveryRootInLanes) {
  const System f = chandra(10);
  const SolveResult result = solve(f, *make_lane_tracker(), test::with_seed(1));
  EXPECT_TRUE(result.complete) << result.message;
  EXPECT_EQ(result.solutions.size(), 512U);
  EXPECT_EQ(result.paths.at_infinity + result.paths.not_needed, result.start.paths - 512U);
  test::expect_conservation(result);
  Judge(f).expect_true_roots(result);
}

// With these seeds ends that double blurs lie beside one of the four that it does not.
TEST(ClusterOfFour, IsNoRootOfMultiplicityFour) {
  const System f = read_system(read_source(kFolder + "four-near.phc"));
  Judge judge(f);
  const auto cvode = make_cvode_tracker();
  const auto lanes = make_lane_tracker();
  for (const std::uint64_t seed : {4U, 11U, 18U, 36U}) {
    for (const Tracker* tracker : {cvode.get(), lanes.get()}) {
      SCOPED_TRACE(tracker->kind() + ", seed " + std::to_string(seed));
      const SolveResult result = solve(f, *tracker, test::with_seed(seed));
      test::expect_conservation(result);
      judge.expect_true_roots(result);
      EXPECT_TRUE(result.complete) << result.message;
      EXPECT_EQ(counts(result).second, 6U);
    }
  }
}

TEST(ClusterOfTwo, LiesWithinItsAccuracy) {
  constexpr double kRoundingOfTheExpected = 0x1p-53;
  const System f = read_system(read_source(kFolder + "two-near.phc"));
  const SolveResult result = test::solve_with_cvode(f);
  for (const double root : {1 - 1e-7, 1 + 1e-7}) {
    EXPECT_TRUE(std::any_of(result.solutions.begin(), result.solutions.end(), [&](const auto& s) {
      return test::distance(s.x, {root, root}) <= s.accuracy + kRoundingOfTheExpected;
    }));
  }
}

INSTANTIATE_TEST_SUITE_P(Index, Extreme, testing::ValuesIn(cases()), [](const auto& test) {
  std::string name = test.param.name;
  std::replace(name.begin(), name.end(), '-', '_');
  return name;
});

}  // namespace
}  // namespace moivre
