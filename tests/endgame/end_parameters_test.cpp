// SPDX-License-Identifier: MIT
// Do all numbers by which an end is judged stand in EndParameters, and are unusable ones refused?
#include "moivre/endgame/end_parameters.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <regex>

namespace moivre {
namespace {

const std::filesystem::path kFolder = MOIVRE_SOURCE_DIR "/src/endgame";

/// 1e-10, 0.3, 10; but for 0, 1 and 2, which measure nothing.
std::vector<std::string> measures_in(const std::string& line) {
  static const std::regex number(R"((?:^|[^\w.])(\d+(?:\.\d*)?(?:e[-+]?\d+)?))");
  const std::string code = line.substr(0, line.find("//"));
  std::vector<std::string> found;
  for (std::sregex_iterator k(code.begin(), code.end(), number), end; k != end; ++k) {
    const double value = std::stod((*k)[1]);
    if (value != 0 && value != 1 && value != 2) found.push_back((*k)[1]);
  }
  return found;
}

TEST(EndParameters, HoldEveryNumberOfTheEndgame) {
  int files = 0;
  for (const auto& entry : std::filesystem::directory_iterator(kFolder)) {
    if (entry.path().extension() != ".cpp" && entry.path().extension() != ".h") continue;
    if (entry.path().filename() == "end_parameters.cpp") continue;  // says which can be used
    ++files;
    std::ifstream file(entry.path());
    for (std::string line; std::getline(file, line);) {
      EXPECT_TRUE(measures_in(line).empty()) << entry.path().filename() << ": " << line;
    }
  }
  EXPECT_GE(files, 5);
}

TEST(EndParameters, NumbersInCodeAreSeenAndThoseInCommentsAreNot) {
  EXPECT_EQ(measures_in("x < 1e-10 && y > 0.3 / 10;"),
            (std::vector<std::string>{"1e-10", "0.3", "10"}));
  EXPECT_TRUE(measures_in("x3 = 1.0 / y[2];  // 0.3").empty());
}

TEST(EndParameters, ThatNoEndCanBeJudgedByAreRefused) {
  EXPECT_TRUE(validate(EndParameters()).empty());
  EndParameters broken;
  broken.samples = 5;
  broken.maximum_winding = 0;
  broken.shrink = 1;
  EXPECT_EQ(validate(broken).size(), 3U);
}

}  // namespace
}  // namespace moivre
