// SPDX-License-Identifier: MIT
// Which mechanisms do the tests read? Those of problems/mechanisms, and texts.
#pragma once

#include <string>

#include "moivre/mechanism/phi.h"
#include "moivre/mechanism/read.h"

namespace moivre::test {

inline Mechanism example(const std::string& name) {
  return read_mechanism(
      read_source(std::string(MOIVRE_SOURCE_DIR) + "/problems/mechanisms/" + name + ".toml"));
}

inline Mechanism typed(const std::string& text) {
  return read_mechanism(Source{"typed.toml", text});
}

inline constexpr double kDegree = 0.017453292519943295769;

}  // namespace moivre::test
