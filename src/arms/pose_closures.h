// SPDX-License-Identifier: MIT
// Which closures does one pose have, given those of the regular pose?
//
// They are followed to the pose, or given by a family or a formula; their ends are read
// (read_ends.h); searches from random postures find sets, and are a witness that nothing is
// missing.
#pragma once

#include <atomic>
#include <cstdint>
#include <optional>
#include <vector>

#include "formula_ends.h"
#include "moivre/arms/poses.h"
#include "prepared_arm.h"

namespace moivre {

/// What is known of a pose's closures before anything is followed.
struct KnownOfPose {
  std::vector<ApproachEnd> by_family;  ///< or none
  std::optional<FoundClosures> by_formula;

  bool is_any() const { return by_formula.has_value() || !by_family.empty(); }
};

/// `known`: of an arm with one beginning. `as_witness`: searches from random postures, at the
/// least.
ArmResult closures_at(const PreparedArm& prepared, const TypedPose& at, const KnownOfPose& known,
                      std::uint64_t as_witness, const Tracker& tracker,
                      const std::atomic<bool>& stop);

}  // namespace moivre
