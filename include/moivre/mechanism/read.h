// SPDX-License-Identifier: MIT
// Which mechanism does this file hold? The reader of Moivre's TOML mechanism files.
//
// Every fault is named in one ParseError, with its line and what to do; a fault of TOML itself ends
// the reading at once.
// Keys by example: docs/mechanism-file.md. An unknown key is a fault that names the nearest known
// one.
#pragma once

#include "moivre/expression/source.h"
#include "moivre/mechanism/mechanism.h"

namespace moivre {

/// Throws ParseError with every fault.
Mechanism read_mechanism(const Source& source);

/// Of a text that a program wrote, a line for each key: faults are told by body, point, joint and
/// key, not by lines that nobody has seen. Throws InvalidInput with every fault.
Mechanism read_mechanism_in_code(const std::string& text);

}  // namespace moivre
