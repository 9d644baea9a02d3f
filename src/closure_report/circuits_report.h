// SPDX-License-Identifier: MIT
// How are circuits told? A section of a motion's text, members of its JSON, a short name in
// pictures.
#pragma once

#include <string>

#include "moivre/motion/circuits.h"
#include "moivre/report/json.h"

namespace moivre {

/// "Circuits" and what follows; empty where there is no branch.
std::string circuits_text(const Circuits& circuits, const MotionResult& motion,
                          const Mechanism& mechanism);

/// {"full_turn", "circuits", "circuit_notes", "pairs", "four_bars"}.
Json circuits_json(const Circuits& circuits, const MotionResult& motion,
                   const Mechanism& mechanism);

/// How a branch is drawn: a colour a circuit, solid or dashed by its stretch.
struct BranchLook {
  std::size_t colour = 0;
  std::string dashes;   ///< stroke-dasharray
  std::string circuit;  ///< "circuit 2"; empty where every branch is a circuit of its own
};

/// One a branch.
std::vector<BranchLook> branch_looks(const Circuits& circuits, const MotionResult& motion);

}  // namespace moivre
