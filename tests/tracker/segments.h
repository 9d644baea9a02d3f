// SPDX-License-Identifier: MIT
// What do tests of trackers follow? Square roots whose paths are known in closed form, and many
// segments at once.
//
// Homogeneous points of one unknown are (x_1, x_0).
#pragma once

#include <map>
#include <vector>

#include "moivre/polynomial/read.h"
#include "moivre/tracker/session.h"
#include "moivre/tracker/tracker.h"

namespace moivre::test {

/// x^2 = 1 becomes `target`.
inline Homotopy from_square_roots_of_one(const std::string& target) {
  return {read_system({"f", "1\n" + target + ";\n"}), read_system({"g", "1\nx^2 - 1;\n"})};
}

inline Complex affine(const Point& x) { return x[0] / x[1]; }

inline PathSegment from(const Point& x, const Contour& contour = Contour::segment(0, 1)) {
  PathSegment segment;
  segment.contour = contour;
  segment.x = x;
  return segment;
}

/// Hands out segments in their order, and keeps what arrives by path number.
class SegmentList : public SegmentSource {
 public:
  explicit SegmentList(std::vector<PathSegment> segments) : segments_(std::move(segments)) {}
  std::optional<PathSegment> next() override {
    if (next_ == segments_.size()) return std::nullopt;
    return segments_[next_++];
  }
  void arrived(const PathSegment& segment, SegmentResult&& reached) override {
    results[segment.path] = std::move(reached);
  }

  std::map<std::uint64_t, SegmentResult> results;

 private:
  std::vector<PathSegment> segments_;
  std::size_t next_ = 0;
};

}  // namespace moivre::test
