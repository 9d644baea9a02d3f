// SPDX-License-Identifier: MIT
// What does a tracker promise? It follows pieces of paths along contours, and says of each how far it came.
//
// A job source hands out Departures; the tracker takes each as far as it can and gives the Arrival to the sink, which may
// have made further departures (an endgame's circles) in the meantime. A tracker with many lanes keeps many
// departures going at once; one with a single lane takes them one by one. It decides nothing about roots: statuses here
// tell about the journey, the end is judged by endgame/, the account is kept by solver/.
//
// x: N homogeneous coordinates, s: contour parameter in [0, 1], t = contour(s).
#pragma once

#include <atomic>
#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "moivre/homotopy/homotopy.h"
#include "moivre/tracker/contour.h"
#include "moivre/tracker/path_system.h"

namespace moivre {

/// One accepted step, as a watcher sees it. The spans are valid during the call only.
struct StepRecord {
  double s = 0;
  PathTime t{0.0};
  std::span<const Complex> x;
  double step = 0;        ///< in s
  int order = 0;          ///< of the predictor or integrator
  double drift = 0;       ///< max_i |H_i| before the Newton correction
  double correction = 0;  ///< |dx_1|_w of the first Newton correction; 0 without correction
};

/// Sees every accepted step of one departure, and may end it. Called by the thread that tracks; must not throw.
class Watcher {
 public:
  virtual ~Watcher() = default;
  enum class Verdict { go_on, stop };
  virtual Verdict watch(const StepRecord& step, PathSystem& path) noexcept = 0;
};

struct Departure {
  std::uint64_t path = 0;
  Contour contour = Contour::segment(0, 1);
  Point x;          ///< N coordinates, on the path at contour(0) or near it
  int care = 0;     ///< 0: as the options say; each level more tracks with tighter tolerances
  int samples = 0;  ///< points wanted at s = 1/samples, 2/samples, ..., 1; 0: none
  Watcher* watcher = nullptr;  ///< not owned; nullptr: nobody watches
  /// The watcher sees the steps that end with |1 - t| up to this.
  double watch_radius = std::numeric_limits<double>::infinity();
  FramePointer frame = nullptr;  ///< the path's, where the homotopy is framed; x is in it
};

enum class Journey {
  arrived,         ///< s = 1 was reached, x is on the path there
  stopped,         ///< the watcher ended it
  bad_start,       ///< Newton does not converge from the departure's x
  step_limit,      ///< the budget of steps or evaluations is used up
  step_too_small,  ///< the step fell below the spacing of numbers
  off_path,        ///< the integrator reached s = 1, but Newton does not converge there
  cancelled        ///< the stop token was set
};

struct StepCount {
  std::uint64_t accepted = 0;
  std::uint64_t rejected = 0;
  WorkCount work;

  StepCount& operator+=(const StepCount& other);
};

struct Arrival {
  Journey journey = Journey::cancelled;
  Point x;       ///< last point on the path
  double s = 0;  ///< where on the contour
  PathTime t{0.0};
  StepCount count;
  std::vector<Point>
      samples;  ///< in the order of s; all of them when arrived, else what was passed
  /// At t = 1, by trackers that work beyond double: condition of J where Newton's method ended quadratically, at a
  /// point known better than double tells. nullopt: nobody looked.
  std::optional<double> regular_condition;
};

/// Hands out departures. `next` may be called by the thread of one session only.
class DepartureSource {
 public:
  virtual ~DepartureSource() = default;
  /// The next departure, or nullopt when there is none *now*; the session ends when it has none under way either.
  virtual std::optional<Departure> next() = 0;
  /// Takes what became of a departure. It may make further departures for `next`.
  virtual void arrived(const Departure& departure, Arrival&& arrival) = 0;
};

/// The tracking of one thread. Owns all memory a journey needs; allocates nothing per step.
class TrackerSession {
 public:
  virtual ~TrackerSession() = default;
  /// Until the source is dry. A set `stop` ends journeys under way with Journey::cancelled.
  virtual void run(DepartureSource& source, const std::atomic<bool>& stop) noexcept = 0;
};

class Tracker {
 public:
  virtual ~Tracker() = default;
  /// "cvode", "lanes".
  virtual std::string kind() const = 0;
  /// Name and value of every option in force, for the report.
  virtual std::vector<std::pair<std::string, std::string>> options_in_force() const = 0;
  /// A session on `homotopy`, which must outlive it. Thread-safe.
  virtual std::unique_ptr<TrackerSession> open(const Homotopy& homotopy) const = 0;
  /// The same tracker with every number of a path in double-double; nullptr where there is none.
  virtual std::unique_ptr<Tracker> in_double_double() const { return nullptr; }
};

/// Follows a single departure in a session of its own.
Arrival follow(TrackerSession& session, Departure departure, const std::atomic<bool>& stop);

}  // namespace moivre
