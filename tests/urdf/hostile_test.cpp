// SPDX-License-Identifier: MIT
// Does any file do harm? Entities, depth, size, and robots with bytes changed at random: a robot or
// faults in the text, soon.
#include <gtest/gtest.h>

#include <ctime>

#include "../fuzz/urdf_laws.h"
#include "moivre/numeric/random.h"

namespace moivre {
namespace {

/// Of this process, so that a busy machine does not matter.
double cpu_seconds() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

/// CPU seconds: far more than it takes, far less than harm.
constexpr double kSoon = 5;

std::string repeated(const std::string& text, std::size_t count) {
  std::string all;
  all.reserve(text.size() * count);
  for (std::size_t k = 0; k < count; ++k) all += text;
  return all;
}

/// The fault that a hostile text is refused with.
std::string refusal_of(const std::string& text) {
  try {
    read_urdf({"hostile.urdf", text});
  } catch (const ParseError& error) {
    return error.diagnostics().front().message;
  }
  return "";
}

constexpr const char* kDoctypeRefused =
    "a DOCTYPE is refused: its entities are not expanded, and a URDF needs none; remove it";

TEST(HostileUrdfTest, EntitiesAreNotExpanded) {
  std::string text = "<!DOCTYPE robot [<!ENTITY a0 \"ha\">";
  for (int k = 1; k < 30; ++k) {
    const std::string before = "&a" + std::to_string(k - 1) + ";";
    text += "<!ENTITY a" + std::to_string(k) + " \"" + repeated(before, 10) + "\">";
  }
  text += "]><robot name=\"&a29;\"><link name=\"&a29;\"/></robot>";
  const double begin = cpu_seconds();
  EXPECT_EQ(refusal_of(text), kDoctypeRefused);
  EXPECT_LT(cpu_seconds() - begin, kSoon);
}

TEST(HostileUrdfTest, NothingOutsideTheFileIsOpened) {
  const std::string text =
      "<!DOCTYPE robot [<!ENTITY x SYSTEM \"file:///etc/passwd\">]>"
      "<robot name=\"r\"><link name=\"&x;\"/></robot>";
  EXPECT_EQ(refusal_of(text), kDoctypeRefused);
}

TEST(HostileUrdfTest, AMillionElementsInsideOneAnotherAreHarmless) {
  const std::size_t depth = 1'000'000;
  const double begin = cpu_seconds();
  EXPECT_NE(refusal_of("<robot name='r'>" + repeated("<a>", depth)), "");
  EXPECT_NE(refusal_of(repeated("<robot>", depth) + repeated("</robot>", depth)), "");
  EXPECT_LT(cpu_seconds() - begin, kSoon);
}

TEST(HostileUrdfTest, HugeFilesAreRefused) {
  EXPECT_EQ(refusal_of(repeated(" ", 20'000'000)),
            "the file is longer than 16 MB, more than any robot's tree");
  const std::string links = "<robot name='r'>" + repeated("<link name='a'/>", 30'000) + "</robot>";
  const double begin = cpu_seconds();
  EXPECT_EQ(refusal_of(links), "there are more than 20,000 links and joints");
  EXPECT_LT(cpu_seconds() - begin, kSoon);
}

TEST(HostileUrdfTest, ALongChainIsReadSoon) {
  std::string text = "<robot name='r'><link name='l0'/>";
  for (int k = 1; k < 9'000; ++k) {
    const std::string n = std::to_string(k);
    text += "<link name='l" + n + "'/><joint name='j" + n + "' type='fixed'><parent link='l" +
            std::to_string(k - 1) + "'/><child link='l" + n + "'/></joint>";
  }
  const double begin = cpu_seconds();
  EXPECT_EQ(read_urdf({"long.urdf", text + "</robot>"}).joints.size(), 8'999U);
  EXPECT_LT(cpu_seconds() - begin, kSoon);
}

TEST(HostileUrdfTest, AZeroByteIsRefused) {
  EXPECT_EQ(refusal_of(std::string("<robot name='r'>\0</robot>", 25)),
            "a zero byte stands here; a URDF is UTF-8 text");
}

TEST(HostileUrdfTest, BytesThatAreNoUtf8AreRefusedAtTheirPlace) {
  const std::string text = "<robot name='r'>\n<link name='K\xF6rper'/></robot>";  // Latin-1
  EXPECT_EQ(refusal_of(text), "a byte that is no UTF-8 stands here; save the file as UTF-8");
  EXPECT_EQ(refusal_of("<robot name='K\xC3\xB6rper'><link name='a'/></robot>"), "");
  try {
    read_urdf({"latin.urdf", text});
  } catch (const ParseError& error) {
    EXPECT_EQ(error.diagnostics().front().at.line, 2U);
    EXPECT_EQ(error.diagnostics().front().at.column, 14U);
  }
}

/// The text with a few bytes changed or left out.
std::string disturbed(std::string text, std::uint64_t trial) {
  const std::uint64_t changes = 1 + random_bits(1, RandomStream::test, trial) % 4;
  for (std::uint64_t k = 0; k < changes; ++k) {
    const std::uint64_t bits = random_bits(2, RandomStream::test, trial * 4 + k);
    const std::size_t at = (bits >> 16U) % text.size();
    if ((bits & 1U) != 0) {
      text[at] = static_cast<char>(bits >> 8U);
    } else {
      text.erase(at, 1 + (bits >> 8U) % 20);
    }
  }
  return text;
}

TEST(HostileUrdfTest, BytesChangedAtRandomBreakNoLaw) {
  constexpr std::uint64_t kTexts = 4'000;
  const std::string whole =
      read_source(MOIVRE_SOURCE_DIR "/problems/robots/panda.urdf").text.substr(0, 1'500) +
      "</joint></robot>";
  for (std::uint64_t trial = 0; trial < kTexts; ++trial) {
    const std::string text = disturbed(whole, trial);
    const auto broken = broken_urdf_law(text);
    ASSERT_FALSE(broken) << *broken << "\n" << text;
  }
}

TEST(HostileUrdfTest, BytesChangedAtRandomInASideFileBreakNoLaw) {
  constexpr std::uint64_t kTexts = 1'000;
  const std::string robots = MOIVRE_SOURCE_DIR "/problems/robots/";
  const Robot robot = read_urdf(read_source(robots + "delta.urdf"));
  const std::string whole = read_source(robots + "delta.loops.toml").text;
  for (std::uint64_t trial = 0; trial < kTexts; ++trial) {
    const std::string text = disturbed(whole, trial);
    const auto broken = broken_side_file_law(robot, text);
    ASSERT_FALSE(broken) << *broken << "\n" << text;
  }
}

}  // namespace
}  // namespace moivre
