// SPDX-License-Identifier: MIT
// Which links and joints of a robot does a user mean? Links by name, the tip, and joints that are
// held at a value.
//
// A held joint stands at its value; joints that mimic it, and those that it mimics, are held with
// it.
// What cannot be is added to `faults`, each a sentence with the links or joints to choose from.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "moivre/urdf/robot.h"

namespace moivre {

/// The names, and "..." where they are too many for a message.
std::string listed_names(std::vector<std::string> names);

/// `otherwise` without a name, and with a fault where there is no such link.
std::size_t find_link(const Robot& robot, const std::optional<std::string>& name,
                      std::size_t otherwise, std::vector<std::string>& faults);
/// Without a name the only leaf; a fault where there are several.
std::size_t find_tip(const Robot& robot, const std::optional<std::string>& name,
                     std::vector<std::string>& faults);

void check_held(const Robot& robot, const std::vector<HeldJoint>& held,
                std::vector<std::string>& faults);
/// The value at which the joint is held, itself or by one that moves together with it; nothing
/// where it is free.
std::optional<double> held_value(const Robot& robot, std::size_t joint,
                                 const std::vector<HeldJoint>& held);

}  // namespace moivre
