// SPDX-License-Identifier: MIT
// How does a branch look in a picture of a motion? Its curve in its colour, marks where it begins
// and ends, its line in the legend.
//
// Everything in pixels, y downwards. Branches that take one curve are drawn as stripes, one inside
// the other, so that every branch is seen, also where it comes back the way it went. Dead point: a
// diamond; bifurcation: a square; joint limit: a triangle.
#pragma once

#include <string>
#include <vector>

#include "circuits_report.h"
#include "moivre/motion/motion.h"
#include "svg.h"

namespace moivre {

inline constexpr double kMotionMargin = 16;      ///< around everything
inline constexpr double kNarrowestMotion = 560;  ///< without the margins
inline constexpr double kLegendLine = 19;

/// Of the branches that take one and the same curve: which is this, of how many? The first is the
/// widest, and drawn first.
struct Share {
  std::size_t number = 0;
  std::size_t of = 1;
};
/// Of each curve; an empty one shares nothing. Curves that are nowhere further than `apart` from
/// one another are one.
std::vector<Share> shares_of(const std::vector<std::vector<Complex>>& curves, double apart);

/// The polyline through the points, each placed by `map`.
std::string curve_svg(const std::vector<Complex>& points, const PixelMap& map,
                      const BranchLook& look, Share share = {});

std::string begin_mark(Complex at, std::size_t colour);
std::string event_mark(EventKind kind, Complex at);
/// Each branch, and what the marks mean, in lines no longer than `width`; y: the line before it,
/// afterwards the last one.
std::string motion_legend(const MotionResult& result, const Mechanism& mechanism,
                          const std::vector<BranchLook>& looks, bool has_shared_curve, double width,
                          double& y);

/// A motion of typed equations: each unknown over the time. At least one branch has a pose.
std::string unknowns_svg(const MotionResult& result, const Mechanism& mechanism,
                         const std::string& title);

}  // namespace moivre
