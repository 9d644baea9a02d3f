// SPDX-License-Identifier: MIT
// Ends where several paths meet, asked of exact algebra one by one, then together.
#include "multiplicities.h"

#include <algorithm>

#include "certificates.h"
#include "coincidence.h"
#include "completeness.h"
#include "exact_roots.h"
#include "judge.h"

namespace moivre {
namespace {

bool is_known(const std::vector<ExactRoot>& exact, const Root& end, std::size_t paths) {
  if (end.is_exact) return true;
  return std::any_of(exact.begin(), exact.end(), [&](const ExactRoot& root) {
    return root.multiplicity == paths && relative_distance(root.x, end.point.x) <= end.tolerance;
  });
}

}  // namespace

void count_ends(Run& run) {
  std::vector<std::vector<std::uint64_t>> multiple;
  for (auto& group : judge(run).roots) {
    const Root& end = run.ledger.roots().at(group.front());
    if (group.size() > 1 && (end.point.simple || !is_on_set(run, end))) {
      multiple.push_back(std::move(group));
    }
  }
  if (multiple.empty()) return;
  const std::vector<ExactRoot> exact = exact_roots(run);
  PathSet left;
  for (const auto& group : multiple) {
    const bool is_one = is_known(exact, run.ledger.roots().at(group.front()), group.size());
    (is_one ? run.counted_ends : left).insert(group.front());
  }
  if (left.empty() || run.interrupted) return;
  look_for_ring(run);
  if (are_as_counted(run)) run.counted_ends.merge(left);
}

}  // namespace moivre
