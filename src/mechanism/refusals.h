// SPDX-License-Identifier: MIT
// What is said of constraints that do not hold a mechanism: on velocities, and one-sided ones. Each
// goes on from what was typed.
#pragma once

namespace moivre {

inline constexpr const char* kLooksLikeADerivative =
    " looks like a derivative: a constraint on velocities (rolling, non-holonomic) does not say "
    "where the mechanism can "
    "be and is not supported; write constraints between coordinates";

inline constexpr const char* kOneSidedEquation =
    "an inequality is a one-sided constraint (contact): it holds only at times and is not "
    "supported; write an equation, or "
    "'limits' on a joint to filter closures";

inline constexpr const char* kVelocityJoint =
    "a constraint on velocities (non-holonomic) does not say where the mechanism can be; it is not "
    "supported (a 'gear' "
    "holds the ratio of two angles)";

inline constexpr const char* kOneSidedJoint =
    "a one-sided constraint (Phi >= 0) holds only at times; it is not supported ('limits' on a "
    "joint filter closures)";

}  // namespace moivre
