// SPDX-License-Identifier: MIT
// Which reader takes which text format? One file each, behind read_system.
#pragma once

#include <vector>

#include "moivre/expression/source.h"
#include "moivre/polynomial/read.h"
#include "moivre/polynomial/system.h"

namespace moivre {

/// The text must hold something and be text; faults are appended, and the system is of no use when
/// there are any.
System read_phcpack(const Source& source, std::vector<Diagnostic>& faults);
System read_bertini(const Source& source, std::vector<Diagnostic>& faults);
System read_msolve(const Source& source, std::vector<Diagnostic>& faults);
/// Its parameters are the last unknowns.
ParametricSystem read_julia(const Source& source, std::vector<Diagnostic>& faults);

/// Does the text, without comments, begin as msolve's does, or hold HomotopyContinuation.jl's
/// declarations?
bool looks_like_msolve(std::string_view text);
bool looks_like_julia(std::string_view text);

/// Parameters stay names, and so do these constants.
ParametricSystem read_parametric_bertini(const Source& source,
                                         const std::vector<std::string>& constants,
                                         std::vector<Diagnostic>& faults);

/// Bertini's words that begin a declaration.
bool is_bertini_keyword(std::string_view word);
/// The text with its `%` comments blanked, every position kept.
std::string without_bertini_comments(std::string text);

}  // namespace moivre
