// SPDX-License-Identifier: MIT
// How is a study reported? A table as text and CSV, everything as JSON, work-precision diagrams for
// gnuplot, a page that holds all.
//
// CSV: one row a file and setting, columns named in the first row; what is unknown is empty. The
// JSON is shown in docs/json.md.
// Diagram: log10 error over log10 CPU time, a curve a method along its tolerances; on the left what
// the tracker itself leaves, on the right what solve() delivers. A setting that loses roots is a
// cross with their number beside it. A mechanism's motion has a diagram of its own: errors of
// position, velocity and acceleration over CPU time.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "moivre/study/study.h"

namespace moivre {

/// A script for gnuplot 5 that writes NAME.svg, data included, and what it wrote.
struct StudyDiagram {
  std::string name;
  std::string script;
  std::string svg;  ///< empty: not drawn
};

/// A file's study, with its diagrams where they have been made.
struct StudiedFile {
  std::string file;
  std::string name;  ///< of the diagrams' files, without ending
  StudyResult result;
  std::vector<StudyDiagram> diagrams;
};

/// The processor as the system names it; "unknown processor" where it does not.
std::string processor_name();

std::string study_text(const StudiedFile& study);
std::string study_csv(const std::vector<StudiedFile>& studies);
std::string study_json(const std::vector<StudiedFile>& studies);
/// Of the settings where there are roots, and of the motion where there is one; none is drawn yet.
std::vector<StudyDiagram> study_diagrams(const StudiedFile& study);
std::string study_html(const std::vector<StudiedFile>& studies);

/// Roots with multiplicity, by the index.json beside the file (problems/polynomials/index.json);
/// nullopt where there is no index, or it does not name the file.
std::optional<std::uint64_t> known_count(const std::string& file);

}  // namespace moivre
