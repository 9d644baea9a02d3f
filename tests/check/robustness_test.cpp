// SPDX-License-Identifier: MIT
// Does the judge keep its calm whatever it is given? Broken bytes are refused or judged, extreme
// numbers are judged.
#include <gtest/gtest.h>

#include <stdexcept>

#include "moivre/numeric/random.h"
#include "results.h"

namespace moivre::test {
namespace {

/// A few bytes of the text changed, left out or doubled.
std::string damaged(std::string text, std::uint64_t seed) {
  auto draw = [seed, k = std::uint64_t{0}](std::uint64_t below) mutable {
    return random_bits(seed, RandomStream::test, k++) % below;
  };
  constexpr std::string_view bytes = "0123456789-+.eE[]{}:,\" nulltruefalse\n\xff\x01";
  for (std::uint64_t change = 1 + draw(4); change > 0 && !text.empty(); --change) {
    const std::size_t place = draw(text.size());
    const std::size_t length = 1 + draw(8);
    switch (draw(4)) {
      case 0:
        text.erase(place, length);
        break;
      case 1:
        text.insert(place, text.substr(draw(text.size()), length));
        break;
      case 2:
        text.resize(place);
        break;
      default:
        text[place] = bytes[draw(bytes.size())];
    }
  }
  return text;
}

/// Damaged copies are judged, or refused as unusable; nothing else is thrown.
void expect_calm(const std::string& system, const std::string& text, std::uint64_t copies) {
  std::uint64_t refused = 0;
  for (std::uint64_t seed = 1; seed <= copies; ++seed) {
    try {
      judged(system, damaged(text, seed));
    } catch (const std::invalid_argument&) {
      ++refused;
    }
  }
  EXPECT_GT(refused, 0U);
  EXPECT_LT(refused, copies);
}

TEST(CheckRobustness, DamagedResultsAreJudgedOrRefused) {
  expect_calm("plane", result_text("plane.json"), 2000);
  expect_calm("doubles", result_text("doubles.json"), 100);
}

TEST(CheckRobustness, DamagedListsAreJudgedOrRefused) {
  const std::string text = result_text("eco-6.out");
  expect_calm("eco-6", text.substr(text.rfind("THE SOLUTIONS")), 300);
}

TEST(CheckRobustness, ExtremeNumbersAreJudged) {
  const auto with = [](const char* key, const Json& value) {
    Json result = honest("plane");
    result["solutions"][0][key] = value;
    return judged("plane", result);
  };
  const std::uint64_t most = UINT64_MAX;
  EXPECT_EQ(with("x", Json::parse("[[1e308,1e308],[-1e308,0],[5e-324,0]]")).roots.certified, 3U);
  EXPECT_FALSE(with("x", Json::parse("[[1e100,0],[-1e100,0],[5e-324,0]]")).holds());
  EXPECT_FALSE(with("multiplicity", most).holds());
  EXPECT_FALSE(with("path", most).holds());
  EXPECT_FALSE(with("winding", {most, most, 2}).holds());
  EXPECT_FALSE(with("residual", 1e308).holds());
  EXPECT_FALSE(with("condition", 5e-324).holds());
  EXPECT_FALSE(with("accuracy", -1e308).holds());
  EXPECT_EQ(with("accuracy", 0.0).roots.listed, 4U);
  EXPECT_TRUE(with("accuracy", 1e308).holds());  // true of any point
  Json deep = honest("plane");
  deep["left_out"] = Json::parse(std::string(500, '[') + std::string(500, ']'));
  EXPECT_TRUE(judged("plane", deep).holds());
}

TEST(CheckRobustness, ResultsWithoutRootsAreJudged) {
  Json result = honest("plane");
  result["solutions"] = Json::array();
  EXPECT_TRUE(refutes(judged("plane", result), ClaimKind::paths));
}

}  // namespace
}  // namespace moivre::test
