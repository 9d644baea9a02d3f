// SPDX-License-Identifier: MIT
// Closures solved at checkpoints and between them, and the tracks that are there.
#include "scene.h"

#include <algorithm>

namespace moivre {
namespace {

/// Whether a branch could begin and end between two scenes and not show where complex closures go.
bool is_hidden(const Scene& a, const Scene& b, const std::function<bool(double)>& can_follow) {
  const auto has_limited = [](const Scene& scene) {
    const ClosureCounts& counts = scene.closures.counts;
    return counts.real + counts.fitted > scene.closures.closures.size();
  };
  const auto has_complex = [](const Scene& scene) {
    const ClosureCounts& counts = scene.closures.counts;
    return counts.complex > counts.real;
  };
  if (has_limited(a) || has_limited(b)) return true;
  return (has_complex(a) || has_complex(b)) && !can_follow((a.time + b.time) / 2);
}

}  // namespace

Scene solve_scene(const MotionRun& run, const Tracker& tracker, double time) {
  ClosureOptions options;
  options.time = time;
  options.solve = run.options.solve;
  options.certify = false;  // what is compared with branches needs no proof of its own
  Scene scene;
  scene.time = time;
  scene.closures = find_closures(run.mechanism, tracker, options, run.stop);
  scene.poses = KnownPoses(run.phi, scene.closures.closures);
  scene.track_of.resize(scene.closures.closures.size());
  return scene;
}

std::vector<Scene> solve_scenes(const MotionRun& run, const Tracker& tracker) {
  std::vector<Scene> scenes;
  for (int c = 0; c <= run.options.checkpoints && !run.stop; ++c) {
    scenes.push_back(solve_scene(run, tracker, run.times.fine(c * kFiner)));
    run.show_progress(0.5 * (c + 1) / (run.options.checkpoints + 1));
  }
  return scenes;
}

bool look_closer(const MotionRun& run, const Tracker& tracker,
                 const std::function<bool(double)>& can_follow, std::vector<Scene>& scenes) {
  if (run.mechanism.drivers.empty() || scenes.empty()) return false;
  std::vector<Scene> all;
  for (std::size_t c = 0; c < scenes.size(); ++c) {
    if (c > 0 && is_hidden(all.back(), scenes[c], can_follow)) {
      const int before = static_cast<int>(c - 1) * kFiner;
      for (int k = 1; k < kFiner && !run.stop; ++k) {
        all.push_back(solve_scene(run, tracker, run.times.fine(before + k)));
      }
    }
    all.push_back(std::move(scenes[c]));
  }
  const bool is_new = all.size() > scenes.size();
  scenes = std::move(all);
  return is_new;
}

void add_scenes(MotionRun& run, const Tracker& tracker, const std::vector<double>& times,
                std::vector<Scene>& scenes) {
  for (const double time : times) {
    if (run.stop) return;
    run.add_time(time);
    scenes.push_back(solve_scene(run, tracker, time));
  }
  std::sort(scenes.begin(), scenes.end(),
            [](const Scene& a, const Scene& b) { return a.time < b.time; });
}

std::optional<std::pair<std::size_t, std::size_t>> match(const MotionRun& run, Scene& scene) {
  std::optional<std::pair<std::size_t, std::size_t>> conflict;
  std::fill(scene.track_of.begin(), scene.track_of.end(), std::nullopt);
  for (std::size_t k = 0; k < run.tracks.size(); ++k) {
    const BranchSample* sample = run.tracks[k].at(scene.time);
    if (sample == nullptr) continue;
    const auto nearest = scene.poses.nearest(run.phi, scene.closures.closures, sample->q);
    if (!nearest) continue;
    auto& owner = scene.track_of[*nearest];
    if (!owner) {
      owner = k;
    } else if (!conflict) {
      conflict = {*owner, k};
    }
  }
  return conflict;
}

}  // namespace moivre
