// SPDX-License-Identifier: MIT
// Which bodies stand at a known angle to each other? Classes of bodies that share one unknown
// angle.
#pragma once

#include <cstddef>
#include <vector>

#include "moivre/formulation/exact.h"

namespace moivre {

/// t_node = factor * t_root.
struct SharedAngle {
  std::size_t root = 0;
  EnclosedUnit factor;
};

class AngleClasses {
 public:
  explicit AngleClasses(std::size_t nodes);

  /// Node 0 (the ground) is the root of its class.
  SharedAngle find(std::size_t node) const;

  enum class Verdict { joined, repeated, contradiction };
  /// t_j = factor * t_i. Where both are in one class already: whether it agrees with that.
  Verdict join(std::size_t i, std::size_t j, const EnclosedUnit& factor);

 private:
  std::vector<SharedAngle> up_;
};

}  // namespace moivre
