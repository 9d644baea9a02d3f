// SPDX-License-Identifier: MIT
// In how many ways can a mechanism be assembled while one or two of its numbers vary? Closures
// counted on a grid, and its borders.
//
// Every sample solves all closures, with families learned by the first samples (family/book.h).
// Between neighbouring samples with different counts lies a border: closures meet in pairs, reach a
// joint's limit, no longer close within fit, or begin to move. It is located by bisection.
//
//   one number    samples in order; borders to kBorder of the range, several between two samples
//                 where halves differ
//   two numbers   the first one varies slowest; a border point on every edge of the grid whose ends
//                 differ, to kMapBorder of the edge
//
// Edges: a sample that is not complete (a path failed, or the run was interrupted) has no border
// next to it. Closures that appear and disappear between two samples with the same count are not
// seen.
#pragma once

#include <Eigen/Core>
#include <compare>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "moivre/closures/closures.h"
#include "moivre/family/book.h"

namespace moivre {

inline constexpr double kBorder = 1e-9;
inline constexpr double kMapBorder = 1e-3;

/// A number of the mechanism (mechanism/dimensions.h) at `count` equidistant values.
struct Varied {
  std::string name;
  double from = 0;
  double to = 0;
  std::size_t count = 2;

  double at(std::size_t k) const;
};

struct SweepOptions {
  ClosureOptions closures;  ///< threads: over samples
  bool sharpen = true;
  bool keep_closures = false;
  std::function<void(std::size_t done, std::size_t total)> progress;  ///< never twice at once
};

/// In how many ways the mechanism can be assembled, by the counts of closures/closures.h.
struct Assemblies {
  std::uint64_t real = 0;      ///< isolated real closures
  std::uint64_t filtered = 0;  ///< of them: outside a joint's limits
  std::uint64_t fitted = 0;    ///< beside them: within Mechanism::fit only
  bool moves = false;          ///< closures form a set of positive dimension

  /// Real ones within the limits, and fitted ones.
  std::uint64_t usable() const { return real - filtered + fitted; }
  auto operator<=>(const Assemblies&) const = default;
};

struct SweepSample {
  std::vector<double> at;     ///< of each varied number
  std::uint64_t complex = 0;  ///< isolated closures, the real ones among them
  Assemblies found;
  bool complete = false;
  std::vector<Eigen::VectorXd> closures;  ///< q of the usable ones, where options.keep_closures
};

struct SweepBorder {
  std::vector<double> at;
  Assemblies below, above;  ///< on both sides, along the number that varies
  std::size_t along = 0;    ///< which number that is
};

struct SweepResult {
  std::vector<Varied> varied;
  std::vector<SweepSample> samples;
  std::vector<SweepBorder> borders;
  std::size_t families = 0;  ///< that were used
  bool complete = false;
  double seconds = 0;
  int threads = 1;
};

/// varied: one or two. Throws std::invalid_argument with every fault before any solve. `book`
/// grows.
SweepResult sweep(const Mechanism& mechanism, const std::vector<Varied>& varied,
                  const Tracker& tracker, FamilyBook& book, const SweepOptions& options = {},
                  const std::atomic<bool>& stop = std::atomic<bool>{false});

}  // namespace moivre
