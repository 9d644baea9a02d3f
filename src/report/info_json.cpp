// SPDX-License-Identifier: MIT
// The structure of a system as JSON; docs/json.md shows it.
#include "moivre/report/info.h"
#include "moivre/report/json.h"

namespace moivre {

std::string info_json(const SystemInfo& info, const std::string& file) {
  Json report = report_head("info", file);
  report["system"] = {{"variables", info.system.variables},
                      {"equations", info.equations},
                      {"degrees", info.system.degrees},
                      {"total_degree", to_json(info.system.total_degree)},
                      {"terms", info.terms},
                      {"real", info.real},
                      {"homogeneous", info.homogeneous}};
  if (!info.conditions.empty()) report["system"]["conditions"] = info.conditions;
  report["reduced"] = {{"verdict", info.verdict},
                       {"variables", info.reduced.variables},
                       {"degrees", info.reduced.degrees},
                       {"total_degree", to_json(info.reduced.total_degree)},
                       {"terms", info.reduced_terms}};
  report["scaling"] = {{"variables_log2", info.variable_log2},
                       {"equations_log2", info.equation_log2}};
  report["start_systems"] = Json::array();
  for (const StartCost& start : info.start_systems) {
    report["start_systems"].push_back(
        {{"kind", to_string(start.source)}, {"paths", to_json(start.paths)}, {"why", start.why}});
  }
  report["start"] = {{"counts", to_json(info.counts)}};
  report["left_out"] = to_json(info.left_out);
  return to_text(report);
}

}  // namespace moivre
