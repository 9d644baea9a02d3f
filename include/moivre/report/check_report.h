// SPDX-License-Identifier: MIT
// How is a judgement reported? As a short table for people, and as JSON.
#pragma once

#include <string>

#include "moivre/check/check.h"

namespace moivre {

/// Which files were judged.
struct JudgedFiles {
  std::string system;
  std::string result;
};

/// Roots, bounds, a line for each kind of claim, and one for each claim that does not hold. A
/// reason why something cannot be verified is given once for all roots.
std::string check_text(const Judgement& judgement, const JudgedFiles& files);
std::string check_json(const Judgement& judgement, const JudgedFiles& files);

}  // namespace moivre
