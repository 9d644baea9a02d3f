// SPDX-License-Identifier: MIT
// A study as JSON, and the index that knows how many roots a file has.
#include <filesystem>
#include <fstream>

#include "moivre/report/json.h"
#include "moivre/report/version.h"
#include "moivre/study_report/study_report.h"

namespace moivre {
namespace {

Json optional_json(const std::optional<double>& x) { return x ? to_json(*x) : Json(nullptr); }

Json spread_json(const Spread& spread) {
  return {{"least", spread.least}, {"median", spread.median}, {"most", spread.most}};
}

Json outcome_json(const StudyOutcome& outcome) {
  return {{"lost", outcome.lost},
          {"strangers", outcome.strangers},
          {"failed", outcome.failed},
          {"retracked", outcome.retracked},
          {"error", optional_json(outcome.error)},
          {"plain_error", optional_json(outcome.plain_error)},
          {"work", work_json(outcome.work)},
          {"time_s", spread_json(outcome.cpu_s)}};
}

Json walk_json(const std::optional<StudyWalk>& walk) {
  if (!walk) return nullptr;
  return {{"paths", walk->paths},
          {"jumped", walk->jumped},
          {"stuck", walk->stuck},
          {"drift_before", to_json(walk->drift_before)},
          {"drift_after", to_json(walk->drift_after)},
          {"end_error", optional_json(walk->end_error)}};
}

Json row_json(const StudyRow& row) {
  return {{"curve", row.curve},
          {"tolerance", row.tolerance},
          {"tracker", tracker_json(row.tracker, row.tracker_options)},
          {"own", outcome_json(row.own)},
          {"solve", outcome_json(row.repaired)},
          {"walk", walk_json(row.walk)}};
}

Json reference_json(const StudyReference& reference) {
  return {{"roots", reference.roots},          {"with_multiplicity", reference.with_multiplicity},
          {"exact", reference.exact},          {"digits", reference.digits},
          {"known", to_json(reference.known)}, {"complete", reference.complete},
          {"why", reference.completeness}};
}

Json table_json(const StudyTable& table) {
  return {{"title", table.title}, {"columns", table.columns}, {"rows", table.rows}};
}

Json file_json(const StudiedFile& study) {
  const StudyResult& result = study.result;
  return {{"file", study.file},
          {"complete", result.complete},
          {"message", result.message},
          {"system", to_json(result.system)},
          {"reduced",
           {{"variables", result.reduced.variables.size()}, {"degrees", result.reduced.degrees}}},
          {"paths", result.paths},
          {"reference", reference_json(result.reference)},
          {"settings", list_json(result.rows, row_json)},
          {"tables", list_json(result.tables, table_json)},
          {"remarks", result.remarks},
          {"time_s", {{"total", result.cpu_s}}}};
}

}  // namespace

std::string study_json(const std::vector<StudiedFile>& studies) {
  bool complete = true;
  for (const StudiedFile& study : studies) complete = complete && study.result.complete;
  Json report;
  report["moivre"] = version();
  report["command"] = "study";
  report["seed"] = studies.empty() ? 0 : studies.front().result.seed;
  report["seeds"] = studies.empty() ? 0 : studies.front().result.seeds;
  report["complete"] = complete;
  report["processor"] = processor_name();
  report["files"] = list_json(studies, file_json);
  return to_text(report);
}

std::optional<std::uint64_t> known_count(const std::string& file) {
  const std::filesystem::path path(file);
  std::ifstream stream(path.parent_path() / "index.json");
  const Json index = Json::parse(stream, nullptr, false);
  if (!index.is_object() || !index.contains("problems")) return std::nullopt;
  for (const Json& problem : index["problems"]) {
    if (problem.value("file", "") != path.filename().string()) continue;
    if (!problem.contains("roots") || !problem["roots"].is_object()) return std::nullopt;
    const Json& roots = problem["roots"];
    if (roots.value("far", 0) != 0) return std::nullopt;
    const Json count = roots.value("with_multiplicity", Json(nullptr));
    return count.is_number_unsigned() ? std::optional(count.get<std::uint64_t>()) : std::nullopt;
  }
  return std::nullopt;
}

}  // namespace moivre
