// SPDX-License-Identifier: MIT
// Are kinematic coefficients the derivatives by the drivers, and advantages what the textbooks
// have?
#include "moivre/kinematics/coefficients.h"

#include "followed.h"
#include "moivre/kinematics/newton.h"

namespace moivre::test {
namespace {

TEST(KinematicCoefficients, AreTheDerivativesByOneDriver) {
  for (const char* name : {"four-bar", "slider-crank", "whitworth", "stephenson-3", "jansen-leg",
                           "five-bar", "gear-five-bar", "rssr", "crane"}) {
    Mechanism m = example(name);
    const Phi phi(m);
    const NewtonResult pose = newton(phi, initial_guess(m));
    ASSERT_EQ(pose.status, NewtonStatus::converged) << name;
    const KinematicCoefficients k = kinematic_coefficients(phi, pose.q, 0);
    ASSERT_TRUE(k.is_determined) << name;
    for (std::size_t a = 0; a < m.drivers.size(); ++a) {
      const double value = driver_state(m.drivers[a].law, 0).value;
      const double h = 1e-4;
      const auto moved = [&](double by) {
        Mechanism there = m;
        there.drivers[a].law = Parabola{value + by, 0, 0};
        return newton(Phi(there), pose.q).q;
      };
      const Eigen::VectorXd ahead = moved(h), behind = moved(-h);
      const double size = 1 + k.first.cwiseAbs().maxCoeff();
      const auto col = static_cast<Eigen::Index>(a);
      EXPECT_LT(((ahead - behind) / (2 * h) - k.first.col(col)).cwiseAbs().maxCoeff(), 1e-6 * size)
          << name;
      const double bend = 1 + k.second[a].col(col).cwiseAbs().maxCoeff();
      EXPECT_LT(
          ((ahead - 2 * pose.q + behind) / (h * h) - k.second[a].col(col)).cwiseAbs().maxCoeff(),
          1e-4 * bend)
          << name;
    }
  }
}

/// A boom of 2 m on a hinge at A, lifted by a cylinder from B; AB = sqrt(0.5).
std::string boom_text(bool is_spatial) {
  const std::string z = is_spatial ? ", 0" : "";
  return std::string(is_spatial ? "space = \"spatial\"\n" : "") +
         "[units]\nlength = \"m\"\n[ground.points]\nA = [0, 0" + z + "]\nB = [0.5, -0.5" + z +
         "]\n[body.boom.points]\nA = [0, 0" + z + "]\nC = [2, 0" + z +
         "]\n[[joint]]\ntype = \"revolute\"\nat = [\"ground.A\", \"boom.A\"]\n" +
         (is_spatial ? "axis = [0, 0, 1]\n" : "") +
         "[[joint]]\ntype = \"actuator\"\nat = [\"ground.B\", \"boom.C\"]\nname = \"lift\"\n"
         "[[driver]]\nslide = \"lift\"\nstart = 2\nvelocity = 0.05\n";
}

TEST(KinematicCoefficients, OfAnActuatorAreByItsLength) {
  for (const bool is_spatial : {false, true}) {
    const Mechanism m = typed(boom_text(is_spatial));
    const Phi phi(m);
    const NewtonResult pose = newton(phi, initial_guess(m));
    ASSERT_EQ(pose.status, NewtonStatus::converged);
    const KinematicCoefficients k = kinematic_coefficients(phi, pose.q, 0);
    // L^2 = AB^2 + AC^2 - 2 AB AC cos(gamma)
    const double ab = std::sqrt(0.5), ac = 2, L = 2;
    const double cosine = (ab * ab + ac * ac - L * L) / (2 * ab * ac);
    const double slope = L / (ab * ac * std::sqrt(1 - cosine * cosine));
    const double bend = 1 / (ab * ac * std::sqrt(1 - cosine * cosine)) -
                        slope * slope * cosine / std::sqrt(1 - cosine * cosine);
    const Eigen::Index turn = is_spatial ? 5 : 2;
    EXPECT_NEAR(std::abs(k.first(turn, 0)), slope, 1e-9);
    EXPECT_NEAR(std::abs(k.second[0](turn, 0)), std::abs(bend), 1e-8);
  }
}

TEST(MechanicalAdvantage, OfAnActuatorIsOneOverWhatItsLengthMoves) {
  const Followed all = followed(
      typed(boom_text(false)),
      {{QuantityGroup::advantage, QuantityGroup::coefficients}, {"lift", "boom.C.y"}}, 8, 2);
  for (std::size_t k = 0; k < all.samples().size(); ++k) {
    EXPECT_NEAR(all.value("d lift/d lift", k), 1, 1e-9);
    EXPECT_NEAR(all.value("lift-boom.C.y advantage", k) *
                    std::abs(all.samples()[k].velocity[2] * 2 * std::cos(all.samples()[k].q[2])),
                0.05, 1e-9);
  }
}

TEST(KinematicCoefficients, OfAllDriversGiveVelocityAndAcceleration) {
  for (const char* name : {"five-bar", "four-bar", "gear-five-bar", "whitworth", "rssr", "crane"}) {
    const Followed all = followed(example(name), {}, 12, 0.4);
    const Phi phi(all.mechanism);
    for (const BranchSample& sample : all.samples()) {
      const KinematicCoefficients k = kinematic_coefficients(phi, sample.q, sample.time);
      Eigen::VectorXd v = Eigen::VectorXd::Zero(sample.q.size());
      Eigen::VectorXd w = v;
      for (std::size_t a = 0; a < k.second.size(); ++a) {
        const DriverState f = driver_state(all.mechanism.drivers[a].law, sample.time);
        v += k.first.col(static_cast<Eigen::Index>(a)) * f.velocity;
        w += k.first.col(static_cast<Eigen::Index>(a)) * f.acceleration;
        for (std::size_t b = 0; b < k.second.size(); ++b) {
          const double other = driver_state(all.mechanism.drivers[b].law, sample.time).velocity;
          w += k.second[a].col(static_cast<Eigen::Index>(b)) * f.velocity * other;
        }
      }
      EXPECT_LT((v - sample.velocity).cwiseAbs().maxCoeff(), 1e-10 * (1 + v.cwiseAbs().maxCoeff()));
      EXPECT_LT((w - sample.acceleration).cwiseAbs().maxCoeff(),
                1e-9 * (1 + w.cwiseAbs().maxCoeff()));
    }
  }
}

TEST(CoefficientColumns, OfSlidesAndMixedOnesGiveTheAccelerationToo) {
  const Followed five = followed(
      example("five-bar"), groups({QuantityGroup::coefficients, QuantityGroup::coordinates}), 8, 1);
  for (std::size_t k = 0; k < five.samples().size(); ++k) {
    const double t = five.samples()[k].time;
    const double f1 = driver_state(five.mechanism.drivers[0].law, t).velocity;
    const double f2 = driver_state(five.mechanism.drivers[1].law, t).velocity;
    const double expected = five.value("d2 coupler1.phi/d crank1^2", k) * f1 * f1 +
                            2 * five.value("d2 coupler1.phi/d crank1 d crank2", k) * f1 * f2 +
                            five.value("d2 coupler1.phi/d crank2^2", k) * f2 * f2;
    EXPECT_NEAR(five.value("coupler1.phi.acceleration", k), expected, 1e-9);
  }
  const double r = 40, l = 120, e = 15;
  const Followed slider =
      followed(typed(slider_crank_text(r, l, e)), groups({QuantityGroup::coefficients}));
  for (std::size_t k = 0; k < slider.samples().size(); ++k) {
    const double theta = slider.samples()[k].q[2];
    const double rise = r * std::sin(theta) - e;
    const double slope =
        -r * std::sin(theta) - rise * r * std::cos(theta) / std::sqrt(l * l - rise * rise);
    EXPECT_NEAR(slider.value("d guide/d crank", k), slope, 1e-9 * r);
  }
}

TEST(MechanicalAdvantage, OfNortonsFourBarIsThatOfItsVelocities) {
  // Example 6-7: omega2 = 25 rad/s, omega4 = 6.998 rad/s at 40 degrees.
  const Followed all = followed(example("four-bar"), groups({QuantityGroup::advantage}), 90);
  ASSERT_EQ(all.readings.quantities.size(), 1U);
  EXPECT_NEAR(all.value("crank-rocker advantage", 0), 25 / 6.998, 1e-3);
  EXPECT_TRUE(all.extremes("crank-rocker advantage").largest.is_unbounded());
  EXPECT_GT(all.extremes("crank-rocker advantage").least.value, 0);
}

TEST(MechanicalAdvantage, IsTheBalanceOfPowerForEveryOutput) {
  const QuantityChoice choice{{QuantityGroup::advantage, QuantityGroup::coordinates},
                              {"rod", "guide", "slider", "slider.B.x"}};
  const Followed all = followed(typed(slider_crank_text(40, 120, 15, "90")), choice);
  const double driver = kPi / 2;
  for (std::size_t k = 1; k < all.samples().size(); k += 7) {
    const double rod = std::abs(all.samples()[k].velocity[5]);
    // Where the rod stands, both are rounding.
    const double power = all.value("crank-rod advantage", k) * rod;
    EXPECT_TRUE(rod < 1e-12 || std::abs(power - driver) <= 1e-9) << power;
    EXPECT_NEAR(all.value("crank-guide advantage", k) * std::abs(all.samples()[k].velocity[6]),
                driver, 1e-9);
    EXPECT_EQ(all.value("crank-slider.B.x advantage", k), all.value("crank-guide advantage", k));
    EXPECT_EQ(all.value("crank-slider advantage", k), all.value("crank-guide advantage", k));
  }
  EXPECT_EQ(all.readings.quantities[all.index("crank-guide advantage")].unit, "1/mm");
  EXPECT_EQ(all.readings.quantities[all.index("crank-rod advantage")].unit, "-");
}

TEST(MechanicalAdvantage, RefusesAnOutputThatIsNot) {
  const Mechanism m = example("four-bar");
  EXPECT_THROW(QuantityReader(m, {{QuantityGroup::advantage}, {"roker"}}), std::invalid_argument);
}

}  // namespace
}  // namespace moivre::test
