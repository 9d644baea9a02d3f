// SPDX-License-Identifier: MIT
// Where does a path end? Regular, singular with a winding number, at infinity, or lost.
//
// An Endgame belongs to one path. It names the next contour to follow, is told how the journey went, and in the end holds a
// PathEnd. It drives no tracker itself, so every tracker serves it.
//
//   1. The whole way, t: 0 -> 1. From |1 - t| <= watch_radius on it watches: valuations, condition, where to turn back to.
//      An arrival at t = 1 with J well conditioned is regular: done, no endgame is run.
//   2. Infinity told early. With r = 1 - t, x_i ~ a r^{w_i}, and v_i = w_i - w_0 the valuation of the affine coordinate
//      x_i / x_0:  v_i < 0 is a coordinate that grows. Valuations come from the tangent, w_i = -r Re(x_i' / x_i).
//      Where min v_i is negative and steady, the coordinate has grown by a large factor, and the condition with it, the path
//      is a candidate. It is cut where the face of its direction has a root beside it, without which nothing is at
//      infinity (face.h): growth alone decides nothing.
//      A path that grows without being steady at r = 1e-10 descends further, in log r.
//   3. Otherwise circles t = 1 - r e^{i theta}: after m turns the path closes; m is the winding number, and the mean of
//      equidistant samples is the end point (Cauchy's integral; the error falls geometrically in the number of samples).
//      The samples' Laurent series in (1 - t)^{1/m} must have no negative powers: then t = 1 is the only
//      branch point inside. Radii shrink until that is so and two estimates agree.
//   4. Several turns about a mean that is not clearly a singular root: a landing from the last radius
//      to t = 1 tells whether simple roots close to each other were taken for one.
//
// Thrifty, where paths that fail by precision go on in double-double at once: one that grows to the last is not circled.
//
// Straight, for trackers beyond double: the way only, no circles. The end is regular, at infinity or has failed. Valuations come
// from differences of log |x_i / x_0| then, since J in double says nothing where such trackers are needed.
//
// x: N homogeneous coordinates of a chart, which knows x_0. accuracy: relative, |x - x*|_inf / |x|_inf in homogeneous coordinates.
// Edges: a path that breaks off far from t = 1 has failed, with the reason. Not supported: winding numbers above maximum_winding.
// Source: [MSW91] for the Cauchy integral, [HuberVerschelde98] and [Timme21] for valuations.
#pragma once

#include <limits>
#include <optional>
#include <vector>

#include "moivre/tracker/tracker.h"

namespace moivre {

enum class PathStatus { finite, at_infinity, failed };
std::string to_string(PathStatus status);

/// Why a path failed.
enum class Failure {
  step_limit,      ///< the budget of steps was used up
  step_too_small,  ///< the path could not be followed any further, far from t = 1
  precision,       ///< the endgame's estimates do not agree in this precision
  bad_start,       ///< Newton does not converge from the start point
  cancelled,       ///< the run was interrupted
  jumped           ///< its end belongs to another path, and tracking it again did not help
};
std::string to_string(Failure failure);
/// Why a path failed whose journey ended so, short of its end.
Failure to_failure(Journey journey);

struct EndgameOptions {
  double watch_radius = 0.1;  ///< |1 - t| from which the path is watched
  double regular_condition =
      1e8;  ///< condition at t = 1 up to which an arrival is regular without more ado
  double singular_condition =
      1e11;                  ///< condition from which an end of winding number 1 is called singular
  int samples = 16;          ///< of one turn
  int maximum_winding = 32;  ///< turns tried before a circle counts as not closing
  int maximum_radii = 20;    ///< circles tried
  std::uint64_t maximum_steps = 6000;  ///< of all journeys of one path, then the endgame concludes
};

/// The verdict on one path.
struct PathEnd {
  PathStatus status = PathStatus::failed;
  std::optional<Failure> failure;
  Point x;  ///< homogeneous end point; the last point when failed
  bool singular = false;
  std::optional<int> winding;  ///< nullopt: Newton landed on the end, and it is to prove simple
  double accuracy = 0;
  double size = 1;        ///< |x|_inf / |x_0|, in the path's frame
  double condition = 0;   ///< of the bordered, row-scaled Jacobian
  Complex t = 0;          ///< how far it came
  FramePointer frame;     ///< in which the path was followed; nullptr: in none
  std::size_t stage = 0;  ///< of the plan, on which it ended
  Complex
      mark;  ///< of the point from which it set out on the last stage, where there are several (solver/marks.h)
  StepCount count;
};

class Endgame : public Watcher {
 public:
  enum class Manner {
    full,
    thrifty,  ///< where a path that grows to the last is handed on, it has failed by precision without a circle
    straight
  };
  Endgame(const EndgameOptions& options, const Chart& chart, std::uint64_t path, int care,
          Manner manner = Manner::full);

