// SPDX-License-Identifier: MIT
// Is it a field, and does its prime depend on the system?
#include "moivre/polynomial/prime_field.h"

#include <gtest/gtest.h>

#include <vector>

#include "moivre/polynomial/read.h"

namespace moivre::test {
namespace {

System system_of(const std::string& text) { return read_system({"test", text}); }

/// The field that needs no system, and some that systems have drawn.
std::vector<PrimeField> fields() {
  std::vector<PrimeField> fields{PrimeField()};
  const System f = system_of("2\nx^2 - 3*y;\n(1/7)*x + 1e-40*y - 2*i;\n");
  for (std::uint64_t seed = 1; seed <= 20; ++seed) fields.emplace_back(f, seed);
  return fields;
}

TEST(PrimeField, ANumberTimesItsInverseIsOne) {
  for (const PrimeField& field : fields()) {
    const Residue p = field.prime();
    for (const Residue a : {Residue{1}, Residue{2}, p - 1, p / 2, Residue{1} << 60}) {
      EXPECT_EQ(field.times(a, field.inverse(a)), 1U);
      EXPECT_EQ(field.plus(a, field.minus(a)), 0U);
    }
    EXPECT_EQ(field.times(p - 1, p - 1), 1U);
  }
}

TEST(PrimeField, ManyProductsAreReducedAtOnce) {
  for (const PrimeField& field : fields()) {
    const Residue largest = field.prime() - 1;
    WideSum sum = largest;
    for (int k = 0; k < PrimeField::kMostProducts; ++k) sum += WideSum{largest} * largest;
    EXPECT_EQ(field.reduced(sum), static_cast<Residue>(sum % field.prime()));
  }
}

TEST(PrimeField, GaussianNumbersHaveImages) {
  const Coefficient i{0, 1};
  for (const PrimeField& field : fields()) {
    EXPECT_EQ(field.times(field.residue(i), field.residue(i)), field.prime() - 1);
    EXPECT_EQ(field.times(field.residue(Coefficient{Rational(1) / Rational(7), 0}), 7), 1U);
  }
}

TEST(PrimeField, EachSystemAndEachSeedHasItsOwnPrime) {
  const Residue prime = PrimeField(system_of("1\nx^2 - 2;\n")).prime();
  EXPECT_EQ(PrimeField(system_of("1\nx^2 - 2;\n")).prime(), prime);
  EXPECT_NE(PrimeField(system_of("1\nx^2 - 2;\n"), 2).prime(), prime);
  EXPECT_NE(PrimeField(system_of("1\nx^2 - 3;\n")).prime(), prime);
  EXPECT_NE(PrimeField(system_of("1\nx^2 + 2;\n")).prime(), prime);
}

}  // namespace
}  // namespace moivre::test
