// SPDX-License-Identifier: MIT
// Which angles do drivers and gears determine, whole turns counted? A wheel of 53 teeth meshes in
// 53 ways; one was drawn.
//
//   driver            a_j - a_i = f(t)                          whole turns included
//   weld, prismatic   a_j - a_i = turn
//   gear              z_i (a_i - a_c) = z_j (a_j - a_c - phase)  as numbers, not modulo a turn
//   rack              a_j - a_i = phase + s / r                  where its slide s is known
//   lever on a cam    a_j - a_c = lift                           where that is known
// Linear equations. Where they leave a body a known angle to the ground, or to one body that they
// leave free, that is its angle;
// a gear all of whose bodies stand at known angles to each other holds by them.
// Symbols: a_i angle of body i (rad, whole turns counted), the ground's is 0; z teeth.
// Edges: a contradiction determines nothing, then the gears stand as they are, in every meshing.
#pragma once

#include <optional>
#include <vector>

#include "moivre/mechanism/mechanism.h"
#include "typed_numbers.h"

namespace moivre {

/// a_body = a_root + value.
struct KnownAngle {
  std::size_t root = 0;   ///< the ground, or a body that is left free
  double value = 0;       ///< rad
  ExactAngle exact = {};  ///< the same, of the angles as typed
};

/// A rack's slide or a cam's lift that is known.
struct KnownSlide {
  double value = 0;
  bool follows = false;  ///< from the equations of other joints: the rack adds none
};

/// The body relative to which a rack turns its pinion, or a cam its lever; and how far, by the
/// rack's slide or the cam's lift.
std::size_t turn_body(const Joint& joint);
double turn_by(const Joint& joint, double slide);

/// Of each body; nothing for a body whose angle depends on more than one other. `slides`: those of
/// racks and lifts of cams, by joint, that are known.
std::vector<std::optional<KnownAngle>> known_angles(
    const Mechanism& mechanism, double t, const std::vector<std::optional<KnownSlide>>& slides);

/// Whether the gear is to hold in the drawn meshing alone, and does by these angles.
bool is_settled(const Joint& gear, const std::vector<std::optional<KnownAngle>>& angles);

}  // namespace moivre
