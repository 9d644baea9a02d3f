// SPDX-License-Identifier: MIT
// How does an arm hold exact displacements, whose integers who only uses an arm need not know?
#pragma once

#include <memory>
#include <utility>

#include "moivre/arms/arm.h"
#include "moivre/numeric/exact_displacement.h"

namespace moivre {

struct ExactMotion : ExactDisplacement {};

inline ExactPointer exact_motion(ExactDisplacement g) {
  return std::make_shared<const ExactMotion>(ExactMotion{std::move(g)});
}

}  // namespace moivre
