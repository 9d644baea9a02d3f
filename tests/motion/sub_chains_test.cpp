// SPDX-License-Identifier: MIT
// Are closures and motions of independent sub-chains, each found on its own, those of the mechanism
// as a whole?
#include "moivre/closures/sub_chains.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "closure_poses.h"
#include "closure_roots.h"
#include "closure_search.h"
#include "gap.h"
#include "mechanisms.h"
#include "moivre/motion/circuits.h"
#include "moivre/numeric/random.h"
#include "motion_product.h"
#include "people.h"

namespace moivre {
namespace {

using test::gap;

/// A crank with dyads, couplers c1, c2, ... and rockers r1, r2, ... of these lengths.
struct Dyad {
  double coupler = 3;
  double rocker = 3;
  double x = 4;  ///< of the rocker's pivot
};

std::string legs_text(const std::vector<Dyad>& dyads) {
  std::string ground = "[ground.points]\nO = [0, 0]\n";
  std::string bodies = "[body.crank.points]\nO = [0, 0]\nA = [1, 0]\n";
  std::string joints = "[[joint]]\ntype = \"revolute\"\nat = [\"ground.O\", \"crank.O\"]\n";
  const auto revolute = [](const std::string& a, const std::string& b) {
    return "[[joint]]\ntype = \"revolute\"\nat = [\"" + a + "\", \"" + b + "\"]\n";
  };
  for (std::size_t k = 0; k < dyads.size(); ++k) {
    const std::string n = std::to_string(k + 1);
    ground += "G" + n + " = [" + std::to_string(dyads[k].x) + ", 0]\n";
    bodies += "[body.c" + n + ".points]\nA = [0, 0]\nB = [" + std::to_string(dyads[k].coupler) +
              ", 0]\n[body.r" + n + ".points]\nG = [0, 0]\nB = [" +
              std::to_string(dyads[k].rocker) + ", 0]\n";
    joints += revolute("crank.A", "c" + n + ".A") + revolute("c" + n + ".B", "r" + n + ".B") +
              revolute("r" + n + ".G", "ground.G" + n);
  }
  return ground + bodies + joints +
         "[[driver]]\nangle = \"crank\"\nstart = 0.3\nvelocity = 6.283185307179586\n";
}

Mechanism legs(const std::vector<Dyad>& dyads) { return mechanism_text(legs_text(dyads)); }

/// Of a search that knows no sub-chains.
ClosureResult closures_of_whole(const Mechanism& mechanism, std::uint64_t seed) {
  ClosureOptions options;
  options.solve.seed = seed;
  options.solve.threads = 1;
  const auto tracker = make_cvode_tracker();
  const std::atomic<bool> stop{false};
  ClosureSearch search(mechanism, *tracker, options, stop);
  search.result.complete = true;
  find_roots(search);
  find_poses(search);
  return search.result;
}

TEST(SubChains, AreWhatTheDrivenCrankAndTheGroundAloneTieTogether) {
  const auto chains = independent_chains(legs({{}, {3, 2, 3}, {2, 3, 3}}));
  ASSERT_EQ(chains.size(), 3U);
  EXPECT_EQ(chains[1].bodies, (std::vector<std::string>{"c2", "r2"}));
  EXPECT_EQ(chains[1].mechanism.joints.size(), 4U);
  EXPECT_EQ(chains[1].mechanism.drivers.size(), 1U);
  EXPECT_EQ(chains[1].coordinates, (std::vector<Eigen::Index>{0, 1, 2, 9, 10, 11, 12, 13, 14}));
}

TEST(SubChains, AreNoneOfOneLegAndOfTypedEquations) {
  EXPECT_TRUE(independent_chains(legs({{}})).empty());
  EXPECT_TRUE(independent_chains(mechanism_file("four-bar")).empty());
  EXPECT_TRUE(independent_chains(mechanism_file("slider-crank-equations")).empty());
}

TEST(SubChains, AreOneWhereARodTiesThem) {
  const std::string rod = "[[joint]]\ntype = \"rod\"\nat = [\"c1.B\", \"c2.B\"]\nlength = 1.5\n";
  EXPECT_TRUE(independent_chains(mechanism_text(legs_text({{}, {}}) + rod)).empty());
}

TEST(SubChains, AreOneWithACrankThatIsFreeToTurn) {
  Mechanism free = legs({{}, {}});
  free.drivers.clear();
  EXPECT_TRUE(independent_chains(free).empty());
}

TEST(SubChains, GiveTheClosuresOfASearchThatKnowsNoneOfThem) {
  for (const std::uint64_t seed : {1U, 2U, 3U, 4U, 5U, 6U}) {
    std::vector<Dyad> dyads;
    for (std::uint64_t k = 0; k < 9; k += 3) {
      const auto number = [&](std::uint64_t n) {
        return random_unit(seed, RandomStream::test, k + n);
      };
      dyads.push_back({1 + 2 * number(0), 1 + 2 * number(1), 1.5 + 2 * number(2)});
    }
    const Mechanism mechanism = legs(dyads);
    const ClosureResult apart = closures_of(mechanism, seed);
    const ClosureResult whole = closures_of_whole(mechanism, seed);
    EXPECT_EQ(apart.counts.complex, whole.counts.complex);
    EXPECT_EQ(apart.counts.real, whole.counts.real);
    EXPECT_EQ(apart.solutions.size(), whole.solutions.size());
    ASSERT_EQ(apart.closures.size(), whole.closures.size());
    for (std::size_t k = 0; k < whole.closures.size(); ++k) {
      EXPECT_EQ(apart.closures[k].id, whole.closures[k].id);
      EXPECT_LE(gap(mechanism, apart.closures[k].q, whole.closures[k].q), 1e-9);
      EXPECT_NEAR(apart.closures[k].smallest_singular_value,
                  whole.closures[k].smallest_singular_value, 1e-9);
    }
    for (const Solution& root : whole.solutions) {
      EXPECT_TRUE(
          std::any_of(apart.solutions.begin(), apart.solutions.end(), [&](const Solution& other) {
            double apart_by = 0;
            for (std::size_t v = 0; v < root.x.size(); ++v) {
              apart_by = std::max(apart_by, std::abs(root.x[v] - other.x[v]));
            }
            return apart_by <= 1e-8 && other.real == root.real;
          }));
    }
  }
}

TEST(SubChains, CountOnlyWhatIsWithinTheLimitsOfEach) {
  const std::string limited = legs_text({{}, {}});
  Mechanism mechanism = mechanism_text(limited);
  for (Joint& joint : mechanism.joints) {
    if (mechanism.bodies[joint.at[0].body].name == "r1") joint.limits = Limits{-3.2, 0};
  }
  const ClosureResult result = closures_of(mechanism);
  EXPECT_EQ(result.counts.real, 4U);
  EXPECT_EQ(result.counts.filtered, 2U);
  EXPECT_EQ(result.closures.size(), 2U);
}

TEST(SubChains, AreCountedWhereTheirProductIsTooLongToBeListed) {
  const ClosureResult result = closures_of(legs(std::vector<Dyad>(40)));
  EXPECT_EQ(result.counts.complex, std::uint64_t{1} << 40);
  EXPECT_EQ(result.counts.real, std::uint64_t{1} << 40);
  EXPECT_FALSE(result.all_listed);
  EXPECT_EQ(result.sub_chains.size(), 40U);
  EXPECT_EQ(result.closures.size(), 41U);
  EXPECT_EQ(result.paths.tracked, 80U);
  for (const Closure& closure : result.closures) EXPECT_LE(closure.residual, 1e-12);
}

TEST(SubChains, LeaveAVerdictToTheWholeWhereOneOfThemHasNoClosure) {
  const ClosureResult result = closures_of(legs({{}, {1, 1, 9}}));
  EXPECT_EQ(result.counts.real, 0U);
  EXPECT_TRUE(result.closures.empty());
}

MotionOptions one_turn(int steps) {
  MotionOptions options;
  options.to = 1;
  options.steps = steps;
  options.solve.threads = 1;
  return options;
}

/// Every branch of one motion beside the other's that is at the same pose at the same time.
void expect_same_branches(const Mechanism& mechanism, const MotionResult& apart,
                          const MotionResult& whole) {
  ASSERT_EQ(apart.branches.size(), whole.branches.size());
  for (const MotionBranch& branch : whole.branches) {
    const auto same =
        std::find_if(apart.branches.begin(), apart.branches.end(), [&](const MotionBranch& other) {
          return other.samples.size() == branch.samples.size() && !branch.samples.empty() &&
                 gap(mechanism, other.samples.front().q, branch.samples.front().q) <= 1e-8 &&
                 gap(mechanism, other.samples.back().q, branch.samples.back().q) <= 1e-8;
        });
    ASSERT_NE(same, apart.branches.end()) << branch.id;
    EXPECT_NEAR(same->begins, branch.begins, 1e-8);
    EXPECT_NEAR(same->ends, branch.ends, 1e-8);
    EXPECT_EQ(same->begin_event.has_value(), branch.begin_event.has_value());
    EXPECT_EQ(same->end_event.has_value(), branch.end_event.has_value());
    EXPECT_LE(gap(mechanism, same->end_pose, branch.end_pose), 1e-5);
    if (branch.begins == whole.from && !branch.begin_event) {
      EXPECT_EQ(same->id, branch.id);
    }
    for (std::size_t k = 0; k < branch.samples.size(); ++k) {
      EXPECT_LE((same->samples[k].velocity - branch.samples[k].velocity).norm(),
                1e-6 * branch.samples[k].velocity.norm());
    }
  }
}

TEST(SubChains, MoveAsTheWholeDoes) {
  const Mechanism mechanism =
      legs({{3, 2.5, 3}, {2, 1.2, 2.8}});  // a crank-rocker, and a double rocker
  const auto tracker = make_cvode_tracker();
  const std::atomic<bool> stop{false};
  const MotionResult apart = find_motion(mechanism, *tracker, one_turn(72));
  const MotionResult whole = find_motion_of_whole(mechanism, *tracker, one_turn(72), stop);
  EXPECT_TRUE(apart.complete) << apart.message;
  EXPECT_TRUE(whole.complete) << whole.message;
  ASSERT_EQ(apart.sub_chains.size(), 2U);
  EXPECT_GT(apart.events.size(), 0U);
  EXPECT_EQ(apart.events.size(), whole.events.size());
  expect_same_branches(mechanism, apart, whole);
  const Circuits of_apart = find_circuits(mechanism, apart);
  const Circuits of_whole = find_circuits(mechanism, whole);
  ASSERT_EQ(of_apart.circuits.size(), of_whole.circuits.size());
  for (std::size_t c = 0; c < of_whole.circuits.size(); ++c) {
    const Circuit& a = of_apart.circuits[c];
    const Circuit& w = of_whole.circuits[c];
    EXPECT_EQ(a.branches.size(), w.branches.size());
    EXPECT_EQ(a.driver_motion, w.driver_motion);
    ASSERT_EQ(a.bodies.size(), w.bodies.size());
    for (std::size_t b = 0; b < w.bodies.size(); ++b) {
      EXPECT_EQ(a.bodies[b].turns, w.bodies[b].turns);
      EXPECT_NEAR(a.bodies[b].lower, w.bodies[b].lower, 1e-4);
      EXPECT_NEAR(a.bodies[b].upper, w.bodies[b].upper, 1e-4);
    }
  }
}

TEST(SubChains, WithDeadPointsAtOneTimeMeetThereAllOfThem) {
  const Mechanism mechanism = legs({{2.5, 2, 4}, {2.5, 2, 4}});
  const MotionResult motion = find_motion(mechanism, *make_cvode_tracker(), one_turn(72));
  ASSERT_EQ(motion.sub_chains.size(), 2U);
  ASSERT_EQ(motion.branches.size(), 8U);
  ASSERT_EQ(motion.events.size(), 2U);
  for (const MotionEvent& event : motion.events) {
    EXPECT_EQ(event.at.kind, EventKind::bifurcation);
    EXPECT_EQ(event.ending.size() + event.beginning.size(), 4U);
  }
  EXPECT_EQ(find_circuits(mechanism, motion).circuits.size(), 1U);
}

TEST(SubChains, CheckpointsOfTheWholeMultiplyThoseOfEach) {
  const MotionResult motion =
      find_motion(legs({{}, {3, 2.5, 3}}), *make_cvode_tracker(), one_turn(8));
  ASSERT_FALSE(motion.checkpoints.empty());
  for (const Checkpoint& row : motion.checkpoints) {
    EXPECT_TRUE(row.agrees) << row.message;
    EXPECT_EQ(row.counts.real, 4U);
    EXPECT_EQ(row.branches.size(), 4U);
  }
  EXPECT_EQ(motion.branches.front().samples.size(), 9U);
  EXPECT_EQ(motion.sub_chains.front().motion.branches.front().samples.size(), 9U);
}

/// Two cranks pinned to one more point of the bar than it needs, with lengths typed to two digits,
/// and the bar held within the angles.
std::string rounded_leg_text(const std::string& limits) {
  return R"([body.c2.points]
O = [0, 0]
B = [1, 0]
[body.c3.points]
O = [0, 0]
C = [1, 0]
[body.bar.points]
A = [0, 0]
B = [3, 0]
C = [1.5, 0.001]
[[joint]]
type = "revolute"
at = ["crank.A", "bar.A"]
[[joint]]
type = "revolute"
at = ["ground.P2", "c2.O"]
)" + limits +
         R"([[joint]]
type = "revolute"
at = ["ground.P3", "c3.O"]
[[joint]]
type = "revolute"
at = ["c2.B", "bar.B"]
[[joint]]
type = "revolute"
at = ["c3.C", "bar.C"]
)";
}

