// SPDX-License-Identifier: MIT
// What has to be computed but once for many partial roots? All that a block's equations tell above
// roots whose values in them are the same.
//
//   blocks A, B, C;  C's equations have unknowns of A and C alone:  C is solved once above a root
//                    of A, however many roots B has there
//
// Values are the same where they are one KnownValue: roots of a block share those of the blocks
// before it, and what is shared above them.
// The postures of six legs stand above one another, and each knows the platform's pose alone.
#pragma once

#include <algorithm>
#include <cstdint>
#include <map>
#include <set>
#include <vector>

#include "moivre/closures/stages.h"
#include "moivre/formulation/block_structure.h"

namespace moivre {

template <class T>
class SharedAbove {
 public:
  SharedAbove(const System& all, const Block& block) {
    std::set<std::size_t> known;
    for (const std::size_t e : block.equations) {
      for (const Term& term : all.polynomials[e].terms) {
        for (const Power& power : term.monomial) known.insert(power.variable);
      }
    }
    for (const std::size_t v : block.variables) known.erase(v);
    known_.assign(known.begin(), known.end());
  }

  /// compute(), if no root with these values was there before.
  template <class Compute>
  const T& above(const PartialRoot& root, const Compute& compute) {
    std::vector<KnownValue> values;
    for (const std::size_t v : known_) values.push_back(root.value[v]);
    const auto [place, is_new] = by_values_.try_emplace(std::move(values));
    if (is_new) place->second = compute();
    return place->second;
  }

 private:
  std::vector<std::size_t> known_;  ///< variables of the blocks before
  std::map<std::vector<KnownValue>, T> by_values_;
};

}  // namespace moivre
