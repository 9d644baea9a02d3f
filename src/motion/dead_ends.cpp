// SPDX-License-Identifier: MIT
// Double closures of the first and the last scene, and the tracks that meet there.
#include "dead_ends.h"

#include <algorithm>

#include "moivre/kinematics/own_units.h"

namespace moivre {
namespace {

// l' Phi_t beside Phi_t: what vanishes is known to the square root of the rounding, as the pose is.
constexpr double kStands = 1e-6;

bool is_dead_point(const Phi& phi, const Eigen::VectorXd& q, double time) {
  const Eigen::MatrixXd l = left_null_space_of(phi, phi.jacobian(q, time));
  const Eigen::VectorXd rates = phi.velocity_rhs(q, time).cwiseQuotient(phi.own_row_units());
  return l.cols() == 1 && std::abs(l.col(0).dot(rates)) > kStands * rates.norm();
}

void end_at(const BranchEvent& event, Branch& way) {
  if (way.event || way.status != BranchStatus::reached) return;
  way.event = event;
  way.status = BranchStatus::ended;
  way.message = to_string(event.kind);
}

void drop_samples(Branch& way, double time) {
  std::erase_if(way.samples, [&](const BranchSample& sample) { return sample.time == time; });
}

}  // namespace

void mark_dead_ends(MotionRun& run, std::vector<Scene>& scenes) {
  for (Scene& scene : scenes) {
    const bool is_last = scene.time == run.times.to;
    if ((!is_last && scene.time != run.times.from) || match(run, scene)) continue;
    for (std::size_t j = 0; j < scene.track_of.size(); ++j) {
      const Closure& closure = scene.closures.closures[j];
      if (closure.multiplicity != 2 || scene.beside[j].size() != 1) continue;
      if (!is_dead_point(run.phi, closure.q, scene.time)) continue;
      BranchEvent event;
      event.time = scene.time;
      for (const std::size_t k : {*scene.track_of[j], scene.beside[j].front()}) {
        Track& track = run.tracks[k];
        event.q = track.at(scene.time)->q;
        end_at(event, is_last ? track.forwards : track.backwards);
        drop_samples(track.forwards, scene.time);
        drop_samples(track.backwards, scene.time);
      }
    }
  }
}

}  // namespace moivre
