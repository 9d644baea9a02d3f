// SPDX-License-Identifier: MIT
// How far is a joint turned or slid? A number as it is typed on the command line: radians or
// metres, or with a unit behind it: 30deg, 0.5rad, 0.2m, 120mm.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace moivre {

struct TypedJointValue {
  double value = 0;  ///< radians or metres
  std::string unit;  ///< as typed; empty where there is none
};

/// Nothing where it is no finite number, or another unit stands behind it.
std::optional<TypedJointValue> read_joint_value(std::string_view text);

/// What is wrong with this unit for a joint that slides, or turns; empty where nothing is.
std::string unit_fault(const TypedJointValue& value, bool is_slide);

}  // namespace moivre
