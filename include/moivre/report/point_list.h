// SPDX-License-Identifier: MIT
// Which points does this file list? Start points of one's own, or roots written down earlier.
//
// Three forms, told apart by content; points are numbered from 0 in the file's order:
//   PHCpack's solution list   "solution 1 :" ... "the solution for t :" ... "x : re im" ... "== err
//                             : ..."; other text between is skipped
//   a table with a head       as `moivre solve --csv` writes it: commas; columns NAME.re and
//                             NAME.im, others are skipped
//   plain numbers             one point per line, re im of each variable in turn, between blanks or
//                             commas; # begins a comment
#pragma once

#include <string>
#include <vector>

#include "moivre/expression/source.h"
#include "moivre/numeric/complex.h"

namespace moivre {

/// Points with their coordinates in the order of `variables`. Throws ParseError with every fault.
std::vector<Point> read_points(const Source& source, const std::vector<std::string>& variables);

}  // namespace moivre