/// A dyad, and a parallel leg that closes within `fit` only.
Mechanism with_rounded_leg(const std::string& limits) {
  std::string text = legs_text({{3, 2.5, 3}});
  text.insert(text.find("[body."), "P2 = [3, 0]\nP3 = [1.5, 0]\n");
  text.insert(text.find("[[driver]]"), rounded_leg_text(limits));
  return mechanism_text("fit = 0.01\n" + text);
}

TEST(SubChains, ClosuresThatAreFittedAreCountedWithThoseOfTheOtherChains) {
  const MotionResult motion = find_motion(with_rounded_leg(""), *make_cvode_tracker(), one_turn(8));
  ASSERT_EQ(motion.sub_chains.size(), 2U);
  const Checkpoint& first = motion.checkpoints.front();
  EXPECT_EQ(first.counts.real, 0U);
  EXPECT_EQ(first.counts.filtered, 0U);
  EXPECT_EQ(first.counts.fitted, 2U);
  EXPECT_EQ(first.message, "one to one in each sub-chain: 2 closures, 2 branches listed");
}

TEST(SubChains, FittedClosuresBeyondLimitsAreNoneOfTheRealOnes) {
  const Mechanism mechanism = with_rounded_leg("limits = [3, 4]\n");
  const ClosureResult closures = closures_of(mechanism);
  EXPECT_EQ(closures.counts.filtered, 0U);
  EXPECT_EQ(closures.counts.fitted, closures.closures.size());
  EXPECT_GT(closures.fitted_beyond_limits, 0U);
  EXPECT_EQ(closures.message, "every path was decided");  // and no wider fit would help
  const MotionResult motion = find_motion(mechanism, *make_cvode_tracker(), one_turn(8));
  EXPECT_EQ(motion.checkpoints.front().counts.filtered, 0U);
  EXPECT_EQ(motion.checkpoints.front().counts.real, 0U);
}

