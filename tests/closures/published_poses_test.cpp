// SPDX-License-Identifier: MIT
// Are the closures those that others found, angle by angle? Poses from the literature, and from
// PHCpack's solutions of the loops.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "mechanisms.h"

namespace moivre {
namespace {

struct PublishedPoses {
  std::string file;
  std::vector<std::string> bodies;
  std::vector<std::vector<double>> angles_rad;  ///< a row a closure, an entry a body
};

/// Solutions of the loop equations sum_k a_k t_k + a_0 = 0 by PHCpack, refined.
const std::vector<PublishedPoses>& published_poses() {
  static const std::vector<PublishedPoses> poses{
      {"3-rpr",
       {"platform"},
       {{-0.9869742378454451},
        {-0.04733136936691773},
        {0.24530953099162733},
        {0.5856727832585524},
        {1.0020385399022498},
        {2.1329043651290895}}},
      {"watt-1",
       {"coupler", "rocker", "link5", "link6"},
       {
           {-1.2660732948402, -2.3939585775615, 0.30909835384489, 1.378192819395},
           {-1.2660732948402, -2.3939585775615, -1.9540358923813, -3.0231303579314},
           {0.50557088145434, 1.6334561641756, -2.6403970940257, 2.5736937476039},
           {0.50557088145434, 1.6334561641756, -0.37726284779942, 0.69183161775065},
       }},
      {"stephenson-3",
       {"coupler", "rocker", "link5", "link6"},
       {
           {-1.2660732948402, -2.3939585775615, -2.0994902539154, -0.96858592091786},
           {-1.2660732948402, -2.3939585775615, -1.0742493169523, -2.2051536499498},
           {0.50557088145434, 1.6334561641756, -1.3514065161036, 2.2155482478093},
           {0.50557088145434, 1.6334561641756, 2.9521284316314, -0.61482633228148},
       }},
      {"five-bar",
       {"coupler1", "coupler2"},
       {
           {-1.1976330141531, -2.2390838773426},
           {1.0148808111858, 2.0563316743753},
       }},
      {"assur-7-quaternary",
       {"link1", "link2", "link3", "link4", "link5", "link6"},
       {
           {-1.4788848175322, 1.2379161152272, -2.7814548224624, 2.8827001537399, -0.57620864887578,
            2.2727448565263},
           {-1.1603543133862, 0.6726139800934, -1.0325079560664, -2.5495594435401, -1.9028029633713,
            -2.7890366980826},
           {-0.42155989177049, 1.0384980852685, 0.53194834541126, 2.8097433326161, -1.8050331325943,
            2.8753836484738},
           {-0.29192202204216, 1.417732958811, 1.3377992313045, 2.3680833205998, -0.92567133283327,
            2.0931782945088},
           {0.88667595093003, -1.180051403139, -1.4527827458085, -0.17142741147159,
            0.96843738866412, 1.4922265364047},
           {0.89630940769306, -0.64352266589012, -0.33973411540912, -1.6790127593319,
            -2.4613605184241, -2.4393945309525},
           {1.8637191097797, -0.10601565677947, 1.840602201283, 0.48131352266788, -0.74344991543095,
            0.94202385003329},
           {2.2722302025576, -0.26011062827322, 2.813243298812, -2.6125875783419, -1.8856817737882,
            -2.8298455348752},
       }},
      {"assur-7-serial",
       {"link1", "link2", "link3", "link4", "link5", "link6"},
       {
           {-3.0050164498331, -1.8529538929287, 2.6219820308683, -1.2133281198061, -1.6125446907559,
            0.37375334874536},
           {-0.73757109743444, 2.8662316032984, 2.8147058023079, 0.46132197799932, 0.29560705731543,
            0.85454267631758},
           {-0.62983561939788, 2.8938504276152, 2.8337245424041, 0.49536101212839, 0.37483183169005,
            0.85988297057242},
           {0.20203609696683, 2.9497435636995, 2.8725691524248, 0.83415127281356, 1.1291694232843,
            0.87073113377978},
           {0.63572749142243, -1.4520421639038, -2.2175013683355, -0.28989280551863,
            -0.10559024136306, 1.1195059227372},
           {0.83786705352483, 2.8315765950317, -1.2655542899943, 1.0940373744863, 0.31987878688594,
            1.9847575213674},
           {1.6546263117822, -0.976124291182, 1.7793650489663, -0.44123049180394, 1.1971999759932,
            -0.022425345840603},
           {2.102661240032, -0.99395752804527, -1.9085622925263, -0.64456288747937,
            -1.1538961841692, 1.2083412487373},
           {2.2451561921076, 1.9379707470561, 2.2374353445821, 0.91397659586161, 2.1984374279267,
            0.66662399515478},
           {2.7733233353249, 1.6650240480067, -0.90902659226331, 0.57282431262257,
            -0.65125310871767, 1.8875503034708},
       }},
      {"jansen-leg",
       {"link_j", "upper", "link_k", "link_c", "link_f", "lower"},
       {
           {-2.1736530556658, -0.93480115880017, -2.3154810446395, -1.285838614218,
            -2.4948552983953, 1.8115267280889},
           {-2.1736530556658, -0.93480115880017, -2.3154810446395, -1.285838614218,
            -1.3767909406488, 0.6000123400466},
           {-2.1736530556658, -0.93480115880017, 2.6077228332823, 1.5780804028607, -2.6364567357397,
            -1.5830996276932},
           {-2.1736530556658, -0.93480115880017, 2.6077228332823, 1.5780804028607, 1.6803774414635,
            0.62702033341703},
           {2.4658948443086, 1.2270429474429, -2.3154810446395, -1.285838614218, -1.1647326082438,
            2.645707522703},
           {2.4658948443086, 1.2270429474429, -2.3154810446395, -1.285838614218, -0.52054046257026,
            1.9522047136626},
           {2.4658948443086, 1.2270429474429, 2.6077228332823, 1.5780804028607, -0.34540230637638,
            -1.5554032012681},
           {2.4658948443086, 1.2270429474429, 2.6077228332823, 1.5780804028607, 1.4836633588163,
            2.6936642537081},
       }},
  };
  return poses;
}

double angle_between(double a, double b) {
  return std::abs(std::remainder(a - b, 2 * std::numbers::pi));
}

class PublishedAngles : public testing::TestWithParam<PublishedPoses> {};

TEST_P(PublishedAngles, AreThoseOfOneClosureEach) {
  constexpr double kTwelveDigits = 1e-12;
  const PublishedPoses& published = GetParam();
  Mechanism mechanism = mechanism_file(published.file);
  if (published.file == "jansen-leg") mechanism = driven_from(mechanism, 0);
  const std::vector<Coordinate> names = coordinates(mechanism);
  const ClosureResult result = closures_of(mechanism);
  ASSERT_EQ(result.closures.size(), published.angles_rad.size());
  for (const std::vector<double>& row : published.angles_rad) {
    int matches = 0;
    for (const Closure& closure : result.closures) {
      double apart = 0;
      for (std::size_t b = 0; b < row.size(); ++b) {
        for (std::size_t k = 0; k < names.size(); ++k) {
          if (names[k].name != published.bodies[b] + ".phi") continue;
          apart = std::max(apart, angle_between(row[b], closure.q[static_cast<Eigen::Index>(k)]));
        }
      }
      matches += apart <= kTwelveDigits ? 1 : 0;
    }
    EXPECT_EQ(matches, 1) << published.bodies[0] << " at " << row[0];
  }
}

INSTANTIATE_TEST_SUITE_P(Mechanisms, PublishedAngles, testing::ValuesIn(published_poses()),
                         [](const auto& tested) {
                           std::string name = tested.param.file;
                           for (char& c : name) c = c == '-' ? '_' : c;
                           return name;
                         });

// Innocenti and Parenti-Castelli 1992: x, y, phi of the platform. They print its angle at B1 as
// 0.8822, its sides give 0.8826:
// 4e-4 of the side of 20.84 is what the poses may differ by, and twice that near a singular one.
TEST(PublishedPlatform, Of3RprIsMetAsFarAsItsPrintedAngleGoes) {
  constexpr double kPrintedAngle = 0.0167;
  const double published[6][3] = {{-8.715, 12.183, -0.987}, {-5.495, -13.935, -0.047},
                                  {-14.894, 1.596, 0.244},  {-13.417, -6.66, 0.585},
                                  {14.92, -1.337, 1.001},   {14.673, -3.013, 2.133}};
  const Mechanism mechanism = mechanism_file("3-rpr");
  const ClosureResult result = closures_of(mechanism);
  ASSERT_EQ(result.closures.size(), 6u);
  for (const auto& row : published) {
    int matches = 0;
    for (const Closure& closure : result.closures) {
      const double apart =
          (closure.q - Eigen::Vector3d(row[0], row[1], row[2])).cwiseAbs().maxCoeff();
      matches += apart <= kPrintedAngle ? 1 : 0;
    }
    EXPECT_EQ(matches, 1) << row[0];
  }
}

}  // namespace
}  // namespace moivre
