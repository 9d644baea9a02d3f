// SPDX-License-Identifier: MIT
// Is every fault of every faulty URDF named, at its line and with its advice, and nothing else?
// Files: tests/urdf/faulty.
//
// A file says what it expects in comments `<!-- expect LINE: words of the message -->`.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <sstream>

#include "moivre/urdf/read.h"

namespace moivre {
namespace {

constexpr std::size_t kFewestFaultyFiles = 24;

struct Expected {
  std::size_t line = 0;
  std::string words;
};

std::vector<Expected> expectations(const std::string& text) {
  const std::string mark = "<!-- expect ";
  std::vector<Expected> expected;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    if (!line.starts_with(mark)) continue;
    const std::size_t colon = line.find(": ");
    const std::size_t end = line.rfind(" -->");
    expected.push_back({std::stoul(line.substr(mark.size(), colon - mark.size())),
                        line.substr(colon + 2, end - colon - 2)});
  }
  return expected;
}

void expect_faults(const std::filesystem::path& file) {
  const Source source = read_source(file.string());
  const std::vector<Expected> expected = expectations(source.text);
  ASSERT_FALSE(expected.empty());
  try {
    read_urdf(source);
    FAIL() << "the file was read without a fault";
  } catch (const ParseError& error) {
    const auto& found = error.diagnostics();
    EXPECT_EQ(found.size(), expected.size()) << error.what();
    for (const Expected& fault : expected) {
      EXPECT_TRUE(std::any_of(found.begin(), found.end(),
                              [&](const Diagnostic& diagnostic) {
                                return diagnostic.at.line == fault.line &&
                                       diagnostic.message.find(fault.words) != std::string::npos;
                              }))
          << fault.line << ": " << fault.words << "\n  in\n"
          << error.what();
    }
    EXPECT_TRUE(std::is_sorted(found.begin(), found.end(), [](const auto& a, const auto& b) {
      return a.at.offset < b.at.offset;
    }));
  }
}

TEST(FaultyUrdfTest, EveryFaultIsNamedAtItsLine) {
  std::size_t files = 0;
  for (const auto& entry : std::filesystem::directory_iterator(
           std::filesystem::path(MOIVRE_SOURCE_DIR) / "tests/urdf/faulty")) {
    SCOPED_TRACE(entry.path().filename().string());
    expect_faults(entry.path());
    ++files;
  }
  EXPECT_GE(files, kFewestFaultyFiles);
}

TEST(FaultyUrdfTest, TheCaretStandsUnderTheNumberThatIsNone) {
  const Source source{"arm.urdf",
                      "<robot name='r'><link name='a'/><link name='b'/>\n"
                      "<joint name='j' type='continuous'><parent link='a'/><child link='b'/>\n"
                      "  <origin xyz='0 zero 1'/></joint></robot>"};
  try {
    read_urdf(source);
    FAIL();
  } catch (const ParseError& error) {
    EXPECT_STREQ(error.what(),
                 "arm.urdf:3:18: error: 'zero' is no number\n"
                 "      <origin xyz='0 zero 1'/></joint></robot>\n"
                 "                     ^\n");
  }
}

}  // namespace
}  // namespace moivre
