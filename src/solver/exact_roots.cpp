// SPDX-License-Identifier: MIT
// Candidates, each counted once.
#include "exact_roots.h"

#include <algorithm>

#include "certificates.h"
#include "moivre/polynomial/local_multiplicity.h"

namespace moivre {

std::optional<std::uint64_t> exact_multiplicity(const System& f, const Point& x) {
  std::vector<Coefficient> exact;
  for (const Complex& xi : x) exact.push_back({Rational(xi.real()), Rational(xi.imag())});
  return local_multiplicity(f, exact);
}

std::vector<ExactRoot> exact_roots(const Run& run) {
  const Setting& setting = run.setting;
  if (!setting.certify_program) return {};
  std::vector<Point> candidates{Point(setting.f.variables.size())};
  for (const auto& group : groups_of(run)) {
    for (const std::uint64_t path : group) {
      const Refined& end = run.ledger.roots().at(path).point;
      const bool is_new = !end.simple && std::find(candidates.begin(), candidates.end(), end.x) ==
                                             candidates.end();
      if (is_new) candidates.push_back(end.x);
    }
  }
  std::vector<ExactRoot> roots;
  for (Point& x : candidates) {
    const auto multiplicity = exact_multiplicity(setting.f, x);
    if (multiplicity && *multiplicity > 1) roots.push_back({std::move(x), *multiplicity});
  }
  return roots;
}

}  // namespace moivre
