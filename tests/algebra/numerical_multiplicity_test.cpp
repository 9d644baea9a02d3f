// SPDX-License-Identifier: MIT
// Does the local ring of a root that is no fraction tell its multiplicity, and a curve that passes
// through it?
#include "moivre/algebra/numerical_multiplicity.h"

#include <gtest/gtest.h>

#include <cmath>

#include "moivre/polynomial/read.h"

namespace moivre {
namespace {

const double kRootOf2 = std::sqrt(2.0);

RingBound ring(const std::string& text, const Point& x, double error) {
  return local_ring_near(read_system({"test", text}), x, error).value_or(RingBound{});
}

TEST(NumericalMultiplicity, IsCountedAtIrrationalRoots) {
  for (const double error : {1e-15, 1e-12, 1e-9}) {
    SCOPED_TRACE(error);
    const RingBound simple = ring("1\n x^2 - 2;\n", {kRootOf2 + error / 2}, error);
    EXPECT_TRUE(simple.is_isolated);
    EXPECT_EQ(simple.dimension, 1U);
    const RingBound twice = ring("1\n (x^2 - 2)^2;\n", {kRootOf2 + error / 2}, error);
    EXPECT_TRUE(twice.is_isolated);
    EXPECT_EQ(twice.dimension, 2U);
    const RingBound twelve = ring("3\n (x^2 - 2)^2;\n (y - x)^3;\n z^2 - (y - x)*z;\n",
                                  {kRootOf2, kRootOf2 - error / 2, 0}, error);
    EXPECT_TRUE(twelve.is_isolated);
    EXPECT_EQ(twelve.dimension, 12U);
  }
}

TEST(NumericalMultiplicity, GrowsBeyondEveryBoundOnACurve) {
  const RingBound lines = ring("3\n (x^2 - 2)*y;\n (x^2 - 2)*z;\n y*z;\n", {kRootOf2, 0, 0}, 1e-14);
  EXPECT_FALSE(lines.is_isolated);
  EXPECT_GT(lines.dimension, 8U);
}

TEST(NumericalMultiplicity, CountsAllRootsThatTheErrorDoesNotTellApart) {
  const std::string pair = "1\n x^2 - 1e-12;\n";
  EXPECT_EQ(ring(pair, {0}, 1e-5).dimension, 2U);
  EXPECT_EQ(ring(pair, {1e-6}, 1e-9).dimension, 1U);
}

TEST(NumericalMultiplicity, IsNotToldWhereMonomialsAreTooMany) {
  EXPECT_FALSE(local_ring_near(read_system({"test", "1\n x^101;\n"}), {0}, 1e-14).has_value());
}

}  // namespace
}  // namespace moivre
