// SPDX-License-Identifier: MIT
// What did PHCpack say of mixed volumes? The stored table of bench/mixed_volumes, with the supports
// it is about.
#pragma once

#include <cstdint>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include "moivre/polynomial/read.h"
#include "moivre/start/support.h"

namespace moivre {

struct PhcpackRow {
  std::string name;
  std::uint64_t common = 0;
  std::uint64_t stable = 0;
  std::uint64_t total = 0;
  std::vector<Support> supports;
};

inline std::vector<Support> parse_supports(std::istream& words) {
  std::vector<Support> supports(1);
  for (std::string word; words >> word;) {
    if (word == ";") {
      supports.emplace_back();
      continue;
    }
    Exponents& term = supports.back().terms.emplace_back();
    for (const char digit : word) term.push_back(static_cast<std::uint32_t>(digit - '0'));
  }
  return supports;
}

/// The lines of bench/mixed_volumes, PHCpack 2.4.86.
inline std::vector<PhcpackRow> phcpack_rows() {
  const std::string folder = MOIVRE_SOURCE_DIR;
  std::ifstream file(folder + "/tests/start/phcpack_mixed_volumes.txt");
  std::vector<PhcpackRow> rows;
  for (std::string line; std::getline(file, line);) {
    std::istringstream words(line);
    std::string kind;
    words >> kind;
    PhcpackRow& row = rows.emplace_back();
    if (kind == "file") words >> row.name;
    words >> row.common >> row.stable >> row.total;
    if (kind == "file") {
      row.supports =
          supports_of(read_system(read_source(folder + "/problems/polynomials/" + row.name)));
    } else {
      row.name = line;
      row.supports = parse_supports(words);
    }
  }
  return rows;
}

}  // namespace moivre
