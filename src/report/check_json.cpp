// SPDX-License-Identifier: MIT
// The judgement as JSON: the contract of docs/json.md.
#include "moivre/report/check_report.h"
#include "moivre/report/json.h"

namespace moivre {
namespace {

Json finding_json(const Finding& finding) {
  return {{"root", finding.root ? Json(*finding.root) : Json()},
          {"claim", to_string(finding.claim)},
          {"why", finding.why}};
}

Json tally_json(const ClaimTally& tally) {
  return {{"claim", to_string(tally.claim)},
          {"holds", tally.holds},
          {"refuted", tally.refuted},
          {"open", tally.open}};
}

Json bound_json(const RootBound& bound) {
  Json json = {{"kind", to_string(bound.kind)}, {"value", to_json(bound.value)}};
  if (!bound.value) json["why"] = bound.missing;
  return json;
}

Json roots_json(const RootTally& roots) {
  return {{"listed", roots.listed},      {"certified", roots.certified},
          {"distinct", roots.distinct},  {"real", roots.real},
          {"not_real", roots.not_real},  {"doubled", roots.doubled},
          {"not_roots", roots.not_roots}};
}

}  // namespace

std::string check_json(const Judgement& judgement, const JudgedFiles& files) {
  Json report = report_head("check", files.system);
  report["result"] = files.result;
  report["form"] = judgement.form == ClaimForm::solution_list ? "solution list" : "solve";
  report["holds"] = judgement.holds();
  report["unverified_proofs"] = judgement.unverified_proofs;
  report["interrupted"] = judgement.interrupted;
  report["stand_in"] = judgement.stand_in.empty() ? Json(nullptr) : Json(judgement.stand_in);
  report["roots"] = roots_json(judgement.roots);
  report["bounds"] = list_json(judgement.bounds, bound_json);
  report["proved_by"] = judgement.proved_by ? Json(to_string(*judgement.proved_by)) : Json(nullptr);
  report["claims"] = list_json(judgement.claims, tally_json);
  report["refuted"] = list_json(judgement.refuted, finding_json);
  report["open"] = list_json(judgement.open, finding_json);
  return to_text(report);
}

}  // namespace moivre
