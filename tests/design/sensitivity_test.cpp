// SPDX-License-Identifier: MIT
// Do sensitivities agree with closed forms, and with closures solved afresh for changed dimensions?
#include "moivre/design/sensitivity.h"

#include <Eigen/LU>
#include <algorithm>
#include <limits>
#include <set>
#include <stdexcept>

#include "../closures/mechanisms.h"
#include "followed.h"
#include "moivre/kinematics/newton.h"
#include "moivre/mechanism/pose.h"
#include "moivre/numeric/random.h"

namespace moivre::test {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

std::size_t dimension_number(const Sensitivities& told, const std::string& name) {
  for (std::size_t k = 0; k < told.dimensions.size(); ++k) {
    if (told.dimensions[k].name == name) return k;
  }
  throw std::out_of_range("no dimension " + name);
}

std::size_t quantity_number(const Sensitivities& told, const std::string& name, int axis = 0) {
  for (std::size_t k = 0; k < told.quantities.size(); ++k) {
    if (told.quantities[k].name == name && told.quantities[k].axis == axis) return k;
  }
  throw std::out_of_range("no quantity " + name);
}

double rate(const Sensitivities& told, std::size_t closure, const std::string& quantity,
            const std::string& dimension, int axis = 0) {
  return told.closures[closure].rates(static_cast<Index>(quantity_number(told, quantity, axis)),
                                      static_cast<Index>(dimension_number(told, dimension)));
}

/// What a quantity is worth in a pose.
double value_of(const Mechanism& mechanism, const SensitiveQuantity& quantity, std::size_t number,
                const VectorXd& q) {
  switch (quantity.group) {
    case SensitiveGroup::coordinate:
      return q[static_cast<Index>(number)];
    case SensitiveGroup::point:
      return point_position(mechanism, quantity.point, q)[quantity.axis];
    case SensitiveGroup::joint:
      return joint_coordinate(mechanism, mechanism.joints[quantity.joint], q).value();
  }
  return 0;
}

double difference(const SensitiveQuantity& quantity, double ahead, double behind) {
  const bool is_angle = quantity.kind == CoordinateKind::angle;
  return is_angle ? std::remainder(ahead - behind, 2 * kPi) : ahead - behind;
}

/// A step in a dimension: differences are right to its square, and to rounding over it. Where rates
/// are large, near a dead point, they change as fast as the pose does, and the step is as much
/// smaller.
double step_of(const Mechanism& mechanism, const Dimension& dimension, double largest_rate) {
  constexpr double kStep = 2e-5;
  const double length = Phi(mechanism).length();
  const double size = dimension.is_angle ? 1 : length;
  return kStep * size / (1 + largest_rate * (dimension.is_angle ? 1 / length : 1));
}

double largest_rate(const ClosureSensitivity& closure, std::size_t dimension) {
  double largest = 0;
  for (const double rate : closure.rates.col(static_cast<Index>(dimension))) {
    if (!std::isnan(rate)) largest = std::max(largest, std::abs(rate));
  }
  return largest;
}

Mechanism changed(const Mechanism& mechanism, const Dimension& dimension, double by, double time) {
  Mechanism there = mechanism;
  set_dimension(there, dimension, dimension_value(mechanism, dimension, time) + by);
  return there;
}

// Of the closures that are compared by solving afresh: those of one mechanism share its formulas.
constexpr std::size_t kCompared = 2;

/// Every rate of some closures against Newton-Raphson from the closure, the dimension a step up and
/// down; where the dimension cannot change alone, that it does not converge. Tells how many were
/// compared.
std::size_t expect_differences(const Mechanism& mechanism, const std::string& name,
                               double time = 0) {
  const ClosureResult result = closures_of(mechanism, 1, time);
  const Sensitivities told = closure_sensitivities(mechanism, result);
  EXPECT_FALSE(told.closures.empty()) << name;
  std::size_t compared = 0;
  for (std::size_t c = 0; c < std::min(kCompared, told.closures.size()); ++c) {
    const ClosureSensitivity& closure = told.closures[c];
    EXPECT_EQ(closure.missing, "") << name;
    const VectorXd& q = result.closures[c].q;
    for (std::size_t k = 0; k < told.dimensions.size(); ++k) {
      const Dimension& dimension = told.dimensions[k];
      const double largest = largest_rate(closure, k);
      const double h = step_of(mechanism, dimension, largest);
      const Mechanism ahead = changed(mechanism, dimension, h, time);
      const Mechanism behind = changed(mechanism, dimension, -h, time);
      const NewtonResult up = newton(Phi(ahead), q, time);
      const NewtonResult down = newton(Phi(behind), q, time);
      const bool is_breaking = std::count(closure.breaking.begin(), closure.breaking.end(), k) > 0;
      EXPECT_EQ(is_breaking, up.status != NewtonStatus::converged)
          << name << " " << closure.id << ": " << dimension.name;
      if (is_breaking || up.status != NewtonStatus::converged) continue;
      const auto rates = closure.rates.col(static_cast<Index>(k));
      for (std::size_t i = 0; i < told.quantities.size(); ++i) {
        const double expected = rates[static_cast<Index>(i)];
        if (std::isnan(expected)) continue;
        const double measured =
            difference(told.quantities[i], value_of(ahead, told.quantities[i], i, up.q),
                       value_of(behind, told.quantities[i], i, down.q)) /
            (2 * h);
        EXPECT_NEAR(measured, expected, 1e-5 * (1 + largest))
            << name << " " << closure.id << ": " << told.quantities[i].name << " by "
            << dimension.name;
        ++compared;
      }
    }
  }
  return compared;
}

TEST(Sensitivity, OfPlanarMechanismsIsWhatClosuresSolvedAfreshSay) {
  for (const char* name : {"four-bar", "slider-crank", "inverted-slider-crank", "whitworth",
                           "scotch-yoke", "stephenson-3", "five-bar", "gear-five-bar", "3-rpr"}) {
    EXPECT_GT(expect_differences(example(name), name), 100U) << name;
  }
  EXPECT_GT(expect_differences(example("four-bar"), "four-bar, turned on", 0.02), 100U);
}

TEST(Sensitivity, OfAnArmWhoseToolIsHeldIsWhatClosuresSolvedAfreshSay) {
  const Mechanism m = example("puma-560");
  const ClosureResult result = closures_of(m);
  const Sensitivities told = closure_sensitivities(m, result);
  ASSERT_GT(told.closures.size(), 1U);
  const std::size_t turn = [&] {
    std::size_t k = 0;
    while (told.dimensions[k].kind != DimensionKind::turn) ++k;
    return k;
  }();
  const double h = 1e-5;
  for (const std::size_t k : {turn, std::size_t{0}}) {
    for (std::size_t c = 0; c < 2; ++c) {
      const VectorXd& q = result.closures[c].q;
      const NewtonResult up = newton(Phi(changed(m, told.dimensions[k], h, 0)), q);
      const NewtonResult down = newton(Phi(changed(m, told.dimensions[k], -h, 0)), q);
      ASSERT_EQ(up.status, NewtonStatus::converged);
      const VectorXd expected = told.closures[c].rates.col(static_cast<Index>(k)).head(q.size());
      EXPECT_LT(((up.q - down.q) / (2 * h) - expected).cwiseAbs().maxCoeff(),
                1e-5 * (1 + expected.cwiseAbs().maxCoeff()))
          << told.dimensions[k].name;
    }
  }
}

TEST(Sensitivity, OfSpatialMechanismsIsWhatClosuresSolvedAfreshSay) {
  for (const char* name : {"rssr", "rccc", "3-rps"}) {
    EXPECT_GT(expect_differences(example(name), name), 100U) << name;
  }
}

/// A four-bar whose links come from the seed, its coupler with a point of interest.
Mechanism random_four_bar(std::uint64_t seed) {
  const auto number = [&](std::uint64_t k, double from, double to) {
    return from + (to - from) * random_unit(seed, RandomStream::test, k);
  };
  const double crank = number(0, 10, 30);
  Mechanism m = typed(four_bar_text(crank, number(1, 70, 90), number(2, 60, 80), number(3, 60, 90),
                                    std::to_string(number(4, 0, 360))));
  m.bodies[2].points.push_back({"P", {number(5, -50, 50), number(6, -50, 50), 0}, {}});
  for (Body& body : m.bodies) {
    for (BodyPoint& point : body.points) {
      point.at.head<2>() += Eigen::Vector2d(number(7, -1, 1), number(8, -1, 1));
    }
  }
  return m;
}

TEST(Sensitivity, OfRandomFourBarsIsWhatClosuresSolvedAfreshSay) {
  std::size_t compared = 0;
  for (std::uint64_t seed = 1; seed <= 8; ++seed) {
    const std::string name = "seed " + std::to_string(seed);
    compared += expect_differences(random_four_bar(seed), name);
  }
  EXPECT_GT(compared, 1000U);
}

TEST(Sensitivity, IsThatOfAllClosuresFoundAnewByContinuation) {
  const Mechanism m = random_four_bar(3);
  const Sensitivities told = closure_sensitivities(m, closures_of(m));
  for (std::size_t k = 0; k < told.dimensions.size(); ++k) {
    const double h = step_of(m, told.dimensions[k], largest_rate(told.closures[0], k));
    const Mechanism ahead = changed(m, told.dimensions[k], h, 0);
    const Mechanism behind = changed(m, told.dimensions[k], -h, 0);
    const ClosureResult up = closures_of(ahead);
    const ClosureResult down = closures_of(behind);
    ASSERT_EQ(up.closures.size(), told.closures.size());
    for (std::size_t c = 0; c < told.closures.size(); ++c) {
      for (std::size_t i = 0; i < told.quantities.size(); ++i) {
        const SensitiveQuantity& quantity = told.quantities[i];
        const double measured = difference(quantity, value_of(ahead, quantity, i, up.closures[c].q),
                                           value_of(behind, quantity, i, down.closures[c].q)) /
                                (2 * h);
        const double expected =
            told.closures[c].rates(static_cast<Index>(i), static_cast<Index>(k));
        EXPECT_NEAR(measured, expected, 1e-5 * (1 + std::abs(expected)));
      }
    }
  }
}

TEST(Sensitivity, OfASliderCrankIsThatOfItsFormula) {
  // x = r cos + sqrt(l^2 - (r sin - e)^2)
  const double r = 40, l = 120, e = 15, theta = 50 * kPi / 180;
  Mechanism m = typed(slider_crank_text(r, l, e));
  m.drivers[0].law = Parabola{theta, 0, 0};
  const Sensitivities told = closure_sensitivities(m, closures_of(m));
  ASSERT_EQ(told.closures.size(), 2U);
  const double rise = r * std::sin(theta) - e;
  for (const double side : {1.0, -1.0}) {
    const double root = side * std::sqrt(l * l - rise * rise);
    std::size_t c = 0;
    const ClosureResult result = closures_of(m);
    while (result.closures[c].q[6] * side < 0) ++c;
    EXPECT_NEAR(rate(told, c, "slider.x", "rod.B.x"), l / root, 1e-12);
    EXPECT_NEAR(rate(told, c, "slider.x", "crank.A.x"),
                std::cos(theta) - rise * std::sin(theta) / root, 1e-12);
    EXPECT_NEAR(rate(told, c, "slider.x", "ground.G.y"), rise / root, 1e-12);
    EXPECT_NEAR(rate(told, c, "slider.x", "crank"),
                -r * std::sin(theta) - rise * r * std::cos(theta) / root, 1e-11);
    EXPECT_NEAR(rate(told, c, "guide", "ground.G.x"), -1, 1e-12);
    EXPECT_NEAR(rate(told, c, "slider.x", "ground.O.x"), 1, 1e-12);
    EXPECT_NEAR(rate(told, c, "slider.phi", "guide.turn"), 1, 1e-12);
  }
}

TEST(Sensitivity, OfACouplerPointIsThatOfTwoCircles) {
  // B is where circles about A and P meet: l dl = (B - A) . dB, r dr = (B - P) . dB.
  const double crank = 30, coupler = 80, rocker = 70, ground = 75;
  const Mechanism m = typed(four_bar_text(crank, coupler, rocker, ground, "60"));
  const ClosureResult result = closures_of(m);
  const Sensitivities told = closure_sensitivities(m, result);
  ASSERT_EQ(told.closures.size(), 2U);
  for (std::size_t c = 0; c < 2; ++c) {
    const VectorXd& q = result.closures[c].q;
    const Eigen::Vector2d a = point_position(m, {2, 0}, q).head<2>();
    const Eigen::Vector2d b = point_position(m, {2, 1}, q).head<2>();
    const Eigen::Vector2d p(ground, 0);
    Eigen::Matrix2d arms;
    arms << (b - a).transpose(), (b - p).transpose();
    const auto expect = [&](const char* dimension, const Eigen::Vector2d& right) {
      const Eigen::Vector2d moved = arms.inverse() * right;
      for (const int axis : {0, 1}) {
        EXPECT_NEAR(rate(told, c, "coupler.B", dimension, axis), moved[axis], 1e-12) << dimension;
      }
    };
    expect("coupler.B.x", {coupler, 0});
    expect("rocker.B.x", {0, rocker});
    expect("ground.P.x", {0, b.x() - p.x()});
    const Eigen::Vector2d along = a / crank;
    expect("crank.A.x", {(b - a).dot(along), 0});
    expect("crank", {(b - a).dot(Eigen::Vector2d(-a.y(), a.x())), 0});
  }
}

TEST(Spread, IsTheSumOfAllShares) {
  Mechanism m = typed(slider_crank_text(40, 120, 15));
  m.drivers[0].law = Parabola{0.8, 0, 0};
  m.tolerance = 0.05;
  m.tolerances["rod.B.x"] = 0.2;
  m.tolerances["crank"] = 0.01;
  const Sensitivities told = closure_sensitivities(m, closures_of(m));
  ASSERT_TRUE(told.has_tolerances());
  const auto i = static_cast<Index>(quantity_number(told, "slider.x"));
  for (std::size_t c = 0; c < told.closures.size(); ++c) {
    double sum = 0, squares = 0;
    for (std::size_t k = 0; k < told.dimensions.size(); ++k) {
      const std::string& name = told.dimensions[k].name;
      const double tolerance = name == "rod.B.x"      ? 0.2
                               : name == "crank"      ? 0.01
                               : name == "guide.turn" ? 0
                                                      : 0.05;
      const double share = tolerance * rate(told, c, "slider.x", name);
      sum += std::abs(share);
      squares += share * share;
    }
    EXPECT_NEAR(told.closures[c].worst_case[i], sum, 1e-12);
    EXPECT_NEAR(told.closures[c].root_sum_square[i], std::sqrt(squares), 1e-12);
  }
}

TEST(Spread, HoldsForEveryCornerOfSmallTolerances) {
  Mechanism m = random_four_bar(5);
  m.tolerance = 1e-4;
  const ClosureResult result = closures_of(m);
  const Sensitivities told = closure_sensitivities(m, result);
  const auto x = static_cast<Index>(quantity_number(told, "coupler.P"));
  const VectorXd& q = result.closures[0].q;
  const double at_rest = point_position(m, {2, 2}, q).x();
  const double worst = told.closures[0].worst_case[x];
  double furthest = 0;
  for (std::uint64_t corner = 0; corner < 40; ++corner) {
    Mechanism there = m;
    for (std::size_t k = 0; k < told.dimensions.size(); ++k) {
      const double slope = told.closures[0].rates(x, static_cast<Index>(k));
      const double random = random_unit(corner, RandomStream::test, k);
      const double side = corner == 0 ? (slope > 0 ? 1 : -1) : (random > 0.5 ? 1 : -1);
      set_dimension(there, told.dimensions[k], told.values[k] + side * told.tolerances[k]);
    }
    const double moved =
        std::abs(point_position(there, {2, 2}, newton(Phi(there), q).q).x() - at_rest);
    EXPECT_LT(moved, worst * 1.001);
    furthest = std::max(furthest, moved);
  }
  EXPECT_NEAR(furthest, worst, 1e-3 * worst);
}

TEST(Spread, OfTheFurthestPointIsSolvedAfresh) {
  // The rod's end of a slider-crank in closed form, with everything off to the worse side.
  Mechanism m = typed(slider_crank_text(40, 120, 0));
  m.drivers[0].law = Parabola{0.8, 0, 0};
  m.tolerances = {{"crank.A.x", 2}, {"rod.B.x", 3}};
  const Sensitivities told = closure_sensitivities(m, closures_of(m));
  std::size_t seen = 0;
  for (const ClosureSensitivity& closure : told.closures) {
    ASSERT_TRUE(closure.corner);
    if (told.quantities[closure.corner->quantity].axis != 0) continue;
    ++seen;
    const auto place = [&](double r, double l, double side) {
      return r * std::cos(0.8) + side * std::sqrt(l * l - std::pow(r * std::sin(0.8), 2));
    };
    std::vector<double> corners;
    for (const double side : {1.0, -1.0}) {
      for (const double r : {38.0, 42.0}) {
        for (const double l : {117.0, 123.0}) {
          corners.push_back(place(r, l, side) - place(40, 120, side));
        }
      }
    }
    for (const std::optional<double>& moved : {closure.corner->up, closure.corner->down}) {
      ASSERT_TRUE(moved);
      EXPECT_TRUE(std::any_of(corners.begin(), corners.end(),
                              [&](double corner) { return std::abs(corner - *moved) < 1e-9; }));
    }
    EXPECT_GT(*closure.corner->up, 0);
    EXPECT_LT(*closure.corner->down, 0);
  }
  EXPECT_GT(seen, 0U);
}

TEST(Spread, BesideADeadPointIsFoundNotToClose) {
  Mechanism m = typed(toggle_text("1.999"));
  m.tolerances = {{"guide", 0.01}};
  const Sensitivities told = closure_sensitivities(m, closures_of(m));
  ASSERT_EQ(told.closures.size(), 2U);
  ASSERT_TRUE(told.closures[0].corner);
  const auto& [quantity, up, down] = *told.closures[0].corner;
  EXPECT_NE(up.has_value(), down.has_value());  // beyond 2 there is none
}

TEST(Sensitivity, HasNoBoundAtADeadPoint) {
  const Mechanism m = typed(toggle_text("2"));
  const Sensitivities told = closure_sensitivities(m, closures_of(m));
  ASSERT_EQ(told.closures.size(), 1U);
  EXPECT_EQ(told.closures[0].missing, "it is a dead point, where sensitivities have no bound");
  EXPECT_TRUE(std::isnan(rate(told, 0, "a.phi", "guide")));
  EXPECT_TRUE(std::isnan(rate(told, 0, "b.S", "a.M.x")));
  EXPECT_TRUE(told.closures[0].breaking.empty());
  // A little within reach it is large, and true.
  const double reach = 2 - 1e-4;
  const Mechanism near = typed(toggle_text(std::to_string(reach)));
  const Sensitivities beside = closure_sensitivities(near, closures_of(near));
  ASSERT_EQ(beside.closures.size(), 2U);
  // reach = 2 cos a
  EXPECT_NEAR(std::abs(rate(beside, 0, "a.phi", "guide")) * 2 * std::sqrt(1 - reach * reach / 4), 1,
              1e-8);
}

TEST(Sensitivity, OfAMechanismWithSpareConstraintsSaysWhatCannotChangeAlone) {
  const Mechanism m = example("double-parallel-crank");
  const Sensitivities told = closure_sensitivities(m, closures_of(m));
  EXPECT_GT(expect_differences(m, "double-parallel-crank"), 20U);
  ASSERT_FALSE(told.closures.empty());
  // The lengths of the cranks by their ends, along them and aside; the driver may go where it
  // likes.
  const auto& breaking = told.closures[0].breaking;
  const auto can_change = [&](const char* name) {
    return std::count(breaking.begin(), breaking.end(), dimension_number(told, name)) == 0;
  };
  EXPECT_FALSE(can_change("crank1.A1.x"));
  EXPECT_FALSE(can_change("crank1.A1.y"));
  EXPECT_TRUE(can_change("crank1"));
  EXPECT_NEAR(rate(told, 0, "crank3.phi", "crank1"), 1, 1e-12);
}

TEST(Sensitivity, OfASpatialLoopInThePlaneMayChangeWithinThePlaneOnly) {
  std::string text =
      "space = \"spatial\"\n[units]\nangle = \"deg\"\n[ground.points]\nO = [0, 0, 0]\nP = [75, 0, "
      "0]\n"
      "[body.crank.points]\nO = [0, 0, 0]\nA = [30, 0, 0]\n[body.coupler.points]\nA = [0, 0, 0]\n"
      "B = [80, 0, 0]\n[body.rocker.points]\nP = [0, 0, 0]\nB = [70, 0, 0]\n";
  const char* names[] = {"O", "A", "B", "P"};
  const char* ends[] = {"ground.O\", \"crank.O", "crank.A\", \"coupler.A",
                        "coupler.B\", \"rocker.B", "ground.P\", \"rocker.P"};
  for (int k = 0; k < 4; ++k) {
    text += std::string("[[joint]]\ntype = \"revolute\"\naxis = [0, 0, 1]\nname = \"") + names[k] +
            "\"\nat = [\"" + ends[k] + "\"]\n";
  }
  const Mechanism m = typed(text + "[[driver]]\nangle = \"O\"\nstart = 60\n");
  EXPECT_GT(expect_differences(m, "spatial four-bar"), 100U);
  const Sensitivities told = closure_sensitivities(m, closures_of(m));
  std::set<std::string> breaking;
  for (const std::size_t k : told.closures[0].breaking) breaking.insert(told.dimensions[k].name);
  EXPECT_EQ(breaking,
            (std::set<std::string>{"ground.O.z", "ground.P.z", "crank.O.z", "crank.A.z",
                                   "coupler.A.z", "coupler.B.z", "rocker.P.z", "rocker.B.z"}));
  const Mechanism flat = typed(four_bar_text(30, 80, 70, 75, "60"));
  const Sensitivities planar = closure_sensitivities(flat, closures_of(flat));
  for (const char* dimension : {"crank.A.x", "rocker.B.y", "ground.P.x", "coupler.B.x"}) {
    for (const int axis : {0, 1}) {
      EXPECT_NEAR(rate(told, 0, "coupler.B", dimension, axis),
                  rate(planar, 0, "coupler.B", dimension, axis), 1e-9)
          << dimension;
    }
  }
}

TEST(Spread, IsNoneWhereADimensionWithATolerenceCannotChangeAlone) {
  Mechanism m = example("double-parallel-crank");
  m.tolerance = 0.01;
  const Sensitivities told = closure_sensitivities(m, closures_of(m));
  ASSERT_FALSE(told.closures.empty());
  EXPECT_TRUE(told.closures[0].worst_case.array().isNaN().all());
  EXPECT_TRUE(told.closures[0].root_sum_square.array().isNaN().all());
}

TEST(Sensitivity, OfABodyThatSpinsBetweenTwoBallsIsThatOfItsLine) {
  Mechanism m = typed(kSpinningCoupler);
  m.bodies[2].points.push_back({"P", {2, 1, 0}, {}});
  EXPECT_GT(expect_differences(m, "spinning coupler"), 100U);
  const Sensitivities told = closure_sensitivities(m, closures_of(m));
  ASSERT_FALSE(told.closures.empty());
  EXPECT_TRUE(std::isnan(rate(told, 0, "coupler.P", "crank.A.x")));
  EXPECT_FALSE(std::isnan(rate(told, 0, "coupler.B", "crank.A.x")));
  EXPECT_FALSE(std::isnan(rate(told, 0, "output", "coupler.B.x")));
}

TEST(Sensitivity, OfAUniversalJointIsTheDerivativeOfItsFormula) {
  // tan(out) = tan(in) / cos(bend): the textbook's Cardan shaft.
  const double bend = 0.5, in = 0.7;
  const auto text = [](double x) { return std::to_string(x); };
  const std::string out_axis = "[" + text(std::sin(bend)) + ", 0, " + text(std::cos(bend)) + "]";
  const Mechanism m = typed(
      "space = \"spatial\"\n[ground.points]\nO = [0, 0, 0]\nE = [0, 0, 0]\n[body.in.points]\nO = "
      "[0, 0, 0]\n[body.out.points]\nO = [0, 0, 0]\nE = [0, 0, 0]\nT = [0, 3, 0]\n"
      "[[joint]]\ntype = \"revolute\"\nname = \"inlet\"\nat = [\"ground.O\", \"in.O\"]\naxis = [0, "
      "0, 1]\n"
      "[[joint]]\ntype = \"revolute\"\nname = \"outlet\"\nat = [\"ground.E\", \"out.E\"]\naxis = "
      "[" +
      out_axis +
      ", [0, 0, 1]]\n[[joint]]\ntype = \"universal\"\nat = [\"in.O\", \"out.O\"]\n"
      "axis = [[1, 0, 0], [0, 1, 0]]\n[[driver]]\nangle = \"inlet\"\nstart = " +
      text(in) + "\n");
  EXPECT_GT(expect_differences(m, "universal joint"), 20U);
  const Sensitivities told = closure_sensitivities(m, closures_of(m));
  ASSERT_FALSE(told.closures.empty());
  const double c = std::cos(bend), s = std::sin(bend);
  // d out / d in = cos(bend) / (1 - sin^2(bend) cos^2(in')), in' counted from where the fork lies
  // in the plane of both shafts.
  const double slope = std::abs(rate(told, 0, "outlet", "inlet"));
  const double by_cos = c / (1 - s * s * std::cos(in) * std::cos(in));
  const double by_sin = c / (1 - s * s * std::sin(in) * std::sin(in));
  EXPECT_LT(std::min(std::abs(slope - by_cos), std::abs(slope - by_sin)), 1e-5);
  // The points of a Cardan joint's centre cannot come apart.
  EXPECT_FALSE(told.closures[0].breaking.empty());
}

TEST(Sensitivity, OfAPlatformOnLegsIsTheInverseOfItsJacobian) {
  const Mechanism m = example("octahedral-3-3");
  const ClosureResult result = closures_of(m);
  const Sensitivities told = closure_sensitivities(m, result);
  std::size_t regular = 0;
  for (std::size_t c = 0; c < std::min(kCompared, told.closures.size()); ++c) {
    if (!told.closures[c].missing.empty()) continue;
    ++regular;
    // The leg that grows does, the others keep their lengths.
    for (std::size_t k = 0; k < told.dimensions.size(); ++k) {
      if (told.dimensions[k].kind != DimensionKind::length) continue;
      for (const Joint& leg : m.joints) {
        const Eigen::Vector3d arm = point_position(m, leg.at[1], result.closures[c].q) -
                                    point_position(m, leg.at[0], result.closures[c].q);
        Eigen::Vector3d moved = Eigen::Vector3d::Zero();
        for (const std::size_t end : {1U, 0U}) {
          if (leg.at[end].body == 0) continue;
          const Body& body = m.bodies[leg.at[end].body];
          const std::string name = body.name + "." + body.points[leg.at[end].point].name;
          for (int axis = 0; axis < 3; ++axis) {
            moved[axis] += (end == 1 ? 1 : -1) * rate(told, c, name, told.dimensions[k].name, axis);
          }
        }
        const bool grows = &leg == &m.joints[told.dimensions[k].joint];
        EXPECT_NEAR(arm.dot(moved) / leg.length, grows ? 1 : 0, 1e-7);
      }
    }
  }
  EXPECT_GT(regular, 0U);
}

TEST(Sensitivity, IsNotOfClosuresByLeastSquares) {
  Mechanism m = example("double-parallel-crank");
  m.bodies[1].points.back().at.x() += 1e-4;
  m.fit = 0.1;
  const ClosureResult result = closures_of(m);
  ASSERT_FALSE(result.closures.empty());
  const Sensitivities told = closure_sensitivities(m, result);
  ASSERT_TRUE(result.closures[0].is_fitted);
  EXPECT_EQ(told.closures[0].missing, "it closes by least squares only");
}

TEST(Sensitivity, RefusesTypedEquations) {
  EXPECT_THROW(require_dimensions(example("slider-crank-equations")), std::invalid_argument);
}

}  // namespace
}  // namespace moivre::test
