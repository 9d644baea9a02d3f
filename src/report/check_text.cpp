// SPDX-License-Identifier: MIT
// The judgement for people: a table, and the reasons.
#include <algorithm>
#include <cstdio>
#include <map>
#include <utility>

#include "moivre/expression/counted.h"
#include "moivre/expression/joined.h"
#include "moivre/report/check_report.h"
#include "moivre/report/number_text.h"

namespace moivre {
namespace {

constexpr const char* kShared =
    "Shared    with solve: reading, proofs of roots, bounds, exact algebra (modulo other primes); "
    "nothing that follows a path\n";

std::string roots_text(const Judgement& judgement) {
  const RootTally& roots = judgement.roots;
  std::string text = counted(roots.listed, "root") + ": ";
  if (!judgement.is_judged_whole) return text + "not judged";
  text += std::to_string(roots.certified) + " certified, " + std::to_string(roots.distinct) +
          " distinct, " + std::to_string(roots.real) + " real, " + std::to_string(roots.not_real) +
          " not real";
  if (roots.doubled > 0) text += ", " + std::to_string(roots.doubled) + " doubled";
  if (roots.not_roots > 0) text += ", " + std::to_string(roots.not_roots) + " not a root";
  if (!judgement.stand_in.empty()) text += "; with " + judgement.stand_in;
  return text;
}

std::string bounds_text(const Judgement& judgement) {
  std::vector<std::string> bounds;
  for (const RootBound& bound : judgement.bounds) {
    bounds.push_back(to_string(bound.kind) + ' ' +
                     (bound.value ? std::to_string(*bound.value) : "unknown: " + bound.missing));
  }
  return bounds.empty() ? "none on such a system" : joined(bounds, ", ");
}

std::string proof_text(const Judgement& judgement) {
  const RootTally& roots = judgement.roots;
  const std::string distinct = counted(roots.distinct, "distinct certified root");
  if (judgement.proved_by) {
    const std::string exact =
        roots.counted_points == 0
            ? ""
            : " and " + counted(roots.counted_points, "multiple one") + " counted exactly";
    return distinct + exact + " meet " + to_string(*judgement.proved_by) +
           ": no isolated root is missing, proved";
  }
  return "that no isolated root is missing is not proved";
}

/// "1 to 4, 7".
std::string numbers_text(const std::vector<std::size_t>& numbers) {
  std::vector<std::string> parts;
  for (std::size_t begin = 0; begin < numbers.size();) {
    std::size_t end = begin + 1;
    while (end < numbers.size() && numbers[end] == numbers[end - 1] + 1) ++end;
    std::string part = std::to_string(numbers[begin]);
    if (end - begin > 1) {
      part.append(end - begin > 2 ? " to " : ", ").append(std::to_string(numbers[end - 1]));
    }
    parts.push_back(part);
    begin = end;
  }
  return joined(parts, ", ");
}

std::string claims_text(const Judgement& judgement) {
  std::string text = "\nClaim           holds   false   not verifiable\n";
  for (const ClaimTally& tally : judgement.claims) {
    char line[80];
    std::snprintf(line, sizeof line, "  %-12s %6zu  %6zu  %6zu\n", to_string(tally.claim).c_str(),
                  tally.holds, tally.refuted, tally.open);
    text += line;
  }
  return text;
}

std::string refuted_text(const Judgement& judgement) {
  if (judgement.refuted.empty()) return "";
  std::string text = "\nFalse\n";
  for (const Finding& finding : judgement.refuted) {
    text += "  " + (finding.root ? "root " + std::to_string(*finding.root) + ", " : "") +
            to_string(finding.claim) + ": " + finding.why + '\n';
  }
  return text;
}

std::string open_text(const Judgement& judgement) {
  if (judgement.open.empty()) return "";
  using Reason = std::pair<ClaimKind, std::string>;
  std::vector<Reason> order;
  std::map<Reason, std::vector<std::size_t>> numbers;
  for (const Finding& finding : judgement.open) {
    const Reason reason{finding.claim, finding.why};
    if (!numbers.contains(reason)) order.push_back(reason);
    std::vector<std::size_t>& list = numbers[reason];
    if (finding.root) list.push_back(*finding.root);
  }
  std::string text = "\nNot verifiable\n";
  for (const Reason& reason : order) {
    const std::vector<std::size_t>& list = numbers[reason];
    if (!list.empty()) {
      text += (list.size() == 1 ? "  root " : "  roots ") + numbers_text(list) + ", ";
    } else {
      text += "  ";
    }
    text += to_string(reason.first) + ": " + reason.second + '\n';
  }
  return text;
}

}  // namespace

std::string check_text(const Judgement& judgement, const JudgedFiles& files) {
  const std::string form =
      judgement.form == ClaimForm::solution_list ? "PHCpack's solution list" : "JSON of solve";
  std::string text = files.result + " (" + form + ") judged by " + files.system + "\n\n";
  text += "Roots     " + roots_text(judgement) + '\n';
  text += "Bounds    " + bounds_text(judgement) + '\n';
  text += "Complete  " + proof_text(judgement) + '\n';
  text += kShared;
  text += claims_text(judgement) + refuted_text(judgement) + open_text(judgement);
  if (judgement.interrupted) text += "\nInterrupted: not every claim was judged.\n";
  if (!judgement.holds()) {
    return text + '\n' + counted(judgement.refuted.size(), "claim does", "claims do") +
           " not hold.\n";
  }
  text += "\nEvery claim that can be verified holds.\n";
  if (judgement.unverified_proofs > 0) {
    text += counted(judgement.unverified_proofs, "claim of a proof", "claims of a proof") +
            " cannot be verified.\n";
  }
  return text;
}

}  // namespace moivre
