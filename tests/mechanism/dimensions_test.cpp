// SPDX-License-Identifier: MIT
// Are dimensions named, set and told as typed, and is Phi_p what Phi's differences say, for every
// joint and driver?
#include "moivre/mechanism/dimensions.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <stdexcept>

#include "files.h"
#include "moivre/mechanism/dimension_rates.h"
#include "moivre/numeric/random.h"

namespace moivre {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;
using test::example;
using test::kDegree;
using test::typed;

constexpr const char* kPlanar[] = {
    "3-rpr",      "five-bar",      "four-bar",      "gear-five-bar", "inverted-slider-crank",
    "jansen-leg", "parallelogram", "scotch-yoke",   "slider-crank",  "stephenson-3",
    "whitworth",  "watt-1",        "assur-7-serial"};
constexpr const char* kSpatial[] = {"3-rps",         "bennett",  "general-6r",
                                    "griffis-duffy", "puma-560", "rccc",
                                    "rssr",          "ur5",      "spherical-four-bar"};

/// Prismatic, slot, weld and their turns; drivers of a slide and of a place.
constexpr const char* kAllPlanarJoints = R"toml(
[units]
angle = "deg"
[ground.points]
O = [0.1, 0.2]
G = [3, 0.5]
[body.crank.points]
O = [0.1, 0]
A = [2, 0.3]
[body.yoke.points]
S = [0.2, 0.1]
T = [5, 1]
[body.tail.points]
T = [0.4, -0.3]
E = [3, 0]
[body.boom.points]
K = [0.3, 1]
L = [2, 0.2]
[body.kite.points]
K = [0.1, 0.7]
[[joint]]
type = "revolute"
at = ["ground.O", "crank.O"]
[[joint]]
type = "prismatic"
at = ["ground.G", "yoke.S"]
along = [1, 0.3]
turn = 10
name = "guide"
[[joint]]
type = "slot"
at = ["yoke.S", "crank.A"]
along = [0.1, 1]
name = "groove"
[[joint]]
type = "weld"
at = ["yoke.T", "tail.T"]
turn = 30
name = "seam"
[[joint]]
type = "rod"
at = ["tail.E", "boom.K"]
length = 2.5
name = "brace"
[[joint]]
type = "rod"
at = ["boom.L", "kite.K"]
length = 1.5
name = "string"
[[driver]]
slide = "guide"
start = 1
[[driver]]
x = "tail.E"
start = 2
[[driver]]
y = "tail.E"
start = 2
[[driver]]
angle = ["crank", "yoke"]
start = 20
)toml";

/// Prismatic, cylindrical, universal, weld and spherical; turns that are not 0.
constexpr const char* kAllSpatialJoints = R"toml(
space = "spatial"
[ground.points]
O = [0, 0.1, 0.2]
[body.a.points]
O = [0.1, 0, 0.3]
B = [1, 0.2, 0.1]
[body.b.points]
B = [0, 0.2, 0]
C = [1, 0, 0.5]
[body.c.points]
C = [0.3, 0.1, 0]
D = [1, 0, 0.5]
[body.d.points]
D = [0.3, 0.1, 0]
E = [0, 2, 1]
[body.e.points]
E = [0.1, 0.3, 0]
[[joint]]
type = "prismatic"
at = ["ground.O", "a.O"]
axis = [[0, 0.6, 0.8], [1, 0, 0]]
turn = 0.7
name = "lift"
[[joint]]
type = "cylindrical"
at = ["a.B", "b.B"]
axis = [0.6, 0, 0.8]
name = "sleeve"
[[joint]]
type = "universal"
at = ["b.C", "c.C"]
axis = [[1, 0, 0], [0, 1, 0]]
[[joint]]
type = "weld"
at = ["c.D", "d.D"]
axis = [0.8, -0.6, 0]
turn = -1.2
name = "seam"
[[joint]]
type = "spherical"
at = ["d.E", "e.E"]
[[driver]]
slide = "lift"
start = 0.5
[[driver]]
angle = "sleeve"
start = 0.5
[[driver]]
slide = "sleeve"
start = 0.5
[[driver]]
z = "e.E"
start = 0.5
)toml";

VectorXd random_pose(const Mechanism& mechanism, std::uint64_t seed) {
  VectorXd q = initial_guess(mechanism);
  for (Index k = 0; k < q.size(); ++k) {
    q[k] += random_unit(seed, RandomStream::test, static_cast<std::uint64_t>(k)) - 0.5;
  }
  return q;
}

void expect_differences(const Mechanism& mechanism, const std::string& name) {
  const std::vector<Dimension> all = dimensions(mechanism);
  for (std::uint64_t seed = 1; seed <= 2; ++seed) {
    const VectorXd q = random_pose(mechanism, seed);
    const MatrixXd partial = partial_dimensions(mechanism, all, q, 0.3);
    ASSERT_EQ(partial.rows(), Phi(mechanism).size()) << name;
    for (std::size_t k = 0; k < all.size(); ++k) {
      // Rows are of second degree in a dimension at most, or turns: differences are right to
      // rounding, or to h^2.
      const double h = all[k].is_angle ? 1e-4 : 1e-3;
      const double value = dimension_value(mechanism, all[k], 0.3);
      const auto moved = [&](double by) {
        Mechanism there = mechanism;
        set_dimension(there, all[k], value + by);
        return Phi(there).value(q, 0.3);
      };
      const VectorXd difference = (moved(h) - moved(-h)) / (2 * h);
      const double size = 1 + difference.cwiseAbs().maxCoeff();
      EXPECT_LT((difference - partial.col(static_cast<Index>(k))).cwiseAbs().maxCoeff(),
                3e-8 * size)
          << name << ": " << all[k].name;
    }
  }
}

