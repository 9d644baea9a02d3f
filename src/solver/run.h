// SPDX-License-Identifier: MIT
// What has become of the paths so far? The state of one solve, between its setting and its result.
//
// A path is not yet followed to its end (`waiting`, where it was followed at all), among `ends`
// (finite, but not yet a root of the system as given), or in the table; one that is followed again
// stays there until its new end is judged. Who changes what: tracking.h and ends.h bring paths in,
// the remedies of settle.h have them followed again, or enter and refute ends; judge.h only reads;
// account.h closes.
#pragma once

#include <map>
#include <optional>
#include <set>
#include <vector>

#include "effort.h"
#include "moivre/algebra/quotient_ring.h"
#include "moivre/endgame/endgame.h"
#include "path_table.h"
#include "point_hash.h"
#include "setting.h"

namespace moivre {

/// A search that was given up is made again where twice as much is worth it.
class Budget {
 public:
  /// Whether to search now, at no more than `worth`.
  bool allows(std::uint64_t worth);

 private:
  std::uint64_t spent_ = 0;
};

/// A root that is known exactly, and how often F has it (exact_roots.h).
struct ExactRoot {
  Point x;                  ///< rounded to double
  bool is_rounded = false;  ///< x is not the root itself
  std::uint64_t multiplicity = 0;
};

/// What is known of proved bounds on the number of isolated roots (completeness.h).
struct Bounds {
  std::optional<MetBound> met;
  bool lacks_paths = false;  ///< fewer are left than the roots that are known exactly need
  Budget for_volume, for_ring, for_points, for_strata, for_roots;
  std::optional<std::uint64_t> volume;  ///< the (stable) mixed volume of what is tracked
  QuotientRing ring;                    ///< of what is tracked
  std::optional<std::uint64_t> points;  ///< different roots of what is tracked
  std::optional<std::uint64_t>
      asked_by_strata;  ///< points of which it was asked whether they are all
};

/// By the candidate, real and imaginary part of each coordinate in turn; multiplicity 0: it is no
/// root, or nothing can be said.
using ExactCandidates = std::map<std::vector<Rational>, ExactRoot>;

/// Thrown where an answer would take its time and the run is to stop. What is entered so far
/// stands.
struct Interrupted {};

struct Run {
  explicit Run(const Setting& the_setting) : setting(the_setting) {}

  const Setting& setting;
  PathTable table;
  Effort effort = Effort::all_steps;  ///< less only while track_all() or track_waiting() is at work
  /// Came to no verdict with less effort than all; from an empty start of the endgame a path is
  /// followed from its start again.
  EndgameStarts waiting;
  std::vector<std::pair<std::uint64_t, PathEnd>> ends;  ///< finite, to be refined
  /// Of the points over one t to which paths have gone back from ends that circles have shown.
  PointHashes sheets;
  Bounds bounds;
  ExactCandidates looked_at;                  ///< each candidate for an exact root once
  std::vector<ExactRoot> ring_roots;          ///< all multiple roots, where the ring tells them
  std::set<std::vector<double>> looked_near;  ///< points whose candidates were looked at
  /// The first path of each multiple root whose multiplicity is exact algebra's (multiplicities.h).
  PathSet counted_ends;
  PathSet
      in_double_double;   ///< followed so, one at a time or to no end: once more tells nothing new
  PathSet in_all_digits;  ///< followed by the last of Trackers::finer: once more tells nothing new
  bool is_settled = false;  ///< a count tells that what is open leads to no other root
  StepCount work;
  bool interrupted = false;
  bool out_of_memory = false;  ///< that is why

  /// Throws Interrupted where the run is to stop.
  void require_time() const {
    if (setting.stop.load(std::memory_order_relaxed)) throw Interrupted();
  }
};

/// Whether the root lies on a positive-dimensional set; asked once a root. Throws Interrupted.
SetHere set_of(const Run& run, const Root& root);
bool is_on_set(const Run& run, const Root& root);

}  // namespace moivre
