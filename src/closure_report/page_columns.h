// SPDX-License-Identifier: MIT
// What does the page's script need to plot a designer's quantities?
#pragma once

#include <string>
#include <vector>

#include "moivre/motion/motion.h"
#include "moivre/report/json.h"

namespace moivre {

struct Readings;

/// A value with its velocity and acceleration is one quantity of three series, any other is one of
/// one.
struct PageColumns {
  Json quantities = Json::array();  ///< [{"name", "units": [one or three]}]
  std::vector<std::string> ids;     ///< of branches
  std::vector<Json> series;         ///< of each: [[values, ...] a quantity], null at events
};

/// In the file's unit of angle; angles that turn go on.
PageColumns page_columns(const Readings& readings, const MotionResult& motion,
                         const Mechanism& mechanism);

}  // namespace moivre
