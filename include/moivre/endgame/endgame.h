// SPDX-License-Identifier: MIT
// Where does a path end? Regular, singular with a winding number, at infinity, or lost.
//
// An Endgame belongs to one path. It names the next contour, receives the result of following it,
// and in the end holds a PathEnd. It calls no tracker itself, so it works with every tracker.
//
//   1. The path is followed from t = 0 to t = 1. From |1 - t| <= watch_radius on its points are
//      recorded, so that circles can begin there. If it reaches t = 1 with a well-conditioned J,
//      the end is regular and no endgame is needed.
//   2. Otherwise it is followed in circles t = 1 - r e^{i theta}. After m turns the path closes; m
//      is the winding number. The mean of equidistant samples is the end point (Cauchy's integral;
//      the error falls geometrically in the number of samples). Radii shrink until two estimates
//      agree. All paths have radii in common.
//   3. The power sums of the m points over one t tell whether these end together (cycle.h). The
//      path ends at infinity if two things hold: those of x_0 are all 0, and the faces of the
//      path's direction have a common root near it (face.h). If the points end apart, the circle is
//      too wide, or more digits are needed.
//   4. After several turns around a mean that is not clearly a singular root, a straight segment to
//      t = 1 (the landing) tells whether simple roots close to each other were taken for one.
//   5. From an end that circles have given, a path may go back outwards from where its last circle
//      began, to a radius that all paths have in common: two paths that stand at one point there
//      are on one sheet, and one of them has jumped on its way in.
//
// The m points over one t are where m paths have arrived. So after each turn that leads to another
// point a path may wait for the others: turn by turn they have walked the circle together (waits(),
// join(), walk_on()). What each would see alone is the same.
//
// x: N homogeneous coordinates of a chart, which knows x_0. accuracy: relative, |x - x*|_inf /
// |x|_inf in homogeneous coordinates.
// Edges: a path that breaks off far from t = 1 has failed, with the reason. Not supported: winding
// numbers above maximum_winding.
// Source: [MSW91] for the Cauchy integral, [HuberVerschelde98] and [Timme21] for valuations.
#pragma once

#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "moivre/endgame/end_parameters.h"
#include "moivre/tracker/session.h"

namespace moivre {

enum class PathStatus { finite, at_infinity, failed };
std::string to_string(PathStatus status);

/// Why a path failed if its last segment ended like this before its end.
Failure to_failure(SegmentStatus status);

/// Where a path stands that has no regular end, so that it can be taken up again.
struct EndgameStart {
  Point x;  ///< homogeneous, in its frame
  double radius = 0;
  FramePointer frame;
};

/// The verdict on one path.
struct PathEnd {
  PathStatus status = PathStatus::failed;
  std::optional<Failure> failure;
  Point x;                     ///< homogeneous end point; the last point when failed
  bool is_as_rounded = false;  ///< at infinity as far as the digits of F's coefficients tell
  bool singular = false;
  /// nullopt: the segment to t = 1 ended there; solver/ tests whether the root is simple.
  std::optional<int> winding;
  double accuracy = 0;
  double size = 1;        ///< |x|_inf / |x_0|, in the path's frame
  double condition = 0;   ///< of the bordered, row-scaled Jacobian
  Complex t = 0;          ///< how far it came
  std::size_t stage = 0;  ///< of the plan, on which it ended
  /// Homogeneous, over 1 - t = common_radius(watch_radius), where the path has gone back to; empty:
  /// it has not.
  Point sheet;
  StepCount count;
  /// Of a failed path: where only regular ends were sought, or its steps near t = 1 are spent.
  std::optional<EndgameStart> endgame_start;
  bool is_taken_up = false;  ///< from a start of the endgame: `count` is of the rest of the way
};

enum class FaceRoot;

class Endgame : public Watcher {
 public:
  Endgame(const EndgameOptions& options, const Chart& chart, std::uint64_t path,
          int tolerance_level);

  /// The first segment, from a start point at t = 0, in the frame where there is one.
  PathSegment depart(Point start, FramePointer frame = nullptr);

  /// The first segment of a path that stands at a start of the endgame on the last stage.
  PathSegment take_up(const EndgameStart& endgame_start, PathSystem& path);

  /// Takes the result of the last segment. Returns the next segment, or nullopt when the verdict is
  /// known. `path`: scratch for evaluations.
  std::optional<PathSegment> accept(SegmentResult&& reached, PathSystem& path);

