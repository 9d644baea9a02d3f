// SPDX-License-Identifier: MIT
// From the mechanism to its closures: roots of its closure polynomials, poses of the real ones, and the verdict.
#include "moivre/closures/closures.h"

#include "closure_poses.h"
#include "closure_roots.h"
#include "moivre/expression/refusal.h"
#include "moivre/numeric/stopwatch.h"
#include "moving_pose.h"

namespace moivre {
namespace {

/// All that is known before anything is solved.
ClosureResult described(const ClosureSearch& search) {
  const System& f = search.isotropic.system;
  ClosureResult result;
  result.seed = search.options.solve.seed;
  result.time = search.options.time;
  result.system = {f.variables, degrees(f), total_degree(degrees(f))};
  result.start.why =
      "each group of bodies is solved on its own, once a branch of the groups before it";
  for (StartCount* count :
       {&result.start.counts.total_degree, &result.start.counts.multihomogeneous,
        &result.start.counts.mixed_volume}) {
    count->missing = "each group of bodies has counts of its own";
  }
  result.tracker = search.tracker.kind();
  result.tracker_options = search.tracker.options_in_force();
  result.coordinates = search.phi.dimension();
  result.constraints = search.phi.size() - search.phi.driver_size();
  result.complete = true;
  for (const std::string& name : search.isotropic.repetitions) {
    result.left_out.push_back({name, "it holds an angle that is held already, at the same value"});
  }
  return result;
}

void add_mobility(ClosureSearch& search) {
  ClosureResult& result = search.result;
  if (!result.closures.empty()) {
    result.mobility = mobility(search.phi, result.closures.front().q, search.options.time);
  } else if (result.moves) {
    result.mobility = mobility(search.phi, result.moves->pose, search.options.time);
  }
}

/// Why the search is not complete.
std::string shortfall(const ClosureSearch& search) {
  if (search.undecided_motion) {
    return "undecided: no closure is isolated, and Newton-Raphson came to no real pose from " +
           std::to_string(kMovingStarts) + " starts; there may be none: give a guess, or drivers";
  }
  if (search.lost_images > 0) return "a closure's mirror image is missing: a path was lost";
  if (search.unpolished > 0) return "a real root was found that Newton-Raphson does not confirm";
  return search.stop ? "interrupted: what is finished is reported" : "some paths failed";
}

std::string verdict(const ClosureSearch& search) {
  const ClosureCounts& counts = search.result.counts;
  if (!search.result.complete) return shortfall(search);
  if (search.result.moves) {
    return "moves: the closures form a set of positive dimension though the drivers stand";
  }
  if (search.part_is_complex) {
    return "cannot be assembled: a part of it closes in complex numbers only";
  }
  if (counts.complex == 0) {
    return "cannot be assembled: there is no closure, not even a complex one";
  }
  if (counts.real == 0) {
    return "cannot be assembled: every closure is complex (" + std::to_string(counts.complex) + ")";
  }
  return "every path was decided";
}

void conclude(ClosureSearch& search) {
  if (search.lost_images > 0 || search.unpolished > 0) search.result.complete = false;
  search.result.message = verdict(search);
  for (const std::string& name : search.isotropic.contradictions) {
    search.result.message += "; " + name + " holds an angle that is held at another value already";
  }
}

}  // namespace

ClosureResult find_closures(const Mechanism& mechanism, const Tracker& tracker,
                            const ClosureOptions& options, const std::atomic<bool>& stop) {
  require_drivers(mechanism, options.time);
  require_unbroken(validate(options.solve));
  ClosureSearch search(mechanism, tracker, options, stop);
  const Stopwatch watch;
  search.result = described(search);
  find_roots(search);
  find_poses(search);
  add_mobility(search);
  conclude(search);
  search.result.time_s.total = watch.total();
  return std::move(search.result);
}

}  // namespace moivre