  /// The first departure, from a start point at t = 0, in the frame where there is one.
  Departure depart(Point start, FramePointer frame = nullptr);

  /// Takes an arrival. The next departure, or nullopt when the verdict stands. `path`: scratch for evaluations.
  std::optional<Departure> accept(Arrival&& arrival, PathSystem& path);

  const PathEnd& end() const noexcept { return end_; }
  PathEnd& end() noexcept { return end_; }

  Verdict watch(const StepRecord& step, PathSystem& path) noexcept override;

 private:
  enum class Phase { whole_way, descent, approach, circle, landing };

  /// A watched point.
  struct Sight {
    double radius = 0;
    std::vector<double>
        valuations;  ///< v_i of the affine coordinates: real parts of their logarithmic slopes
    std::vector<double> turning;  ///< their imaginary parts
    double least = 0;             ///< the least of them, or 0
    double condition = 0;
    double size = 0;  ///< of the largest affine coordinate
  };
  /// A watched point whose sight nobody has asked for yet.
  struct Unseen {
    Point x;
    PathTime t;
  };
  struct Estimate {
    Point x;
    int winding = 0;
  };

  bool is_time_to_look(double radius) const;
  bool look(PathSystem& path);
  Sight sight(const Point& x, double radius, PathSystem& path);
  Verdict watch_straight(const StepRecord& step, PathSystem& path) noexcept;
  bool valuations_are_steady(std::size_t sights, double tolerance) const;
  double drift(std::size_t i, std::size_t sights) const;
  bool settles(std::size_t i) const;
  bool growth_lasts(double tolerance) const;
  bool diverges(double tolerance) const;
  bool diverges_beyond_double() const;
  bool leads_to_infinity(const Point& x, double radius, const PathSystem& path);
  bool stays_at_infinity(const Point& x, double radius, const PathSystem& path) const;
  bool may_diverge() const;
  std::optional<Departure> proceed(Arrival&& arrival, PathSystem& path);
  Departure along(const Contour& contour, Point x, int samples = 0, Watcher* watcher = nullptr);
  std::optional<Departure> judge_arrival(Arrival&& arrival, PathSystem& path);
  bool is_handed_on(const Arrival& arrival) const;
  Departure descend(Arrival&& arrival);
  std::nullopt_t at_infinity();
  std::optional<Departure> begin_circle();
  std::optional<Departure> next_turn(Arrival&& arrival, PathSystem& path);
  std::optional<Departure> shrink(PathSystem& path);
  std::optional<Departure> conclude(PathSystem& path);
  std::optional<Departure> estimate_end(PathSystem& path);
  Point laurent_coefficient(int j) const;
  double truncation() const;
  double landing_condition() const;
  std::optional<Departure> land();
  bool is_power_series(const Point& constant, PathSystem& path) const;
  bool is_regular_arrival(const Arrival& arrival, PathSystem& path, double condition);
  std::nullopt_t decide_infinity(const PathSystem& path);
  Point normalized(const Point& x) const;
  std::nullopt_t fail(Failure failure);

  EndgameOptions options_;
  Chart chart_;
  std::uint64_t path_;
  int care_;
  Manner manner_;
  FramePointer frame_;
  Phase phase_ = Phase::whole_way;
  PathEnd end_;

  // Watching.
  std::vector<Sight> sights_;
  std::vector<Unseen> unseen_;  // after the last sight
  double last_kept_ =
      std::numeric_limits<double>::infinity();  // |1 - t| of the last point kept to be seen
  int watched_ = 0;
  int creeping_ = 0;  ///< watched steps within the radius of the singular ends
  bool cut_ = false;
  double doubted_ = std::numeric_limits<
      double>::infinity();  // |1 - t| where growth was last found to lead nowhere
  Point outpost_;           // last watched point, from which circles begin
  double radius_ = 0;       // its |1 - t|
  Point tangent_;
  std::vector<Complex> logarithms_;  // of x_i / x_0, where the last sight was begun
  double logarithms_radius_ = 0;

  // Circles.
  Point patch_;                 // fixed affine patch of all samples
  Point turn_begin_;            // normalized point at angle 0
  std::vector<Point> samples_;  // normalized, over all turns so far
  int turns_ = 0;
  int radii_ = 0;
  std::optional<Estimate> last_;
  std::optional<Estimate> best_;
  double best_difference_ = 0;
};

}  // namespace moivre
