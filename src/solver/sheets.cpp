// SPDX-License-Identifier: MIT
// Counts multiplied, lists repeated.
#include "sheets.h"

#include <algorithm>
#include <limits>
#include <stdexcept>

#include "facts.h"
#include "refine.h"
#include "solver_sentences.h"

namespace moivre {
namespace {

bool fits(std::uint64_t sheets, std::uint64_t count) {
  return count <= std::numeric_limits<std::uint64_t>::max() / sheets;
}

void multiply(std::uint64_t sheets, StartCount& count) {
  if (!count.paths) return;
  if (fits(sheets, *count.paths)) {
    *count.paths *= sheets;
  } else {
    count = {std::nullopt, why_count_is_too_large()};
  }
}

void multiply(std::uint64_t sheets, StartFacts& start) {
  start.paths *= sheets;
  for (StartCount* count :
       {&start.counts.total_degree, &start.counts.multihomogeneous, &start.counts.mixed_volume}) {
    multiply(sheets, *count);
  }
}

/// Each entry `sheets` times in a row; none where these were too many.
template <class Entry>
std::vector<Entry> repeated(std::uint64_t sheets, const std::vector<Entry>& entries) {
  std::vector<Entry> all;
  if (entries.size() > kMostListed / sheets) return all;
  all.reserve(sheets * entries.size());
  for (const Entry& entry : entries) all.insert(all.end(), sheets, entry);
  return all;
}

std::vector<FailedPath> renumbered(std::uint64_t sheets, const std::vector<FailedPath>& failures) {
  std::vector<FailedPath> all = repeated(sheets, failures);
  for (std::size_t k = 0; k < all.size(); ++k) {
    all[k].path = sheets * all[k].path + k % sheets;
  }
  return all;
}

void multiply(std::uint64_t sheets, Refiner& refiner, Solution& root) {
  root.path *= sheets;
  root.multiplicity *= sheets;
  root.singular = true;
  root.winding = repeated(sheets, root.winding);
  root.residual = refiner.residual(root.x);
}

}  // namespace

void take_back_powers(const System& f, const PowerFree& bases, SolveResult& result) {
  const std::uint64_t sheets = bases.sheets;
  if (!fits(sheets, std::max(result.paths.tracked, result.start.paths))) {
    throw std::overflow_error("the number of paths exceeds 64 bits");
  }
  result.system = facts_of(f);
  multiply(sheets, result.start);
  result.paths *= sheets;
  Refiner refiner(make_refiner_program(f, std::vector<double>(f.variables.size(), 1.0)));
  for (auto* const points : {&result.solutions, &result.on_sets}) {
    for (Solution& root : *points) multiply(sheets, refiner, root);
  }
  if (result.bound && !result.bound->is_of_points()) result.bound->value *= sheets;
  result.failures = renumbered(sheets, result.failures);
  result.ledger = repeated(sheets, result.ledger);
  result.left_out.push_back(exponents_left_out(bases));
}

}  // namespace moivre
