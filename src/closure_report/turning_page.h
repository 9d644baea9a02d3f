// SPDX-License-Identifier: MIT
// How are the closures of a spatial mechanism looked at from all sides? One page, side by side, turned together by the mouse.
#pragma once

#include <string>

#include "moivre/closures/closures.h"

namespace moivre {

std::string turning_html(const ClosureResult& result, const Mechanism& mechanism,
                         const std::string& file, const std::string& summary);

}  // namespace moivre
