// SPDX-License-Identifier: MIT
// Does the structure report tell what a solve would do?
#include "moivre/report/info.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <sstream>

#include "moivre/polynomial/read.h"

namespace moivre::test {
namespace {

SystemInfo info_of(const std::string& text) { return inspect(read_system({"file", text})); }

TEST(Info, CountsThePathsOfWhatIsLeftAfterElimination) {
  const SystemInfo info = info_of("3\nx^2 + y^2 + z^2 - 4;\nx*y - z;\nx + y + z - 1;\n");
  EXPECT_EQ(info.system.total_degree, 4U);
  EXPECT_EQ(info.reduced.variables.size(), 2U);
  ASSERT_EQ(info.start_systems.size(), 3U);
  for (const StartCost& start : info.start_systems)
    EXPECT_EQ(start.paths, 4U) << to_string(start.source);
  EXPECT_FALSE(info.left_out.empty());
}

TEST(Info, KnowsRealFromComplexAndHomogeneousFromNot) {
  EXPECT_TRUE(info_of("2\nx^2 - y^2;\nx*y;\n").homogeneous);
  EXPECT_FALSE(info_of("2\nx^2 - y;\nx*y;\n").homogeneous);
  EXPECT_TRUE(info_of("1\nx^2 + 1;\n").real);
  EXPECT_FALSE(info_of("1\nx^2 + i;\n").real);
}

TEST(Info, TellsThatParallelLinesNeedNoPath) {
  const SystemInfo info = info_of("2\nx + y - 1;\nx + y - 2;\n");
  EXPECT_EQ(info.verdict, "inconsistent");
  EXPECT_EQ(info.start_systems[0].paths, 0U);
}

TEST(Info, TakesSystemsThatAreNotSquare) {
  const SystemInfo info = info_of("1 2\nx*y - 1;\n");
  EXPECT_EQ(info.verdict, "underdetermined");
  EXPECT_FALSE(info.start_systems[0].paths.has_value());
  const std::string why = "fewer equations than unknowns: roots are not isolated";
  EXPECT_EQ(info.start_systems[0].why, why);
  EXPECT_TRUE(info_text(info, "file").ends_with("\n  total-degree: not possible (" + why + ")\n"));
}

TEST(Info, GivesNullForACountBeyond64Bits) {
  std::ostringstream text;
  text << "33\n";
  for (int k = 0; k < 33; ++k) text << 'x' << k << "^4 - 3*x" << (k + 1) % 33 << "^3 + 1;\n";
  const auto json = nlohmann::json::parse(info_json(info_of(text.str()), "file"));
  EXPECT_TRUE(json["system"]["total_degree"].is_null());
  EXPECT_TRUE(json["start_systems"][0]["paths"].is_null());
}

}  // namespace
}  // namespace moivre::test
