// SPDX-License-Identifier: MIT
// Which reader takes which text format? One file each, behind read_system.
#pragma once

#include <vector>

#include "expand.h"
#include "moivre/expression/source.h"
#include "moivre/polynomial/read.h"
#include "moivre/polynomial/system.h"
#include "statements.h"

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

/// The imaginary unit and pi, by the names that a PHCpack text may give them.
Environment meanings_of_constants();

/// The whole is one name to these readers, perhaps with an index.
bool is_one_name(std::string_view text);

/// Has the text one of the signs <, <=, >, >=?
bool is_condition(std::string_view text);
/// Does each side of its signs parse?
bool parses_as_condition(const Statement& statement);
/// x > 0 is one condition, 0 < x <= 1 two. Unknowns are those in `names`; faults are appended.
void read_condition(const Statement& statement, const Environment& names, System& system,
                    std::vector<Diagnostic>& faults);

/// Parameters stay names, and so do these constants.
ParametricSystem read_parametric_bertini(const Source& source,
                                         const std::vector<std::string>& constants,
                                         std::vector<Diagnostic>& faults);

/// Bertini's words that begin a declaration.
bool is_bertini_keyword(std::string_view word);
/// The text with its `%` comments blanked, every position kept.
std::string without_bertini_comments(std::string text);

}  // namespace moivre
