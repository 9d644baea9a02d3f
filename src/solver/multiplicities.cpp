// SPDX-License-Identifier: MIT
// Ends where several paths meet, asked of exact algebra one by one, then together.
#include "multiplicities.h"

#include "completeness.h"
#include "exact_roots.h"
#include "judge.h"

namespace moivre {
void count_ends(Run& run) {
  PathGroups multiple;
  for (const auto& [group, ground] : judge(run).roots) {
    if (ground == Ground::exact || ground == Ground::whole_cycles) multiple.add(group);
  }
  if (multiple.empty()) return;
  const std::vector<ExactRoot> exact = exact_roots(run);
  PathSet left;
  for (const PathGroups::Group group : multiple) {
    const bool is_one = is_counted_by(exact, run.table.roots().at(group.front()), group.size());
    (is_one ? run.counted_ends : left).insert(group.front());
  }
  if (left.empty() || run.interrupted) return;
  look_for_ring(run);
  if (are_as_counted(run)) run.counted_ends.merge(left);
}

}  // namespace moivre
