// SPDX-License-Identifier: MIT
// Does a file that would cost too much end with a fault, and does one of ten megabytes not?
#include <gtest/gtest.h>

#include "read_support.h"

namespace moivre {
namespace {

TEST(ReaderLimits, StopsAnExpansionWhoseTermsFallTogetherByItsWork) {
  std::string text = "1\n(x+1)";
  for (int k = 2; k < 6000; ++k) text += "*(x+" + std::to_string(k) + ")";
  const std::vector<Diagnostic> faults = faults_of(text + ";\n");
  ASSERT_EQ(faults.size(), 1U);
  EXPECT_EQ(
      faults[0].message,
      "the expansion takes more than 50000000 products of terms (with all before it in this file)");
}

TEST(ReaderLimits, BoundWhatCopiesOfASubfunctionCost) {
  std::string text = "variable_group x;\nfunction f;\ns = (1 + x)^500;\nf = s";
  for (int k = 0; k < 20'000; ++k) text += " + s";
  const std::vector<Diagnostic> faults = faults_of(text + ";\n");
  ASSERT_EQ(faults.size(), 1U);
  EXPECT_EQ(
      faults[0].message,
      "the expansion takes more than 50000000 products of terms (with all before it in this file)");
}

TEST(ReaderLimits, NameASumOfTooManyTermsOnce) {
  std::string text = "1\n";
  for (int k = 1'000'100; k > 0; --k) text.append("+x^").append(std::to_string(k));
  const std::vector<Diagnostic> faults = faults_of(text + ";\n");
  ASSERT_EQ(faults.size(), 1U);
  EXPECT_EQ(faults[0].message, "the expansion has more than 1000000 terms");
}

TEST(ReaderLimits, LetALineOfTenMegabytesPass) {
  std::string text = "1 3\n";
  std::size_t count = 0;
  for (; text.size() < 10'000'000; ++count) text += "+1.25*x^2*y^3*z";
  const System f = system_of(text + ";\n");
  ASSERT_EQ(f.polynomials[0].terms.size(), 1U);
  EXPECT_EQ(f.polynomials[0].terms[0].coefficient.re, Rational(5, 4) * count);
}

}  // namespace
}  // namespace moivre
