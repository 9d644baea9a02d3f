// SPDX-License-Identifier: MIT
// The freedoms that opening a joint gives, and along which lines they move its two ends.
#include "moivre/kinematics/transmission.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "moivre/kinematics/null_space.h"
#include "moivre/kinematics/own_units.h"
#include "moivre/mechanism/joint_type.h"
#include "moivre/mechanism/pose.h"

namespace moivre {
namespace {

using Eigen::Index;
using Eigen::Matrix2d;
using Eigen::MatrixXd;
using Eigen::Vector2d;
using Eigen::VectorXd;

// A displacement this small relative to the largest is rounding: poses are known to about 1e-13.
constexpr double kStandsStill = 1e-7;

constexpr Index kCoordinates = 3;  // x, y, phi

bool is_tied_by_driver(const Mechanism& mechanism, std::size_t number) {
  const Joint& joint = mechanism.joints[number];
  return std::any_of(mechanism.drivers.begin(), mechanism.drivers.end(), [&](const Driver& driver) {
    if (driver.kind == DriverKind::slide) return driver.joint == number;
    if (driver.kind != DriverKind::angle) return false;
    return std::is_permutation(driver.bodies.begin(), driver.bodies.end(),
                               std::array{joint.at[0].body, joint.at[1].body}.begin());
  });
}

/// How each freedom moves what the body has at `place`, in the ground frame: 2 x (number of
/// freedoms).
MatrixXd displacements(std::size_t body, const Eigen::Vector3d& place, const VectorXd& q,
                       const MatrixXd& freedoms) {
  if (body == 0) return MatrixXd::Zero(2, freedoms.cols());
  const Index at = kCoordinates * (static_cast<Index>(body) - 1);
  const Vector2d arm = place.head<2>() - q.segment<2>(at);
  MatrixXd moved = freedoms.middleRows(at, 2);
  moved.row(0) -= arm.y() * freedoms.row(at + 2);
  moved.row(1) += arm.x() * freedoms.row(at + 2);
  return moved;
}

/// How far each freedom moves anything, roughly: an angle counts with the largest arm that a point
/// has.
double extent_of(const Mechanism& mechanism, const MatrixXd& freedoms) {
  double arm = 0;
  for (const Body& body : mechanism.bodies) {
    for (const BodyPoint& point : body.points) arm = std::max(arm, point.at.norm());
  }
  double square = 0;
  for (Index row = 0; row < freedoms.rows(); ++row) {
    const double scale = row % kCoordinates == 2 ? arm : 1;
    square += scale * scale * freedoms.row(row).squaredNorm();
  }
  return std::sqrt(square);
}

/// Of the 2 x k displacements: the only line along which they lie; nullopt where there is none or
/// more.
std::optional<Vector2d> only_line(const MatrixXd& moved, double size) {
  const Matrix2d square = moved * moved.transpose();
  const double trace = square.trace();
  if (std::sqrt(trace) <= kStandsStill * size) return std::nullopt;
  // The eigenvector of the larger eigenvalue, from half the angle between the axes.
  const double angle = 0.5 * std::atan2(2 * square(0, 1), square(0, 0) - square(1, 1));
  const Vector2d along(std::cos(angle), std::sin(angle));
  const Vector2d across(-along.y(), along.x());
  const double aside = (across.transpose() * moved).norm();
  if (aside > kStandsStill * std::sqrt(trace)) return std::nullopt;
  return along;
}

double angle_between(const Vector2d& a, const Vector2d& b) {
  return std::atan2(std::abs(a.x() * b.y() - a.y() * b.x()), std::abs(a.dot(b)));
}

/// The line along which a slot or a rod pushes.
Vector2d push(const Mechanism& mechanism, const Joint& joint, const VectorXd& q) {
  if (joint.type == JointType::rod) {
    return (point_position(mechanism, joint.at[1], q) - point_position(mechanism, joint.at[0], q))
        .head<2>();
  }
  const Vector2d along = (orientation(mechanism, joint.at[0].body, q) * joint.axis[0]).head<2>();
  return {-along.y(), along.x()};
}

}  // namespace

std::vector<TransmissionJoint> transmission_joints(const Mechanism& mechanism) {
  std::vector<TransmissionJoint> found;
  if (is_typed(mechanism) || mechanism.space == Space::spatial) return found;
  Index row = 0;
  for (std::size_t k = 0; k < mechanism.joints.size(); ++k) {
    const Joint& joint = mechanism.joints[k];
    const Index rows = kCoordinates - freedoms(joint.type, Space::planar);
    const bool pushes = joint.type == JointType::revolute || joint.type == JointType::slot ||
                        joint.type == JointType::rod;
    const bool moves = joint.at[0].body != 0 && joint.at[1].body != 0;
    if (pushes && moves && !is_tied_by_driver(mechanism, k)) found.push_back({k, row, rows});
    row += rows;
  }
  return found;
}

std::optional<double> transmission_angle(const Mechanism& mechanism, const Phi& phi,
                                         const TransmissionJoint& at, const VectorXd& q,
                                         const MatrixXd& Phi_q) {
  const Joint& joint = mechanism.joints[at.joint];
  const Index behind = at.first_row + at.rows;
  const MatrixXd J = in_own_units(phi, Phi_q);
  MatrixXd open(J.rows() - at.rows, J.cols());
  open << J.topRows(at.first_row), J.bottomRows(J.rows() - behind);
  const MatrixXd freedoms = phi.own_units().asDiagonal() * null_space_basis(open);
  if (freedoms.cols() != at.rows) return std::nullopt;
  // A slot's first body touches the pin wherever that stands.
  const Eigen::Vector3d end = point_position(mechanism, joint.at[1], q);
  const Eigen::Vector3d begin =
      joint.type == JointType::slot ? end : point_position(mechanism, joint.at[0], q);
  const MatrixXd first = displacements(joint.at[0].body, begin, q, freedoms);
  const MatrixXd second = displacements(joint.at[1].body, end, q, freedoms);
  const double size = extent_of(mechanism, freedoms);
  const std::optional<Vector2d> u1 = only_line(first, size);
  const std::optional<Vector2d> u2 = only_line(second, size);
  if (joint.type == JointType::revolute) {
    if (!u1 || !u2) return std::nullopt;
    return angle_between(*u1, *u2);
  }
  if (u1.has_value() == u2.has_value()) return std::nullopt;
  const Vector2d n = push(mechanism, joint, q);
  const Vector2d u = u1 ? *u1 : *u2;
  return std::atan2(std::abs(n.dot(u)), std::abs(n.x() * u.y() - n.y() * u.x()));
}

}  // namespace moivre
