// SPDX-License-Identifier: MIT
// Are the closures that a formula proposes all that a pose has? Then no path has to be followed to
// it.
//
// A regular pose has N closures, complex ones too. No pose has more that stand alone; and one that
// has N simple closures has nothing else, sets neither: the map from joint values to poses covers
// poses N times, and a fibre of it has as many connected pieces at the most, since poses are smooth
// (Zariski's main theorem). So the proposals answer where Newton's method on the arm as typed leads
// from them to N closures that are simple and different. Which formula it was does not matter.
// N is the arm's own where the formula's geometry is the arm's as typed (are_all). Where it is what
// the file's digits stand for, the arm may have closures that no regular pose's equations count:
// a Panda typed to four digits, joint 6 held, has ten at a straight shoulder, and N = 8. Those
// stand on sets that the digits leave open, and are sought there.
// Simple is what Kantorovich's theorem says is so:
//   |step| |J^-1| K <= 1/2,  K >= |second derivatives|: 2 |screws|^2 bounds them, brackets of two
//                            screws each
// or, where that is too coarse, with |J^-1 second derivatives| in the place of |J^-1| K.
// Where anything falls short there is no answer here.
#pragma once

#include <optional>
#include <vector>

#include "approach.h"
#include "group_formula.h"
#include "polish.h"

namespace moivre {

/// A closure that is not real; its conjugate is another.
struct ConjugatePair {
  JointVector<Complex> values;
  double imaginary = 0;  ///< the largest part of an angle
  double accuracy = 0;   ///< its last Newton step
  double stiffness = 0;  ///< 1 / |J^-1|: below the smallest singular value
};

struct FoundClosures {
  std::vector<Polished> real;
  std::vector<ConjugatePair> pairs;
  /// Radians from what was proposed, the largest.
  double moved = 0;
  /// Of the arm as typed, too: the formula's geometry is the arm's, not what its digits stand for.
  bool are_all = false;
};

/// All closures, where what is proposed leads to `closures` of them.
std::optional<FoundClosures> closures_proposed(const ProposedClosures& proposed, const Arm& arm,
                                               const Eigen::Isometry3d& pose, std::size_t closures);

/// The same as ends of paths.
std::vector<ApproachEnd> ends_of(const FoundClosures& found);

}  // namespace moivre
