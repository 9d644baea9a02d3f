// SPDX-License-Identifier: MIT
// Is this process the one that tells, or one of several that only work? Of those that mpirun starts
// rank 0 tells.
//
// One that only works runs the command as the other does, on files that it reads itself, and writes
// nothing: no result, no ledger, no text. Its limit of time is that of the process that tells.
#pragma once

#include "moivre/numeric/observations.h"

namespace moivre {

/// Observations of a run in several processes, which are kept where they are told to be.
class SharedObservations {
 public:
  virtual ~SharedObservations() = default;
  /// Kept in `ledger`, which may be nullptr.
  virtual Observations* kept_in(Observations* ledger) = 0;
};

struct ProcessRole {
  bool tells = true;
  SharedObservations* shared = nullptr;  ///< nullptr: this process is alone
};

const ProcessRole& process_role();
/// Before any command runs.
void set_process_role(const ProcessRole& role);

}  // namespace moivre
