// SPDX-License-Identifier: MIT
// Stored results, read and judged.
#include "results.h"

#include <algorithm>

#include "moivre/polynomial/read.h"

namespace moivre::test {
namespace {

std::string path_of(const std::string& file) {
  return std::string(MOIVRE_SOURCE_DIR) + "/tests/check/results/" + file;
}

}  // namespace

System system_of_result(const std::string& name) {
  return read_system(read_source(path_of(name + ".phc")));
}

std::string result_text(const std::string& file) { return read_source(path_of(file)).text; }

Json honest(const std::string& name) { return Json::parse(result_text(name + ".json")); }

Judgement judged(const std::string& system, const std::string& result) {
  const System f = system_of_result(system);
  return check(f, read_claims({"result", result}, f.variables));
}

Judgement judged(const std::string& system, const Json& result) {
  return judged(system, result.dump());
}

std::string lines(const std::vector<Finding>& findings) {
  std::string text;
  for (const Finding& finding : findings) {
    text += (finding.root ? "root " + std::to_string(*finding.root) + ", " : "") +
            to_string(finding.claim) + ": " + finding.why + '\n';
  }
  return text;
}

bool refutes(const Judgement& judgement, ClaimKind claim, std::size_t root) {
  return std::any_of(judgement.refuted.begin(), judgement.refuted.end(), [&](const Finding& f) {
    return f.claim == claim && f.root.value_or(0) == root;
  });
}

}  // namespace moivre::test
