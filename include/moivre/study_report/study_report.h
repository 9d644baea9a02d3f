// SPDX-License-Identifier: MIT
// How is a study told? A table as text and CSV, everything as JSON, a work-precision diagram for gnuplot, a page that holds all.
//
// CSV: one row a file and setting, columns named in the first row; what is unknown is empty. The JSON is shown in docs/json.md.
// Diagram: log10 error over log10 CPU time, a curve a method along its tolerances; on the left what the tracker itself
// leaves, on the right what solve() delivers. A setting that loses roots is a cross with their number beside it.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "moivre/study/study.h"

namespace moivre {

/// A file's study, with its diagram where gnuplot has drawn one.
struct StudiedFile {
  std::string file;
  std::string name;  ///< of the diagram's files, without ending
  StudyResult result;
  std::string diagram;  ///< SVG; empty: not drawn
};

/// The processor as the system names it; "unknown processor" where it does not.
std::string processor_name();

std::string study_text(const StudiedFile& study);
std::string study_csv(const std::vector<StudiedFile>& studies);
std::string study_json(const std::vector<StudiedFile>& studies);
/// A script for gnuplot 5 that writes NAME.svg, data included.
std::string study_gnuplot(const StudiedFile& study);
std::string study_html(const std::vector<StudiedFile>& studies);

/// Roots with multiplicity, by the index.json beside the file (problems/polynomials/index.json); nullopt where there is
/// no index, or it does not name the file.
std::optional<std::uint64_t> known_count(const std::string& file);

}  // namespace moivre
