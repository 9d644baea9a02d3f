// SPDX-License-Identifier: MIT
// Which reader fills which part of a Robot? All note faults in the reading.
#pragma once

#include <map>

#include "xml_reading.h"

namespace moivre {

/// Names of links or joints -> their numbers.
using Numbers = std::map<std::string, std::size_t>;

/// A <joint> whose name has been read; its mimic's leader is found afterwards, by read_mimic().
/// Links it names are counted in `links`.
RobotJoint read_joint(XmlReading& reading, const pugi::xml_node& node, const std::string& name,
                      const Numbers& links);
/// The <mimic> of joint `number`.
void read_mimic(XmlReading& reading, const pugi::xml_node& node, std::size_t number,
                const Numbers& joints, Robot& robot);

/// Finds parents, children and the root. Faults: two parents of a link, loops, several roots,
/// mimics that go round in a circle.
void check_tree(XmlReading& reading, const std::vector<pugi::xml_node>& links,
                const std::vector<pugi::xml_node>& joints, Robot& robot);

}  // namespace moivre
