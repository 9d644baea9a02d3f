// SPDX-License-Identifier: MIT
// Bound and completeness of a family that was read, on a member of its own.
#include "judged_claims.h"

#include <string_view>

#include "known_counts.h"
#include "moivre/expression/counted.h"
#include "moivre/family/learn.h"

namespace moivre {
namespace {

constexpr std::string_view kAsTheFileSays = "the file says, unproved: ";

void tell_as_a_claim(Learning& learning) {
  if (!learning.standing.empty() && !learning.standing.starts_with(kAsTheFileSays)) {
    learning.standing.insert(0, kAsTheFileSays);
  }
}

}  // namespace

void judge_claims(Family& family, std::uint64_t draw) {
  Learning& learning = family.learning;
  if (!learning.complete && !learning.bound) return tell_as_a_claim(learning);
  const Point member = generic_member(family, draw);
  if (learning.bound) {
    learning.bound = known_counts(family, member).met;
    if (learning.bound) {
      learning.standing = "proved: the roots are as many as the " +
                          name_in_results(learning.bound->kind) + " allows";
      return;
    }
  }
  tell_as_a_claim(learning);
  const std::optional<std::uint64_t> roots = roots_by_algebra(family, member);
  if (!roots || *roots == family.roots.size()) return;
  learning.complete = false;
  learning.standing = "the file has " + counted(family.roots.size(), "root") +
                      ", and exact algebra counts " + std::to_string(*roots) +
                      " of a generic member: roots are missing";
}

}  // namespace moivre
