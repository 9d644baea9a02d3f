// SPDX-License-Identifier: MIT
// What does a side file add to a mechanism? Points of its bodies, joints that close loops, drivers
// and a guess.
//
// A side file is a mechanism file without bodies of its own:
//   [ground.points], [body.NAME.points]   more points of a body, in its side frame
//   [[joint]]                             as in mechanism files; axes in the bodies' side frames
//   [[driver]], [guess]                   as in mechanism files
// The side frame of body b has the body's origin and is turned by frames[b] in the body's frame: v
// in the body = frames[b] v.
// One `axis` for both bodies is in the first one's side frame, and has the same components in both
// bodies' own frames.
// Angles (turn, limits, drivers, guess) are those of the bodies' own frames.
// Units are the mechanism's: metres and radians. The mechanism has bodies, in space.
// Not supported: further bodies, tolerances of points, planar mechanisms.
#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "moivre/expression/source.h"
#include "moivre/mechanism/mechanism.h"

namespace moivre {

struct Additions {
  std::string title;                           ///< empty where the file has none
  std::vector<std::vector<BodyPoint>> points;  ///< of each body, the ground first, in its own frame
  std::string joints;                          ///< [[joint]], as text of a mechanism file
  std::string drivers;                         ///< [[driver]], likewise
  std::string guess;                           ///< [guess], likewise
  std::vector<Driver> driven;                  ///< `drivers`, with joints counted in `mechanism`
};

/// `frames`: a rotation for each body. Throws ParseError with every fault, at its place in the side
/// file.
Additions read_additions(const Source& source, const Mechanism& mechanism,
                         const std::vector<Eigen::Matrix3d>& frames);

}  // namespace moivre
