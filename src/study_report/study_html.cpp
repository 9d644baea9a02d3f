// SPDX-License-Identifier: MIT
// A study as one page that needs no other file: facts, diagram and table of each file.
#include "moivre/report/markup.h"
#include "moivre/report/version.h"
#include "study_cells.h"

namespace moivre {
namespace {

std::string element(const std::string& tag, const std::string& content) {
  return '<' + tag + '>' + escaped(content) + "</" + tag + '>';
}

/// The SVG element without the XML declaration and document type, which HTML has none of.
std::string inline_svg(const std::string& svg) {
  const std::size_t begin = svg.find("<svg");
  return begin == std::string::npos ? "" : svg.substr(begin);
}

std::string table(const StudyResult& result) {
  if (result.rows.empty()) return "";
  std::string text = "<div class=\"wide\"><table>\n<tr>";
  for (const StudyCell& cell : study_cells(result.rows.front())) {
    if (!cell.heading.empty()) text += element("th", cell.heading);
  }
  text += "</tr>\n";
  for (const StudyRow& row : result.rows) {
    text += row.repaired.lost > 0 ? "<tr class=\"lost\">" : "<tr>";
    for (const StudyCell& cell : study_cells(row)) {
      if (!cell.heading.empty()) text += element("td", cell.rough);
    }
    text += "</tr>\n";
  }
  return text + "</table></div>\n";
}

std::string table(const StudyTable& other) {
  std::string text = element("p", other.title) + "\n<div class=\"wide\"><table>\n";
  const auto lines = lines_of(other);
  for (std::size_t k = 0; k < lines.size(); ++k) {
    text += "<tr>";
    for (const std::string& cell : lines[k]) text += element(k == 0 ? "th" : "td", cell);
    text += "</tr>\n";
  }
  return text + "</table></div>\n";
}

std::string section(const StudiedFile& study) {
  std::string text = element("h2", study.name) + "\n<p>" + escaped(study.file) + "<br>\n";
  for (const std::string& fact : study_facts(study)) text += escaped(fact) + "<br>\n";
  if (!study.result.complete) text += escaped(study.result.message) + "<br>\n";
  text += "</p>\n";
  for (const StudyDiagram& diagram : study.diagrams) {
    text += diagram.svg.empty() ? "<p>No diagram was drawn. Its script for gnuplot is " +
                                      escaped(diagram.name) + ".gp.</p>\n"
                                : inline_svg(diagram.svg);
  }
  text += table(study.result);
  for (const StudyTable& other : study.result.tables) text += table(other);
  return text;
}

}  // namespace

std::string study_html(const std::vector<StudiedFile>& studies) {
  std::string text =
      "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
      "<title>Error against run time</title>\n<style>\n"
      "body { font: 15px/1.5 sans-serif; margin: 2em auto; max-width: 1240px; padding: 0 1em; }\n"
      "svg { width: 100%; height: auto; }\nsvg[viewBox^=\"0 0 760\"] { max-width: 760px; }\n"
      ".wide { overflow-x: auto; }\n"
      "table { border-collapse: collapse; font-size: 12px; }\n"
      "th, td { padding: 2px 7px; text-align: right; white-space: nowrap; }\n"
      "th { border-bottom: 1px solid #888; }\n"
      "th:first-child, td:first-child { text-align: left; }\n"
      "tr.lost td { background: #fbe3d6; }\n</style>\n</head>\n<body>\n"
      "<h1>Error against run time</h1>\n";
  text += "<p>Moivre " + escaped(std::string(version())) + ", " + escaped(processor_name()) +
          ".</p>\n<ul>\n";
  for (const std::string& line : study_legend()) text += element("li", line) + '\n';
  text += "<li>Rows in red: roots were lost though paths were tracked again.</li>\n</ul>\n";
  for (const StudiedFile& study : studies) text += section(study);
  return text + "</body>\n</html>\n";
}

}  // namespace moivre
