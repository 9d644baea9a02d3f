// SPDX-License-Identifier: MIT
// What does a lane ask of scalar Newton? A point that rounding keeps it from, or the proof that an
// end is regular.
//
//   Complex               x in double, residuals in double-double where they are needed
//                         (tracker/path_system.h)
//   ComplexDoubleDouble   everything in double-double (tracker/fine_path_system.h); ends at t = 1
//                         are to be regular ones
//
// The number types are those that one lane holds. Compiled once, for all instruction sets.
#pragma once

#include "lane_control.h"
#include "moivre/tracker/fine_path_system.h"

namespace moivre {

template <class Number>
class LaneNewton;

template <>
class LaneNewton<Complex> {
 public:
  static constexpr LaneRules kRules = kDoubleRules;

  explicit LaneNewton(const Homotopy& homotopy) : path_(homotopy), given_(path_.coordinates()) {}

  std::size_t coordinates() const { return path_.coordinates(); }
  /// For watchers.
  PathSystem& watched() { return path_; }
  /// Of the path that the next call is about.
  void set_frame(const PathFrame* frame) { path_.set_frame(frame); }
  static const PathTime& time(const PathTime& t) { return t; }

  /// Corrects x, the point that `control` is to have next, and dx, the tangent there.
  Rescue rescue(Point& x, Point& dx, const LaneControl& control);
  static void normalize(Point& x);
  static const Point& rounded(const Point& x) { return x; }

 private:
  PathSystem path_;
  Point given_;
};

template <>
class LaneNewton<ComplexDoubleDouble> {
 public:
  using FinePoint = std::vector<ComplexDoubleDouble>;
  static constexpr LaneRules kRules = kDoubleDoubleRules;

  explicit LaneNewton(const Homotopy& homotopy)
      : fine_(homotopy), path_(homotopy), rounded_(path_.coordinates()) {}

  std::size_t coordinates() const { return path_.coordinates(); }
  PathSystem& watched() { return path_; }
  void set_frame(const PathFrame* frame) {
    fine_.set_frame(frame);
    path_.set_frame(frame);
  }
  static Time<ComplexDoubleDouble> time(const PathTime& t) {
    return fine_time<ComplexDoubleDouble>(t);
  }

  Rescue rescue(FinePoint& x, FinePoint& dx, const LaneControl& control);
  /// To norm 1 as far as double tells: no path depends on its scale.
  void normalize(FinePoint& x);
  const Point& rounded(const FinePoint& x);

 private:
  FinePathSystem<ComplexDoubleDouble> fine_;
  PathSystem path_;
  Point rounded_;
};

}  // namespace moivre
