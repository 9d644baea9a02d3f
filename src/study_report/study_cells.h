// SPDX-License-Identifier: MIT
// What is one row of a study, column by column? The one list that the text, the CSV and the page
// are made from.
#pragma once

#include <string>
#include <vector>

#include "moivre/study_report/study_report.h"

namespace moivre {

/// Which table for people a column stands in: both, the one of times and losses, or that of errors
/// and work.
enum class CellTable { both, outcome, quality };

struct StudyCell {
  std::string key;      ///< the column's name in CSV
  std::string heading;  ///< over the column in tables for people; empty: in CSV only
  std::string exact;    ///< every digit; empty where unknown
  std::string rough;    ///< two digits; "-" where unknown
  CellTable table = CellTable::outcome;
};

std::vector<StudyCell> study_cells(const StudyRow& row);

/// First column to the left, the others to the right, two spaces between.
std::string aligned(const std::vector<std::vector<std::string>>& lines);

/// Headings and rows as text, four digits.
std::vector<std::vector<std::string>> lines_of(const StudyTable& table);

/// "seeds 1 to 3", what was solved, and the reference: a sentence each.
std::vector<std::string> study_facts(const StudiedFile& study);

/// What the table's columns mean, a sentence each.
std::vector<std::string> study_legend();

}  // namespace moivre
