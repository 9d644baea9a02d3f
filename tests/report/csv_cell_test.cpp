// SPDX-License-Identifier: MIT
// Is a name of a file one cell, and never a formula?
#include "moivre/report/csv_cell.h"

#include <gtest/gtest.h>

namespace moivre {
namespace {

TEST(CsvCell, LeavesAnOrdinaryNameAlone) {
  EXPECT_EQ(csv_cell("shoulder pan [rad]"), "shoulder pan [rad]");
  EXPECT_EQ(csv_cell("a=b"), "a=b");
  EXPECT_EQ(csv_cell(""), "");
}

TEST(CsvCell, BeginsNoFormula) {
  EXPECT_EQ(csv_cell("=cmd|' /C calc'!A0"), "'=cmd|' /C calc'!A0");
  EXPECT_EQ(csv_cell("+1"), "'+1");
  EXPECT_EQ(csv_cell("-1"), "'-1");
  EXPECT_EQ(csv_cell("@SUM(A1)"), "'@SUM(A1)");
  EXPECT_EQ(csv_cell("=HYPERLINK(\"x\",1)"), "\"'=HYPERLINK(\"\"x\"\",1)\"");
}

TEST(CsvCell, IsOneCell) {
  EXPECT_EQ(csv_cell("a,b"), "\"a,b\"");
  EXPECT_EQ(csv_cell("a\nb"), "\"a\nb\"");
}

}  // namespace
}  // namespace moivre
