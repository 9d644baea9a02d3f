// SPDX-License-Identifier: MIT
// What is known of a mechanism's closures while they are being found?
//
// The order: roots of the closure polynomials (closure_roots.h), poses of the real ones
// (closure_poses.h), then the verdict (closures.cpp), which is drawn from what stands here.
#pragma once

#include <map>

#include "moivre/certify/certifier.h"
#include "moivre/closures/closures.h"
#include "moivre/closures/root_proofs.h"

namespace moivre {

/// A root near a real one: it fails another equation or, under a fit, is not real.
struct NearMiss {
  Solution root;
  bool is_rejected = true;
  bool is_near = true;  ///< no farther from a real pose than rounded lengths explain
};

struct ClosureSearch {
  ClosureSearch(const Mechanism& the_mechanism, const Tracker& the_tracker,
                const ClosureOptions& the_options, const std::atomic<bool>& the_stop)
      : ClosureSearch(the_mechanism, the_tracker, the_options, the_stop,
                      formulate(the_mechanism, the_options.time)) {}
  /// With its polynomials, or others that say the same of it.
  ClosureSearch(const Mechanism& the_mechanism, const Tracker& the_tracker,
                const ClosureOptions& the_options, const std::atomic<bool>& the_stop,
                Formulation the_formulation)
      : mechanism(the_mechanism),
        tracker(the_tracker),
        options(the_options),
        stop(the_stop),
        phi(mechanism),
        formulation(std::move(the_formulation)) {}

  bool wants_proofs() const {
    return options.certify && options.solve.certify && proves_beyond_double();
  }
  /// They are wanted, and there are as many equations as unknowns.
  bool has_proofs() const {
    const System& f = formulation.system;
    return wants_proofs() && f.polynomials.size() == f.variables.size();
  }

  /// What is proved is proved of the numbers that were typed, not of frames that were rounded.
  bool proves_as_typed() const {
    return has_proofs() && formulation.is_exact && !formulation.has_rounded_frames;
  }

  const Mechanism& mechanism;
  const Tracker& tracker;
  const ClosureOptions& options;
  const std::atomic<bool>& stop;
  const Phi phi;
  const Formulation formulation;
  ClosureResult result;
  /// All equations are combined at random to as many as there are unknowns. Else the first ones
  /// that could determine these are solved, which may depend on each other within rounding.
  bool is_combined = false;
  bool is_as_typed = false;  ///< to the last typed digit: what is above roots has more than double
  std::uint64_t lost_images = 0;  ///< roots whose mirror image is not among the roots
  std::uint64_t unproved =
      0;  ///< simple roots of the rounded polynomials that the mechanism as typed may not have
  std::uint64_t unpolished = 0;  ///< real roots that Newton-Raphson does not confirm
  std::uint64_t rootless =
      0;  ///< poses that close regularly beside roots that do not, and are no root's
  std::vector<NearMiss> near_misses;
  std::vector<Closure> near_closures;  ///< what these come to where it misses by rounding only
  std::map<const Joint*, std::uint64_t>
      beyond_limits;  ///< closures that each joint's limits filtered
  std::vector<Closure>
      fitted_beyond_limits;  ///< poses within Mechanism::fit that the limits filtered
  std::vector<Eigen::VectorXd> fitted_before;  ///< poses within fit, before all was combined
  bool undecided_motion = false;  ///< a set of closures may exist, and no pose that moves was found
  bool part_is_complex = false;   ///< a part of the mechanism closes in complex numbers only
};

}  // namespace moivre
