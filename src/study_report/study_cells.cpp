// SPDX-License-Identifier: MIT
// The columns of a study.
#include "study_cells.h"

#include <fstream>

#include "moivre/expression/counted.h"
#include "moivre/report/number_text.h"

namespace moivre {
namespace {

StudyCell number(const std::string& key, const std::string& heading, double x) {
  return {key, heading, exact_text(x), rough_text(x), CellTable::outcome};
}

StudyCell number(const std::string& key, const std::string& heading, std::optional<double> x) {
  return x ? number(key, heading, *x) : StudyCell{key, heading, "", "-", CellTable::outcome};
}

StudyCell integer(const std::string& key, const std::string& heading, std::uint64_t n) {
  return {key, heading, std::to_string(n), std::to_string(n), CellTable::outcome};
}

StudyCell integer(const std::string& key, const std::string& heading,
                  std::optional<std::uint64_t> n) {
  return n ? integer(key, heading, *n) : StudyCell{key, heading, "", "-", CellTable::outcome};
}

/// `member` of the walk, where there was one.
template <class T>
std::optional<T> of_walk(const StudyRow& row, T StudyWalk::*member) {
  return row.walk ? std::optional<T>((*row.walk).*member) : std::nullopt;
}

std::optional<double> of_walk(const StudyRow& row, std::optional<double> StudyWalk::*member) {
  return row.walk ? (*row.walk).*member : std::nullopt;
}

}  // namespace

std::vector<StudyCell> study_cells(const StudyRow& row) {
  const StudyOutcome& own = row.own;
  const StudyOutcome& all = row.repaired;
  const std::string tolerance = exact_text(row.tolerance);
  std::vector<StudyCell> cells{{"curve", "curve", row.curve, row.curve, CellTable::both},
                               {"tolerance", "tol", tolerance, tolerance, CellTable::both},
                               number("own_cpu_s", "own s", own.cpu_s.median),
                               number("own_cpu_s_least", "", own.cpu_s.least),
                               number("own_cpu_s_most", "", own.cpu_s.most),
                               integer("own_lost", "lost", own.lost),
                               integer("jumped", "jumped", of_walk(row, &StudyWalk::jumped)),
                               integer("stuck", "", of_walk(row, &StudyWalk::stuck)),
                               integer("own_failed", "failed", own.failed),
                               integer("own_strangers", "", own.strangers),
                               number("cpu_s", "solve s", all.cpu_s.median),
                               number("cpu_s_least", "least", all.cpu_s.least),
                               number("cpu_s_most", "most", all.cpu_s.most),
                               integer("lost", "lost", all.lost),
                               integer("retracked", "again", all.retracked),
                               integer("failed", "failed", all.failed),
                               integer("strangers", "strange", all.strangers)};
  const std::vector<StudyCell> quality{
      number("end_error", "end err", of_walk(row, &StudyWalk::end_error)),
      number("plain_error", "plain err", all.plain_error),
      number("error", "error", all.error),
      number("drift_before", "|H| before", of_walk(row, &StudyWalk::drift_before)),
      number("drift_after", "|H| after", of_walk(row, &StudyWalk::drift_after)),
      integer("steps", "steps", all.work.accepted),
      integer("rejected", "rejected", all.work.rejected),
      integer("evaluations", "evaluated", all.work.work.values),
      integer("fine_evaluations", "", all.work.work.fine_values),
      integer("linearizations", "", all.work.work.linearizations),
      integer("factorizations", "factored", all.work.work.factorizations)};
  for (const StudyCell& cell : quality) {
    cells.push_back(cell);
    cells.back().table = CellTable::quality;
  }
  return cells;
}

std::vector<std::string> study_facts(const StudiedFile& study) {
  const StudyResult& result = study.result;
  const StudyReference& reference = result.reference;
  const std::string last =
      std::to_string(result.seed + static_cast<std::uint64_t>(result.seeds) - 1);
  std::vector<std::string> facts{
      counted(result.system.variables.size(), "unknown") + ", " + counted(result.paths, "path") +
          ", seeds " + std::to_string(result.seed) + " to " + last + ", CPU time of one thread",
      "reference: " + counted(reference.roots, "isolated root") + ", " +
          std::to_string(reference.exact) + " of them to " + std::to_string(reference.digits) +
          " digits; " + reference.completeness};
  facts.insert(facts.end(), result.remarks.begin(), result.remarks.end());
  return facts;
}

std::vector<std::string> study_legend() {
  return {
      "own: solve without repairs; what it lost, jumped (paths at another path's root) and failed "
      "is the tracker's doing",
      "solve: with paths tracked again; least, median and most of CPU seconds over the seeds; "
      "strange: roots that are none of the reference",
      "end err: largest forward error where the tracker's last step ends; error: of "
      "the delivered roots, residuals in double-double; plain err: of the same with residuals in "
      "plain double",
      "|H|: largest along the paths, before and after the correction of a step; steps and "
      "factorizations: median over the seeds"};
}

std::string processor_name() {
  std::ifstream info("/proc/cpuinfo");
  for (std::string line; std::getline(info, line);) {
    if (line.rfind("model name", 0) != 0) continue;
    const std::size_t colon = line.find(": ");
    if (colon != std::string::npos) return line.substr(colon + 2);
  }
  return "unknown processor";
}

}  // namespace moivre
