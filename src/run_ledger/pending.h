// SPDX-License-Identifier: MIT
// What of a run is not committed yet?
//
// Private to the module.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>

#include "moivre/numeric/bytes.h"
#include "moivre/numeric/observations.h"

namespace moivre {

/// What came in since the last commit, of one list.
struct Chunk {
  ByteWriter outcomes;
  std::int64_t jobs = 0, roots = 0, at_infinity = 0, failed = 0;

  void add(const JobOutcome& outcome) {
    outcomes.put(outcome.job);
    outcomes.put(std::string_view(outcome.bytes));
    ++jobs;
    roots += outcome.kind == OutcomeKind::root ? 1 : 0;
    at_infinity += outcome.kind == OutcomeKind::at_infinity ? 1 : 0;
    failed += outcome.kind == OutcomeKind::failed ? 1 : 0;
  }
};

struct Told {
  std::uint64_t done = 0, total = 0, roots = 0;
};

/// What of an answer has no whole piece yet.
struct Slot {
  std::int64_t next = 0;
  std::string rest;
};

/// All that waits for a commit.
struct Pending {
  std::map<Fingerprint, Chunk> chunks;
  std::size_t bytes = 0;
  std::optional<Told> told;
};

}  // namespace moivre
