// SPDX-License-Identifier: MIT
// Writes the folder of a study.
#include "study_folder.h"

#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <stdexcept>

#include "gnuplot.h"

namespace moivre {
namespace {

std::string content_of(const std::string& path) {
  std::ifstream stream(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
}

std::string told(GnuplotOutcome outcome, const std::string& script) {
  switch (outcome) {
    case GnuplotOutcome::drawn:
      return "";
    case GnuplotOutcome::no_gnuplot:
      return "no diagrams: gnuplot is not installed; its scripts are there for later\n";
    case GnuplotOutcome::failed:
      return "gnuplot failed on " + script + '\n';
  }
  return "";
}

}  // namespace

StudyFolder::StudyFolder(const std::string& folder) : folder_(folder) {
  if (folder_.empty()) return;
  std::error_code error;
  std::filesystem::create_directories(folder_, error);
  if (error || !std::filesystem::is_directory(folder_)) {
    throw std::invalid_argument("--out " + folder_ + ": cannot make this folder" +
                                (error ? ": " + error.message() : ""));
  }
  csv_.emplace(folder_ + "/study.csv");
  page_.emplace(folder_ + "/index.html");
}

std::string StudyFolder::write(std::vector<StudiedFile>& studies) {
  if (folder_.empty()) return "";
  std::string message;
  for (StudiedFile& study : studies) {
    study.diagrams = study_diagrams(study);
    for (StudyDiagram& diagram : study.diagrams) {
      const std::string script = diagram.name + ".gp";
      Output(folder_ + '/' + script).write(diagram.script);
      const GnuplotOutcome outcome = run_gnuplot(folder_, script);
      if (outcome == GnuplotOutcome::drawn)
        diagram.svg = content_of(folder_ + '/' + diagram.name + ".svg");
      if (message.empty()) message = told(outcome, script);
    }
  }
  csv_->write(study_csv(studies));
  page_->write(study_html(studies));
  return message;
}

std::vector<std::string> names_of(const std::vector<std::string>& files) {
  std::map<std::string, int> used;
  std::vector<std::string> names;
  for (const std::string& file : files) {
    const std::string stem = std::filesystem::path(file).stem().string();
    const int times = ++used[stem];
    names.push_back(times == 1 ? stem : stem + '-' + std::to_string(times));
  }
  return names;
}

}  // namespace moivre
