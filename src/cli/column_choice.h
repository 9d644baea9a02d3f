// SPDX-License-Identifier: MIT
// Which of a designer's quantities are wanted? --columns and --output, for the table, the extremes
// and the page's plots.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "command.h"
#include "moivre/design/readings.h"

namespace moivre {

struct ColumnChoice {
  std::string groups;  ///< as typed: "joints,transmission"; empty: none
  std::vector<std::string> outputs;
};

void add_column_options(CLI::App& app, ColumnChoice& choice);

/// "--columns help".
bool asks_for_help(const ColumnChoice& choice);
/// The groups, and what can be an output of this mechanism.
std::string columns_help(const Mechanism& mechanism);

/// Throws std::invalid_argument where a group is not known, with those that are.
std::vector<QuantityGroup> groups_of(const ColumnChoice& choice);

/// nullptr where no columns are wanted. Throws std::invalid_argument where an output is not known.
std::unique_ptr<const QuantityReader> make_reader(const Mechanism& mechanism,
                                                  const ColumnChoice& choice);

}  // namespace moivre
