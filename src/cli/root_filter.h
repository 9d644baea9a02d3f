// SPDX-License-Identifier: MIT
// How are wanted roots chosen on the command line? --real, --positive, --nonzero, --box "x=0:1".
#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

#include "moivre/solver/filter.h"

namespace moivre {

struct FilterChoice {
  RootFilter flags;              ///< without its box
  std::vector<std::string> box;  ///< as typed
};

void add_filter_options(CLI::App& app, FilterChoice& choice);

/// Throws std::invalid_argument with every range that is none.
RootFilter filter_of(const FilterChoice& choice);

}  // namespace moivre
