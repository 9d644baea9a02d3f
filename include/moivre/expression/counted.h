// SPDX-License-Identifier: MIT
// How is a number of things said? "1 path", "2 paths".
#pragma once

#include <string>
#include <string_view>

namespace moivre {

/// `noun` takes another ending in the plural: counted(2, "entry", "entries"). Count: any integer
/// type.
template <class Count>
std::string counted(Count count, std::string_view noun, std::string_view plural) {
  return std::to_string(count) + ' ' + std::string(count == 1 ? noun : plural);
}

template <class Count>
std::string counted(Count count, std::string_view noun) {
  return counted(count, noun, std::string(noun) + 's');
}

}  // namespace moivre
