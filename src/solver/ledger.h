// SPDX-License-Identifier: MIT
// Where did each path end, and which paths ended at one point? The ledger of all paths.
//
// A path has exactly one entry: a root (finite), a failure, or one more at infinity; the number of
// paths at infinity is kept, not the paths.
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <vector>

#include "refine.h"

namespace moivre {

/// Numbers of paths.
using PathSet = std::set<std::uint64_t>;

/// The finite end of one path, on the system as given.
struct Root {
  Refined point;
  std::optional<int> winding;  ///< nullopt: the end needed no circle, so it counts as 1
  bool is_counted = false;     ///< exact algebra has its multiplicity; nothing is known of cycles
  double tolerance = 0;        ///< relative, within which another end is the same root
  std::shared_ptr<const Certificate> certificate;  ///< of a simple root that is proved
  mutable std::optional<bool> on_set;  ///< lies on a positive-dimensional set, once asked
};

class Ledger {
 public:
  void enter_root(std::uint64_t path, Root&& root);
  void enter_infinity(std::uint64_t path);
  void enter_failure(const FailedPath& failure);
  /// Strikes the path's entry, so that it can be entered anew.
  void strike(std::uint64_t path);

  const std::map<std::uint64_t, Root>& roots() const { return roots_; }
  const std::map<std::uint64_t, FailedPath>& failures() const { return failures_; }
  std::uint64_t at_infinity() const { return at_infinity_; }
  std::uint64_t tracked() const { return at_infinity_ + roots_.size() + failures_.size(); }

  /// Paths that end at one point, each group ascending.
  std::vector<std::vector<std::uint64_t>> groups() const;

 private:
  std::map<std::uint64_t, Root> roots_;
  std::map<std::uint64_t, FailedPath> failures_;
  std::uint64_t at_infinity_ = 0;
};

/// Number of cycles of each winding number that these paths make up; nullopt when they make no whole
/// cycles, so that a path is missing or one is too many.
std::optional<std::vector<int>> cycles(const Ledger& ledger,
                                       const std::vector<std::uint64_t>& group);

/// Simple roots, not real, whose complex conjugate is not among the roots.
std::vector<Point> missing_conjugates(const Ledger& ledger);

/// All imaginary parts vanish: by proof where there is one, else to within the root's accuracy.
bool is_real(const Root& root);

}  // namespace moivre
