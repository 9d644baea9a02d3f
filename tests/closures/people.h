// SPDX-License-Identifier: MIT
// Mechanisms that people typed, each with its truth in its head: problems/people.
#pragma once

#include <string>

#include "moivre/mechanism/read.h"

namespace moivre::test {

inline Mechanism person(const std::string& name) {
  return read_mechanism(
      read_source(std::string(MOIVRE_SOURCE_DIR) + "/problems/people/" + name + ".toml"));
}

}  // namespace moivre::test
