// SPDX-License-Identifier: MIT
// A study as a table for people, and as CSV.
#include <algorithm>
#include <cmath>

#include "moivre/report/number_text.h"
#include "study_cells.h"

namespace moivre {
namespace {

std::string quoted(const std::string& text) {
  if (text.find_first_of(",\"\n") == std::string::npos) return text;
  std::string result = "\"";
  for (const char c : text) result += c == '"' ? "\"\"" : std::string(1, c);
  return result + '"';
}

std::vector<std::vector<std::string>> table_of(const StudyResult& result, CellTable table) {
  std::vector<std::vector<std::string>> lines;
  for (const StudyRow& row : result.rows) {
    const std::vector<StudyCell> cells = study_cells(row);
    if (lines.empty()) lines.emplace_back();
    const bool is_first = lines.size() == 1;
    std::vector<std::string> line;
    for (const StudyCell& cell : cells) {
      if (cell.heading.empty() || (cell.table != CellTable::both && cell.table != table)) continue;
      if (is_first) lines.front().push_back(cell.heading);
      line.push_back(cell.rough);
    }
    lines.push_back(std::move(line));
  }
  return lines;
}

}  // namespace

std::string aligned(const std::vector<std::vector<std::string>>& lines) {
  std::vector<std::size_t> widths;
  for (const auto& line : lines) {
    widths.resize(std::max(widths.size(), line.size()));
    for (std::size_t k = 0; k < line.size(); ++k) widths[k] = std::max(widths[k], line[k].size());
  }
  std::string text;
  for (const auto& line : lines) {
    for (std::size_t k = 0; k < line.size(); ++k) {
      const std::string space(widths[k] - line[k].size(), ' ');
      text += k == 0 ? line[k] + space : "  " + space + line[k];
    }
    text += '\n';
  }
  return text;
}

std::vector<std::vector<std::string>> lines_of(const StudyTable& table) {
  std::vector<std::vector<std::string>> lines{table.columns};
  for (const std::vector<double>& row : table.rows) {
    std::vector<std::string>& line = lines.emplace_back();
    for (const double x : row) line.push_back(x == std::round(x) ? exact_text(x) : rough_text(x));
  }
  return lines;
}

std::string study_text(const StudiedFile& study) {
  std::string text = study.file + '\n';
  for (const std::string& fact : study_facts(study)) text += fact + '\n';
  if (!study.result.rows.empty()) {
    text += '\n' + aligned(table_of(study.result, CellTable::outcome)) + '\n' +
            aligned(table_of(study.result, CellTable::quality));
  }
  text += '\n';
  for (const StudyTable& table : study.result.tables) {
    text += table.title + '\n' + aligned(lines_of(table)) + '\n';
  }
  if (!study.result.complete) text += study.result.message + '\n';
  for (const std::string& line : study_legend()) text += line + '\n';
  return text;
}

std::string study_csv(const std::vector<StudiedFile>& studies) {
  std::string head = "file";
  for (const StudyCell& cell : study_cells(StudyRow{})) head += ',' + cell.key;
  std::string text = head + '\n';
  for (const StudiedFile& study : studies) {
    for (const StudyRow& row : study.result.rows) {
      text += quoted(study.file);
      for (const StudyCell& cell : study_cells(row)) text += ',' + quoted(cell.exact);
      text += '\n';
    }
  }
  return text;
}

}  // namespace moivre
