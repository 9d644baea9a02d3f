// SPDX-License-Identifier: MIT
// Lines of axes, where they meet, and on which side of each other they are.
#include "moivre/arms/posture.h"

#include <cmath>

#include "moivre/expression/joined.h"

namespace moivre {
namespace {

using Eigen::Vector3d;

/// Sines below are of parallel axes, distances relative to the arm's length of axes that meet:
/// files hold six decimals.
constexpr double kSame = 1e-5;
/// Signs of what is smaller, relative to its size, are rounding's.
constexpr double kUndecided = 1e-9;

struct Line {
  Vector3d at;
  Vector3d along;  ///< unit
};

std::vector<Line> axes_of(const Arm& arm, const Eigen::VectorXd& values) {
  std::vector<Line> lines;
  const std::vector<Eigen::Isometry3d> frames = joint_frames(arm, values);
  for (std::size_t k = 0; k < frames.size(); ++k) {
    lines.push_back({frames[k].translation(), frames[k].linear() * arm.joints[k].axis});
  }
  return lines;
}

bool are_parallel(const Line& a, const Line& b) { return a.along.cross(b.along).norm() < kSame; }

double distance(const Line& a, const Vector3d& point) { return a.along.cross(point - a.at).norm(); }

std::optional<Vector3d> meeting(const Line& a, const Line& b, double length) {
  const Vector3d normal = a.along.cross(b.along);
  if (normal.norm() < kSame) return std::nullopt;
  const double along = (b.at - a.at).cross(b.along).dot(normal) / normal.squaredNorm();
  const Vector3d point = a.at + along * a.along;
  return distance(b, point) < kSame * length ? std::optional(point) : std::nullopt;
}

std::optional<bool> is_positive(double x, double size) {
  return std::abs(x) > kUndecided * size ? std::optional(x > 0) : std::nullopt;
}

bool is_on_the_right(const Line& first, const Line& second, const Vector3d& up, const Vector3d& end,
                     double length) {
  const double offset = second.along.dot(end - first.at);
  const double ahead = up.cross(second.along).dot(end - first.at);
  return (std::abs(offset) > kSame * length ? offset * ahead : ahead) > 0;
}

std::optional<bool> is_elbow_up(const std::vector<Line>& axes, const Vector3d& up,
                                const Vector3d& end, double length) {
  const Vector3d& normal = axes[1].along;
  const auto in_plane = [&](const Vector3d& x) { return Vector3d(x - normal.dot(x) * normal); };
  const Vector3d line = in_plane(end - axes[1].at);
  const Vector3d elbow = in_plane(axes[2].at - axes[1].at);
  if (line.norm() < kSame * length) return std::nullopt;
  const Vector3d above = elbow - line * (line.dot(elbow) / line.squaredNorm());
  return is_positive(up.dot(above), length);
}

}  // namespace

Posture posture_of(const Arm& arm, const Eigen::VectorXd& values) {
  Posture posture;
  if (arm.joints.size() != 6) return posture;
  for (const ArmJoint& joint : arm.joints) {
    if (joint.is_slide) return posture;
  }
  const std::vector<Line> axes = axes_of(arm, values);
  const std::optional<Vector3d> wrist = meeting(axes[4], axes[5], arm.length);
  const bool is_wrist = wrist && distance(axes[3], *wrist) < kSame * arm.length;
  const bool is_planar = are_parallel(axes[1], axes[2]) && !are_parallel(axes[0], axes[1]);
  const bool is_long = wrist && is_planar && are_parallel(axes[2], axes[3]);
  if (!is_wrist && !is_long) return posture;
  const auto flip = is_positive(axes[4].along.dot(axes[3].along.cross(axes[5].along)), 1);
  if (flip) posture.is_flipped = !*flip;
  if (!is_planar) return posture;
  const Vector3d up = axes[0].along.z() < 0 ? Vector3d(-axes[0].along) : axes[0].along;
  posture.is_right = is_on_the_right(axes[0], axes[1], up, *wrist, arm.length);
  posture.is_up = is_elbow_up(axes, up, is_long ? axes[3].at : *wrist, arm.length);
  return posture;
}

std::string to_string(const Posture& posture) {
  std::vector<std::string> words;
  if (posture.is_right) words.emplace_back(*posture.is_right ? "shoulder right" : "shoulder left");
  if (posture.is_up) words.emplace_back(*posture.is_up ? "elbow up" : "elbow down");
  if (posture.is_flipped) words.emplace_back(*posture.is_flipped ? "flip" : "no flip");
  return joined(words, ", ");
}

}  // namespace moivre
