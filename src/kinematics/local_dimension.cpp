// SPDX-License-Identifier: MIT
// Ranks where they decide, and else planes moved away from the pose.
#include "moivre/kinematics/local_dimension.h"

#include <Eigen/Core>
#include <algorithm>

#include "moivre/kinematics/own_units.h"
#include "slicing.h"

namespace moivre {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

// Two steps: a set that turns back before the longer one is met by the shorter. Beside an isolated
// pose of multiplicity 7 Phi stays near 0.02^7 = 1e-12 of its terms, above rounding.
constexpr double kSteps[] = {0.1, 0.02};
constexpr int kAgreeing = 3;

/// Do most slices by d planes at this step meet the poses?
bool meets(const Slicing& slicing, Index d, double step) {
  int found = 0;
  for (int slice = 0; slice < Slicing::kSlices; ++slice) {
    found += slicing.pose_on(d, step, slice).has_value();
  }
  return found >= kAgreeing;
}

}  // namespace

LocalDimension local_dimension(const Phi& phi, const VectorXd& q, double t, std::uint64_t seed) {
  require_place(phi, q, t);
  const Index rank = rank_of(phi, phi.jacobian(q, t));
  const Index tangent = phi.dimension() - rank;
  if (tangent == 0) return {0, "the constraints fix every direction at this pose"};
  if (rank == phi.size()) {
    return {tangent, "the constraints are independent at a pose, and fewer than the coordinates"};
  }
  const Slicing slicing(phi, q, t, seed);
  // In units of their own rows and coordinates constraints may be independent where they are not as
  // they stand.
  for (Index d = std::min(tangent, slicing.directions()); d > 0; --d) {
    for (const double step : kSteps) {
      if (meets(slicing, d, step)) {
        return {d, "second random slices beside a pose meet the closures again"};
      }
    }
  }
  return {0, "second random slices beside this pose meet no closure"};
}

VectorXd generic_pose(const Phi& phi, const VectorXd& q, double t, std::uint64_t seed) {
  const LocalDimension local = local_dimension(phi, q, t, seed);
  Index highest = rank_of(phi, phi.jacobian(q, t));
  // Then as many rows are independent as a set of this dimension allows.
  if (local.dimension == 0 || highest == phi.dimension() - local.dimension) return q;
  VectorXd generic = q;
  const Slicing slicing(phi, q, t, seed);
  for (const double step : kSteps) {
    for (int slice = 0; slice < Slicing::kSlices; ++slice) {
      const auto z = slicing.pose_on(local.dimension, step, slice);
      if (!z) continue;
      const VectorXd beside = slicing.q_of(*z);
      const Index rank = rank_of(phi, phi.jacobian(beside, t));
      if (rank <= highest) continue;
      highest = rank;
      generic = beside;
    }
  }
  return generic;
}

}  // namespace moivre
