// SPDX-License-Identifier: MIT
// The notes, in the order in which claims were judged.
#include "verdicts.h"

#include <algorithm>
#include <cstdio>

namespace moivre {

std::string to_string(ClaimKind kind) {
  constexpr const char* names[] = {
      "system",   "reduced",   "start",        "paths",        "complete",   "root",
      "accuracy", "distinct",  "real",         "multiplicity", "residual",   "condition",
      "digits",   "certified", "completeness", "bound",        "inequality", "plane"};
  return names[static_cast<std::size_t>(kind)];
}

ClaimTally& Verdicts::tally(ClaimKind claim) {
  std::vector<ClaimTally>& claims = judgement_.claims;
  const auto place = std::lower_bound(claims.begin(), claims.end(), claim,
                                      [](const ClaimTally& t, ClaimKind k) { return t.claim < k; });
  if (place != claims.end() && place->claim == claim) return *place;
  return *claims.insert(place, ClaimTally{claim});
}

void Verdicts::hold(ClaimKind claim) { ++tally(claim).holds; }

void Verdicts::refute(ClaimKind claim, const std::string& why, std::optional<std::size_t> root) {
  ++tally(claim).refuted;
  judgement_.refuted.push_back({claim, root, why});
}

void Verdicts::leave_open(ClaimKind claim, const std::string& why,
                          std::optional<std::size_t> root) {
  ++tally(claim).open;
  judgement_.open.push_back({claim, root, why});
}

void Verdicts::leave_proof_open(ClaimKind claim, const std::string& why,
                                std::optional<std::size_t> root) {
  ++judgement_.unverified_proofs;
  leave_open(claim, why, root);
}

void Verdicts::judge(ClaimKind claim, bool holds, const std::string& why,
                     std::optional<std::size_t> root) {
  if (holds) {
    hold(claim);
  } else {
    refute(claim, why, root);
  }
}

std::string rough(double x) {
  char text[16];
  std::snprintf(text, sizeof text, "%.2g", x);
  return text;
}

std::string root_name(std::size_t number) { return "root " + std::to_string(number); }

}  // namespace moivre
