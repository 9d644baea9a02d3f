// SPDX-License-Identifier: MIT
// The study of each file, with progress, interruption and output.
#include "run_study.h"

#include <functional>
#include <stdexcept>

#include "command_line.h"
#include "interruption.h"
#include "moivre/numeric/invalid_input.h"
#include "moivre/polynomial/read.h"
#include "moivre/report/number_text.h"
#include "moivre/study_report/study_report.h"
#include "output.h"
#include "progress_line.h"
#include "study_folder.h"

#if MOIVRE_WITH_MECHANISM
#include "mechanism_input.h"
#include "moivre/closure_study/closure_study.h"
#include "moivre/expression/counted.h"
#include "moivre/mechanism/read.h"
#endif

namespace moivre {
namespace {

std::vector<StudySetting> settings_of(const StudyChoice& choice) {
  std::vector<StudySetting> settings;
  for (ChosenSetting& chosen : chosen_settings(choice)) {
    settings.push_back({chosen.curve, chosen.tolerance, std::move(chosen.tracker)});
  }
  return settings;
}

/// A file that has been read: how it is studied.
using Study = std::function<StudyResult(const std::vector<StudySetting>&, const ReferenceTrackers&,
                                        const StudyOptions&, const std::atomic<bool>&)>;

Study study_of_system(const std::string& file) {
  System system = read_system(read_source(file));
  if (system.polynomials.size() != system.variables.size()) {
    throw std::invalid_argument(file + ": " + counted(system.polynomials.size(), "equation") +
                                " in " + counted(system.variables.size(), "unknown") +
                                "; as many equations as unknowns are needed");
  }
  return [system = std::move(system)](const auto& settings, const ReferenceTrackers& references,
                                      const StudyOptions& options, const auto& stop) {
    return study_system(system, settings, *references.reference_tracker, references.witness.get(),
                        options, stop);
  };
}

#if MOIVRE_WITH_MECHANISM
Study study_of_mechanism(const std::string& file) {
  return [mechanism = read_mechanism(read_source(file))](
             const auto& settings, const ReferenceTrackers& references, const StudyOptions& options,
             const auto& stop) {
    return study_mechanism(mechanism, settings, *references.reference_tracker,
                           references.witness.get(), options, stop);
  };
}

bool names_mechanism(const std::string& file) { return is_mechanism_file(file); }
#else
Study study_of_mechanism(const std::string& file) {
  throw std::invalid_argument(
      file + ": this program was built without mechanisms (MOIVRE_WITH_MECHANISM)");
}

bool names_mechanism(const std::string& file) { return file.ends_with(".toml"); }
#endif

std::vector<Study> read_files(const std::vector<std::string>& files) {
  std::vector<Study> studies;
  for (const std::string& file : files) {
    studies.push_back(names_mechanism(file) ? study_of_mechanism(file) : study_of_system(file));
  }
  return studies;
}

StudyOptions options_of(const StudyCommand& command) {
  StudyOptions options;
  options.seed = command.seed;
  options.seeds = command.seeds;
  require_unbroken(validate(options));
  return options;
}

bool all_complete(const std::vector<StudiedFile>& studies) {
  for (const StudiedFile& study : studies) {
    if (!study.result.complete || !study.result.reference.complete) return false;
  }
  return true;
}

/// The files asked for by name, and those of the folder that a problem may be named like.
std::vector<std::string> outputs_of(const StudyCommand& command) {
  std::vector<std::string> outputs{command.json, command.csv};
  if (!command.out.empty()) {
    for (const char* name : {"/study.csv", "/index.html"}) outputs.push_back(command.out + name);
  }
  return outputs;
}

struct FolderWritten {
  std::string remark;
  std::string failure;
};

FolderWritten write_folder(StudyFolder& folder, std::vector<StudiedFile>& studies) {
  try {
    return {folder.write(studies), ""};
  } catch (const std::invalid_argument& failure) {
    return {"", failure.what()};
  }
}

std::string study_texts(const std::vector<StudiedFile>& studies) {
  std::string text;
  for (const StudiedFile& study : studies) text += study_text(study) + '\n';
  return text;
}

}  // namespace

int run_study(const StudyCommand& command) {
  for (const std::string& file : command.files) require_distinct(outputs_of(command), file);
  const std::vector<StudySetting> settings = settings_of(command.choice);
  const ReferenceTrackers references = make_reference_trackers();
  StudyOptions options = options_of(command);
  const std::vector<Study> subjects = read_files(command.files);
  Output json(command.json);
  Output csv(command.csv);
  StudyFolder folder(command.out);

  const std::vector<std::string> names = names_of(command.files);
  std::vector<StudiedFile> studies;
  const Interruption interruption;
  {
    ProgressLine line(!command.quiet);
    for (std::size_t k = 0; k < subjects.size(); ++k) {
      options.known_roots = command.count ? command.count : known_count(command.files[k]);
      options.progress = [&](const StudyProgress& progress) {
        line.show(names[k] + ": " + progress.now + ", " + std::to_string(progress.done) + " of " +
                  std::to_string(progress.total));
      };
      studies.push_back({command.files[k],
                         names[k],
                         subjects[k](settings, references, options, interruption.stop()),
                         {}});
    }
  }
  const FolderWritten written = write_folder(folder, studies);
  deliver(
      {{&json, [&] { return study_json(studies); }}, {&csv, [&] { return study_csv(studies); }}},
      command.quiet && written.failure.empty(), [&] { return study_texts(studies); });
  if (!written.failure.empty()) throw std::invalid_argument(written.failure);
  if (!command.quiet) std::fputs(written.remark.c_str(), stderr);
  return all_complete(studies) ? kDecided : kUndecided;
}

}  // namespace moivre
