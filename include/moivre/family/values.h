// SPDX-License-Identifier: MIT
// Which members are requested? Values typed as "a=1, b=2/3", or a table with a column for each
// parameter.
//
// A value is an expression whose only name is i, the imaginary unit: 3.1, 1/3, 2e-3 - i. It is
// exact; in a table it is rounded to double.
// Every fault is named: in one std::invalid_argument, or, of a table, in one ParseError with line
// and column.
#pragma once

#include "moivre/expression/source.h"
#include "moivre/family/family.h"

namespace moivre {

/// Throws std::invalid_argument: what is no number, unknown names, names given twice, and every
/// parameter without a value.
ParameterValues values_at(const Family& family, const std::string& text);

/// Members, a row each. The head names the parameters, in any order; columns are separated by
/// commas. Blank lines and lines that begin with # are skipped.
std::vector<Point> read_members(const Source& source, const Family& family);

}  // namespace moivre
