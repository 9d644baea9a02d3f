// SPDX-License-Identifier: MIT
// Do branches of spatial mechanisms keep to themselves, through singular poses and past them, and
// are these told as what they are?
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "gap.h"
#include "mechanisms.h"
#include "moivre/certify/certifier.h"
#include "moivre/factorization/svd.h"
#include "moivre/mechanism/pose.h"
#include "moivre/motion/motion.h"
#include "sarrus.h"

namespace moivre {
namespace {

using Eigen::VectorXd;
using test::gap;

constexpr double kPi = std::numbers::pi;

MotionResult motion_of(const Mechanism& mechanism, int steps, int checkpoints) {
  MotionOptions options;
  options.to = natural_duration(mechanism);
  options.steps = steps;
  options.checkpoints = checkpoints;
  options.solve.threads = 1;
  return find_motion(mechanism, *make_cvode_tracker(), options);
}

/// Value of the joint of that name.
double joint_value(const Mechanism& mechanism, const std::string& name, const VectorXd& q) {
  const auto joint = std::find_if(mechanism.joints.begin(), mechanism.joints.end(),
                                  [&](const Joint& other) { return other.name == name; });
  return joint_coordinate(mechanism, *joint, q).value();
}

void expect_whole(const MotionResult& result) {
  EXPECT_TRUE(result.complete) << result.message;
  for (const std::string& failure : result.failures) ADD_FAILURE() << failure;
  for (const Checkpoint& checkpoint : result.checkpoints) {
    EXPECT_TRUE(checkpoint.agrees) << checkpoint.time << ": " << checkpoint.message;
  }
}

/// Every sample is a closure that is solved afresh, by another seed, and every closure is on one
/// branch.
void expect_closures_afresh(const Mechanism& mechanism, const MotionResult& result,
                            double left_out) {
  for (const double time : result.times) {
    if (std::abs(time - left_out) < 1e-9) continue;
    const ClosureResult afresh = closures_of(mechanism, 5, time);
    ASSERT_TRUE(afresh.complete) << time << ": " << afresh.message;
    std::size_t present = 0;
    for (const MotionBranch& branch : result.branches) {
      for (const BranchSample& sample : branch.samples) {
        if (sample.time != time) continue;
        ++present;
        double least = 1;
        for (const Closure& closure : afresh.closures) {
          least = std::min(least, gap(mechanism, sample.q, closure.q));
        }
        EXPECT_LE(least, 1e-8) << "branch " << branch.id << ", t = " << time;
      }
    }
    EXPECT_EQ(present, afresh.closures.size()) << "t = " << time;
  }
}

const MotionBranch& branch_called(const MotionResult& result, const std::string& id) {
  return *std::find_if(result.branches.begin(), result.branches.end(),
                       [&](const MotionBranch& branch) { return branch.id == id; });
}

/// The largest difference of a joint between neighbouring samples, and of the same from one
/// difference to the next.
std::pair<double, double> jumps(const Mechanism& mechanism, const std::string& joint,
                                const std::vector<BranchSample>& samples) {
  double jump = 0, bend = 0, before = 0;
  for (std::size_t k = 1; k < samples.size(); ++k) {
    const double change = std::remainder(joint_value(mechanism, joint, samples[k].q) -
                                             joint_value(mechanism, joint, samples[k - 1].q),
                                         2 * kPi);
    if (k > 1) bend = std::max(bend, std::abs(change - before));
    jump = std::max(jump, std::abs(change));
    before = change;
  }
  return {jump, bend};
}

TEST(SpatialMotion, APumaGoesThroughItsStraightWristOnTwoBranchesThatAreNotExchanged) {
  const Mechanism m = mechanism_file("puma-line");
  const MotionResult result =
      motion_of(m, 10, 4);  // a sample and a checkpoint are at the straight wrist
  expect_whole(result);
  EXPECT_EQ(result.branches.size(), 10U);
  ASSERT_EQ(result.events.size(), 2U);
  for (const MotionEvent& event : result.events) {
    EXPECT_EQ(event.at.kind, EventKind::bifurcation);
    EXPECT_NEAR(event.drivers[0], 0, 1e-10);
    ASSERT_EQ(event.ending.size(), 1U);
    ASSERT_EQ(event.beginning.size(), 1U);
    const MotionBranch& before = branch_called(result, event.ending[0]);
    const MotionBranch& after = branch_called(result, event.beginning[0]);
    EXPECT_NEAR(before.ends, 0.5, 1e-9);
    EXPECT_NEAR(after.begins, 0.5, 1e-9);
    EXPECT_LT(gap(m, before.end_pose, after.begin_pose), 1e-6);
    // Both wrist angles go on as they came, J5 through 0.
    std::vector<BranchSample> samples = before.samples;
    samples.insert(samples.end(), after.samples.begin(), after.samples.end());
    const double first = joint_value(m, "J5", samples.front().q);
    const double last = joint_value(m, "J5", samples.back().q);
    EXPECT_LT(first * last, 0);
    for (const char* joint : {"J4", "J5", "J6"}) {
      const auto [jump, bend] = jumps(m, joint, samples);
      EXPECT_LT(jump, 0.2) << joint;
      EXPECT_LT(bend, 0.05) << joint;
    }
  }
  expect_closures_afresh(m, result, 0.5);
}

TEST(SpatialMotion, APumaThatMissesItsStraightWristTurnsItAtOnceAndKeepsItsBranches) {
  for (const double miss : {1e-2, 1e-7}) {
    SCOPED_TRACE(miss);
    Mechanism m = mechanism_file("puma-line");
    const Joint& line = *std::find_if(m.joints.begin(), m.joints.end(),
                                      [](const Joint& joint) { return joint.name == "line"; });
    m.bodies[0].points[line.at[0].point].at += miss * Eigen::Vector3d(0.8, -0.36, -0.48);
    const MotionResult result = motion_of(m, 5, 4);
    expect_whole(result);
    ASSERT_EQ(result.branches.size(), 8U);
    EXPECT_TRUE(result.events.empty());
    int turned = 0;
    for (const MotionBranch& branch : result.branches) {
      const auto five = [&](const BranchSample& sample) { return joint_value(m, "J5", sample.q); };
      EXPECT_GT(five(branch.samples.front()) * five(branch.samples.back()), 0) << branch.id;
      const double four =
          std::abs(std::remainder(joint_value(m, "J4", branch.samples.back().q) -
                                      joint_value(m, "J4", branch.samples.front().q),
                                  2 * kPi));
      turned += four > 2 ? 1 : 0;
    }
    EXPECT_EQ(turned, miss < 1e-3 ? 2 : 0);
    expect_closures_afresh(m, result, -1);
  }
}

TEST(SpatialMotion, APlatformHasDeadPointsWhereALegComesToItsSingularPoses) {
  Mechanism m = mechanism_file("3-rps");
  m.drivers[0].law = Parabola{1.5, 1.2, 0};
  m.drivers[1].law = Parabola{1.7, 0, 0};
  m.drivers[2].law = Parabola{1.4, 0, 0};
  const MotionResult result = motion_of(m, 10, 2);
  expect_whole(result);
  ASSERT_FALSE(result.events.empty());
  const Phi phi(m);
  for (const MotionEvent& event : result.events) {
    EXPECT_EQ(event.at.kind, EventKind::dead_point) << event.at.time;
    // Branches meet in pairs, and the platform can move though the legs stand.
    EXPECT_EQ((event.ending.size() + event.beginning.size()) % 2, 0U);
    const VectorXd sigma = singular_values(phi.jacobian(event.at.q, event.at.time));
    EXPECT_LT(sigma[sigma.size() - 1], 1e-6);
    EXPECT_GT(sigma[sigma.size() - 2], 1e-4);
  }
  expect_closures_afresh(m, result, -1);
}

TEST(SpatialMotion, BennettsLinkageGoesAllTheWayRoundAndComesBackToItself) {
  const Mechanism m = mechanism_file("bennett");
  const MotionResult result = motion_of(m, 72, 4);
  expect_whole(result);
  ASSERT_EQ(result.branches.size(), 1U);
  EXPECT_TRUE(result.events.empty());
  const MotionBranch& branch = result.branches[0];
  ASSERT_EQ(branch.samples.size(), 73U);
  EXPECT_LT(gap(m, branch.samples.front().q, branch.samples.back().q), 1e-9);
  // Its closed form: the product of the tangents of two neighbouring half angles never changes.
  const auto half = [&](const char* joint, const BranchSample& sample) {
    return joint_value(m, joint, sample.q) / 2;
  };
  const BranchSample& first = branch.samples.front();
  const double product = std::tan(half("J1", first)) * std::tan(half("J2", first));
  for (const BranchSample& sample : branch.samples) {
    const double a = half("J1", sample), b = half("J2", sample);
    EXPECT_NEAR(std::sin(a) * std::sin(b), product * std::cos(a) * std::cos(b), 1e-9);
  }
}

// The rod says where the rocker goes; a coupler that is typed as a body beside it may spin, and no
// more.
TEST(SpatialMotion, ACouplerThatSpinsBetweenBallsMovesAsARodDoes) {
  Mechanism bodies = mechanism_text(test::kSpinningCoupler);
  bodies.drivers[0].law = Parabola{0.9, 1, 0};
  Mechanism rod = mechanism_file("rssr");
  rod.drivers[0].law = bodies.drivers[0].law;
  const MotionResult result = motion_of(bodies, 36, 4);
  const MotionResult by_rod = motion_of(rod, 36, 4);
  expect_whole(result);
  ASSERT_EQ(result.branches.size(), 2U);
  ASSERT_EQ(by_rod.branches.size(), 2U);
  const auto same = [&](const MotionBranch& branch) -> const MotionBranch& {
    const double output = joint_value(bodies, "output", branch.samples.front().q);
    const double other = joint_value(rod, "output", by_rod.branches[0].samples.front().q);
    return by_rod.branches[std::abs(output - other) < 1e-9 ? 0 : 1];
  };
  for (const MotionBranch& branch : result.branches) {
    const MotionBranch& twin = same(branch);
    ASSERT_EQ(branch.samples.size(), twin.samples.size());
    for (std::size_t k = 0; k < branch.samples.size(); ++k) {
      EXPECT_NEAR(joint_value(bodies, "output", branch.samples[k].q),
                  joint_value(rod, "output", twin.samples[k].q), 1e-9);
    }
    // The spin is held by the pose alone: after a whole turn the coupler is where it was.
    EXPECT_LT(gap(bodies, branch.samples.front().q, branch.samples.back().q), 1e-9);
  }
  expect_closures_afresh(bodies, result, -1);
}

TEST(SpatialMotion, LegsBetweenBallsCarryAPlatformAsActuatorsDo) {
  std::string legs = "space = \"spatial\"\n[ground.points]\n";
  std::string platform = "[body.platform.points]\n";
  std::string joints;
  const double base[6][3] = {{9, -2, 0},  {3, 9, 0.3},   {-3, 9.5, 0.6},
                             {-9, -2, 0}, {-6, -7, 0.3}, {6, -8, 0.6}};
  const double top[6][3] = {{4, 2, 0},    {4, 3, 0.2}, {0, 5, 0},
                            {-4, 3, 0.2}, {-4, -3, 0}, {1, -5, 0.2}};
  const auto point = [](const double(&p)[3]) {
    return "[" + std::to_string(p[0]) + ", " + std::to_string(p[1]) + ", " + std::to_string(p[2]) +
           "]\n";
  };
  for (int k = 0; k < 6; ++k) {
    const std::string n = std::to_string(k);
    legs += "B" + n + " = " + point(base[k]);
    platform += "P" + n + " = " + point(top[k]);
    const double far =
        std::hypot(base[k][0] - top[k][0], base[k][1] - top[k][1], base[k][2] - top[k][2] - 8);
    joints += "[body.cylinder" + n + ".points]\nB = [0, 0, 0]\n[body.piston" + n +
              ".points]\nP = [0.3, 0, 0]\n" + "[[joint]]\ntype = \"spherical\"\nat = [\"ground.B" +
              n + "\", \"cylinder" + n + ".B\"]\n" +
              "[[joint]]\ntype = \"prismatic\"\nname = \"leg" + n + "\"\nat = [\"cylinder" + n +
              ".B\", \"piston" + n + ".P\"]\naxis = [0, 0, 1]\n" +
              "[[joint]]\ntype = \"spherical\"\nat = [\"piston" + n + ".P\", \"platform.P" + n +
              "\"]\n" + "[[driver]]\nslide = \"leg" + n + "\"\nstart = " + std::to_string(far) +
              "\nvelocity = " + (k == 0 ? "0.5" : "0") + "\n";
  }
  const Mechanism mechanism = mechanism_text(legs + platform + joints);
  const MotionResult result = motion_of(mechanism, 4, 1);
  expect_whole(result);
  ASSERT_FALSE(result.branches.empty());
  EXPECT_EQ(result.idle.size(), 6U);
  for (const MotionBranch& branch : result.branches) {
    for (const BranchSample& sample : branch.samples) {
      EXPECT_TRUE(sample.velocity.allFinite());
      EXPECT_NEAR(joint_value(mechanism, "leg1", sample.q),
                  mechanism.drivers[1].law.index() == 0
                      ? std::get<Parabola>(mechanism.drivers[1].law).start
                      : 0,
                  1e-9);
    }
  }
}

// Their formulations choose pivots anew at every time.
TEST(SpatialMotion, OverconstrainedLoopsHaveAllTheirPairsOfComplexClosuresFollowed) {
  for (const char* name : {"bricard-driven", "spherical-3-rrr"}) {
    const MotionResult result = motion_of(mechanism_file(name), 5, 4);
    expect_whole(result);
    for (const LeftOut& out : result.left_out) ADD_FAILURE() << name << ": " << out.why;
  }
}

// At its folded poses branches cross, the top swings, and rounding parts the double closures into
// two that are real or not.
TEST(SpatialMotion, SarrussLinkageIsFollowedThoughEveryCheckpointIsACrossing) {
  if (!proves_beyond_double()) GTEST_SKIP() << "needs more digits";
  for (const int start_deg : {45, 135}) {
    const Mechanism m =
        mechanism_text(sarrus_text("start = " + std::to_string(start_deg) + "\nvelocity = 90"));
    MotionOptions options;
    options.to = 2;
    options.steps = 8;
    options.checkpoints = 2;
    options.solve.threads = 1;
    const MotionResult result = find_motion(m, *make_cvode_tracker(), options);
    expect_whole(result);
    ASSERT_EQ(result.branches.size(), 4U) << start_deg;
    for (const MotionBranch& branch : result.branches) {
      EXPECT_NEAR(branch.ends - branch.begins, 1, 1e-6) << branch.id;
      for (const BranchSample& sample : branch.samples) {
        if (!sample.is_determined) continue;
        const double a = joint_value(m, "a", sample.q);
        const double law = start_deg * kPi / 180 + kPi / 2 * sample.time;
        EXPECT_NEAR(std::remainder(a - law, 2 * kPi), 0, 1e-9);
      }
    }
    for (const MotionEvent& event : result.events) {
      EXPECT_EQ(event.at.kind, EventKind::bifurcation);
      EXPECT_NEAR(event.at.time, std::round(event.at.time), 1e-6);
    }
  }
}

}  // namespace
}  // namespace moivre