TEST(SubChains, FittedClosuresOfTheWholeHaveNoneBeyondLimits) {
  ClosureCounts real, fitted;
  real.complex = real.real = 4;
  real.filtered = 1;
  fitted.complex = fitted.real = 2;
  fitted.fitted = 5;
  const ClosureCounts whole = product_of({real, fitted});
  EXPECT_EQ(whole.real, 8U);
  EXPECT_EQ(whole.filtered, 2U);
  EXPECT_EQ(whole.fitted, 15U);
}

TEST(SubChains, CountsOfTheWholeStopAtTheLargestNumber) {
  ClosureCounts part;
  part.complex = part.real = std::uint64_t{1} << 40;
  part.filtered = part.real / 2;
  part.rejected = 3;
  const ClosureCounts whole = product_of({part, part});
  EXPECT_EQ(whole.complex, ~std::uint64_t{0});
  EXPECT_EQ(whole.real, ~std::uint64_t{0});
  EXPECT_EQ(whole.rejected, 6U);
  part.filtered = part.real;
  EXPECT_EQ(product_of({part, part}).filtered, ~std::uint64_t{0});
}

TEST(SubChains, OfManyBranchesOneIsListedThoughNothingElseIsThereInItsMiddle) {
  std::vector<Dyad> dyads(8, {3, 2.5, 3});
  dyads.push_back({2, 1.2, 2.8});  // there at the beginning and at the end of the turn alone
  const MotionResult motion = find_motion(legs(dyads), *make_cvode_tracker(), one_turn(4));
  EXPECT_FALSE(motion.all_listed);
  for (std::size_t k = 0; k < motion.sub_chains.size(); ++k) {
    for (const MotionBranch& part : motion.sub_chains[k].motion.branches) {
      EXPECT_TRUE(std::any_of(motion.branches.begin(), motion.branches.end(),
                              [&](const MotionBranch& whole) { return whole.of[k] == part.id; }))
          << k << part.id;
    }
  }
}

