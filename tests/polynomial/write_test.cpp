// SPDX-License-Identifier: MIT
// Does a system come back from both text formats exactly, whatever its coefficients and its order
// of variables?
#include <gtest/gtest.h>

#include <stdexcept>

#include "moivre/numeric/integer.h"
#include "moivre/polynomial/read.h"
#include "read_support.h"

namespace moivre {
namespace {

void expect_round_trip(const System& f) {
  for (const PolynomialFormat format : {PolynomialFormat::phcpack, PolynomialFormat::bertini}) {
    const std::string text = to_text(f, format);
    EXPECT_EQ(detect_format(text), format) << text;
    EXPECT_EQ(system_of(text), f) << text;
  }
}

Polynomial number(const Rational& r) { return constant({r, 0}); }
const Polynomial x = unknown(0);
const Polynomial y = unknown(1);

TEST(Writer, WritesWhatPeopleWouldWrite) {
  const System f = system_of("2\nx^2 + 3.1*y^2 - 5;\n-x*y + (1/3)*x - (2-0.5*i)*y;\n");
  EXPECT_EQ(to_text(f, PolynomialFormat::phcpack),
            "2\nx^2 + 3.1*y^2 - 5;\n-x*y + (1/3)*x + (-2+0.5*i)*y;\n");
  EXPECT_EQ(to_text(f, PolynomialFormat::bertini),
            "CONFIG\nEND;\nINPUT\nvariable_group x, y;\nfunction f1, f2;\n"
            "f1 = x^2 + 3.1*y^2 - 5;\nf2 = -x*y + (1/3)*x + (-2+0.5*I)*y;\nEND;\n");
  expect_round_trip(f);
}

TEST(Writer, KeepsTheOrderOfTheVariables) {
  const System f = system_of("2\ny - x^2;\nx*y;\n");
  EXPECT_EQ(f.variables.front(), "y");
  EXPECT_EQ(to_text(f, PolynomialFormat::phcpack), "2\ny+x-y-x - x^2 + y;\ny*x;\n");
  expect_round_trip(f);
}

TEST(Writer, KeepsUnusedVariablesAndZeroPolynomials) {
  expect_round_trip({{"a", "b", "c"}, {Polynomial{}, x * x + number(-1)}});
  expect_round_trip({{"a"}, {Polynomial{}}});
  expect_round_trip({{"a", "b"}, {number(3)}});
}

TEST(Writer, KeepsCoefficientsOfAnySizeExactly) {
  const Integer huge = pow(Integer(10), 3000U) + 7;
  const Integer large = pow(Integer(7), 400U);
  const System f{
      {"x", "y"},
      {Coefficient{ratio(huge, huge + 1), Rational(-1, 3)} * x +
           Coefficient{0, ratio(large, large + 2)} * y + number(ratio(1, huge) * ratio(huge) * 2),
       number(ratio(1, pow(Integer(2), 1070U))) * x + number(ratio(pow(Integer(10), 307U))) * y +
           number(ratio(pow(Integer(10), 307U) + 1, 3))}};
  expect_round_trip(f);
}

TEST(Writer, BreaksLongLinesAtASign) {
  std::string text = "1\n1";
  for (int k = 1; k < 100; ++k) text += "+x^" + std::to_string(k);
  const std::string written = to_text(system_of(text + ";"), PolynomialFormat::phcpack);
  std::size_t begin = 0;
  for (std::size_t end = 0; (end = written.find('\n', begin)) != std::string::npos;
       begin = end + 1) {
    EXPECT_LT(end - begin, 120U);
  }
  expect_round_trip(system_of(text + ";"));
}

TEST(Writer, GivesFunctionsNamesThatNoVariableHas) {
  expect_round_trip({{"f1", "f_2"}, {x + y, x * y}});
}

TEST(Writer, KeepsGroupsInBertinisText) {
  System f{{"x", "y", "z"}, {x * x + number(3) * x * y, unknown(2) * x + y}};
  f.groups = {{{0, 1}, true}, {{2}, false}};
  const std::string text = to_text(f, PolynomialFormat::bertini);
  EXPECT_EQ(text,
            "CONFIG\nEND;\nINPUT\n"
            "hom_variable_group x, y;\nvariable_group z;\n"
            "function f1, f2;\nf1 = x^2 + 3*x*y;\nf2 = x*z + y;\nEND;\n");
  EXPECT_EQ(system_of(text).groups, f.groups);
  expect_round_trip(f);
  f.groups = {{{2}, false}, {{0, 1}, true}};
  EXPECT_THROW(to_text(f, PolynomialFormat::bertini), std::invalid_argument);
  f.groups = {{{0, 1}, true}};
  EXPECT_THROW(to_text(f, PolynomialFormat::bertini), std::invalid_argument);
}

TEST(Writer, RefusesNamesThatTheFormatCannotHold) {
  const System f{{"i"}, {x}};
  EXPECT_THROW(to_text(f, PolynomialFormat::phcpack), std::invalid_argument);
  EXPECT_EQ(system_of(to_text(f, PolynomialFormat::bertini)), f);
  EXPECT_THROW(to_text({{"a b"}, {x}}, PolynomialFormat::phcpack), std::invalid_argument);
  EXPECT_THROW(to_text({{"function"}, {x}}, PolynomialFormat::bertini), std::invalid_argument);
  EXPECT_THROW(to_text({{"a"}, {}}, PolynomialFormat::phcpack), std::invalid_argument);
}

}  // namespace
}  // namespace moivre
