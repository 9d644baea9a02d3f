// SPDX-License-Identifier: MIT
// Does any text stay text in XML and HTML?
#include "moivre/report/markup.h"

#include <gtest/gtest.h>

namespace moivre::test {
namespace {

TEST(Markup, MarkupInATextIsEscaped) {
  EXPECT_EQ(escaped("a<b> & \"c\" 'd'"), "a&lt;b&gt; &amp; &quot;c&quot; &#39;d&#39;");
}

TEST(Markup, ALetterBeyondAsciiStays) { EXPECT_EQ(escaped("Grübler φ₁"), "Grübler φ₁"); }

TEST(Markup, BytesThatAreNoTextAreReplaced) {
  const std::string replaced = "\xEF\xBF\xBD";
  EXPECT_EQ(escaped("a\xFF"
                    "b"),
            "a" + replaced + "b");
  EXPECT_EQ(escaped("\xC3"), replaced);
  EXPECT_EQ(escaped("\xED\xA0\x80").substr(0, 3), replaced) << "a surrogate";
  EXPECT_EQ(escaped("\xC0\xAF").substr(0, 3), replaced) << "overlong";
  EXPECT_EQ(escaped(std::string(1, '\0') + "\x1B\x7F"), replaced + replaced + replaced);
}

}  // namespace
}  // namespace moivre::test
