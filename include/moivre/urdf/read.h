// SPDX-License-Identifier: MIT
// Which robot does this URDF file hold? Links and joints of a <robot>, with every fault named at
// its line.
//
// Read are type, parent, child, origin, axis, limit and mimic of <joint>, and the name of <link>.
// Everything else (shapes, masses) is ignored. One ParseError has every fault, each with its line
// and what to do. A fault of the XML itself ends the reading at once.
// Entities of a DOCTYPE are not expanded and nothing outside the file is opened: a DOCTYPE is
// refused.
// Edges: an axis that is absent is x; an origin that is absent is none; a limit's bounds that are
// absent are 0; the zero axis of a fixed joint is taken. At most 16 MB and 20,000 links and joints.
// Not supported: xacro (run it first), quat_xyzw, planar and floating joints, encodings other than
// UTF-8.
#pragma once

#include "moivre/expression/source.h"
#include "moivre/urdf/robot.h"

namespace moivre {

/// Throws ParseError with every fault.
Robot read_urdf(const Source& source);

/// Whether the text begins as XML does: "<", behind blanks.
bool looks_like_xml(const std::string& text);

}  // namespace moivre
