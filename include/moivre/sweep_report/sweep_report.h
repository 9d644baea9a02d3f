// SPDX-License-Identifier: MIT
// How is a sweep reported? As text for people, as JSON and CSV for programs, and as a picture.
//
//   text   how many samples have how many real closures, and the borders of one number
//   JSON   everything;  CSV one sample per line
//   SVG    one number: the number of real closures as a curve, that of all as a thin one; two: a map, a colour a number, with its borders
#pragma once

#include <string>

#include "moivre/sweep/sweep.h"

namespace moivre {

std::string sweep_text(const SweepResult& result, const std::string& file);
std::string sweep_json(const SweepResult& result, const std::string& file);
std::string sweep_csv(const SweepResult& result);
std::string sweep_svg(const SweepResult& result, const std::string& title);

}  // namespace moivre
