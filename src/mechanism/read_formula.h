// SPDX-License-Identifier: MIT
// How does a string of the file become a formula? Parsed and resolved, its faults at their place in
// the file.
#pragma once

#include "toml_reading.h"

namespace moivre {

/// What is refused in an equation before it is parsed: inequalities, primes. Returns whether there
/// was one.
bool refuse_constraint(Reading& reading, const toml::node& node, const std::string& text);

/// `text`, or `left = right` as left - right, parsed; nothing and faults where it cannot be.
std::optional<Expression> read_expression(Reading& reading, const toml::node& node,
                                          const std::string& text);

/// Of a text, perhaps with `=`, that cannot be parsed: appends the unknown names of the summands
/// that can be, so that a fault of form hides none of these.
void check_names(Reading& reading, const toml::node& node, const std::string& text,
                 const Names& names);

/// Expression and names to a formula; nothing and faults where a name is unknown.
std::optional<Formula> read_formula(Reading& reading, const Expression& expression,
                                    const Names& names);

}  // namespace moivre
