// SPDX-License-Identifier: MIT
// Do twice the cores track twice as fast? Wall and CPU time of tracking over thread counts, and
// where the rest went.
//
//   scaling [--tracker cvode|lanes] [--repeat N] [--threads N] [PROBLEM...]     names of
//   problems/polynomials
//
// One process, its pool of threads warm; thread counts 1..N take turns in every repeat, so that
// what else the machine does meets all of them. Of tracking (SolveTime::track), k threads:
//
//   efficiency   T_1 / (k T_k), of medians and of minima
//   late         mean time after the first session's begin at which a session begins (threads
//                waking, sessions opening)
//   idle at end  mean time before the last session's end at which a session ends (the last paths
//                drain)
//
// late and idle are those of the run with the least wall time. The cold start is the process's
// first run on all threads.
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <exception>
#include <mutex>
#include <numeric>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

#include "moivre/polynomial/read.h"
#include "moivre/solver/solve.h"
#include "moivre/tracker/session.h"
#include "moivre/tracker_cvode/cvode_tracker.h"
#include "moivre/tracker_lanes/lane_tracker.h"

namespace {

using moivre::SolveResult;
using Clock = std::chrono::steady_clock;

struct Request {
  std::string tracker = "lanes";
  int repeats = 21;
  int threads = static_cast<int>(std::thread::hardware_concurrency());
  std::vector<std::string> names{"katsura-10"};
};

/// Throws std::invalid_argument or std::out_of_range when a number is not one.
Request request_of(int argc, char** argv) {
  Request request;
  std::vector<std::string> names;
  for (int k = 1; k < argc; ++k) {
    const std::string word = argv[k];
    const bool is_option = word == "--tracker" || word == "--repeat" || word == "--threads";
    if (is_option && k + 1 == argc) throw std::invalid_argument(word + " needs a value");
    if (word == "--tracker") {
      request.tracker = argv[++k];
    } else if (word == "--repeat") {
      request.repeats = std::stoi(argv[++k]);
    } else if (word == "--threads") {
      request.threads = std::stoi(argv[++k]);
    } else {
      names.push_back(word);
    }
  }
  if (!names.empty()) request.names = names;
  if (request.tracker != "cvode" && request.tracker != "lanes") {
    throw std::invalid_argument("no tracker: " + request.tracker);
  }
  if (request.repeats < 1) throw std::invalid_argument("--repeat must be at least 1");
  if (request.threads < 1) throw std::invalid_argument("--threads must be at least 1");
  return request;
}

/// When the sessions of a tracker were asked for, began and ended.
struct Sessions {
  struct Span {
    Clock::time_point begin, end;
  };
  std::mutex mutex;
  std::vector<Clock::time_point> asked;
  std::vector<Span> spans;
};

class TimedSession : public moivre::TrackerSession {
 public:
  TimedSession(std::unique_ptr<moivre::TrackerSession> session, Sessions& sessions)
      : session_(std::move(session)), sessions_(sessions) {}
  void run(moivre::SegmentSource& source, const std::atomic<bool>& stop) noexcept override {
    const Clock::time_point begin = Clock::now();
    session_->run(source, stop);
    const Clock::time_point end = Clock::now();
    const std::lock_guard lock(sessions_.mutex);
    sessions_.spans.push_back({begin, end});
  }

 private:
  std::unique_ptr<moivre::TrackerSession> session_;
  Sessions& sessions_;
};

/// A tracker that notes its sessions' times.
class TimedTracker : public moivre::Tracker {
 public:
  explicit TimedTracker(const moivre::Tracker& tracker) : tracker_(tracker) {}
  std::string kind() const override { return tracker_.kind(); }
  moivre::OptionsInForce options_in_force() const override { return tracker_.options_in_force(); }
  std::unique_ptr<moivre::TrackerSession> open(const moivre::Homotopy& homotopy) const override {
    {
      const std::lock_guard lock(sessions.mutex);
      sessions.asked.push_back(Clock::now());
    }
    return std::make_unique<TimedSession>(tracker_.open(homotopy), sessions);
  }

  mutable Sessions sessions;

