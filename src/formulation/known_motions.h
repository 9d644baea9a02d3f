// SPDX-License-Identifier: MIT
// Which racks and cams are settled before the roots are found? No polynomial ties a slide to an
// angle, so that one must be known.
//
//   s = r (a_p - a_r - phase)      s slide, r pitch radius, a_p and a_r angles of pinion and rack
// One from the other, in turn, until nothing more follows (docs/decisions/0030-racks.md):
//   angles known by drivers, welds, gears and racks, whole turns counted    ->  s
//   s known by a driver, or by linear equations                             ->  an angle
// A cam gives the lift of its follower, slide or angle, where the cam's own angle is known.
// A pinion, a lever or a tappet that nothing else moves or reads follows its rack or cam: its angle
// or place is read off each root.
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "meshings.h"

namespace moivre {

/// Known before the roots: angles of bodies, slides of racks and lifts of cams (by joint), and
/// which joints' second bodies follow.
struct KnownMotions {
  std::vector<std::optional<KnownAngle>> angles;
  std::vector<std::optional<KnownSlide>> slides;
  std::vector<bool> is_followed;
};

/// What linear equations say of the racks that are not settled by these.
using FindSlides = std::function<std::vector<std::optional<double>>(const KnownMotions&)>;

/// Throws std::invalid_argument where a rack or a cam is neither settled nor followed.
KnownMotions known_motions(const Mechanism& mechanism, double t, const FindSlides& find_slides);

/// Where a rack's pinion or a cam's lever is pinned.
std::optional<PointOf> pivot_of(const Mechanism& mechanism, const Joint& joint);

/// By how much a rack's slide or a cam's lift disagrees with the angle of its second body, in
/// radians modulo whole turns; 0 where that is not known.
double disagreement(const Joint& joint, const KnownSlide& slide,
                    const std::vector<std::optional<KnownAngle>>& angles);

}  // namespace moivre
