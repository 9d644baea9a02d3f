// SPDX-License-Identifier: MIT
// Which of Highway's instruction sets does this CPU run?
//
//   bits HWY_AVX3, HWY_AVX2, ...; the baseline that the whole program is compiled for is always
//   among them
//
// The compiler's own question to the CPU, and not that of Highway's shared library: loading it
// calibrates a timer, which takes longer than to solve a small system
// (docs/decisions/0024-start-up.md).
// Not supported: instruction sets beyond the baseline on CPUs other than x86. Private to the
// module.
#pragma once

#include <cstdint>

namespace moivre {

/// What the CPU runs, or what restrict_targets() has left of it.
std::int64_t runnable_targets();

/// From now on only these, so that every instruction set can be tested on one machine; 0: all
/// again.
void restrict_targets(std::int64_t targets);

}  // namespace moivre
