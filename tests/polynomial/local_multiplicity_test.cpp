// SPDX-License-Identifier: MIT
// Is the multiplicity of a root that is known exactly counted exactly, and is nothing said where nothing is known?
#include "moivre/polynomial/local_multiplicity.h"

#include <gtest/gtest.h>

#include "moivre/numeric/complex.h"
#include "moivre/polynomial/read.h"

namespace moivre {
namespace {

std::optional<std::uint64_t> multiplicity(const std::string& text, const Point& x) {
  std::vector<Coefficient> exact;
  for (const Complex& xi : x) exact.push_back({Rational(xi.real()), Rational(xi.imag())});
  return local_multiplicity(read_system({"test", text}), exact);
}

TEST(LocalMultiplicity, IsTheProductOfTheDegreesForPowers) {
  EXPECT_EQ(multiplicity("2\n x^2;\n y^2;\n", {0, 0}), 4U);
  EXPECT_EQ(multiplicity("2\n x^2;\n y^3;\n", {0, 0}), 6U);
  EXPECT_EQ(multiplicity("3\n x^2;\n y^2;\n z^2;\n", {0, 0, 0}), 8U);
  EXPECT_EQ(multiplicity("2\n x^2 - y^3;\n x^3;\n", {0, 0}), 9U);
}

// [DaytonZeng05] and the literature it collects.
TEST(LocalMultiplicity, OfPublishedSystems) {
  EXPECT_EQ(multiplicity("2\n 29/16*x^3 - 2*x*y;\n y - x^2;\n", {0, 0}), 3U);
  EXPECT_EQ(multiplicity("2\n x^2 + y - 3;\n x + 1/8*y^2 - 3/2;\n", {1, 2}), 3U);
  EXPECT_EQ(multiplicity("3\n x^2*y - x*y^2;\n x - y^2;\n z;\n", {0, 0, 0}), 4U);
}

TEST(LocalMultiplicity, OfASimpleRootIsOne) {
  EXPECT_EQ(multiplicity("2\n x^2 + y^2 - 2;\n x - y;\n", {1, 1}), 1U);
  EXPECT_EQ(multiplicity("1\n x^2 + 1;\n", {Complex(0, 1)}), 1U);
}

TEST(LocalMultiplicity, IsThatOfTheRootAlone) {
  EXPECT_EQ(multiplicity("1\n (x - 3)^4*(x + 1)*x^2;\n", {3}), 4U);
  EXPECT_EQ(multiplicity("1\n (x - 3)^4*(x + 1)*x^2;\n", {0}), 2U);
  EXPECT_EQ(multiplicity("1\n (x^2 + 1)^3;\n", {Complex(0, -1)}), 3U);
  // A simple root 2e-12 away does not count.
  EXPECT_EQ(multiplicity("2\n y^2 - 5095*x^2*y;\n x + 9823*y;\n", {0, 0}), 2U);
}

TEST(LocalMultiplicity, SaysNothingOfAPointThatIsNoRoot) {
  EXPECT_FALSE(multiplicity("2\n x^2;\n y^2;\n", {1e-30, 0}));
}

TEST(LocalMultiplicity, SaysNothingOfARootThatIsNotIsolated) {
  EXPECT_FALSE(multiplicity("2\n x*y;\n x^2;\n", {0, 0}));
  EXPECT_FALSE(multiplicity("2\n x^2 + y^2 - 5;\n (x^2 + y^2 - 5)*x;\n", {1, 2}));
}

TEST(LocalMultiplicity, GivesUpWhereThePowersAreTooHigh) {
  EXPECT_FALSE(multiplicity("1\n x^4294967295;\n", {0}));
  EXPECT_FALSE(multiplicity("2\n x^40;\n y^40;\n", {0, 0}));
}

}  // namespace
}  // namespace moivre