  /// The verdict is not known, and there is no segment: the turns so far have led from
  /// begin_of_turn() to another sheet's, which may be that of another path that waits. Ends by
  /// join() or walk_on().
  bool waits() const noexcept { return waits_; }
  double radius() const noexcept { return radius_; }
  int turns() const noexcept { return turns_; }
  /// Homogeneous, in no frame; both over 1 - t = radius().
  Point begin_of_turn() const { return outside(frame_, turn_begin_); }
  Point end_of_turn() const { return outside(frame_, turn_end_); }
  /// All but end(), which a path that waits needs to go on elsewhere, as exact bytes.
  std::string bytes_of_waiting() const;
  /// As the one that wrote these bytes, of the same options, chart, path and tolerance level.
  /// Throws std::invalid_argument where they are no such bytes.
  void wait_as(std::string_view bytes, PathEnd end);
  /// One turn more.
  PathSegment walk_on();
  /// The samples of its turns, homogeneous, in no frame.
  std::vector<Point> samples() const;
  /// With the samples of all sheets of its chain, each beginning where the one before has ended,
  /// its own samples[own]: they are closed, or more turns than a cycle may have.
  std::optional<PathSegment> join(const std::vector<std::vector<Point>>& samples, std::size_t own,
                                  PathSystem& path);
  /// As a sheet of the same cycle, which has ended at infinity.
  std::optional<PathSegment> end_with(const Endgame& sheet);

  const PathEnd& end() const noexcept { return end_; }
  PathEnd& end() noexcept { return end_; }

  Verdict watch(const StepRecord& step, PathSystem& path) override;

 private:
  enum class Phase { whole_way, first_approach, approach, circle, landing, way_back };

  struct Estimate {
    Point x;
    int winding = 0;
  };

  std::optional<PathSegment> proceed(SegmentResult&& reached, PathSystem& path);
  PathSegment along(const Contour& contour, Point x, int samples = 0, Watcher* watcher = nullptr);
  std::optional<PathSegment> judge_result(SegmentResult&& reached, PathSystem& path);
  void polish_endgame_start(PathSystem& path);
  PathSegment turn_to_circles(PathSystem& path);
  bool may_look_again() const;
  std::optional<PathSegment> look_again(PathSystem& path);
  std::optional<PathSegment> hand_on(std::optional<PathSegment> next, PathSystem& path);
  bool may_go_back() const;
  PathSegment go_back();
  void arrive_back(SegmentResult&& reached);
  void deliver_end();
  double common_radius(double radius) const;
  PathSegment approach(double radius);
  std::optional<PathSegment> begin_circle();
  Contour circle() const;
  PathSegment walk_turn(Point x);
  bool are_steps_spent() const;
  bool may_wait() const;
  std::optional<PathSegment> next_turn(SegmentResult&& reached, PathSystem& path);
  std::optional<PathSegment> shrink(PathSystem& path);
  std::optional<PathSegment> conclude(PathSystem& path);
  std::optional<PathSegment> estimate_end(PathSystem& path);
  Point laurent_coefficient(int j) const;
  void leave_poles();
  double truncation() const;
  double landing_condition() const;
  std::optional<PathSegment> land();
  std::vector<Complex> samples_of_x0() const;
  bool ends_beyond(const std::vector<Complex>& x0) const;
  FaceRoot place_at_infinity(PathSystem& path) const;
  FaceRoot confirmed(FaceRoot place, PathSystem& path);
  bool errors_explain(PathSystem& path) const;
  bool polish_samples(PathSystem& path);
  bool sheets_meet(const Point& x) const;
  bool sheets_meet_in_all_digits(PathSystem& path);
  bool is_regular_end(const SegmentResult& reached, PathSystem& path, double condition);
  bool is_known_finite() const;
  std::nullopt_t take_finite();
  Point normalized(Point x) const;
  std::nullopt_t fail(Failure failure);

  EndgameOptions options_;
  Chart chart_;
  std::uint64_t path_;
  int tolerance_level_;
  FramePointer frame_;
  Phase phase_ = Phase::whole_way;
  PathEnd end_;

  // Watching.
  int creeping_ = 0;        ///< recorded steps within the creeping radius
  Point endgame_start_;     ///< last watched point, from which circles begin
  double radius_ = 0;       ///< its |1 - t|
  double next_radius_ = 0;  ///< of the circle that is approached

  std::uint64_t steps_of_way_ = 0;  ///< accepted before circles began
  bool looks_again_ = false;        ///< circles are repeated from where they began

  // Circles.
  Point patch_;       // affine patch of the circle's samples
  Point turn_begin_;  // normalized point at angle 0
  Point turn_end_;    // point that waits
  bool waits_ = false;
  std::vector<Point> samples_;  // normalized, over all turns so far
  int turns_ = 0;
  std::optional<Estimate> last_;
  std::optional<Estimate> best_;
  double best_difference_ = 0;
};

}  // namespace moivre
