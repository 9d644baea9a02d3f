// SPDX-License-Identifier: MIT
// Where do names go, so that they cover neither the mechanism nor each other? The best of places
// around each anchor, in turn.
//
// What is drawn leaves ink, points with a weight; a place costs the ink below it, the labels it
// overlaps, and its distance.
#pragma once

#include <vector>

#include "moivre/closure_report/drawing.h"
#include "svg.h"

namespace moivre {

/// A text's place in pixels: the middle of its base line, which lies `baseline` below the middle of
/// its letters.
struct PlacedLabel {
  const Label* label = nullptr;
  std::string text;
  Complex at;
  Complex baseline;
};

/// `frame`: pixels that labels should keep to.
std::vector<PlacedLabel> place_labels(const Drawing& drawing, const Mechanism& mechanism,
                                      const Eigen::VectorXd& q,
                                      const std::vector<Similarity>& places, const PixelMap& map,
                                      const Box& frame);

std::string labels_svg(const std::vector<PlacedLabel>& labels);

}  // namespace moivre
