// SPDX-License-Identifier: MIT
// Are supports those of the polynomials, term by term, and is 0 added where it is missing and only
// there?
#include "moivre/start/support.h"

#include <gtest/gtest.h>

#include <stdexcept>

#include "moivre/polynomial/read.h"

namespace moivre {
namespace {

TEST(Support, HasTheExponentsOfTheTermsInTheirOrder) {
  const System f = read_system(Source{"two", "2\nx*y^3 + 2*y - 5; x^2 - x;"});
  const std::vector<Support> supports = supports_of(f);
  ASSERT_EQ(supports.size(), 2u);
  EXPECT_EQ(supports[0].terms, (std::vector<Exponents>{{1, 3}, {0, 1}, {0, 0}}));
  EXPECT_EQ(supports[1].terms, (std::vector<Exponents>{{2, 0}, {1, 0}}));
  for (std::size_t i = 0; i < 2; ++i) {
    EXPECT_EQ(supports[i].terms.size(), f.polynomials[i].terms.size());
  }
}

TEST(Support, TheZeroPolynomialHasNoTerms) {
  const System f{{"x"}, {Polynomial{}}};
  EXPECT_TRUE(supports_of(f).front().terms.empty());
}

TEST(WithOrigin, AddsZeroOnlyWhereItIsMissing) {
  const SupportsWithOrigin s =
      with_origin({Support{{{1, 0}, {0, 0}, {0, 2}}}, Support{{{1, 1}, {0, 3}}}, Support{}}, 2);
  EXPECT_EQ(s.added, (std::vector<bool>{false, true, true}));
  EXPECT_EQ(s.origin, (std::vector<std::size_t>{1, 2, 0}));
  EXPECT_EQ(s.supports[0].terms.size(), 3u);
  EXPECT_EQ(s.supports[1].terms, (std::vector<Exponents>{{1, 1}, {0, 3}, {0, 0}}));
  EXPECT_EQ(s.supports[2].terms, (std::vector<Exponents>{{0, 0}}));
}

TEST(WithOrigin, RefusesATermOfAnotherLength) {
  EXPECT_THROW(with_origin({Support{{{1, 0}, {0}}}}, 2), std::invalid_argument);
}

}  // namespace
}  // namespace moivre
