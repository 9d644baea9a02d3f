// SPDX-License-Identifier: MIT
// Is it shown that equations have no common root without zero coordinates where they have none, and
// never where they have one?
#include "moivre/algebra/torus_roots.h"

#include <gtest/gtest.h>

#include "moivre/polynomial/read.h"

namespace moivre {
namespace {

bool shows_none(const std::string& text) { return has_no_torus_root(read_system({"test", text})); }

TEST(TorusRoots, NoneWhereMoreGeneralEquationsThanUnknownsStand) {
  EXPECT_TRUE(shows_none("2 1\nx^2 - 3*x + 1;\nx^3 - 2;\n"));
  EXPECT_TRUE(shows_none("3 2\nx*y - 2*x + 1;\nx^2 - 3*y^2 + 5;\n7*x^2*y - x - 11;\n"));
  EXPECT_TRUE(shows_none("4 3\nx*y - z;\ny*z - 2*x + 1;\nx*z - 3*y;\nx + y + z - 7;\n"));
}

TEST(TorusRoots, NoneWhereAnEquationHasOneTerm) {
  EXPECT_TRUE(shows_none("2\nx^2*y;\nx + y - 1;\n"));
}

// Of the first two the common root is (0, 1): its coordinate x is 0.
TEST(TorusRoots, ARootWithAZeroCoordinateIsNone) {
  EXPECT_TRUE(shows_none("3 2\nx + y - 1;\nx^2 + y^2 - 1;\nx - 3*y + 3;\n"));
  EXPECT_TRUE(shows_none("3 2\nx^2 + x*y;\nx*y - 2*y^2 + x;\nx + 5*y;\n"));
}

TEST(TorusRoots, NothingIsShownWhereThereIsOne) {
  EXPECT_FALSE(shows_none("2 1\nx^2 - 3*x + 2;\nx^3 - 8;\n"));
  EXPECT_FALSE(shows_none("3 2\nx + y - 3;\nx^2 + y^2 - 5;\nx*y^2 - 4;\n"));
  // Both irrational: x = sqrt(2), y = 1 + sqrt(2).
  EXPECT_FALSE(shows_none("3 2\nx^2 - 2;\ny - x - 1;\ny^2 - 2*y - 1;\n"));
}

TEST(TorusRoots, NothingIsShownOfAsManyEquationsAsUnknowns) {
  EXPECT_FALSE(shows_none("2\nx + y;\nx + y - 1;\n"));
}

TEST(TorusRoots, NothingIsShownBeyondAFewHundredMonomials) {
  EXPECT_FALSE(shows_none("3 2\nx^40 + y - 1;\ny^40 - x - 3;\nx^20*y^20 - 7*x + 1;\n"));
}

}  // namespace
}  // namespace moivre
