// SPDX-License-Identifier: MIT
// What has been found so far? A note for each claim that was judged.
#pragma once

#include "moivre/check/check.h"

namespace moivre {

class Verdicts {
 public:
  explicit Verdicts(Judgement& judgement) : judgement_(judgement) {}

  void hold(ClaimKind claim);
  void refute(ClaimKind claim, const std::string& why,
              std::optional<std::size_t> root = std::nullopt);
  void leave_open(ClaimKind claim, const std::string& why,
                  std::optional<std::size_t> root = std::nullopt);
  /// What is said to be proved is not proved here.
  void leave_proof_open(ClaimKind claim, const std::string& why,
                        std::optional<std::size_t> root = std::nullopt);
  /// Holds, or is refuted for the reason.
  void judge(ClaimKind claim, bool holds, const std::string& why,
             std::optional<std::size_t> root = std::nullopt);

  Judgement& judgement() { return judgement_; }

 private:
  ClaimTally& tally(ClaimKind claim);

  Judgement& judgement_;
};

/// Two digits, as 1.3e-15.
std::string rough(double x);
/// "root 3".
std::string root_name(std::size_t number);

}  // namespace moivre
