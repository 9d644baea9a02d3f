// SPDX-License-Identifier: MIT
// Do the spatial closure polynomials and Phi vanish at the same poses, and which unknowns does each
// mechanism get?
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>

#include "../mechanism/files.h"
#include "exact_pose.h"
#include "moivre/formulation/exact.h"
#include "moivre/formulation/formulation.h"
#include "moivre/mechanism/pose.h"
#include "moivre/numeric/dual_quaternion.h"
#include "moivre/numeric/random.h"
#include "moivre/polynomial/value.h"
#include "rigid_groups.h"

namespace moivre {
namespace {

using Eigen::Vector3d;
using Eigen::VectorXd;

double random_number(std::uint64_t index) {
  return 2 * random_unit(3, RandomStream::test, index) - 1;
}

std::size_t index_of(const Formulation& f, const std::string& equation) {
  const auto found = std::find(f.equation_names.begin(), f.equation_names.end(), equation);
  return static_cast<std::size_t>(found - f.equation_names.begin());
}

TEST(ExactPose, FramesAreThoseOfPhiWithinRounding) {
  for (std::uint64_t k = 0; k < 20; ++k) {
    const Vector3d axis =
        Vector3d(random_number(3 * k), random_number(3 * k + 1), random_number(3 * k + 2))
            .normalized();
    const DualQuaternion<double> frame = to_double(frame_of(axis));
    const Eigen::Quaterniond turn(frame.q[0], frame.q[1], frame.q[2], frame.q[3]);
    EXPECT_LE((turn.normalized().toRotationMatrix() - joint_frame(axis)).norm(), 1e-14);
  }
}

// Its axis and two directions across it have fractions as coordinates, so that the frame has.
TEST(ExactPose, AFrameOfFractionsIsExact) {
  EXPECT_TRUE(has_exact_frame({0, 0.6, 0.8}));
  EXPECT_TRUE(has_exact_frame({-1, 0, 0}));
  EXPECT_FALSE(has_exact_frame({0, 0.5, 0.8660254037844386}));
  for (const Vector3d& axis :
       {Vector3d(0, 0.6, 0.8), Vector3d(0.6, 0, -0.8), Vector3d(-0.28, 0.96, 0), Vector3d(0, 0, -1),
        Vector3d(0, -1, 0), Vector3d(1, 0, 0)}) {
    const ExactPose frame = frame_of(axis);
    const ExactPose z = frame * ExactPose{{0, 0, 0, 1}, {}} * conjugate(frame);
    for (std::size_t k = 0; k < 3; ++k) {
      EXPECT_EQ(z.q[k + 1], norm(frame) * typed_decimal(axis[static_cast<Eigen::Index>(k)]));
    }
    const DualQuaternion<double> rounded = to_double(frame);
    const Eigen::Quaterniond turn(rounded.q[0], rounded.q[1], rounded.q[2], rounded.q[3]);
    EXPECT_LE((turn.normalized().toRotationMatrix() - joint_frame(axis)).norm(), 1e-15);
  }
}

TEST(ExactPose, AQuarterTurnIsOneExactly) {
  const ExactPose quarter = turn_about_z(0.5 * 3.14159265358979323846);
  EXPECT_EQ(quarter.q[0], Rational(1));
  EXPECT_EQ(quarter.q[3], Rational(1));
  EXPECT_EQ(frame_of({0, 0, 1}).q[1], Rational(0));
}

// The rod's row of Phi is |d|^2 - L^2, its polynomial that times |q|^2, which is (1 + o^2) (1 +
// t^2).
TEST(SpatialFormulation, TheRodOfAnRssrIsPhisRowTimesTheNorm) {
  const Mechanism mechanism = test::example("rssr");
  const Phi phi(mechanism);
  const Formulation f = formulate(mechanism, 0);
  ASSERT_EQ(f.system.variables, (std::vector<std::string>{"t_output"}));
  ASSERT_EQ(f.system.polynomials.size(), 1U);
  std::optional<double> factor;
  for (std::uint64_t k = 0; k < 20; ++k) {
    const double t = 3 * random_number(k);
    const VectorXd q = coordinates_of_root(f, {t});
    const VectorXd rows = phi.value(q, 0);
    for (Eigen::Index i = 0; i < rows.size(); ++i) {
      const bool is_rod = phi.row_names()[static_cast<std::size_t>(i)] == "rod coupler: length";
      if (!is_rod) {
        EXPECT_NEAR(rows[i], 0, 1e-13) << phi.row_names()[static_cast<std::size_t>(i)];
        continue;
      }
      const double ratio = value_at(f.system.polynomials[0], {t}).real() / ((1 + t * t) * rows[i]);
      if (!factor) factor = ratio;
      EXPECT_NEAR(ratio, *factor, 1e-10 * std::abs(*factor));
    }
  }
}

/// The platform's legs as long as a random pose has them, and that pose as a root.
Point pose_and_legs(Mechanism& mechanism, std::uint64_t pose, VectorXd& q) {
  q.resize(6);
  for (Eigen::Index k = 0; k < 6; ++k) {
    q[k] = 2 * random_number(6 * pose + static_cast<std::uint64_t>(k));
  }
  for (Joint& leg : mechanism.joints) {
    leg.length =
        (point_position(mechanism, leg.at[0], q) - point_position(mechanism, leg.at[1], q)).norm();
  }
  const Vector3d v = q.tail<3>();
  const Eigen::Quaterniond turn(Eigen::AngleAxisd(v.norm(), v.normalized()));
  const Quaternion<double> r{turn.w(), turn.x(), turn.y(), turn.z()};
  const Quaternion<double> g = scaled(0.5, product(Quaternion<double>{0, q[0], q[1], q[2]}, r));
  return {r[0], r[1], r[2], r[3], g[0], g[1], g[2], g[3]};
}

TEST(SpatialFormulation, APlatformsPolynomialsVanishWherePhiDoes) {
  for (std::uint64_t pose = 0; pose < 10; ++pose) {
    Mechanism mechanism = test::example("dietmaier");
    VectorXd q;
    Point root = pose_and_legs(mechanism, pose, q);
    const Formulation f = formulate(mechanism, 0);
    ASSERT_EQ(f.system.variables.size(), root.size());
    // The patch a . x - 1 makes the homogeneous point one of C^8.
    const Complex patch =
        value_at(f.system.polynomials[index_of(f, "patch of q_platform_")], root) + 1.0;
    for (Complex& x : root) x /= patch;
    EXPECT_LE(residual_of_root(f, root), 1e-13);
    EXPECT_LE((coordinates_of_root(f, root) - q).norm(), 1e-12);
    root[4] += 1e-3;
    EXPECT_GE(residual_of_root(f, root), 1e-6);
  }
}

TEST(SpatialFormulation, APlatformsFirstLegIsSubtractedFromTheOthers) {
  const Formulation f = formulate(test::example("dietmaier"), 0);
  std::size_t with_square = 0;
  for (const Polynomial& p : f.system.polynomials) {
    with_square += static_cast<std::size_t>(
        std::count_if(p.terms.begin(), p.terms.end(), [](const Term& term) {
          return term.monomial == Monomial{{4, 2}};
        }));
  }
  EXPECT_EQ(with_square, 1U);
}

TEST(SpatialFormulation, AnArmHasFourLoopEquationsInFourHalfAngles) {
  const Formulation f = formulate(test::example("general-6r"), 0);
  EXPECT_EQ(std::count(f.equation_names.begin(), f.equation_names.end(), "loop"), 4);
  EXPECT_EQ(f.system.variables.size(), 6U);
  EXPECT_EQ(f.system.polynomials.size(), 6U);
  for (std::size_t k = 0; k < f.system.polynomials.size(); ++k) {
    if (f.equation_names[k] != "loop") continue;
    for (const Term& term : f.system.polynomials[k].terms) {
      for (const Power& power : term.monomial) EXPECT_EQ(power.exponent, 1U);
    }
  }
}

TEST(SpatialFormulation, ThreeParallelAxesAreSolvedAfterTheOthers) {
  const Formulation f = formulate(test::example("ur5"), 0);
  EXPECT_EQ(std::count(f.equation_names.begin(), f.equation_names.end(), "loop"), 4);
  for (std::size_t k = 0; k < f.system.polynomials.size(); ++k) {
    if (f.equation_names[k] != "loop") continue;
    EXPECT_EQ(degree(f.system.polynomials[k]), 2U);
  }
}

TEST(SpatialFormulation, WeldedAndDrivenBodiesAreOneGroup) {
  const RigidGroups groups = rigid_groups(test::example("rssr"), 0);
  EXPECT_EQ(groups.names, (std::vector<std::string>{"ground", "rocker"}));
  EXPECT_EQ(groups.ties.size(), 2U);
}

TEST(SpatialFormulation, AWeldThatContradictsADriverIsNamed) {
  Mechanism mechanism = test::example("rssr");
  Joint weld = mechanism.joints[0];
  weld.type = JointType::weld;
  weld.name = "stuck";
  mechanism.joints.push_back(weld);
  const Formulation f = formulate(mechanism, 0);
  ASSERT_EQ(f.contradictions.size(), 1U);
  EXPECT_EQ(f.contradictions.front(), "weld stuck holds bodies that are already held otherwise");
}

TEST(SpatialFormulation, ARodOfAnotherLengthBesideADriverContradictsNoAngle) {
  Mechanism mechanism = test::example("rssr");
  Joint rod = mechanism.joints[0];
  rod.type = JointType::rod;
  rod.name = "brace";
  rod.length = 12345;
  mechanism.joints.push_back(rod);
  const Formulation f = formulate(mechanism, 0);
  ASSERT_EQ(f.contradictions.size(), 1U);
  EXPECT_EQ(f.contradictions.front(), "brace cannot hold: what it joins is already held");
}

}  // namespace
}  // namespace moivre
