// SPDX-License-Identifier: MIT
// Are the planes on which every equation is zero found, all of them and no others?
#include "moivre/polynomial/coordinate_planes.h"

#include <gtest/gtest.h>

#include <string>

#include "moivre/polynomial/read.h"

namespace moivre {
namespace {

std::vector<CoordinatePlane> planes_of(const std::string& text) {
  return coordinate_planes(read_system({"planes.txt", text}));
}

using Planes = std::vector<CoordinatePlane>;

TEST(CoordinatePlanes, AreWhereEveryTermHasAZeroFactor) {
  // x, y, z: on x = 0; and where y and z are both 0.
  EXPECT_EQ(planes_of("x*y + x*z^2; x^2*y - x*z; x*y*z + 3*x*y;"), (Planes{{{0}, 2}, {{1, 2}, 1}}));
}

TEST(CoordinatePlanes, AreNoneBesideAConstantTerm) {
  EXPECT_EQ(planes_of("x*y - 1; x*y + x;"), Planes{});
}

TEST(CoordinatePlanes, OfDimensionZeroAreRoots) {
  EXPECT_EQ(planes_of("x^2 - y; x*y + y^2;"), Planes{});
}

TEST(CoordinatePlanes, AreNotThoseWhereADenominatorIsZero) {
  EXPECT_EQ(planes_of("x*y/x; x*z; x*(y + z);"), (Planes{{{1, 2}, 1}}));
}

TEST(CoordinatePlanes, OfHomogeneousGroupsAreProjective) {
  // Of P^2 with x, y, z: the point x = y = 0 has no dimension, the line x = 0 has one.
  const std::string head = "INPUT\nhom_variable_group x, y, z;\nfunction f, g;\n";
  EXPECT_EQ(planes_of(head + "f = x*y + y^2 + x*z;\ng = x^2 + y*z;\nEND;\n"), Planes{});
  EXPECT_EQ(planes_of(head + "f = x*y;\ng = x*z;\nEND;\n"), (Planes{{{0}, 1}}));
}

TEST(CoordinatePlanes, LeaveOfAPolynomialTheTermsWithoutAZero) {
  const auto [x, y, z] = unknowns<3>();
  EXPECT_EQ(on_plane(x * y + 2 * y + z, {0}), 2 * y + z);
  EXPECT_EQ(on_plane(x * y + x, {0}), Polynomial{});
}

}  // namespace
}  // namespace moivre
