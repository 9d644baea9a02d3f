// SPDX-License-Identifier: MIT
// How does the linear-product start of a partition become a plan? One stage, t F + (1 - t) G with G
// multiplied out.
//
// Start points as in start/linear_product.h. Edges: nullopt where G has too many terms to be
// multiplied out. Throws as linear_product_start() does.
#pragma once

#include "moivre/start/linear_product.h"
#include "moivre/start/start_plan.h"

namespace moivre {

std::optional<StartPlan> multihomogeneous_plan(const System& f, const Partition& groups,
                                               std::uint64_t seed);

}  // namespace moivre
