// SPDX-License-Identifier: MIT
// Bound and completeness of a family that was read, on a member of its own.
#include "judged_claims.h"

#include <utility>

#include "family_sentences.h"
#include "known_counts.h"
#include "moivre/family/learn.h"

namespace moivre {
namespace {

void tell_as_a_claim(Learning& learning) {
  learning.standing = standing_as_a_claim(std::move(learning.standing));
}

}  // namespace

void judge_claims(Family& family, std::uint64_t draw) {
  Learning& learning = family.learning;
  if (!learning.complete && !learning.bound) return tell_as_a_claim(learning);
  const Point member = generic_member(family, draw);
  if (learning.bound) {
    learning.bound = known_counts(family, member).met;
    if (learning.bound) {
      learning.standing = standing_by_bound(learning.bound->kind);
      return;
    }
  }
  tell_as_a_claim(learning);
  const std::optional<std::uint64_t> roots = roots_by_algebra(family, member);
  if (!roots || *roots == family.roots.size()) return;
  learning.complete = false;
  learning.standing = standing_of_file_refuted(family.roots.size(), *roots);
}

}  // namespace moivre
