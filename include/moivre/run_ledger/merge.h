// SPDX-License-Identifier: MIT
// What do the ledgers of one run's parts hold together? One ledger, from which the run goes on.
//
// Observations of all are put into one file; what several hold is there once where it came as the
// same outcomes. Results of finished runs are not taken: the run's own command writes them.
#pragma once

#include <string>
#include <vector>

namespace moivre {

/// Puts the observations of `parts` into `ledger`, which is made where there is none. Parts are
/// read one after another; each is taken as a whole, or not. Throws std::invalid_argument where a
/// file is no ledger, damaged, of another format or run, or is being written, and where there is no
/// room.
void merge_ledgers(const std::string& ledger, const std::vector<std::string>& parts);

}  // namespace moivre
