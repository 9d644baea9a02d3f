// SPDX-License-Identifier: MIT
// Undecided checkpoints at crossings, and the fine times beside them.
#include "step_aside.h"

#include <algorithm>
#include <iterator>

namespace moivre {
namespace {

bool is_crossing(const MotionRun& run, const Scene& scene) {
  return std::any_of(run.tracks.begin(), run.tracks.end(), [&](const Track& track) {
    for (const Branch* way : {&track.forwards, &track.backwards}) {
      const bool crosses = way->event && way->event->kind == EventKind::bifurcation;
      if (crosses && is_event_time(run, *way->event, scene.time)) return true;
    }
    return false;
  });
}

/// The fine time before or behind `time`; nothing where that is no fine time, or the first or last one.
std::optional<double> fine_beside(const MotionTimes& times, double time, int side) {
  for (int k = 1; k < times.fine_steps; ++k) {
    if (times.fine(k) == time) return times.fine(k + side);
  }
  return std::nullopt;
}

bool has_scene(const std::vector<Scene>& scenes, double time) {
  return std::any_of(scenes.begin(), scenes.end(),
                     [&](const Scene& scene) { return scene.time == time; });
}

}  // namespace

std::vector<double> step_aside(const MotionRun& run, const Tracker& tracker,
                               std::vector<Scene>& scenes) {
  std::vector<double> times;
  for (const Scene& scene : scenes) {
    const bool is_undecided = !scene.closures.complete && is_crossing(run, scene);
    if (is_undecided && fine_beside(run.times, scene.time, 1)) times.push_back(scene.time);
  }
  std::vector<Scene> beside;
  for (const double time : times) {
    for (const int side : {-1, 1}) {
      const double there = *fine_beside(run.times, time, side);
      if (run.stop || has_scene(scenes, there) || has_scene(beside, there)) continue;
      beside.push_back(solve_scene(run, tracker, there));
    }
  }
  std::erase_if(scenes, [&](const Scene& scene) {
    return std::find(times.begin(), times.end(), scene.time) != times.end();
  });
  std::move(beside.begin(), beside.end(), std::back_inserter(scenes));
  std::sort(scenes.begin(), scenes.end(),
            [](const Scene& a, const Scene& b) { return a.time < b.time; });
  return times;
}

}  // namespace moivre
