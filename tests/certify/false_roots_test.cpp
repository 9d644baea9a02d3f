// SPDX-License-Identifier: MIT
// Are a few thousand fabricated candidates refused wherever no root lies?
#include "false_roots.h"

namespace moivre::test {
namespace {

TEST(FalseRoots, AreRefusedAndTrueOnesTold) {
  const FalseRootCounts counts = expect_no_untruth(1, 40);
  EXPECT_EQ(counts.candidates, 40U * 60U);
  // The test would prove little if nearly all were of one kind.
  EXPECT_GT(counts.certified, 500U);
  EXPECT_GT(counts.without_root, 500U);
  EXPECT_GT(counts.elsewhere, 10U);
}

TEST(FalseRoots, OfAChangedCoefficientAreNotRootsOfTheSystem) {
  // The roots of x^2 - 2 and of x^2 - 2 - 2^-60: doubles cannot tell their coefficients apart.
  const System f =
      system_of("1\nx^2 - 2.00000000000000000086736173798840354720596224069595336914;\n");
  CertifyOptions options;
  options.most_bits = 256;
  Certifier certifier(make_certify_program(f), options);
  Certificate c = certifier.certify(Point{1.4142135623730951});
  ASSERT_TRUE(certifier.sharpen(c, 128));
  Certifier other(make_certify_program(system_of("1\nx^2 - 2;\n")), options);
  Certificate d = other.certify(Point{1.4142135623730951});
  ASSERT_TRUE(other.sharpen(d, 128));
  // sqrt(2) + 2^-60 / (2 sqrt 2): 3.07e-19 apart, and both errors are far below.
  EXPECT_LT(c.error(0) + d.error(0), 1e-30);
  EXPECT_NEAR(c.finer.front()[0].real() - d.finer.front()[0].real(), 3.0666e-19, 1e-22);
}

}  // namespace
}  // namespace moivre::test
