// SPDX-License-Identifier: MIT
// Candidates, each counted once.
#include "exact_roots.h"

#include <algorithm>
#include <iterator>

#include "moivre/polynomial/local_multiplicity.h"

namespace moivre {

namespace {

void look_at(Run& run, const Point& x) {
  const bool is_known = std::any_of(run.looked_at.begin(), run.looked_at.end(),
                                    [&](const ExactRoot& known) { return known.x == x; });
  if (!is_known) run.looked_at.push_back({x, exact_multiplicity(run.setting.f, x)});
}

}  // namespace

std::uint64_t exact_multiplicity(const System& f, const Point& x) {
  std::vector<Coefficient> exact;
  for (const Complex& xi : x) exact.push_back({Rational(xi.real()), Rational(xi.imag())});
  return local_multiplicity(f, exact).value_or(0);
}

std::vector<ExactRoot> exact_roots(Run& run) {
  if (!run.setting.certify_program) return {};
  look_at(run, Point(run.setting.f.variables.size()));
  for (const auto& [path, root] : run.ledger.roots()) {
    if (!root.point.simple) look_at(run, root.point.x);
  }
  std::vector<ExactRoot> roots;
  std::copy_if(run.looked_at.begin(), run.looked_at.end(), std::back_inserter(roots),
               [](const ExactRoot& root) { return root.multiplicity > 1; });
  return roots;
}

}  // namespace moivre
