// SPDX-License-Identifier: MIT
// Which rules does a family break that was not learned here, or was changed since?
#include <cmath>

#include "moivre/family/family.h"

namespace moivre {
namespace {

using Rules = std::vector<std::string>;

void check_point(const Point& x, std::size_t size, const std::string& what, Rules& broken) {
  if (x.size() != size) {
    broken.push_back(what + " has " + std::to_string(x.size()) + " numbers, not " +
                     std::to_string(size));
  } else if (!std::isfinite(max_norm(x))) {
    broken.push_back(what + " has a number that is not finite");
  }
}

}  // namespace

std::vector<std::string> broken_rules_of_unlearned(const Family& family) {
  Rules broken = broken_rules(family.system);
  if (family.system.polynomials.size() > family.system.variables.size()) {
    broken.emplace_back("a family has no more equations than unknowns and parameters");
    return broken;
  }
  if (family.sizes.size() != family.parameters()) {
    broken.push_back("a family has a size for each of its " + std::to_string(family.parameters()) +
                     " parameters, not " + std::to_string(family.sizes.size()));
  }
  for (const double size : family.sizes) {
    if (!(size > 0) || !std::isfinite(size)) {
      broken.emplace_back("the size of a parameter must be finite and above 0");
    }
  }
  return broken;
}

std::vector<std::string> broken_rules(const Family& family) {
  Rules broken = broken_rules_of_unlearned(family);
  if (!broken.empty()) return broken;
  check_point(family.generic, family.parameters(), "the generic member", broken);
  for (std::size_t k = 0; k < family.roots.size(); ++k) {
    check_point(family.roots[k], family.unknowns(), "root " + std::to_string(k), broken);
  }
  return broken;
}

}  // namespace moivre
