// SPDX-License-Identifier: MIT
// Ranks where they decide, and else Gauss-Newton on planes moved away from the pose.
#include "moivre/kinematics/local_dimension.h"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>

#include "moivre/factorization/qr.h"
#include "moivre/kinematics/null_space.h"
#include "moivre/kinematics/own_units.h"
#include "moivre/numeric/random.h"

namespace moivre {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

// Two steps: a set that turns back before the longer one is met by the shorter. Beside an isolated
// pose of multiplicity 7 Phi stays near 0.02^7 = 1e-12 of its terms, above rounding.
constexpr double kSteps[] = {0.1, 0.02};
constexpr double kOnTheSet = 1e-13;  // |Phi_i| relative to the length of its row at the pose
constexpr double kNeighbourhood =
    10;  // steps: a pose further away is not the neighbour that is looked for
constexpr int kMaximumIterations = 60;
// Where motions cross, the null space is wider than each of them: a start near each is a matter of
// luck.
constexpr int kStarts = 8;
constexpr double kWander = 2;  // steps
constexpr double kFaintRow =
    1e-3;  // of the longest: a row that vanishes at q, whose rounding has to stay rounding
constexpr int kSlices = 5;
constexpr int kAgreeing = 3;

class Slicing {
 public:
  Slicing(const Phi& phi, const VectorXd& q, double t, std::uint64_t seed)
      : phi_(phi), q_(q), t_(t), seed_(seed), scale_(sizes_of(phi, q)) {
    const VectorXd rows = (phi.jacobian(q, t) * scale_.asDiagonal()).rowwise().norm();
    weight_ = rows.cwiseMax(kFaintRow * rows.maxCoeff()).cwiseInverse();
    null_space_ = null_space(weight_.asDiagonal() * phi.jacobian(q, t) * scale_.asDiagonal());
  }

  /// In which a set of poses could lie, once rows and coordinates are brought to their own units.
  Index directions() const { return null_space_.cols(); }

  /// Do most slices by d planes at this step meet the poses?
  bool meets(Index d, double step) const {
    int found = 0;
    for (int slice = 0; slice < kSlices; ++slice)
      found += has_pose_on(planes(d, slice), step, slice);
    return found >= kAgreeing;
  }

 private:
  /// d x n: random orthonormal directions in the null space, where a set of poses would lie; planes
  /// stand across them.
  MatrixXd planes(Index d, int slice) const {
    const Index k = null_space_.cols();
    MatrixXd C(k, d);
    for (Index i = 0; i < C.size(); ++i) {
      const Index index = (slice * k + d) * k + i;
      C.data()[i] =
          2 * random_unit(seed_, RandomStream::slice, static_cast<std::uint64_t>(index)) - 1;
    }
    const MatrixXd orthonormal = Qr(C).basis();
    return (null_space_ * orthonormal).transpose();
  }

  bool has_pose_on(const MatrixXd& A, double step, int slice) const {
    for (int start = 0; start < kStarts; ++start) {
      if (arrives(A, step, start_on(A, step, slice * kStarts + start))) return true;
    }
    return false;
  }

  /// A point of the planes in the null space N of Phi_q: N c with A N c = step, the rest of c at
  /// random.
  VectorXd start_on(const MatrixXd& A, double step, int number) const {
    const MatrixXd AN = A * null_space_;
    VectorXd wander(null_space_.cols());
    for (Index i = 0; i < wander.size(); ++i) {
      const auto index = static_cast<std::uint64_t>(number * wander.size() + i);
      wander[i] = kWander * step * (2 * random_unit(seed_, RandomStream::start_system, index) - 1);
    }
    const VectorXd wanted = VectorXd::Constant(A.rows(), step) - AN * wander;
    return null_space_ * (wander + shortest_solution(AN, wanted));
  }

  /// Gauss-Newton on Phi(q + scale z) = 0, A z = step (1, 1, ..., 1).
  bool arrives(const MatrixXd& A, double step, VectorXd z) const {
    const Index m = phi_.size();
    const Index d = A.rows();
    VectorXd rest(m + d);
    MatrixXd J(m + d, q_.size());
    for (int k = 0; k < kMaximumIterations; ++k) {
      const VectorXd y = q_ + scale_.cwiseProduct(z);
      rest << weight_.cwiseProduct(phi_.value(y, t_)), A * z - VectorXd::Constant(d, step);
      if (!rest.allFinite()) return false;
      if (rest.lpNorm<Eigen::Infinity>() <= kOnTheSet) return true;
      J << weight_.asDiagonal() * phi_.jacobian(y, t_) * scale_.asDiagonal(), A;
      z -= shortest_solution(J, rest);
      if (!(z.lpNorm<Eigen::Infinity>() <= kNeighbourhood * step)) return false;
    }
    return false;
  }

  const Phi& phi_;
  const VectorXd& q_;
  double t_;
  std::uint64_t seed_;
  /// Of each coordinate, no less than the pose's own: far away it is known to fewer digits.
  VectorXd scale_;
  VectorXd weight_;      ///< of each row
  MatrixXd null_space_;  ///< of the weighted Phi_q
};

}  // namespace

LocalDimension local_dimension(const Phi& phi, const VectorXd& q, double t, std::uint64_t seed) {
  require_place(phi, q, t);
  const Index rank = rank_of(phi, phi.jacobian(q, t));
  const Index tangent = phi.dimension() - rank;
  if (tangent == 0) return {0, "the constraints fix every direction at this pose"};
  if (rank == phi.size()) {
    return {tangent, "the constraints are independent at a pose, and fewer than the coordinates"};
  }
  const Slicing slicing(phi, q, t, seed);
  // In units of their own rows and coordinates constraints may be independent where they are not as
  // they stand.
  for (Index d = std::min(tangent, slicing.directions()); d > 0; --d) {
    for (const double step : kSteps) {
      if (slicing.meets(d, step)) {
        return {d, "second random slices beside a pose meet the closures again"};
      }
    }
  }
  return {0, "second random slices beside this pose meet no closure"};
}

}  // namespace moivre
