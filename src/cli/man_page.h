// SPDX-License-Identifier: MIT
// What does `man moivre-solve` show? One page for each command, in the troff of man(7).
#pragma once

#include <string>

#include "manual.h"

namespace moivre {

/// "moivre-solve", of `moivre family learn` "moivre-family-learn".
std::string page_name(const ManualCommand& command);

/// The page; `program` is `moivre` itself, whose other pages are named at the end. Throws
/// std::logic_error when manual_text.cpp says nothing of the command.
std::string man_page(const ManualCommand& command, const ManualCommand& program,
                     const std::string& version);

}  // namespace moivre
