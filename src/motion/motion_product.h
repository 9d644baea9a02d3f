// SPDX-License-Identifier: MIT
// How does a mechanism move whose sub-chains do not depend on each other? Each is followed on its
// own; the whole is put together.
//
//   branches     one of each sub-chain, while all of them are there
//   events       those of each sub-chain, once for every choice of branches that the others are on
//   checkpoints  where every sub-chain has one: counts multiply, and it agrees where all do
// A sub-chain's pose where another one's branch ends is followed to from its sample before.
// Steps of a branch go from sample to sample, at least kFewestSamples of them, by poses, velocities
// and accelerations; beside an event by the poses alone.
#pragma once

#include "moivre/motion/motion.h"

namespace moivre {

/// "G.H.C" -> G, H, C: one closure of each sub-chain.
std::vector<std::string> parts_of_name(const std::string& name);

/// Not taken apart. `mechanism`: without idle freedoms.
MotionResult find_motion_of_whole(const Mechanism& mechanism, const Tracker& tracker,
                                  const MotionOptions& options, const std::atomic<bool>& stop);

/// `mechanism`: without idle freedoms; `chains`: its independent ones, two or more.
MotionResult find_motion_apart(const Mechanism& mechanism,
                               const std::vector<IndependentChain>& chains, const Tracker& tracker,
                               const MotionOptions& options, const std::atomic<bool>& stop);

}  // namespace moivre
