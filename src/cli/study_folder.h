// SPDX-License-Identifier: MIT
// What is in the folder of a study? study.csv, index.html, each file's diagrams with scripts. Known
// to be writable beforehand.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "moivre/study_report/study_report.h"
#include "output.h"

namespace moivre {

class StudyFolder {
 public:
  /// Makes the folder; an empty name: none is wanted. Throws std::invalid_argument when it cannot
  /// be written to.
  explicit StudyFolder(const std::string& folder);

  /// Writes everything, draws what gnuplot can draw, and puts the diagrams into `studies`. Returns
  /// a sentence when a diagram was not drawn, else nothing.
  std::string write(std::vector<StudiedFile>& studies);

 private:
  std::string folder_;
  std::optional<Output> csv_;
  std::optional<Output> page_;
};

/// The files' stems, each once: a second "x" becomes "x-2".
std::vector<std::string> names_of(const std::vector<std::string>& files);

}  // namespace moivre
