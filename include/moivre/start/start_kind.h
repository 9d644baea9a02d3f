// SPDX-License-Identifier: MIT
// Which starts are there, and how many paths has each? start/choose_start.h says how one is chosen.
//
// StartKind is what a caller asks for, StartSource what the roots of a result came from in the end.
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
/// What the paths to a result began from, or what its roots came from without paths.
enum class StartSource : std::uint8_t {
  total_degree,
  multihomogeneous,
  polyhedral,
  own,      ///< a start system and a root of it that the caller gave
  family,   ///< the roots of a general member
  formula,  ///< no path: a formula has the roots
  approach  ///< the closures of an arm's regular pose
};
/// "total-degree", "multihomogeneous", "polyhedral", "own", "family", "formula", "approach".
std::string to_string(StartSource source);
/// What can be asked for; nullopt of a source that has to be given.
std::optional<StartKind> asked_for(StartSource source);

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
