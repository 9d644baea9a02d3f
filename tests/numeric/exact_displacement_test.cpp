// SPDX-License-Identifier: MIT
// Do the forms of some displacements vanish on them and on nothing else, and are the coordinates
// those of what was combined?
#include "moivre/numeric/exact_displacement.h"

#include <gtest/gtest.h>

#include "moivre/numeric/random.h"

namespace moivre {
namespace {

ExactDisplacement random_displacement(std::uint64_t number, int size) {
  std::uint64_t index = 8 * number;
  return mapped(ExactDisplacement(), [&](const Integer&) {
    const double part = 2 * random_unit(5, RandomStream::test, index++) - 1;
    return Integer(static_cast<std::int64_t>(part * size));
  });
}

std::vector<ExactDisplacement> random_displacements(std::size_t count) {
  std::vector<ExactDisplacement> all;
  for (std::size_t k = 0; k < count; ++k) all.push_back(random_displacement(k, 1 << 20));
  return all;
}

TEST(ExactDisplacement, FormsVanishOnTheVectorsAlone) {
  const auto vectors = random_displacements(4);
  const auto forms = vanishing_forms(vectors);
  ASSERT_EQ(forms.size(), 4U);
  const ExactDisplacement other = random_displacement(9, 1 << 20);
  bool vanishes_on_other = true;
  for (const ExactDisplacement& form : forms) {
    for (const ExactDisplacement& v : vectors) EXPECT_EQ(value(form, v), 0);
    vanishes_on_other = vanishes_on_other && value(form, other) == 0;
  }
  EXPECT_FALSE(vanishes_on_other);
  EXPECT_EQ(vanishing_forms(forms).size(), 4U);
}

TEST(ExactDisplacement, DependentVectorsLeaveMoreForms) {
  auto vectors = random_displacements(3);
  vectors.push_back(Integer(7) * vectors[0] + Integer(-3) * vectors[2]);
  EXPECT_EQ(vanishing_forms(vectors).size(), 5U);
  EXPECT_EQ(vanishing_forms({ExactDisplacement()}).size(), 8U);
}

TEST(ExactDisplacement, CoordinatesAreThoseOfTheCombination) {
  const auto vectors = random_displacements(4);
  for (const double length : {1.0, 1e-3, 1e6}) {
    const auto [forms, factor] = coordinate_forms(vectors, length);
    ASSERT_EQ(forms.size(), 4U);
    const std::vector<Integer> a{3, -5, 0, 11};
    ExactDisplacement g;
    for (std::size_t k = 0; k < a.size(); ++k) g = g + a[k] * vectors[k];
    for (std::size_t k = 0; k < a.size(); ++k) EXPECT_EQ(value(forms[k], g), a[k] * factor);
  }
}

TEST(ExactDisplacement, AFactorIsTakenOutAndFractionsToo) {
  const DualQuaternion<Rational> g{{Rational(1, 2), Rational(1, 3), 0, 2},
                                   {Rational(5, 6), 0, 0, 1}};
  const ExactDisplacement whole_g = whole(g, common_denominator({g}));
  EXPECT_EQ(whole_g.q, (Quaternion<Integer>{3, 2, 0, 12}));
  EXPECT_EQ(whole_g.g, (Quaternion<Integer>{5, 0, 0, 6}));
  const ExactDisplacement once = reduced(Integer(-4) * whole_g);
  EXPECT_EQ(once.q, (Quaternion<Integer>{-3, -2, 0, -12}));
  EXPECT_EQ(rounded(once).q[3], -1.0);
}

/// A turn about z by a quarter, then a shift by 2 along x: the dual part is half the shift times
/// the turn.
TEST(DualQuaternion, ProductsAreInTheOrderOfTransforms) {
  const DualQuaternion<double> turn{{1, 0, 0, 1}, {}};
  const DualQuaternion<double> shift{{1, 0, 0, 0}, {0, 1, 0, 0}};
  const Quaternion<double> after = shift_of(shift * turn);
  EXPECT_DOUBLE_EQ(after[1], 2);
  const Quaternion<double> before = shift_of(turn * shift);
  EXPECT_DOUBLE_EQ(before[1], 0);
  EXPECT_DOUBLE_EQ(before[2], 2);
  const DualQuaternion<double> back = (shift * turn) * conjugate(shift * turn);
  EXPECT_EQ(back.q, (Quaternion<double>{2, 0, 0, 0}));
  EXPECT_EQ(back.g, (Quaternion<double>{0, 0, 0, 0}));
}

}  // namespace
}  // namespace moivre
