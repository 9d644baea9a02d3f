// SPDX-License-Identifier: MIT
// How are wanted roots chosen on the command line? --real, --positive, --nonzero, --box "x=0:1",
// --where "x*y > 2", and by conditions in the file.
#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

#include "moivre/solver/filter.h"

namespace moivre {

struct FilterChoice {
  RootFilter flags;                ///< without its box and conditions
  std::vector<std::string> box;    ///< as typed
  std::vector<std::string> where;  ///< as typed
};

void add_filter_options(CLI::App& app, FilterChoice& choice);

/// Without conditions. Throws InvalidInput with every range that is none.
RootFilter filter_of(const FilterChoice& choice);

/// The conditions of the system, then those typed. Throws ParseError where one is none.
std::vector<Condition> conditions_of(const FilterChoice& choice, const System& f);

}  // namespace moivre
