// SPDX-License-Identifier: MIT
// Are the pieces of SVG right? Numbers, outlines, lines of text, scale bars.
#include "svg.h"

#include <gtest/gtest.h>

#include "figures.h"
#include "well_formed.h"

namespace moivre {
namespace {

TEST(Svg, NumbersAreShortAndFinite) {
  EXPECT_EQ(pixel_text(1.0), "1");
  EXPECT_EQ(pixel_text(-0.001), "0");
  EXPECT_EQ(pixel_text(12.345), "12.35");
  EXPECT_EQ(pixel_text(100), "100");
  EXPECT_EQ(pixel_text(std::numeric_limits<double>::quiet_NaN()), "0");
}

TEST(Svg, ALinkIsTwoLinesAndTwoHalfCircles) {
  const Figure figure{0, 2, {capsule(Style::link, 0, 10, 1)}};
  EXPECT_EQ(figure_svg(figure, {}, {}),
            "<g class=\"c2\"><path class=\"link\" "
            "d=\"M0 1L10 1A1 1 0 0 0 10 -1L0 -1A1 1 0 0 0 0 1Z\"/></g>\n");
}

TEST(Svg, LinesAreBrokenBetweenWordsOnly) {
  EXPECT_EQ(wrapped("one two three", 10, 60), (std::vector<std::string>{"one two", "three"}));
  EXPECT_EQ(wrapped("unbreakable", 10, 5), (std::vector<std::string>{"unbreakable"}));
}

TEST(Svg, AScaleBarHasARoundLengthAndNamesItsUnit) {
  EXPECT_EQ(scale_bar(0, 3.1, "mm"),
            "<path class=\"bar\" d=\"M0 -4L0 4M62 -4L62 4M0 0L62 0\"/>"
            "<text x=\"70\" y=\"4\" text-anchor=\"start\" class=\"note\">20 mm</text>\n");
  EXPECT_EQ(scale_bar(0, 250, ""),
            "<path class=\"bar\" d=\"M0 -4L0 4M50 -4L50 4M0 0L50 0\"/>"
            "<text x=\"58\" y=\"4\" text-anchor=\"start\" class=\"note\">"
            "0.2 in the file&#39;s unit of length</text>\n");
}

TEST(Svg, ADocumentIsWellFormed) {
  const std::string document =
      svg_document(100, 50, "<&>", text_svg({1, 2}, "start", "note", "</text><script>"));
  EXPECT_TRUE(test::Markup(document).is_well_formed());
}

}  // namespace
}  // namespace moivre
