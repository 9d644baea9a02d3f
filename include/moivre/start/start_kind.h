// SPDX-License-Identifier: MIT
// Which starts are there, and how many paths has each? start/choose_start.h says how one is chosen.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

namespace moivre {

enum class StartKind { automatic, total_degree, multihomogeneous, polyhedral };
/// "auto", "total-degree", "multihomogeneous", "polyhedral".
std::string to_string(StartKind kind);
std::optional<StartKind> start_kind(const std::string& name);

/// A number of paths, or why there is none.
struct StartCount {
  std::optional<std::uint64_t> paths;
  std::string missing;  ///< the reason, where paths is nullopt
};

struct StartCounts {
  StartCount total_degree;
  StartCount multihomogeneous;
  StartCount mixed_volume;  ///< with 0 added
};

}  // namespace moivre
