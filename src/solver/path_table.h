// SPDX-License-Identifier: MIT
// Where did each path end, and which paths ended at one point? The table of all paths.
//
// A path has exactly one entry, its last: a root, a failure, infinity, or not needed. Of every
// path its record is kept, 16 bytes; of a root and of a failure what more there is
// to know. An end that is refuted stays on record, and is none of a group.
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <utility>
#include <vector>

#include "dimension.h"
#include "path_groups.h"
#include "refine.h"

namespace moivre {

/// Numbers of paths.
using PathSet = std::set<std::uint64_t>;

/// The finite end of one path, on the system as given. A run may have a million of them: no byte
/// that few of them need.
struct Root {
  Refined point;
  double tolerance = 0;  ///< relative, within which another end is the same root
  std::shared_ptr<const Certificate> certificate;  ///< of a simple root that is proved
  std::optional<std::int16_t>
      winding;            ///< nullopt: no circle was needed, so it counts as 1, or none was seen
  bool is_exact = false;  ///< an isolated multiple root that `point` is exactly, but for rounding
  /// A positive-dimensional set that it lies on, once asked.
  mutable std::optional<SetHere> on_set;
};

class PathTable {
 public:
  /// Each takes the place of what was entered of the path before. by_count: its end was not seen,
  /// so many have to lead to that root. beside: of a simple root that is
  /// no further than the tolerance from this end, and not it, as far as the end is known coordinate
  /// by coordinate.
  void enter_root(std::uint64_t path, Root&& root,
                  std::shared_ptr<const Certificate> beside = nullptr);
  void enter_by_count(std::uint64_t path, Root&& root);
  /// What was seen of its end is that point.
  bool is_seen_at(std::uint64_t path, const Point& x) const;
  void enter_infinity(std::uint64_t path, bool is_as_rounded = false);
  /// last: where it was last, on the system as given; empty where that is nowhere.
  void enter_failure(const FailedPath& failure, Point last = {});
  /// What was seen of its end, a root, is none: something else that is known says so.
  void refute(std::uint64_t path) { refuted_.insert(path); }
  /// What is known of its end, a root, is told elsewhere; its record stays.
  void release(std::uint64_t path) { roots_.erase(path); }
  /// Its end lies on a curve.
  void tell_curve(std::uint64_t path) { roots_.at(path).on_set = SetHere::sharp; }
  /// It leads to no root that is not known already: a count says so (settle.h).
  void leave(std::uint64_t path);

  /// The path was followed once more, or on; `stage`: of the plan, where it ended.
  void count_following(std::uint64_t path, const StepCount& count, std::size_t stage,
                       bool is_followed_on = false);
  void set_precision(std::uint64_t path, PathPrecision precision) {
    record(path).precision = precision;
  }
  void set_handed_over(std::uint64_t path) { record(path).handed_over = true; }

  const std::map<std::uint64_t, Root>& roots() const { return roots_; }
  const std::map<std::uint64_t, FailedPath>& failures() const { return failures_; }
  /// Paths with a root on record that is none.
  const PathSet& refuted() const { return refuted_; }
  /// As entered with the path's root; null where there is none.
  const Certificate* beside(std::uint64_t path) const;
  /// Of failed paths.
  const std::map<std::uint64_t, Point>& last_points() const { return last_points_; }
  /// By path number, up to the last path that anything is known of.
  const std::vector<PathRecord>& records() const { return records_; }
  /// They are no longer in the table.
  std::vector<PathRecord> take_records() { return std::move(records_); }
  PathPrecision precision(std::uint64_t path) const;
  std::uint64_t count(PathVerdict verdict) const;
  /// Paths with an entry.
  std::uint64_t tracked() const;

  /// Paths that end at one point, each group ascending; of ends that are not refuted.
  PathGroups groups() const;

 private:
  PathRecord& record(std::uint64_t path);
  /// Takes the entry away and makes this the path's verdict.
  void decide(std::uint64_t path, PathVerdict verdict);

  std::map<std::uint64_t, Root> roots_;
  std::map<std::uint64_t, std::shared_ptr<const Certificate>> beside_;
  PathSet refuted_;
  std::map<std::uint64_t, FailedPath> failures_;
  std::map<std::uint64_t, Point> last_points_;
  std::vector<PathRecord> records_;
  std::array<std::uint64_t, 6> count_{};  ///< of records, by verdict, but for the open ones
};

/// Number of cycles of each winding number that these paths make up; nullopt when they make no
/// whole cycles, so that a path is missing or one is too many.
std::optional<std::vector<int>> cycles(const PathTable& table, PathGroups::Group group);

/// Simple roots, not real, whose complex conjugate is not among the roots.
std::vector<Point> missing_conjugates(const PathTable& table);

/// All imaginary parts vanish: by proof where there is one, else to within the root's accuracy.
bool is_real(const Root& root);

}  // namespace moivre