 private:
  const moivre::Tracker& tracker_;
};

/// Seconds of one run's tracking.
struct Run {
  double wall, cpu, late, idle;
};

double seconds(Clock::duration d) { return std::chrono::duration<double>(d).count(); }

Run track(const moivre::System& f, const moivre::Tracker& tracker, int threads) {
  const TimedTracker timed(tracker);
  moivre::SolveOptions options;
  options.threads = threads;
  options.maximum_tolerance_level = 0;
  const SolveResult result = moivre::solve(f, timed, options);
  Run run{result.time.track, result.time.track_cpu, 0, 0};
  const Sessions& sessions = timed.sessions;
  Clock::time_point first = Clock::time_point::max();
  Clock::time_point last = Clock::time_point::min();
  for (const Clock::time_point& asked : sessions.asked) first = std::min(first, asked);
  for (const Sessions::Span& span : sessions.spans) last = std::max(last, span.end);
  for (const Sessions::Span& span : sessions.spans) {
    run.late += seconds(span.begin - first) / threads;
    run.idle += seconds(last - span.end) / threads;
  }
  return run;
}

struct Series {
  std::vector<Run> runs;

  const Run& least() const {
    return *std::min_element(runs.begin(), runs.end(),
                             [](const Run& a, const Run& b) { return a.wall < b.wall; });
  }
  double median(double Run::*what) const {
    std::vector<double> values;
    for (const Run& run : runs) values.push_back(run.*what);
    std::sort(values.begin(), values.end());
    return values[values.size() / 2];
  }
};

void measure(const std::string& name, const moivre::Tracker& tracker, const Request& request) {
  const std::string file = MOIVRE_SOURCE_DIR "/problems/polynomials/" + name + ".phc";
  const moivre::System f = moivre::read_system(moivre::read_source(file));
  std::vector<Series> series(static_cast<std::size_t>(request.threads));
  track(f, tracker, request.threads);
  for (int repeat = 0; repeat < request.repeats; ++repeat) {
    for (int k = 1; k <= request.threads; ++k) {
      series[static_cast<std::size_t>(k - 1)].runs.push_back(track(f, tracker, k));
    }
  }
  std::printf("%s, %s\n", name.c_str(), request.tracker.c_str());
  const double median1 = series[0].median(&Run::wall);
  const double least1 = series[0].least().wall;
  for (std::size_t k = 0; k < series.size(); ++k) {
    const Series& s = series[k];
    const double threads = static_cast<double>(k + 1);
    const double median = s.median(&Run::wall);
    const Run& least = s.least();
    std::printf("%9zu %9.2f %9.2f %9.2f %9.2f %10.3f %8.3f %9.2f %9.2f\n", k + 1, 1e3 * median,
                1e3 * least.wall, 1e3 * s.median(&Run::cpu), 1e3 * least.cpu,
                median1 / (threads * median), least1 / (threads * least.wall), 1e3 * least.late,
                1e3 * least.idle);
  }
  std::fflush(stdout);
}

void print_cold_start(const std::string& name, const moivre::Tracker& tracker, int threads) {
  const std::string file = MOIVRE_SOURCE_DIR "/problems/polynomials/" + name + ".phc";
  const moivre::System f = moivre::read_system(moivre::read_source(file));
  const Run cold = track(f, tracker, threads);
  std::printf("cold start, %s, %d threads: wall %.2f ms, late %.2f ms\n\n", name.c_str(), threads,
              1e3 * cold.wall, 1e3 * cold.late);
}

void run(const Request& request) {
  const auto tracker =
      request.tracker == "cvode" ? moivre::make_cvode_tracker() : moivre::make_lane_tracker();
  print_cold_start(request.names.front(), *tracker, request.threads);
  std::printf("%d repeats, milliseconds\n", request.repeats);
  std::printf("%9s %9s %9s %9s %9s %10s %8s %9s %9s\n", "", "wall", "wall", "CPU", "CPU",
              "efficiency", "", "late", "idle");
  std::printf("%9s %9s %9s %9s %9s %10s %8s %9s %9s\n", "threads", "median", "least", "median",
              "least", "of median", "of least", "at begin", "at end");
  for (const std::string& name : request.names) measure(name, *tracker, request);
}

}  // namespace

int main(int argc, char** argv) {
  try {
    run(request_of(argc, argv));
    return 0;
  } catch (const std::exception& fault) {
    std::fprintf(stderr, "scaling: %s\n", fault.what());
    return 2;
  }
}
