// SPDX-License-Identifier: MIT
// Does every mechanism of problems/mechanisms assemble where its closures were published or
// computed?
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>

#include "../mechanism/files.h"
#include "moivre/kinematics/mobility.h"
#include "moivre/mechanism/pose.h"

namespace moivre {
namespace {

using Eigen::VectorXd;
using test::example;
using test::kDegree;

constexpr double kBar = 1e-12;  // of the sum of the terms' magnitudes, for every row

struct Counts {
  const char* name;
  Eigen::Index coordinates, constraints, rank;
};

TEST(Examples, EveryMechanismAssemblesFromItsGuessWithItsMobility) {
  const Counts all[] = {{"four-bar", 9, 8, 8},
                        {"slider-crank", 9, 8, 8},
                        {"slider-crank-equations", 3, 2, 2},
                        {"five-bar", 12, 10, 10},
                        {"watt-1", 15, 14, 14},
                        {"stephenson-3", 15, 14, 14},
                        {"3-rpr", 3, 3, 3},
                        {"assur-7-quaternary", 18, 18, 18},
                        {"assur-7-serial", 18, 18, 18},
                        {"jansen-leg", 21, 20, 20},
                        {"double-parallel-crank", 12, 12, 11},
                        {"redundant-system", 5, 6, 4},
                        {"scotch-yoke", 6, 5, 5},
                        {"whitworth", 12, 11, 11},
                        {"inverted-slider-crank", 9, 8, 8},
                        {"gear-five-bar", 12, 11, 11},
                        {"belt-five-bar", 12, 11, 11},
                        {"cam-valve", 9, 8, 8},
                        {"crane", 6, 4, 4},
                        {"rack-steering", 18, 17, 17},
                        {"rack-crank", 12, 11, 11},
                        {"parallelogram", 9, 8, 7},
                        {"rssr", 12, 11, 11},
                        {"bennett", 18, 20, 17}};
  for (const Counts& expected : all) {
    const Mechanism m = example(expected.name);
    const Phi phi(m);
    const NewtonResult run = newton(phi, initial_guess(m));
    EXPECT_EQ(run.status, NewtonStatus::converged) << expected.name << ": " << run.message;
    EXPECT_LE(run.scaled_residual, kBar) << expected.name;
    const Mobility mob = mobility(phi, run.q);
    EXPECT_EQ(mob.coordinates, expected.coordinates) << expected.name;
    EXPECT_EQ(mob.constraints, expected.constraints) << expected.name;
    EXPECT_EQ(mob.rank, expected.rank) << expected.name;
    EXPECT_EQ(mob.rank_by_svd, expected.rank) << expected.name;
  }
}

/// Angles that Newton reaches from guessed body angles (degrees kept to two decimals, so that
/// Newton has work to do).
VectorXd assembled_from_angles(const Mechanism& mechanism, const std::vector<double>& angles_rad,
                               std::size_t first_body) {
  Mechanism guessed = mechanism;
  for (std::size_t k = 0; k < angles_rad.size(); ++k) {
    guessed.guess[mechanism.bodies[first_body + k].name + ".phi"] =
        std::round(angles_rad[k] * 100) / 100;
  }
  const Phi phi(guessed);
  const NewtonResult run = newton(phi, initial_guess(guessed));
  EXPECT_EQ(run.status, NewtonStatus::converged) << mechanism.title << ": " << run.message;
  EXPECT_LE(run.scaled_residual, kBar);
  return phi.canonical(run.q);
}

void expect_closures(const char* name, std::size_t first_body,
                     const std::vector<std::vector<double>>& closures) {
  const Mechanism m = example(name);
  for (const std::vector<double>& angles : closures) {
    const VectorXd q = assembled_from_angles(m, angles, first_body);
    for (std::size_t k = 0; k < angles.size(); ++k) {
      EXPECT_NEAR(q[static_cast<Eigen::Index>(3 * (first_body - 1 + k) + 2)], angles[k], 1e-12)
          << name << " body " << m.bodies[first_body + k].name;
    }
  }
}

TEST(Examples, FiveBarHasItsTwoClosures) {
  expect_closures(
      "five-bar", 3,
      {{-1.1976330141530844, -2.2390838773426447}, {1.0148808111857663, 2.0563316743753273}});
}

TEST(Examples, WattOneHasItsFourClosures) {
  expect_closures(
      "watt-1", 2,
      {{-1.2660732948402114, -2.3939585775614693, 0.3090983538448877, 1.3781928193949584},
       {-1.2660732948402114, -2.393958577561469, -1.9540358923813466, -3.0231303579314166},
       {0.5055708814543443, 1.6334561641756018, -2.640397094025652, 2.5736937476038637},
       {0.5055708814543443, 1.6334561641756018, -0.3772628477994173, 0.6918316177506529}});
}

TEST(Examples, StephensonThreeHasItsFourClosures) {
  expect_closures(
      "stephenson-3", 2,
      {{-1.2660732948402114, -2.393958577561469, -2.0994902539153726, -0.9685859209178576},
       {-1.2660732948402114, -2.393958577561469, -1.0742493169522946, -2.2051536499498092},
       {0.5055708814543443, 1.6334561641756018, -1.3514065161035675, 2.2155482478093056},
       {0.5055708814543443, 1.6334561641756018, 2.952128431631394, -0.6148263322814791}});
}

TEST(Examples, QuaternaryAssurStructureHasItsEightRealClosures) {
  expect_closures("assur-7-quaternary", 1,
                  {{-1.478884817532193, 1.2379161152271552, -2.781454822462358, 2.882700153739928,
                    -0.5762086488757836, 2.272744856526325},
                   {-1.1603543133862437, 0.6726139800934026, -1.0325079560664445,
                    -2.5495594435400863, -1.9028029633712904, -2.7890366980825636},
                   {-0.4215598917704897, 1.0384980852685244, 0.5319483454112643, 2.809743332616099,
                    -1.805033132594294, 2.8753836484738047},
                   {-0.29192202204216144, 1.4177329588109977, 1.337799231304504, 2.3680833205998297,
                    -0.9256713328332666, 2.093178294508826},
                   {0.8866759509300275, -1.180051403138953, -1.4527827458084535,
                    -0.17142741147158969, 0.9684373886641158, 1.4922265364047318},
                   {0.8963094076930629, -0.6435226658901172, -0.3397341154091178,
                    -1.6790127593319006, -2.461360518424097, -2.4393945309524585},
                   {1.8637191097797174, -0.10601565677947455, 1.8406022012829695,
                    0.4813135226678793, -0.7434499154309502, 0.9420238500332854},
                   {2.2722302025576084, -0.2601106282732202, 2.813243298812006, -2.612587578341881,
                    -1.885681773788243, -2.829845534875247}});
}

TEST(Examples, SerialAssurStructureHasRealClosuresOfItsTen) {
  expect_closures("assur-7-serial", 1,
                  {{-3.005016449833121, -1.8529538929286915, 2.62198203086834, -1.2133281198061268,
                    -1.6125446907559209, 0.37375334874535726},
                   {0.6357274914224296, -1.452042163903844, -2.2175013683354643,
                    -0.28989280551863006, -0.10559024136305784, 1.1195059227371722},
                   {1.6546263117821622, -0.9761242911820025, 1.779365048966322, -0.4412304918039398,
                    1.1971999759931862, -0.02242534584060296},
                   {2.102661240032001, -0.9939575280452679, -1.908562292526263, -0.6445628874793665,
                    -1.1538961841691724, 1.2083412487372867},
                   {2.2451561921076024, 1.9379707470561245, 2.237435344582094, 0.9139765958616106,
                    2.1984374279266863, 0.6666239951547834},
                   {2.7733233353249087, 1.6650240480066554, -0.9090265922633112, 0.5728243126225667,
                    -0.6512531087176745, 1.887550303470796}});
}

TEST(Examples, ThreeRprPlatformHasItsSixPoses) {
  const Mechanism m = example("3-rpr");
  const Phi phi(m);
  const double poses[][3] = {{-8.726595331862907, 12.175669752170045, -0.9869742378454451},
                             {-5.495660815452858, -13.935498276039363, -0.04733136936691773},
                             {-14.896128100172765, 1.5829616619625837, 0.24530953099162733},
                             {-13.419939013974382, -6.6562479567101684, 0.5856727832585524},
                             {14.9201332471544, -1.3379177430462292, 1.0020385399022498},
                             {14.673943655735037, -3.0126031249259277, 2.1329043651290895}};
  for (const auto& pose : poses) {
    const Eigen::Vector3d expected(pose[0], pose[1], pose[2]);
    const NewtonResult run = newton(phi, (expected * 100).array().round().matrix() / 100);
    ASSERT_EQ(run.status, NewtonStatus::converged);
    EXPECT_LT((run.q - expected).norm(), 1e-11);
    EXPECT_LE(run.scaled_residual, kBar);
  }
}

TEST(Examples, JansenLegHasItsEightClosuresAndFootPointsAtCrankZero) {
  const Mechanism m = example("jansen-leg");
  // link_j, upper, link_k, link_c, link_f, lower; and the foot F.
  const std::vector<std::vector<double>> closures{
      {-2.1736530556657923, -0.9348011588001719, -2.315481044639538, -1.2858386142179512,
       -2.4948552983953327, 1.8115267280888618},
      {-2.1736530556657923, -0.9348011588001719, -2.315481044639538, -1.2858386142179512,
       -1.3767909406487966, 0.6000123400465953},
      {-2.1736530556657923, -0.9348011588001719, 2.6077228332823097, 1.5780804028607225,
       -2.636456735739671, -1.5830996276931866},
      {-2.1736530556657923, -0.9348011588001719, 2.6077228332823097, 1.5780804028607225,
       1.680377441463519, 0.6270203334170343},
      {2.465894844308564, 1.2270429474429436, -2.315481044639538, -1.2858386142179512,
       -1.1647326082437524, 2.645707522702991},
      {2.465894844308564, 1.2270429474429436, -2.315481044639538, -1.2858386142179512,
       -0.5205404625702594, 1.9522047136625842},
      {2.465894844308564, 1.2270429474429436, 2.6077228332823097, 1.5780804028607225,
       -0.34540230637638336, -1.5554032012681098},
      {2.465894844308564, 1.2270429474429436, 2.6077228332823097, 1.5780804028607225,
       1.483663358816333, 2.69366425370806}};
  const double feet[][2] = {
      {-72.09381701521059, -64.57365961056807}, {-60.66562363113678, -9.95678440116675},
      {10.18916388532417, 38.64969992619908},   {-72.94772704942022, 66.13395152835517},
      {-43.16011052410474, -91.75693292612321}, {-68.97559398102895, -70.71490319662139},
      {9.97254782309522, 39.989381877142804},   {-52.258876899521965, -15.46662597203667}};
  expect_closures("jansen-leg", 2, closures);
  for (std::size_t k = 0; k < closures.size(); ++k) {
    const VectorXd q = assembled_from_angles(m, closures[k], 2);
    const Eigen::Vector3d foot = point_position(m, {7, 2}, q);
    EXPECT_NEAR(foot.x(), feet[k][0], 1e-10);
    EXPECT_NEAR(foot.y(), feet[k][1], 1e-10);
  }
}

TEST(Examples, RssrRockerStandsAtTheTwoPublishedAngles) {
  const Mechanism m = example("rssr");
  const Phi phi(m);
  for (const double psi_deg : {-93.54158024029208, 91.57541939668447}) {
    // Rocker frame: x = cos psi e1 + sin psi e2, z along the output axis.
    const Eigen::Vector3d e1(1, 0, 0), e2(0, 0.8, -0.6), axis(0, 0.6, 0.8);
    const double guess = std::round(psi_deg) * kDegree;
    Eigen::Matrix3d R;
    R.col(0) = std::cos(guess) * e1 + std::sin(guess) * e2;
    R.col(2) = axis;
    R.col(1) = axis.cross(R.col(0));
    const Eigen::AngleAxisd turn(R);
    VectorXd q = initial_guess(m);
    q.segment<3>(9) = turn.angle() * turn.axis();
    const NewtonResult run = newton(phi, q);
    ASSERT_EQ(run.status, NewtonStatus::converged) << run.message;
    const Eigen::Vector3d arm = point_position(m, {2, 1}, run.q) - Eigen::Vector3d(4, 1, 0.5);
    EXPECT_NEAR(std::atan2(arm.dot(e2), arm.dot(e1)) / kDegree, psi_deg, 1e-10);
  }
}

TEST(Examples, BennettFollowsItsClosureRelation) {
  Mechanism m = example("bennett");
  VectorXd q = newton(Phi(m), initial_guess(m)).q;
  const double published_deg[][2] = {{40, 164.8232088324813}, {100, 132.86517656845734}};
  for (const auto& [theta1, theta2] : published_deg) {
    for (double theta = 40; theta <= theta1; theta += 5) {
      m.drivers[0].law = Parabola{theta * kDegree, 0, 0};
      const NewtonResult run = newton(Phi(m), q);
      ASSERT_EQ(run.status, NewtonStatus::converged) << run.message;
      q = run.q;
    }
    // theta2 turns Rx(alpha1) z-frames: the angle about joint 2's axis between link1's x and
    // link2's x.
    const Eigen::Vector3d x1 = orientation(m, 1, q).col(0), x2 = orientation(m, 2, q).col(0);
    EXPECT_NEAR(std::acos(x1.dot(x2)) / kDegree, theta2, 1e-9);
  }
}

TEST(Examples, InvertedSliderCrankHasOppositeDisplacements) {
  const Mechanism m = example("inverted-slider-crank");
  const Phi phi(m);
  const VectorXd q = newton(phi, initial_guess(m)).q;
  VectorXd turned = q;
  turned[5] += std::acos(-1.0);
  turned[8] += std::acos(-1.0);
  const VectorXd other = newton(phi, turned).q;
  const double s = *joint_coordinate(m, m.joints[3], q);
  EXPECT_GT(std::abs(s), 1);
  EXPECT_NEAR(*joint_coordinate(m, m.joints[3], other), -s, 1e-13);
}

TEST(Examples, GearFiveBarHoldsItsRatio) {
  const Mechanism m = example("gear-five-bar");
  const VectorXd q = newton(Phi(m), initial_guess(m)).q;
  // -20 phi1 = 40 (phi2 - 30 deg)
  EXPECT_NEAR(q[5] / kDegree, 30 - 70 / 2.0, 1e-12);
}

}  // namespace
}  // namespace moivre