TEST(SubChains, ManyBranchesAreListedOnceForEachOfASubChain) {
  const MotionResult motion =
      find_motion(legs(std::vector<Dyad>(9, {3, 2.5, 3})), *make_cvode_tracker(), one_turn(4));
  EXPECT_FALSE(motion.all_listed);
  EXPECT_EQ(motion.branches.size(), 10U);
  EXPECT_TRUE(motion.complete) << motion.message;
  EXPECT_EQ(motion.checkpoints.front().counts.real, 512U);
}

MotionOptions short_motion() {
  MotionOptions options;
  options.to = 0.02;
  options.steps = 2;
  options.checkpoints = 1;
  options.solve.threads = 1;
  return options;
}

std::vector<std::vector<std::string>> reached(const Mechanism& mechanism, const MotionResult& all,
                                              const std::string& name) {
  std::vector<std::vector<std::string>> of;
  for (const MotionBranch& branch :
       reachable_from(all, find_circuits(mechanism, all), {name}).branches) {
    of.push_back(branch.of);
  }
  return of;
}

TEST(SubChainNames, AreThoseOfTheWholeOfOneOfEachAndOfASingleSubChain) {
  const Mechanism mechanism = test::person("letters-collide-jansen-double");
  const MotionResult all = find_motion(mechanism, *make_cvode_tracker(), short_motion());
  EXPECT_EQ(all.drawn, "AT");
  const std::vector<std::string> drawn{"E", "H"};
  for (const char* name : {"AT", "E.H", "drawn"}) {
    const auto of = reached(mechanism, all, name);
    EXPECT_NE(std::find(of.begin(), of.end(), drawn), of.end()) << name;
  }
  const auto of_first = reached(mechanism, all, "1:E");
  EXPECT_GE(of_first.size(), all.sub_chains[1].motion.branches.size());
  for (const auto& of : of_first) EXPECT_EQ(of[0], "E");
  const auto of_second = reached(mechanism, all, "2:H");
  for (const auto& of : of_second) EXPECT_EQ(of[1], "H");
  EXPECT_THROW(reached(mechanism, all, "3:E"), std::invalid_argument);
  const MotionResult left = reachable_from(all, find_circuits(mechanism, all), {"E.H"});
  EXPECT_LT(left.sub_chains[0].motion.branches.size(), all.sub_chains[0].motion.branches.size());
}

