// SPDX-License-Identifier: MIT
// How is a robot laid out as a mechanism? Names that a mechanism file takes, and frames with all
// joints at zero.
#pragma once

#include <Eigen/Core>
#include <set>
#include <string>
#include <vector>

#include "moivre/urdf/robot.h"

namespace moivre {

struct Layout {
  std::vector<std::string> bodies;  ///< of the links; "ground" the root
  std::vector<std::string> joints;  ///< also the points that a joint ties
  std::vector<Eigen::Matrix3d>
      rotation;                    ///< of each link's frame in the root's, all joints at zero
  std::vector<std::size_t> order;  ///< links, parents before their children
};

Layout layout_of(const Robot& robot);

/// Letters, digits, _ and -; a number behind it where the name is taken. It is taken then.
std::string typed_name(const std::string& name, std::set<std::string>& taken);

}  // namespace moivre
