// SPDX-License-Identifier: MIT
// Which poses lie a step away from a pose of Phi = 0? Gauss-Newton on planes moved away from it.
//
//   y = q + C z      C: sizes of the coordinates; z: 0 for those that are held
//   N                null space of Phi_q C, rows at unit length: a set of poses lies along it
//   planes           A z = step (1, ..., 1), rows of A orthonormal in N
// Rows of Phi are weighted by their lengths at q.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <optional>
#include <vector>

#include "moivre/mechanism/phi.h"

namespace moivre {

class Slicing {
 public:
  static constexpr int kSlices = 5;
  // Where motions cross, the null space is wider than each of them: a start near each is a matter
  // of luck.
  static constexpr int kStarts = 8;

  /// `moving`: the coordinates that may differ from q; the others are held.
  Slicing(const Phi& phi, const Eigen::VectorXd& q, double t, std::uint64_t seed,
          std::vector<Eigen::Index> moving);
  /// All may.
  Slicing(const Phi& phi, const Eigen::VectorXd& q, double t, std::uint64_t seed);

  /// In which a set of poses could lie, once rows and coordinates are brought to their own units.
  Eigen::Index directions() const { return null_space_.cols(); }
  const Eigen::MatrixXd& null_space() const { return null_space_; }

  /// d x |z|: random orthonormal directions in the null space, where a set of poses would lie;
  /// planes stand across them.
  Eigen::MatrixXd planes(Eigen::Index d, int slice) const;
  /// A point z of the planes in N, the rest of it at random; `number` tells starts apart.
  Eigen::VectorXd start_on(const Eigen::MatrixXd& A, double step, int number) const;
  /// The pose on the planes that Gauss-Newton comes to from z; nullopt where it comes to none
  /// nearby.
  std::optional<Eigen::VectorXd> arrival(const Eigen::MatrixXd& A, double step,
                                         Eigen::VectorXd z) const;
  /// That of the first start of a slice which comes to one.
  std::optional<Eigen::VectorXd> pose_on(Eigen::Index d, double step, int slice) const;

  Eigen::VectorXd q_of(const Eigen::VectorXd& z) const;
  /// q' of z'.
  Eigen::VectorXd rates_of(const Eigen::VectorXd& z) const;

 private:
  Eigen::MatrixXd jacobian(const Eigen::VectorXd& y) const;  ///< Phi_q C, unweighted

  const Phi& phi_;
  const Eigen::VectorXd& q_;
  double t_;
  std::uint64_t seed_;
  std::vector<Eigen::Index> moving_;
  /// Of each moving coordinate, no less than the pose's own: far away it is known to fewer digits.
  Eigen::VectorXd scale_;
  Eigen::VectorXd weight_;      ///< of each row
  Eigen::MatrixXd null_space_;  ///< N
};

}  // namespace moivre
