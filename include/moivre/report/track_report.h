// SPDX-License-Identifier: MIT
// How is a single path reported? One row per step as CSV, everything as JSON, the verdict in a
// sentence.
//
// CSV columns: journey, s, t.re, t.im, NAME.re, NAME.im of each variable, h_before, h_after,
// correction, step, order (solver/trace.h says what they are); infinite coordinates are empty. The
// JSON is shown in docs/json.md.
#pragma once

#include <string>

#include "moivre/solver/trace.h"

namespace moivre {

/// What the user asked for, beside the trace.
struct TrackHeading {
  std::string file;
  std::uint64_t seed = 1;
  std::string from;    ///< file of the start system; empty: the start of solve
  std::string points;  ///< file of its points
};

std::string track_csv(const Trace& trace);
std::string track_json(const Trace& trace, const TrackHeading& heading);
/// "path 3: finite after 24 steps, ..."
std::string track_verdict(const Trace& trace);

}  // namespace moivre
