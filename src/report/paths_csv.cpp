// SPDX-License-Identifier: MIT
// The ledger of a solve as CSV: one path a line, whatever became of it.
#include <map>

#include "moivre/report/solve_report.h"
#include "moivre/report/text_pieces.h"

namespace moivre {

void write_paths_csv(const TextSink& sink, const SolveResult& result) {
  std::map<std::uint64_t, Failure> reasons;
  for (const FailedPath& path : result.failures) reasons[path.path] = path.failure;
  TextPieces text(sink);
  text += "path,stage,verdict,solution,reason,precision,followed,handed_over,steps,by_count\n";
  for (std::uint64_t k = 0; k < result.ledger.size(); ++k) {
    const PathRecord& path = result.ledger[k];
    const bool is_placed = path.solution != PathRecord::kNoSolution;
    const bool is_on_set = path.verdict == PathVerdict::finite && !is_placed;
    const auto reason = reasons.find(k);
    text += std::to_string(k) + ',' + std::to_string(path.stage) + ',' +
            (is_on_set ? "on a set" : to_string(path.verdict)) + ',' +
            (is_placed ? std::to_string(path.solution) : "") + ',' +
            (reason == reasons.end() ? "" : to_string(reason->second)) + ',' +
            to_string(path.precision) + ',' + std::to_string(path.followed) + ',' +
            (path.handed_over ? "1," : "0,") + std::to_string(path.steps) +
            (path.by_count ? ",1\n" : ",0\n");
  }
  text.flush();
}

std::string paths_csv(const SolveResult& result) {
  return whole_text([&](const TextSink& sink) { write_paths_csv(sink, result); });
}

}  // namespace moivre
