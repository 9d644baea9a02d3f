// SPDX-License-Identifier: MIT
// The table of remedies, and the loop over it.
#include "settle.h"

#include "beside_sets.h"
#include "clusters.h"
#include "completeness.h"
#include "isolated.h"
#include "judge.h"
#include "missing_roots.h"
#include "more_digits.h"

namespace moivre {
namespace {

constexpr Remedy kRemedies[]{
    isolate_roots,            // any, where one unknown is left: all roots by proof
    part_in_double_double,    // several paths at a singular end: simple roots near to each other?
    raise_failed_paths,       // no end, by precision: many paths at once in double-double
    follow_in_smaller_steps,  // any: smaller steps, by the other tracker
    raise_to_double_double,   // any, ends alone without a proof, what is in doubt by that
    give_missing_roots,       // fewer roots than exact algebra counts: the ring has the others
    raise_to_more_digits,     // any: 100 and 300 digits, as long as they help
    part_clusters_in_more_bits,  // several paths at one place that no count confirms: simple roots?
    isolate_roots,               // as many simple roots may be proved now as there are
    look_beside_sets,            // sheets that meet on a set: a root beside it?
    look_at_blurred_sets,       // ends on a set on which F vanishes but for rounding: is there one?
    part_clusters,              // a multiple root, or several? By proofs and local rings
    raise_after_contradiction,  // the ends are not as many as exact algebra counts
};

/// The certified roots, and the multiple ones to which whole cycles lead, are as many as exact
/// algebra counts: what is open leads to none. No proof: of a multiple root the paths tell that it
/// is one.
bool settle_by_count(Run& run) {
  if (run.interrupted || !run.waiting.empty() || !are_as_counted(run)) return false;
  for (const auto& [path, question] : judge_ends_alone(run).open) run.table.leave(path);
  return true;
}

}  // namespace

bool is_settled(Run& run) {
  run.is_settled = settle_by_bound(run) || settle_by_count(run);
  return run.is_settled;
}

std::span<const Remedy> remedies() { return kRemedies; }

void settle(Run& run, std::span<const Remedy> table) {
  for (const Remedy remedy : table) {
    if (run.interrupted) return;
    remedy(run);
    if (is_settled(run)) return;
  }
}

}  // namespace moivre
