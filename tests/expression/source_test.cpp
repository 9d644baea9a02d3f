// SPDX-License-Identifier: MIT
// Are files read whole or refused with a reason, and does a message show the line with a caret
// under the fault?
#include "moivre/expression/source.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

namespace moivre {
namespace {

std::string reason_not_to_read(const std::string& path) {
  try {
    read_source(path);
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return {};
}

TEST(Source, IsReadWithoutItsByteOrderMark) {
  const std::string path = testing::TempDir() + "moivre_source_test.txt";
  std::ofstream(path, std::ios::binary) << "\xEF\xBB\xBFx - 1;\n";
  EXPECT_EQ(read_source(path).text, "x - 1;\n");
  EXPECT_EQ(read_source(path).name, path);
  std::filesystem::remove(path);
}

TEST(Source, IsRefusedWithTheReason) {
  EXPECT_EQ(reason_not_to_read(testing::TempDir()),
            testing::TempDir() + ": cannot be read: it is a directory");
  EXPECT_EQ(reason_not_to_read("no/such/file"),
            "no/such/file: cannot be opened: No such file or directory");
}

TEST(SourcePosition, MovesOverLinesAndColumns) {
  const SourcePosition begin{.offset = 10, .line = 3, .column = 4};
  EXPECT_EQ(after(begin, "ab"), (SourcePosition{.offset = 12, .line = 3, .column = 6}));
  EXPECT_EQ(after(begin, "a\nbc\n"), (SourcePosition{.offset = 15, .line = 5, .column = 1}));
  EXPECT_EQ(after(begin, "a\nbc"), (SourcePosition{.offset = 14, .line = 4, .column = 3}));
}

TEST(Diagnostic, ShowsTheLineAndACaretBelowTheFault) {
  const Source source{"conics.phc", "2\n\tx^2 ++ y;\r\nlast"};
  EXPECT_EQ(to_text({{.offset = 8, .line = 2, .column = 7}, "stray"}, source),
            "conics.phc:2:7: error: stray\n    \tx^2 ++ y;\n    \t     ^\n");
  EXPECT_EQ(to_text({{.offset = 18, .line = 3, .column = 5}, "ends"}, source),
            "conics.phc:3:5: error: ends\n    last\n        ^\n");
}

TEST(Diagnostic, ShowsAWindowOfALongLineAndNoControlCharacters) {
  const Source source{"f", std::string(500, 'a') + '\x1B' + std::string(500, 'b')};
  const std::string text = to_text({{.offset = 500, .line = 1, .column = 501}, "here"}, source);
  const std::size_t line = text.find("    ...");
  const std::size_t caret = text.find('^');
  ASSERT_NE(line, std::string::npos);
  ASSERT_NE(caret, std::string::npos);
  const std::size_t shown = text.find('?');
  EXPECT_EQ(shown - line, caret - (text.find('\n', line) + 1));
  EXPECT_LT(text.size(), 300U);
}

TEST(Diagnostic, CountsACharacterOfSeveralBytesAsOneColumnOfTheScreen) {
  const Source source{"f", "\xC3\xA9 $"};
  EXPECT_EQ(to_text({{.offset = 3, .line = 1, .column = 4}, "m"}, source),
            "f:1:4: error: m\n    \xC3\xA9 $\n      ^\n");
}

TEST(ParseError, SaysEveryFaultAndBoundsItsText) {
  const Source source{"f", "x"};
  EXPECT_EQ(std::string(ParseError(source, {{{}, "one"}, {{}, "two"}}).what()),
            "f:1:1: error: one\n    x\n    ^\nf:1:1: error: two\n    x\n    ^\n");
  const ParseError many(source, std::vector<Diagnostic>(5000, {{}, "same"}));
  EXPECT_EQ(many.diagnostics().size(), 5000U);
  std::string first_thousand;
  for (int k = 0; k < 1000; ++k) first_thousand += "f:1:1: error: same\n    x\n    ^\n";
  EXPECT_TRUE(many.what() == first_thousand + "f: 4000 more faults\n");
}

TEST(ReadSource, IsWholeWhateverItsLength) {
  const std::string path = testing::TempDir() + "moivre-long.phc";
  for (const std::size_t length : {0U, 1U, 4095U, 4096U, 4097U, 69631U, 69632U, 69633U, 300000U}) {
    std::string text(length, ' ');
    for (std::size_t k = 0; k < length; ++k) text[k] = static_cast<char>('a' + k % 23);
    std::ofstream(path, std::ios::binary) << text;
    EXPECT_EQ(read_source(path).text, text) << length;
  }
}

}  // namespace
}  // namespace moivre
