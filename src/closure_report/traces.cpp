// SPDX-License-Identifier: MIT
// Curves of points along branches.
#include "traces.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "moivre/mechanism/joint_type.h"
#include "moivre/mechanism/pose.h"
#include "shown_angles.h"

namespace moivre {
namespace {

MovingPoint moving_point(const Mechanism& mechanism, const Site& site) {
  const PointOf& point = site.points.front();
  const Body& body = mechanism.bodies[point.body];
  return {body.name + "." + body.points[point.point].name, point, site.is_jointed};
}

bool is_held_to_ground(const Mechanism& mechanism, std::size_t body) {
  return std::any_of(mechanism.joints.begin(), mechanism.joints.end(), [&](const Joint& joint) {
    const std::size_t a = joint.at[0].body;
    const std::size_t b = joint.at[1].body;
    const bool holds = !is_transmission(joint.type) && joint.type != JointType::rod &&
                       joint.type != JointType::actuator;
    return holds && ((a == 0 && b == body) || (b == 0 && a == body));
  });
}

/// q with whole turns added to its angles, so that they are nearest to those of `other`.
Eigen::VectorXd turned_near(const Mechanism& mechanism, Eigen::VectorXd q,
                            const Eigen::VectorXd& other) {
  const std::vector<Coordinate> names = coordinates(mechanism);
  for (Eigen::Index k = 0; k < q.size(); ++k) {
    if (!names[static_cast<std::size_t>(k)].is_periodic) continue;
    q[k] = other[k] + std::remainder(q[k] - other[k], 2 * std::numbers::pi);
  }
  return q;
}

}  // namespace

std::vector<TracedPose> traced_poses(const Mechanism& mechanism, const MotionBranch& branch,
                                     const MotionResult& result) {
  std::vector<TracedPose> poses;
  const auto add_event = [&](const std::optional<std::size_t>& event, bool is_end) {
    if (!event) return;
    const BranchEvent& at = result.events[*event].at;
    if (branch.samples.empty()) {
      poses.push_back({at.time, at.q, nullptr});
      return;
    }
    const BranchSample& beside = is_end ? branch.samples.back() : branch.samples.front();
    poses.push_back({at.time, turned_near(mechanism, at.q, beside.q), nullptr});
  };
  add_event(branch.begin_event, false);
  for (const BranchSample& sample : branch.samples) {
    poses.push_back({sample.time, sample.q, &sample});
  }
  add_event(branch.end_event, true);
  if (poses.empty()) return poses;
  const Eigen::VectorXd turns = turns_to_begin(mechanism, poses.front().q, poses.front().time);
  for (TracedPose& pose : poses) pose.q += turns;
  return poses;
}

std::vector<Eigen::VectorXd> all_poses(const Mechanism& mechanism, const MotionResult& result) {
  std::vector<Eigen::VectorXd> poses;
  for (const MotionBranch& branch : result.branches) {
    for (const TracedPose& pose : traced_poses(mechanism, branch, result)) poses.push_back(pose.q);
  }
  return poses;
}

std::vector<MovingPoint> moving_points(const Mechanism& mechanism) {
  std::vector<MovingPoint> points;
  for (const bool is_jointed : {false, true}) {
    for (const Site& site : sites(mechanism)) {
      const bool moves = std::none_of(site.points.begin(), site.points.end(),
                                      [](const PointOf& point) { return point.body == 0; });
      if (!moves || site.is_jointed != is_jointed) continue;
      points.push_back(moving_point(mechanism, site));
    }
  }
  return points;
}

std::vector<MovingPoint> traced_points(const Mechanism& mechanism) {
  std::vector<MovingPoint> free;
  std::vector<MovingPoint> floating;
  for (const Site& site : sites(mechanism)) {
    const MovingPoint point = moving_point(mechanism, site);
    const auto body_is_held = [&](const PointOf& p) {
      return is_held_to_ground(mechanism, p.body);
    };
    if (site.points.front().body == 0) continue;
    if (!site.is_jointed) free.push_back(point);
    if (std::none_of(site.points.begin(), site.points.end(), body_is_held)) {
      floating.push_back(point);
    }
  }
  if (!free.empty()) return free;
  return floating.empty() ? moving_points(mechanism) : floating;
}

std::vector<Complex> curve(const Mechanism& mechanism, const MovingPoint& point,
                           const MotionBranch& branch, const MotionResult& result) {
  std::vector<Complex> places;
  for (const TracedPose& pose : traced_poses(mechanism, branch, result)) {
    places.push_back(seen(mechanism, point_position(mechanism, point.point, pose.q)));
  }
  return places;
}

}  // namespace moivre
