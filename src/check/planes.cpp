// SPDX-License-Identifier: MIT
// Is every equation zero where the unknowns that a result names are? By looking at each term.
#include <algorithm>

#include "bench.h"
#include "moivre/expression/joined.h"
#include "moivre/polynomial/coordinate_planes.h"

namespace moivre {
namespace {

/// Ascending, without doubles; nullopt where a name is none of an unknown.
std::optional<std::vector<std::uint32_t>> unknowns_of(const System& f, const PlaneClaim& plane) {
  std::vector<std::uint32_t> zeros;
  for (const std::string& name : plane.zero) {
    const auto found = std::find(f.variables.begin(), f.variables.end(), name);
    if (found == f.variables.end()) return std::nullopt;
    zeros.push_back(static_cast<std::uint32_t>(found - f.variables.begin()));
  }
  std::sort(zeros.begin(), zeros.end());
  zeros.erase(std::unique(zeros.begin(), zeros.end()), zeros.end());
  return zeros;
}

bool is_zero_throughout(const Polynomial& p, const std::vector<std::uint32_t>& zeros) {
  return on_plane(p, zeros).terms.empty();
}

/// Empty where the claim is right.
std::string fault_of(const System& f, const PlaneClaim& plane) {
  const auto zeros = unknowns_of(f, plane);
  if (!zeros) return "it names what is no unknown";
  for (std::size_t k = 0; k < f.polynomials.size(); ++k) {
    if (!is_zero_throughout(f.polynomials[k], *zeros)) {
      return "equation " + std::to_string(k + 1) + " is not zero on all of it";
    }
  }
  for (const Polynomial& denominator : f.denominators) {
    if (is_zero_throughout(denominator, *zeros)) return "a denominator is zero on all of it";
  }
  const std::uint64_t dimension = plane_dimension(f, *zeros);
  if (dimension == 0) return "it is no set of dimension 1 or more";
  if (dimension != plane.dimension) {
    return "its dimension is " + std::to_string(dimension) + ", not " +
           std::to_string(plane.dimension);
  }
  return "";
}

}  // namespace

void judge_planes(const System& f, const Claims& claims, Verdicts& verdicts) {
  for (const PlaneClaim& plane : claims.planes) {
    const std::string fault = fault_of(f, plane);
    verdicts.judge(ClaimKind::plane, fault.empty(),
                   "where " + joined(plane.zero, ", ") + " = 0: " + fault);
  }
}

}  // namespace moivre
