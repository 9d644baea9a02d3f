// SPDX-License-Identifier: MIT
// Are roots of a triangular system proved block after block: that they are, that they are real,
// that an expression vanishes there?
#include "moivre/closures/root_proofs.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "mechanisms.h"
#include "spatial_counts.h"

namespace moivre {
namespace {

/// x^2 = 2, y = x, z^2 = y: three blocks, the second one linear.
Formulation roots_of_roots() {
  Formulation formulation;
  formulation.system.variables = {"x", "y", "z"};
  const Polynomial x = unknown(0);
  const Polynomial y = unknown(1);
  const Polynomial z = unknown(2);
  const Coefficient minus{-1, 0};
  formulation.system.polynomials = {x * x + constant({-2, 0}), y + minus * x, z * z + minus * y};
  formulation.mirror = {0, 1, 2};
  formulation.is_direction = {false, false, false};
  return formulation;
}

const double kRoot = std::sqrt(2.0);
const double kFourthRoot = std::sqrt(kRoot);

struct Proofs {
  KnownProof first, all;
};

Proofs prove(RootProver& prover, const Point& values) {
  prover.add({{0}, {0}});
  prover.close();
  Proofs proofs;
  proofs.first = prover.prove(nullptr, values);
  prover.add({{1}, {1}});
  prover.add({{2}, {2}});
  prover.close();
  proofs.all = prover.prove(proofs.first, values);
  return proofs;
}

/// z^4 - 2 - 10^-digits.
Polynomial off_by(unsigned digits) {
  const Polynomial z = unknown(2);
  Rational small = 1;
  for (unsigned k = 0; k < digits; ++k) small /= 10;
  return z * z * z * z + constant({-2 - small, 0});
}

TEST(RootProofs, ProveARealRootAndItsDigits) {
  const Formulation formulation = roots_of_roots();
  RootProver prover(formulation, true);
  const Proofs proofs = prove(prover, {kRoot, kRoot, kFourthRoot + 1e-9});
  ASSERT_NE(proofs.all, nullptr);
  const ProvedRoot root = prover.root(proofs.all);
  EXPECT_EQ(root.real, true);
  EXPECT_NEAR(root.x[2].real(), kFourthRoot, 1e-15);
  EXPECT_LE(root.accuracy, 1e-14);
}

TEST(RootProofs, ProveThatARootIsNotReal) {
  const Formulation formulation = roots_of_roots();
  RootProver prover(formulation, true);
  const Proofs proofs = prove(prover, {-kRoot, -kRoot, Complex(0, kFourthRoot)});
  ASSERT_NE(proofs.all, nullptr);
  EXPECT_EQ(prover.root(proofs.all).real, false);
}

TEST(RootProofs, TellNothingOfWhatIsNoRoot) {
  const Formulation formulation = roots_of_roots();
  RootProver prover(formulation, true);
  const Proofs proofs = prove(prover, {kRoot, kRoot, 1.1});
  EXPECT_NE(proofs.first, nullptr);
  EXPECT_EQ(proofs.all, nullptr);
}

TEST(RootProofs, TellNothingAboveWhatIsNotProved) {
  const Formulation formulation = roots_of_roots();
  RootProver prover(formulation, true);
  EXPECT_EQ(prove(prover, {1.5, kRoot, kFourthRoot}).all, nullptr);
}

TEST(RootProofs, TellWhatVanishesFromWhatIsTiny) {
  Formulation formulation = roots_of_roots();
  const std::vector<unsigned> digits{3, 16, 40, 60};
  for (const unsigned k : digits) formulation.exclusions.push_back({off_by(k), ""});
  const Polynomial z = unknown(2);
  formulation.exclusions.push_back({z * z * z * z + constant({-2, 0}), "zero"});
  RootProver prover(formulation, true);
  const Proofs proofs = prove(prover, {kRoot, kRoot, kFourthRoot});
  for (const Formulation::Exclusion& exclusion : formulation.exclusions) {
    EXPECT_EQ(prover.vanishes(proofs.all, exclusion), exclusion.reason == "zero");
  }
}

TEST(RootProofs, TellSiblingsApart) {
  const Formulation formulation = roots_of_roots();
  RootProver prover(formulation, true);
  const Proofs proofs = prove(prover, {kRoot, kRoot, kFourthRoot});
  const KnownProof other = prover.prove(proofs.first, {kRoot, kRoot, -kFourthRoot});
  const auto are_new = [](const std::vector<KnownProof>& told) {
    return RootProver::are_new(told);
  };
  EXPECT_EQ(are_new({proofs.all, other}), std::vector<bool>({true, true}));
  const KnownProof again = prover.prove(proofs.first, {kRoot, kRoot, kFourthRoot + 1e-8});
  EXPECT_EQ(are_new({proofs.all, other, again}), std::vector<bool>({true, true, false}));
  EXPECT_EQ(are_new({proofs.all, nullptr}), std::vector<bool>({true, false}));
}

TEST(RootProofs, AreNotSoughtWhereTheyAreNotWanted) {
  const Formulation formulation = roots_of_roots();
  RootProver prover(formulation, false);
  EXPECT_EQ(prove(prover, {kRoot, kRoot, kFourthRoot}).all, nullptr);
}

TEST(CertifiedClosures, OfAFourBarAreProvedComplete) {
  const ClosureResult result = closures_of(mechanism_file("four-bar"));
  EXPECT_EQ(result.completeness, RootCompleteness::proved);
  for (const Closure& closure : result.closures) EXPECT_EQ(closure.certified, true) << closure.id;
}

TEST(CertifiedClosures, ComplexOnesAreCertifiedToo) {
  const ClosureResult result = closures_of(mechanism_file("assur-7-serial"));
  EXPECT_GT(result.counts.complex, result.counts.real);
  for (const Solution& root : result.solutions) EXPECT_EQ(root.certified, true) << root.path;
}

/// Its change point is a double root.
TEST(CertifiedClosures, AMultipleOneHasNoCertificate) {
  const ClosureResult result = closures_of(mechanism_file("parallelogram"));
  ASSERT_EQ(result.closures.size(), 1U);
  EXPECT_TRUE(result.closures.front().singular);
  EXPECT_EQ(result.closures.front().certified, false);
  EXPECT_EQ(result.completeness, RootCompleteness::shown);
}

/// A millionth of a degree beside the change point its closures lie so near to each other that
/// their paths seem to meet.
TEST(CertifiedClosures, TwoBesideAChangePointAreNotTakenForADoubleOne) {
  for (const double angle : {1e-6, 2e-6, 3e-6}) {
    for (std::uint64_t seed = 1; seed <= 8; ++seed) {
      const ClosureResult result = closures_of(
          driven_from(mechanism_file("parallelogram"), angle * std::numbers::pi / 180), seed);
      EXPECT_EQ(result.closures.size(), 2U) << angle << ", seed " << seed;
      EXPECT_EQ(result.completeness, RootCompleteness::proved) << angle << ", seed " << seed;
    }
  }
}

TEST(CertifiedClosures, AreNotToldOfWhereEquationsAreSpare) {
  const ClosureResult result = closures_of(mechanism_file("bennett"));
  ASSERT_FALSE(result.closures.empty());
  EXPECT_EQ(result.closures.front().certified, std::nullopt);
  EXPECT_EQ(result.completeness, std::nullopt);
}

/// Roots with t = i are no poses, though rounded coefficients leave 1 + t^2 at 1e-15 there, and not
/// at 0.
TEST(Arms, HaveNoClosureWhereAHalfAnglesTangentIsImaginary) {
  for (const double x : {0.089, 0.144, -0.232}) {
    Mechanism arm = mechanism_file("puma-560");
    auto& points = arm.bodies[0].points;
    const auto base = std::find_if(points.begin(), points.end(),
                                   [](const BodyPoint& point) { return point.name == "J1"; });
    ASSERT_NE(base, points.end());
    base->at.x() = x;
    const ClosureResult result = closures_of(arm);
    EXPECT_TRUE(result.complete) << result.message;
    EXPECT_EQ(result.counts.complex, 8U) << x;
    EXPECT_EQ(result.completeness, RootCompleteness::proved) << x;
  }
}

/// Beside the quadric where the quaternion has norm 0: in double the closures that are off by
/// little pass for points of it.
TEST(Platforms, OffByABillionthHaveAllFortyClosuresByProof) {
  for (const char* name : {"octahedral-3-3", "platform-6-3"}) {
    const Mechanism mechanism = disturbed(mechanism_file(name), 1e-9, 2);
    const ClosureResult result = closures_of(mechanism, 2);
    EXPECT_TRUE(result.complete) << result.message;
    EXPECT_EQ(result.counts.complex, 40U) << name;
    EXPECT_EQ(result.completeness, RootCompleteness::proved) << name;
  }
}

TEST(Loops, HaveTheirClosuresProvedComplete) {
  for (const char* name : {"general-6r", "manseur-doty", "puma-560"}) {
    EXPECT_EQ(closures_of(mechanism_file(name)).completeness, RootCompleteness::proved) << name;
  }
}

TEST(CertifiedClosures, OfSubChainsAreThoseOfTheWhole) {
  const Mechanism two_legs = read_mechanism(
      read_source(std::string(MOIVRE_SOURCE_DIR) + "/tests/trial/files/beest2.toml"));
  const ClosureResult result = closures_of(two_legs);
  EXPECT_EQ(result.sub_chains.size(), 2U);
  EXPECT_EQ(result.completeness, RootCompleteness::proved);
  for (const Closure& closure : result.closures) EXPECT_EQ(closure.certified, true) << closure.id;
}

}  // namespace
}  // namespace moivre
