// SPDX-License-Identifier: MIT
// Writes the folder of a study.
#include "study_folder.h"

#include <cctype>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <set>
#include <stdexcept>
#include <string_view>

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

/// The stem without what gnuplot, or the shell that it asks in quotes, reads as a command.
std::string harmless(std::string stem) {
  for (char& c : stem) {
    const auto byte = static_cast<unsigned char>(c);
    const bool is_plain = std::isalnum(byte) != 0 || byte >= 0x80 ||
                          std::string_view(" .+-_").find(c) != std::string_view::npos;
    if (!is_plain) c = '_';
  }
  if (stem.starts_with('-')) stem.front() = '_';
  return stem;
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
  std::set<std::string> used;
  std::vector<std::string> names;
  for (const std::string& file : files) {
    const std::string stem = harmless(std::filesystem::path(file).stem().string());
    std::string name = stem;
    for (int k = 2; !used.insert(name).second; ++k) name = stem + '-' + std::to_string(k);
    names.push_back(name);
  }
  return names;
}

}  // namespace moivre
