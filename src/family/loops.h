// SPDX-License-Identifier: MIT
// Where do roots of one member go when it becomes another? Followed together; and all that loops of
// members lead to.
//
// Private to the module.
#pragma once

#include "moivre/family/learn.h"
#include "moivre/numeric/observations.h"
#include "root_set.h"

namespace moivre {

/// What follows paths, and until when. Results do not depend on the number of threads.
struct Follower {
  const Tracker& tracker;
  const std::atomic<bool>& stop;
  int threads = 1;
  Observations* observations =
      nullptr;  ///< asked for ends before paths are followed, and told them
};

/// Where each root at `from` arrives at `to`; nullopt where its path broke off, or ends at no
/// regular root.
std::vector<std::optional<Point>> follow_roots(const System& system, const Point& from,
                                               const Point& to, const std::vector<Point>& roots,
                                               const Follower& follower);

struct LoopSearch {
  std::vector<double> sizes;       ///< of the random members
  std::uint64_t first_number = 0;  ///< of the random numbers: other searches take others
  MonodromyOptions options;
};

/// What a search did.
struct LoopCount {
  int loops = 0;
  std::uint64_t paths = 0;
  bool was_cut = false;  ///< a limit of loops or roots ended it while they brought new roots

  LoopCount& operator+=(const LoopCount& other) {
    loops += other.loops;
    paths += other.paths;
    was_cut = was_cut || other.was_cut;
    return *this;
  }
};

/// Adds to `roots`, at `base`, all that loops lead to.
LoopCount go_round_loops(const System& system, const Point& base, const LoopSearch& search,
                         const Follower& follower, RootSet& roots);

}  // namespace moivre
