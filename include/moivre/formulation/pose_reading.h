// SPDX-License-Identifier: MIT
// Where does a root of the closure polynomials put the bodies of a spatial mechanism?
//
// Bodies that cannot move relative to each other are one group; group 0 is the ground's. Groups are
// placed one after another, in one of two ways:
//   by a pose    relative to a placed group: eight polynomials, a dual quaternion (real factors do
//                not matter)
//   by points    two or three of its points coincide with points of placed groups: a link that was
//                left out of the polynomials.
//                With two points the turn about their line is the one of mechanism/spins.h.
// q of each body: [x, y, z, rotation vector], the vector no longer than pi.
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <string>
#include <vector>

#include "moivre/numeric/complex.h"
#include "moivre/numeric/dual_quaternion.h"
#include "moivre/polynomial/system.h"

namespace moivre {

struct PoseReading {
  struct PointPair {
    Eigen::Vector3d here;   ///< in the group's own frame
    std::size_t group = 0;  ///< a placed one
    Eigen::Vector3d there;  ///< in its frame
  };
  struct Placement {
    std::size_t group = 0;
    std::size_t parent = 0;  ///< of a placement by a pose
    DualQuaternion<Polynomial> relative;
    std::vector<PointPair> points;  ///< not empty: by points
  };
  struct BodyPose {
    std::size_t group = 0;
    DualQuaternion<double> in_group;  ///< the body's frame in its group's
  };

  std::size_t groups = 0;
  std::vector<Placement> placements;
  std::vector<BodyPose> bodies;  ///< all but the ground
};

/// q of a root; meaningful where the root is real.
Eigen::VectorXd coordinates_of_root(const PoseReading& reading, const Point& root);

}  // namespace moivre
