// SPDX-License-Identifier: MIT
// Are circuits those that a hand finds which moves the linkage, and do links turn and rock as the
// books say?
#include "moivre/motion/circuits.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numbers>
#include <set>

#include "linkages.h"
#include "mechanisms.h"
#include "moivre/closures/four_bars.h"
#include "moivre/closures/same_pose.h"
#include "moivre/numeric/random.h"
#include "traced_circuit.h"

namespace moivre {
namespace {

using Eigen::VectorXd;
using test::four_bar;
using test::kDegree;
using Groups = std::set<std::set<std::string>>;

MotionResult motion_of(const Mechanism& mechanism, int steps = 100) {
  MotionOptions options;
  options.to = natural_duration(mechanism);
  options.steps = steps;
  options.solve.threads = 1;
  return find_motion(mechanism, *make_cvode_tracker(), options);
}

const Swing& swing_of(const std::vector<Swing>& swings, std::string_view name) {
  return *std::find_if(swings.begin(), swings.end(),
                       [&](const Swing& swing) { return swing.name == name; });
}

/// The ids of each circuit's branches.
Groups groups_of(const Circuits& circuits, const MotionResult& motion) {
  Groups groups;
  for (const Circuit& circuit : circuits.circuits) {
    std::set<std::string> ids;
    for (const std::size_t k : circuit.branches) ids.insert(motion.branches[k].id);
    groups.insert(ids);
  }
  return groups;
}

/// Every closure at the beginning is traced by hand: the same closures on a circuit, the same
/// angles.
void expect_as_traced(const Mechanism& mechanism, const std::string& what) {
  constexpr double kStep = 0.01;
  constexpr double kMissedBetweenSteps = 1e-4;
  const MotionResult motion = motion_of(mechanism);
  ASSERT_TRUE(motion.complete) << what << ": " << motion.message;
  const Circuits circuits = find_circuits(mechanism, motion);
  EXPECT_TRUE(circuits.is_full_turn) << what;
  EXPECT_TRUE(circuits.notes.empty()) << what;
  const Phi phi(mechanism);
  const test::CircuitTracer tracer(mechanism, kStep);
  for (const std::size_t first : first_branches(motion)) {
    const Circuit& circuit = circuits.circuits[circuit_of(circuits, first)];
    const test::TracedCircuit traced = tracer.trace(motion.branches[first].samples.front().q);
    ASSERT_TRUE(traced.is_closed) << what << ' ' << motion.branches[first].id;
    for (const std::size_t other : first_branches(motion)) {
      const bool is_met =
          other == first ||
          std::any_of(traced.crossings.begin(), traced.crossings.end(), [&](const VectorXd& q) {
            return distance(phi, q, motion.branches[other].samples.front().q) < kSamePose;
          });
      const bool is_told = circuit_of(circuits, other) == circuit_of(circuits, first);
      EXPECT_EQ(is_told, is_met) << what << ' ' << motion.branches[first].id << ' '
                                 << motion.branches[other].id;
    }
    for (std::size_t body = 0; body < circuit.bodies.size(); ++body) {
      const Swing& swing = circuit.bodies[body];
      const auto i = static_cast<Eigen::Index>(3 * body + 2);
      EXPECT_EQ(swing.turns, std::abs(traced.turns[i])) << what << ' ' << swing.name;
      if (swing.turns != 0) continue;
      EXPECT_NEAR(swing.upper - swing.lower, traced.upper[i] - traced.lower[i], kMissedBetweenSteps)
          << what << ' ' << swing.name;
      EXPECT_NEAR(std::remainder(swing.lower - traced.lower[i], 2 * std::numbers::pi), 0,
                  kMissedBetweenSteps)
          << what << ' ' << swing.name;
    }
  }
}

std::vector<std::array<double, 2>> random_places(std::uint64_t seed) {
  std::vector<std::array<double, 2>> places;
  for (std::uint64_t k = 0; k < 7; ++k) {
    places.push_back({4 * random_unit(seed, RandomStream::test, 2 * k),
                      4 * random_unit(seed, RandomStream::test, 2 * k + 1)});
  }
  return places;
}

TEST(Circuits, ClosuresOfAWholeTurnAreOnCircuitsOfTheirOwn) {
  const Mechanism m = mechanism_file("four-bar");
  const MotionResult motion = motion_of(m);
  const Circuits circuits = find_circuits(m, motion);
  EXPECT_EQ(groups_of(circuits, motion), (Groups{{"A"}, {"B"}}));
  for (const Circuit& circuit : circuits.circuits) {
    EXPECT_EQ(circuit.driver_motion, DriverMotion::turns);
    EXPECT_EQ(circuit.drivers[0].turns, 1);
    EXPECT_EQ(swing_of(circuit.bodies, "crank").turns, 1);
    EXPECT_EQ(swing_of(circuit.bodies, "rocker").turns, 0);
  }
  EXPECT_FALSE(passages_from(circuits, 0)[1]);
}

TEST(Circuits, CrankRockersLimitsAreThoseOfTheCosineLaw) {
  // The rocker stands at its limits where crank and coupler are in one line.
  constexpr double kAngle = 1e-7;
  constexpr double g = 6;
  constexpr double a = 2;
  constexpr double h = 7;
  constexpr double b = 5;
  const Mechanism m = four_bar({g, a, h, b}, 40);
  const Circuits circuits = find_circuits(m, motion_of(m));
  ASSERT_EQ(circuits.circuits.size(), 2U);
  const auto limit = [&](double reach) {
    return std::numbers::pi - std::acos((g * g + b * b - reach * reach) / (2 * g * b));
  };
  for (const Circuit& circuit : circuits.circuits) {
    const Swing& rocker = swing_of(circuit.bodies, "output");
    const bool is_up = rocker.lower > 0;
    EXPECT_NEAR(rocker.lower, is_up ? limit(a + h) : -limit(h - a), kAngle);
    EXPECT_NEAR(rocker.upper, is_up ? limit(h - a) : -limit(a + h), kAngle);
  }
}

TEST(Circuits, DriverThatRocksStandsInDeadPointsWhereTheCosineLawSays) {
  // RRR3: one circuit; the input goes as far as coupler and output reach in one line.
  constexpr double g = 5;
  constexpr double a = 4;
  constexpr double h = 8;
  constexpr double b = 3;
  const Mechanism m = four_bar({g, a, h, b}, 100);
  const MotionResult motion = motion_of(m);
  const Circuits circuits = find_circuits(m, motion);
  ASSERT_EQ(circuits.circuits.size(), 1U);
  const Circuit& circuit = circuits.circuits[0];
  EXPECT_EQ(circuit.driver_motion, DriverMotion::rocks);
  EXPECT_EQ(circuit.stretches.size(), 2U);
  EXPECT_EQ(circuit.dead_points.size(), 2U);
  const double inner = std::acos((g * g + a * a - (h - b) * (h - b)) / (2 * g * a));
  EXPECT_NEAR(circuit.drivers[0].lower, inner, 1e-10);
  EXPECT_NEAR(circuit.drivers[0].upper, 2 * std::numbers::pi - inner, 1e-10);
  const auto ways = passages_from(circuits, 0);
  ASSERT_TRUE(ways[1]);
  EXPECT_EQ(ways[1]->dead_points, 1);
}

/// Lengths g, a, h, b of the type, by rejection.
std::array<double, 4> lengths_of(FourBarType type, std::uint64_t seed) {
  std::array<double, 4> lengths{};
  for (std::uint64_t k = 0;; ++k) {
    for (std::uint64_t j = 0; j < 4; ++j) {
      lengths[j] = 1 + 3 * random_unit(seed, RandomStream::test, 4 * k + j);
    }
    if (four_bar_type(lengths) == type) return lengths;
  }
}

TEST(Circuits, GrashofsEightTypesTurnAndRockAsTheirNamesSay) {
  struct Expected {
    FourBarType type;
    std::size_t circuits;
    std::array<int, 3> turns;  // input, coupler, output
  };
  const Expected all[] = {
      {FourBarType::double_crank, 2, {1, 1, 1}},
      {FourBarType::crank_rocker, 2, {1, 0, 0}},
      {FourBarType::double_rocker, 2, {0, 1, 0}},
      {FourBarType::rocker_crank, 2, {0, 0, 1}},
      {FourBarType::triple_rocker_frame, 1, {0, 0, 0}},
      {FourBarType::triple_rocker_input, 1, {0, 0, 0}},
      {FourBarType::triple_rocker_coupler, 1, {0, 0, 0}},
      {FourBarType::triple_rocker_output, 1, {0, 0, 0}},
  };
  for (const Expected& expected : all) {
    for (const std::uint64_t seed : {std::uint64_t{1}, std::uint64_t{2}}) {
      const Mechanism m = four_bar(lengths_of(expected.type, seed), 100);
      const std::string what = barker_letters(expected.type) + ' ' + std::to_string(seed);
      const Circuits circuits = find_circuits(m, motion_of(m));
      EXPECT_EQ(circuits.circuits.size(), expected.circuits) << what;
      for (const Circuit& circuit : circuits.circuits) {
        for (std::size_t k = 0; k < 3; ++k) {
          EXPECT_EQ(circuit.bodies[k].turns, expected.turns[k]) << what << ' ' << k;
        }
        const bool is_crank = expected.turns[0] != 0;
        EXPECT_EQ(circuit.driver_motion, is_crank ? DriverMotion::turns : DriverMotion::rocks)
            << what;
      }
    }
  }
}

TEST(Circuits, FourBarsAreAsTraced) {
  for (int type = 0; type < 8; ++type) {
    const auto lengths = lengths_of(static_cast<FourBarType>(type), 7);
    expect_as_traced(four_bar(lengths, 100), barker_letters(static_cast<FourBarType>(type)));
  }
}

TEST(Circuits, StephensonsThreeHasTwoCirclesAndOneThatRocks) {
  const Mechanism m = mechanism_file("stephenson-3");
  const MotionResult motion = motion_of(m);
  const Circuits circuits = find_circuits(m, motion);
  EXPECT_EQ(groups_of(circuits, motion), (Groups{{"A"}, {"B"}, {"C", "D", "E", "F"}}));
  const Circuit& third = circuits.circuits[2];
  EXPECT_EQ(third.driver_motion, DriverMotion::rocks);
  EXPECT_NEAR(third.drivers[0].lower / kDegree, 16.07606, 1e-5);
  EXPECT_NEAR(third.drivers[0].upper / kDegree, 220.3365, 1e-4);
  EXPECT_EQ(third.stretches.size(), 2U);
  for (const auto& stretch : third.stretches) {
    ASSERT_EQ(stretch.size(), 2U);
    // The branch that begins late is the first one of the stretch: the driver stands a turn earlier
    // there.
    EXPECT_GT(motion.branches[stretch[0]].begins, 0);
    EXPECT_EQ(motion.branches[stretch[1]].begins, 0);
  }
}

TEST(Circuits, SixBarsOfTheFilesAreAsTraced) {
  for (const char* name : {"stephenson-3", "watt-1", "jansen-leg"}) {
    expect_as_traced(mechanism_file(name), name);
  }
}

TEST(Circuits, KlannsLegWalksOnTwoCircuitsAndRocksOnTheThird) {
  const Mechanism m = test::klann("crank");
  const MotionResult motion = motion_of(m);
  const Circuits circuits = find_circuits(m, motion);
  ASSERT_EQ(circuits.circuits.size(), 3U);
  std::size_t rocking = 0;
  for (const Circuit& circuit : circuits.circuits) {
    rocking += circuit.driver_motion == DriverMotion::rocks ? 1 : 0;
  }
  EXPECT_EQ(rocking, 1U);
  // As it was drawn, q = 0, it walks.
  const Phi phi(m);
  for (std::size_t k = 0; k < motion.branches.size(); ++k) {
    const VectorXd& q = motion.branches[k].begin_pose;
    if (distance(phi, q, VectorXd::Zero(q.size())) > 1e-2) continue;
    EXPECT_EQ(circuits.circuits[circuit_of(circuits, k)].driver_motion, DriverMotion::turns);
  }
  for (const char* driven : {"crank", "coupler", "link", "output"}) {
    expect_as_traced(test::klann(driven), std::string("Klann by ") + driven);
  }
  // As it is drawn its rocker stands in a dead point.
  expect_as_traced(test::klann("rocker", 20), "Klann by rocker");
}

TEST(Circuits, RandomSixBarsAreAsTraced) {
  for (std::uint64_t seed = 1; seed <= 4; ++seed) {
    const std::vector<std::array<double, 2>> places = random_places(seed);
    for (const char* driven : {"crank", "output"}) {
      const std::string what = ' ' + std::to_string(seed) + " by " + driven;
      expect_as_traced(test::stephenson_3(places, driven), "Stephenson III" + what);
      expect_as_traced(test::watt_2(places, driven), "Watt II" + what);
    }
  }
}

TEST(Circuits, ParallelogramsCircuitsMeetInChangePoints) {
  const Mechanism m = mechanism_file("parallelogram");
  const Circuits circuits = find_circuits(m, motion_of(m));
  ASSERT_EQ(circuits.circuits.size(), 1U);
  const Circuit& circuit = circuits.circuits[0];
  EXPECT_EQ(circuit.driver_motion, DriverMotion::turns);
  EXPECT_TRUE(circuit.dead_points.empty());
  EXPECT_EQ(circuit.change_points.size(), 3U);  // 0, 180 and 360 degrees
  EXPECT_EQ(swing_of(circuit.bodies, "rocker").turns, 1);
}

TEST(Circuits, AreToldApartHoweverLargeTheLengthsAre) {
  const Mechanism m = four_bar({100e5, 40e5, 120e5, 80e5}, 40);
  EXPECT_EQ(find_circuits(m, motion_of(m)).circuits.size(), 2U);
}

TEST(Circuits, DeadPointAtTheBeginningJoins) {
  // Its crank rocks about 0, where the motion begins: from a dead point at the end of its range.
  const Mechanism rocking = four_bar({5, 4, 8, 3}, 100);
  const double inner = find_circuits(rocking, motion_of(rocking)).circuits[0].drivers[0].lower;
  const Mechanism m = four_bar({5, 4, 8, 3}, inner / kDegree);
  const MotionResult motion = motion_of(m);
  const Circuits circuits = find_circuits(m, motion);
  ASSERT_EQ(circuits.circuits.size(), 1U) << motion.message;
  EXPECT_NEAR(circuits.circuits[0].drivers[0].upper - circuits.circuits[0].drivers[0].lower,
              2 * std::numbers::pi - 2 * inner, 1e-6);
}

TEST(Circuits, OfAPartOfTheTurnMayBeJoinedOutsideAndSaySo) {
  const Mechanism m = mechanism_file("stephenson-3");
  MotionOptions options;
  options.to = 1;
  options.solve.threads = 1;
  const MotionResult motion = find_motion(m, *make_cvode_tracker(), options);
  const Circuits circuits = find_circuits(m, motion);
  EXPECT_FALSE(circuits.is_full_turn);
  EXPECT_EQ(circuits.circuits.size(), 4U);
  ASSERT_EQ(circuits.notes.size(), 1U);
  EXPECT_EQ(circuits.notes[0],
            "the drivers do not come back to where they began: circuits may be joined outside of "
            "this range");
  EXPECT_EQ(circuits.circuits[2].driver_motion, DriverMotion::open);
}

TEST(Circuits, JointLimitsStopTheDriver) {
  Mechanism m = mechanism_file("four-bar");
  const MotionResult free = motion_of(m);
  const Swing rocker = swing_of(find_circuits(m, free).circuits[0].bodies, "rocker");
  for (Joint& joint : m.joints) {
    const bool is_rockers =
        joint.at[0].body + joint.at[1].body == 3 && joint.at[0].body * joint.at[1].body == 0;
    if (!is_rockers) continue;
    const double middle = (rocker.lower + rocker.upper) / 2;
    const double sign = joint.at[0].body == 0 ? 1 : -1;
    joint.limits =
        sign > 0 ? Limits{middle, rocker.upper + 0.1} : Limits{-rocker.upper - 0.1, -middle};
  }
  const MotionResult motion = motion_of(m);
  const Circuits circuits = find_circuits(m, motion);
  const Circuit& circuit = circuits.circuits[0];
  EXPECT_EQ(circuit.driver_motion, DriverMotion::rocks);
  EXPECT_EQ(circuit.stops.size(), 2U);
  EXPECT_TRUE(circuit.dead_points.empty());
}

TEST(Circuits, GearsThatComeBackInAnotherMeshingLeaveCircuitsOpen) {
  const Mechanism m = mechanism_file("gear-five-bar");
  const Circuits circuits = find_circuits(m, motion_of(m));
  EXPECT_FALSE(circuits.is_full_turn);
  ASSERT_EQ(circuits.notes.size(), 1U);
  EXPECT_EQ(
      circuits.notes[0],
      "the turn ends in other poses than it began with, as gears do: circuits go on beyond it");
  ASSERT_FALSE(circuits.circuits.empty());
  for (const Circuit& circuit : circuits.circuits) {
    EXPECT_EQ(circuit.driver_motion, DriverMotion::open);
  }
}

TEST(Circuits, SpatialOnesTellTheirJoints) {
  const Mechanism m = mechanism_file("rssr");
  const MotionResult motion = motion_of(m);
  const Circuits circuits = find_circuits(m, motion);
  EXPECT_EQ(circuits.circuits.size(), 2U);
  for (const Circuit& circuit : circuits.circuits) {
    EXPECT_TRUE(circuit.bodies.empty());
    EXPECT_EQ(circuit.joints.size(), 2U);
  }
}

TEST(Circuits, ReachableBranchesAreThoseOfTheClosuresCircuit) {
  const Mechanism m = mechanism_file("stephenson-3");
  const MotionResult whole = motion_of(m);
  const Circuits circuits = find_circuits(m, whole);
  const MotionResult motion = reachable_from(whole, circuits, {"D"});
  std::string ids;
  for (const MotionBranch& branch : motion.branches) ids += branch.id;
  EXPECT_EQ(ids, "CDEF");
  EXPECT_EQ(motion.events.size(), 2U);
  for (const MotionBranch& branch : motion.branches) {
    EXPECT_TRUE(branch.begin_event || branch.end_event);
  }
  EXPECT_EQ(find_circuits(m, motion).circuits.size(), 1U);
  EXPECT_EQ(reachable_from(whole, circuits, {"A", "B"}).branches.size(), 2U);
  EXPECT_TRUE(reachable_from(whole, circuits, {"A"}).events.empty());
}

TEST(Circuits, UnknownClosureIsRefusedWithTheNamesThatThereAre) {
  const Mechanism m = mechanism_file("stephenson-3");
  const MotionResult motion = motion_of(m);
  const Circuits circuits = find_circuits(m, motion);
  // E begins later: it is a branch, no closure where the motion begins.
  for (const std::string name : {"E", "Z", "a", ""}) {
    try {
      reachable_from(motion, circuits, {name});
      ADD_FAILURE() << name;
    } catch (const std::invalid_argument& refusal) {
      EXPECT_EQ(std::string(refusal.what()),
                "there is no closure '" + name + "' where the motion begins; there are A, B, C, D");
    }
  }
  EXPECT_THROW(find_circuits(mechanism_file("four-bar"), motion), std::invalid_argument);
}

}  // namespace
}  // namespace moivre
