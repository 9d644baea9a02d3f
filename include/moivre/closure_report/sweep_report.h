// SPDX-License-Identifier: MIT
// How is a sweep reported? As text for people, as JSON and CSV for programs, and as a picture.
//
//   text   how many samples have how many real closures, which of them are outside a joint's
//          limits, and the borders of one number
//   JSON   everything;  CSV one sample per line
//   SVG    one number: the number of real closures as a curve, that of all as a thin one, that
//          within limits or fit where it differs, and where it moves; two: a map, a colour a number
//          (within limits or fit), with its borders
//   HTML   the picture, and the closures of the sample that one points at, chooses by a slider or
//          names in the address (#at=12.5,9)
// The page draws bodies as the hulls of their points; for typed equations it lists the unknowns. It
// needs closures kept by the sweep, which of multiplied sub-chains may be fewer than are counted,
// and shows those of at most kMostShown samples, evenly thinned, so that a browser can hold them.
#pragma once

#include <string>
#include <vector>

#include "moivre/sweep/sweep.h"

namespace moivre {

/// `warnings`: the mechanism's.
std::string sweep_text(const SweepResult& result, const std::string& file,
                       const std::vector<std::string>& warnings = {});
std::string sweep_json(const SweepResult& result, const std::string& file,
                       const std::vector<std::string>& warnings = {});
std::string sweep_csv(const SweepResult& result);
/// Titled by the file's name, without its folder.
std::string sweep_svg(const SweepResult& result, const std::string& file);

inline constexpr std::size_t kMostShown = 10'000;
std::string sweep_html(const SweepResult& result, const Mechanism& mechanism,
                       const std::string& file);

}  // namespace moivre
