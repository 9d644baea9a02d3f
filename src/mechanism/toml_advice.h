// SPDX-License-Identifier: MIT
// What did the typist mean where a file is no TOML? The parser's fault, with what to do about it,
// where the slip is.
//
// The parser notices a missing bracket only at the next line: the fault is placed at the end of the
// line that lacks it.
#pragma once

#include <string>

#include "moivre/expression/source.h"

namespace moivre {

/// `fault`: the parser's words, `at`: where it stopped.
Diagnostic toml_fault(const Source& source, const SourcePosition& at, const std::string& fault);

}  // namespace moivre
