// SPDX-License-Identifier: MIT
// Brings target and start system to common degrees in projective coordinates and compiles both.
#include "moivre/homotopy/homotopy.h"

#include <algorithm>
#include <stdexcept>

#include "moivre/polynomial/homogenize.h"

namespace moivre {
namespace {

HomotopySide make_side(const System& f, const std::vector<std::uint64_t>& degrees) {
  HomotopySide side;
  side.system = homogenize(f, degrees);
  side.tape = make_tape(side.system);
  side.real = is_real(f);
  return side;
}

}  // namespace

Homotopy::Homotopy(const System& f, const System& g) {
  const std::size_t n = f.variables.size();
  if (f.polynomials.size() != n || g.variables.size() != n || g.polynomials.size() != n) {
    throw std::invalid_argument("a homotopy needs two systems of n polynomials in n variables; got " +
                                std::to_string(f.polynomials.size()) + " in " + std::to_string(n) +
                                " and " + std::to_string(g.polynomials.size()) + " in " +
                                std::to_string(g.variables.size()));
  }
  std::vector<std::uint64_t> common = degrees(f);
  const std::vector<std::uint64_t> own = degrees(g);
  for (std::size_t i = 0; i < n; ++i) common[i] = std::max(common[i], own[i]);
  target_ = make_side(f, common);
  start_ = make_side(g, common);
}

}  // namespace moivre
