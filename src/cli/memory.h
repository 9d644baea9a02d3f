// SPDX-License-Identifier: MIT
// How much memory may this process still take? What a limit of the shell, a container or the
// machine leaves.
#pragma once

#include <cstdint>

namespace moivre {

struct MemoryState {
  std::uint64_t used = 0;       ///< bytes that are in memory
  std::uint64_t available = 0;  ///< bytes that can still be had
};

/// Of this moment; where the system does not tell, as much as there is no lack of. Signal handlers
/// may ask.
MemoryState memory_state();

/// The C library reserves 64 MB of addresses for each thread that asks for memory. Where addresses
/// are limited threads share one place instead. Before the first thread.
void spare_addresses();

}  // namespace moivre