TEST(PartialDimensions, AreWhatDifferencesOfPhiSay) {
  for (const char* name : kPlanar) expect_differences(example(name), name);
  for (const char* name : kSpatial) expect_differences(example(name), name);
  expect_differences(typed(kAllPlanarJoints), "all planar joints");
  expect_differences(typed(kAllSpatialJoints), "all spatial joints");
}

TEST(PartialDimensions, OfTypedEquationsAreThoseOfTheirDrivers) {
  const Mechanism m = example("slider-crank-equations");
  const MatrixXd partial = partial_dimensions(m, dimensions(m), initial_guess(m), 0);
  ASSERT_EQ(partial.cols(), 1);
  VectorXd expected = VectorXd::Zero(partial.rows());
  expected[partial.rows() - 1] = -1;
  EXPECT_EQ(partial.col(0), expected);
}

TEST(Dimensions, OfDriversWithOneNameAreToldApart) {
  const Mechanism m = typed(kAllPlanarJoints);
  const std::vector<std::string> names = dimension_names(m);
  EXPECT_EQ(std::set<std::string>(names.begin(), names.end()).size(), names.size());
  for (const char* name : {"driver tail.E.x", "driver tail.E.y", "guide", "crank-yoke",
                           "guide.turn", "seam.turn", "brace.length", "crank.A.x"}) {
    EXPECT_EQ(std::count(names.begin(), names.end(), name), 1) << name;
  }
  EXPECT_EQ(std::count(names.begin(), names.end(), "tail.E"), 0);
}

TEST(Dimensions, AreSetInTheFilesUnitsByName) {
  Mechanism m = typed(kAllPlanarJoints);
  set_dimension(m, "seam.turn", 90);
  EXPECT_DOUBLE_EQ(m.joints[3].turn_rad, 90 * kDegree);
  set_dimension(m, "driver tail.E.y", 7);
  EXPECT_EQ(driver_state(m.drivers[2].law, 5).value, 7);
  EXPECT_THROW(set_dimension(m, "tail.E", 7), std::invalid_argument);
}

double tolerance_of(const Mechanism& mechanism, const std::string& name) {
  for (const Dimension& dimension : dimensions(mechanism)) {
    if (dimension.name == name) return dimension_tolerance(mechanism, dimension);
  }
  throw std::out_of_range(name);
}

TEST(Tolerances, AreTheNarrowestThatIsTyped) {
  std::string text = "tolerance = 0.05\n";
  text += kAllPlanarJoints;
  const auto put = [&](const std::string& before, const std::string& what) {
    text.insert(text.find(before), what);
  };
  put("[body.crank.points]",
      "[body.crank]\ntolerance = 0.02\n[body.crank.tolerances]\nA = [0.01, 0]\n");
  put("turn = 30", "tolerance = 2\n");
  put("length = 2.5", "tolerance = 0.3\n");
  text += "tolerance = 0.5\n";
  const Mechanism m = typed(text);
  EXPECT_EQ(tolerance_of(m, "ground.O.y"), 0.05);
  EXPECT_EQ(tolerance_of(m, "crank.O.x"), 0.02);
  EXPECT_EQ(tolerance_of(m, "crank.A.x"), 0.01);
  EXPECT_EQ(tolerance_of(m, "crank.A.y"), 0);
  EXPECT_EQ(tolerance_of(m, "brace.length"), 0.3);
  EXPECT_DOUBLE_EQ(tolerance_of(m, "seam.turn"), 2 * kDegree);
  EXPECT_EQ(tolerance_of(m, "guide.turn"), 0);  // of an angle there is no general one
  EXPECT_EQ(tolerance_of(m, "guide"), 0);
  EXPECT_DOUBLE_EQ(tolerance_of(m, "crank-yoke"), 0.5 * kDegree);
}

void expect_fault(const std::string& text, const std::string& line) {
  try {
    typed(text);
    FAIL() << "it was read: " << line;
  } catch (const ParseError& error) {
    const std::string said = error.what();
    EXPECT_EQ(said.substr(0, said.find('\n')), "typed.toml:" + line);
  }
}

TEST(Tolerances, ThatMakeNoSenseAreFaultsWithTheirPlace) {
  const std::string triangle = test::triangle_text("2.5");
  const std::string from_zero = "a tolerance is how far a number may be off, up or down: from 0 up";
  expect_fault("tolerance = -0.1\n" + triangle, "1:13: error: " + from_zero);
  expect_fault(
      "tolerance = \"fine\"\n" + triangle,
      "1:13: error: 'tolerance' must be a number, not a string; numbers stand without quotes "
      "and units");
  expect_fault("[ground.tolerances]\nQ = 0.1\n" + triangle,
               "2:1: error: body 'ground' has no point 'Q'; known are 'O', 'P'");
  expect_fault(
      "[ground.tolerances]\nO = [0.1, 0.1, 0.1]\n" + triangle,
      "2:5: error: the tolerance of 'ground.O' must be 2 numbers in brackets, not 3 entries");
  expect_fault("[ground.tolerances]\nO = [0.1, -0.1]\n" + triangle, "2:5: error: " + from_zero);
  expect_fault(triangle + "tolerance = 0.1\n",
               "19:1: error: unknown key 'tolerance' in a revolute joint; known are 'type', "
               "'name', 'at', 'limits'");
  const Source equations = read_source(std::string(MOIVRE_SOURCE_DIR) +
                                       "/problems/mechanisms/slider-crank-equations.toml");
  expect_fault(
      "tolerance = 0.1\n" + equations.text,
      "1:13: error: tolerances are of the dimensions of bodies; this file has typed equations");
}

}  // namespace
}  // namespace moivre
