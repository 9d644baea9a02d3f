// SPDX-License-Identifier: MIT
// Where does a text go that is written piece by piece? To a function that is called with each
// piece, in order.
#pragma once

#include <functional>
#include <string_view>

namespace moivre {

/// May throw; the writer then stops.
using TextSink = std::function<void(std::string_view)>;

}  // namespace moivre
