// SPDX-License-Identifier: MIT
// Each constraint that reads a dimension is made anew with that dimension moving, and evaluated.
#include "moivre/mechanism/dimension_rates.h"

#include <algorithm>

#include "pose_jets.h"

namespace moivre {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

bool is_at(const Dimension& dimension, const PointOf& point) {
  return dimension.kind == DimensionKind::point && dimension.point.body == point.body &&
         dimension.point.point == point.point;
}

bool reads(const Mechanism& mechanism, const Joint& joint, const Dimension& dimension) {
  return is_at(dimension, joint.at[0]) || is_at(dimension, joint.at[1]) ||
         is_moving(mechanism, joint, DimensionKind::length, &dimension) ||
         is_moving(mechanism, joint, DimensionKind::turn, &dimension);
}

bool reads(const Mechanism& mechanism, const Driver& driver, const Dimension& dimension) {
  if (dimension.kind == DimensionKind::driver) {
    return &mechanism.drivers[dimension.driver] == &driver;
  }
  switch (driver.kind) {
    case DriverKind::angle:
      return mechanism.space == Space::spatial &&
             reads(mechanism, mechanism.joints[driver.joint], dimension);
    case DriverKind::slide:
      return reads(mechanism, mechanism.joints[driver.joint], dimension);
    case DriverKind::x:
    case DriverKind::y:
    case DriverKind::z:
      return is_at(dimension, driver.point);
    case DriverKind::unknown:
      break;
  }
  return false;
}

std::vector<Jet> moving_jets(const VectorXd& q, const VectorXd& qdot) {
  std::vector<Jet> jets;
  for (Index k = 0; k < q.size(); ++k) jets.emplace_back(q[k], qdot[k], 0);
  return jets;
}

/// Fills rows of Phi_p, one constraint after another.
class PartialRows {
 public:
  PartialRows(const std::vector<Dimension>& dimensions, const VectorXd& q, double t)
      : dimensions_(dimensions), q_(moving_jets(q, VectorXd::Zero(q.size()))), t_(t) {}

  /// `make(moving)` makes the constraint, `is_read(dimension)` says whether it depends on the
  /// dimension.
  template <class Make, class IsRead>
  void add(const Make& make, const IsRead& is_read) {
    const auto rows = static_cast<Index>(make(nullptr)->labels.size());
    MatrixXd part = MatrixXd::Zero(rows, static_cast<Index>(dimensions_.size()));
    std::vector<Jet> values(static_cast<std::size_t>(rows));
    for (std::size_t k = 0; k < dimensions_.size(); ++k) {
      if (!is_read(dimensions_[k])) continue;
      make(&dimensions_[k])->evaluate(At<Jet>{q_, Jet(t_)}, values.data());
      for (Index i = 0; i < rows; ++i) {
        part(i, static_cast<Index>(k)) = values[static_cast<std::size_t>(i)].d;
      }
    }
    parts_.push_back(std::move(part));
  }

  void add_zeros(std::size_t rows) {
    parts_.push_back(
        MatrixXd::Zero(static_cast<Index>(rows), static_cast<Index>(dimensions_.size())));
  }

  MatrixXd whole() const {
    Index rows = 0;
    for (const MatrixXd& part : parts_) rows += part.rows();
    MatrixXd all(rows, static_cast<Index>(dimensions_.size()));
    Index first = 0;
    for (const MatrixXd& part : parts_) {
      all.middleRows(first, part.rows()) = part;
      first += part.rows();
    }
    return all;
  }

 private:
  const std::vector<Dimension>& dimensions_;
  std::vector<Jet> q_;
  double t_;
  std::vector<MatrixXd> parts_;
};

}  // namespace

MatrixXd partial_dimensions(const Mechanism& mechanism, const std::vector<Dimension>& dimensions,
                            const VectorXd& q, double t) {
  PartialRows rows(dimensions, q, t);
  rows.add_zeros(mechanism.equations.size());
  for (const Joint& joint : mechanism.joints) {
    rows.add([&](const Dimension* moving) { return joint_constraint(mechanism, joint, moving); },
             [&](const Dimension& dimension) { return reads(mechanism, joint, dimension); });
  }
  for (const Driver& driver : mechanism.drivers) {
    rows.add([&](const Dimension* moving) { return driver_constraint(mechanism, driver, moving); },
             [&](const Dimension& dimension) { return reads(mechanism, driver, dimension); });
  }
  return rows.whole();
}

Eigen::Vector3d point_rate(const Mechanism& mechanism, const PointOf& point, const VectorXd& q,
                           const VectorXd& qdot, const Dimension* dimension) {
  const std::vector<Jet> jets = moving_jets(q, qdot);
  const auto r = position_jet(mechanism, point, {jets, Jet(0)}, dimension);
  return {r.x.d, r.y.d, r.z.d};
}

std::optional<double> joint_rate(const Mechanism& mechanism, const Joint& joint, const VectorXd& q,
                                 const VectorXd& qdot, const Dimension* dimension) {
  const std::vector<Jet> jets = moving_jets(q, qdot);
  const std::optional<Jet> coordinate = joint_jet(mechanism, joint, {jets, Jet(0)}, dimension);
  return coordinate ? std::optional(coordinate->d) : std::nullopt;
}

}  // namespace moivre
