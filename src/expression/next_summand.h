// SPDX-License-Identifier: MIT
// Where does a sum go on behind a fault? At its next summand, outside all parentheses: so that one
// fault hides no other.
#pragma once

#include <cstddef>
#include <optional>
#include <string_view>
#include <vector>

namespace moivre {

struct NextSummand {
  std::optional<std::size_t> begin;     ///< behind its sign; none: the text ends before
  std::vector<std::size_t> unopened;    ///< each `)` passed that closes nothing
  std::optional<std::size_t> unclosed;  ///< the innermost `(` that the text's end leaves open
};

/// Looks in `text` from `from` on, where the parentheses at `open` are not closed yet. A sign
/// inside a number (1e-5) is none of a sum.
NextSummand next_summand(std::string_view text, std::size_t from, std::vector<std::size_t> open);

}  // namespace moivre