TEST(SubChainNames, OfClosuresThatAreNotListedAreFollowedWhereTheyAreAskedFor) {
  const Mechanism mechanism = test::person("strandbeest-4-drawn-pose-not-listed");
  MotionOptions options = short_motion();
  options.asked = {"A.B.C.D"};
  const MotionResult all = find_motion(mechanism, *make_cvode_tracker(), options);
  EXPECT_FALSE(all.all_listed);
  EXPECT_EQ(all.drawn, "G.H.C.B");
  for (const char* name : {"G.H.C.B", "A.B.C.D", "drawn"}) {
    EXPECT_FALSE(reached(mechanism, all, name).empty()) << name;
  }
}

TEST(PeoplesMotions, OfAValveGearAndOfASuspensionAreDecidedInFewSteps) {
  for (const auto& [name, branches, checkpoints] : {std::tuple("walschaerts-motion-slow", 18U, 40U),
                                                    std::tuple("vpp-shock-undecided", 4U, 10U)}) {
    MotionOptions options;
    options.solve.threads = 1;
    const MotionResult motion = find_motion(test::person(name), *make_cvode_tracker(), options);
    EXPECT_TRUE(motion.complete) << name << ": " << motion.message;
    EXPECT_EQ(motion.branches.size(), branches) << name;
    EXPECT_LE(motion.checkpoints.size(), checkpoints) << name;
    EXPECT_LE(motion.steps, 1000) << name;
    for (const LeftOut& step : motion.left_out) {
      EXPECT_NE(step.what, "a short branch, if there is one") << name << ": " << step.why;
    }
  }
}

}  // namespace
}  // namespace moivre
