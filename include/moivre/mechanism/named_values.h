// SPDX-License-Identifier: MIT
// Which coordinates does a user give values by name, and what is q with them? A guess "crank.phi =
// 40" in the file's units.
//
// Angles are taken in the file's unit, degrees or radians, where that is asked for; q has radians.
#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "moivre/mechanism/mechanism.h"

namespace moivre {

struct NamedValue {
  std::string name;  ///< of a coordinate
  double value = 0;
  std::string said;  ///< both as the user wrote them, for messages: "crank.phi=40"
};

enum class AngleUnit { of_the_file, radians };

/// Every broken rule as a sentence: names that are no coordinate, or given twice, values that
/// cannot be worked with.
std::vector<std::string> broken_rules(const Mechanism& mechanism,
                                      const std::vector<NamedValue>& given, AngleUnit unit);

/// A number a coordinate: `base` where none is given. Throws InvalidInput with every broken rule.
Eigen::VectorXd with_values(const Mechanism& mechanism, const std::vector<NamedValue>& given,
                            const Eigen::VectorXd& base, AngleUnit unit);

}  // namespace moivre
