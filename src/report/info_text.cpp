// SPDX-License-Identifier: MIT
// The structure of a system for people.
#include <string>

#include "moivre/expression/counted.h"
#include "moivre/expression/joined.h"
#include "moivre/polynomial/scale.h"
#include "moivre/report/info.h"
#include "moivre/report/number_text.h"
#include "moivre/report/text_blocks.h"

namespace moivre {
namespace {

std::string size_text(std::uint64_t equations, std::uint64_t unknowns, std::uint64_t terms) {
  return counted(equations, "equation") + " in " + counted(unknowns, "unknown") + ", " +
         counted(terms, "term");
}

std::string degrees_line(const SystemFacts& facts) {
  return degrees_text(facts.degrees) + "; total degree " + count_text(facts.total_degree);
}

}  // namespace

std::string info_text(const SystemInfo& info, const std::string& file) {
  std::string text =
      file + ": " + size_text(info.equations, info.system.variables.size(), info.terms) + '\n';
  text += "unknowns      " + joined(info.system.variables, " ") + '\n';
  text += "degrees       " + degrees_line(info.system) + '\n';
  text += std::string("coefficients  ") + (info.real ? "real" : "complex") + '\n';
  text += std::string("homogeneous   ") + (info.homogeneous ? "yes" : "no") + '\n';
  if (!info.conditions.empty()) text += "conditions    " + joined(info.conditions, ", ") + '\n';
  text += "tracked       ";
  if (info.reduced.degrees.empty()) {
    text += "nothing: " + info.verdict + '\n';
  } else {
    text +=
        size_text(info.reduced.degrees.size(), info.reduced.variables.size(), info.reduced_terms) +
        ", degrees " + degrees_line(info.reduced) + '\n';
  }
  const std::string scaling = to_text(Scaling{info.variable_log2, info.equation_log2});
  text += "scaling       " + (scaling.empty() ? "none needed" : scaling) + '\n';
  text += "\nPaths of each start system\n";
  for (const StartCost& start : info.start_systems) {
    text += "  " + to_string(start.source) + ": " +
            (start.paths ? std::to_string(*start.paths) : "not possible") + " (" + start.why +
            ")\n";
  }
  return text + left_out_text(info.left_out);
}

}  // namespace moivre
