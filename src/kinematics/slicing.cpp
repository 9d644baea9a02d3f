// SPDX-License-Identifier: MIT
// Random planes in the null space, and Gauss-Newton on Phi and one of them.
#include "slicing.h"

#include <cmath>
#include <numeric>
#include <utility>

#include "moivre/factorization/qr.h"
#include "moivre/kinematics/null_space.h"
#include "moivre/numeric/random.h"

namespace moivre {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr double kOnTheSet = 1e-13;  // |Phi_i| relative to the length of its row at the pose
constexpr double kNeighbourhood =
    10;  // steps: a pose further away is not the neighbour that is looked for
constexpr int kMaximumIterations = 60;
constexpr double kWander = 2;  // steps
constexpr double kFaintRow =
    1e-3;  // of the longest: a row that vanishes at q, whose rounding has to stay rounding

std::vector<Index> all_of(const Phi& phi) {
  std::vector<Index> all(static_cast<std::size_t>(phi.dimension()));
  std::iota(all.begin(), all.end(), Index{0});
  return all;
}

}  // namespace

Slicing::Slicing(const Phi& phi, const VectorXd& q, double t, std::uint64_t seed,
                 std::vector<Index> moving)
    : phi_(phi),
      q_(q),
      t_(t),
      seed_(seed),
      moving_(std::move(moving)),
      scale_(sizes_of(phi, q)(moving_)) {
  const VectorXd rows = (phi.jacobian(q, t) * sizes_of(phi, q).asDiagonal()).rowwise().norm();
  // Where all rows vanish at q, there is no length to weigh by.
  const double longest = rows.size() == 0 ? 0 : rows.maxCoeff();
  weight_ = longest == 0 ? VectorXd::Ones(rows.size()).eval()
                         : rows.cwiseMax(kFaintRow * longest).cwiseInverse().eval();
  null_space_ = moivre::null_space(weight_.asDiagonal() * jacobian(q));
}

Slicing::Slicing(const Phi& phi, const VectorXd& q, double t, std::uint64_t seed)
    : Slicing(phi, q, t, seed, all_of(phi)) {}

MatrixXd Slicing::jacobian(const VectorXd& y) const {
  const MatrixXd J = phi_.jacobian(y, t_);
  return J(Eigen::all, moving_) * scale_.asDiagonal();
}

VectorXd Slicing::q_of(const VectorXd& z) const { return q_ + rates_of(z); }

VectorXd Slicing::rates_of(const VectorXd& z) const {
  VectorXd rates = VectorXd::Zero(q_.size());
  rates(moving_) = scale_.cwiseProduct(z);
  return rates;
}

MatrixXd Slicing::planes(Index d, int slice) const {
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

// N c with A N c = step, the rest of c at random.
VectorXd Slicing::start_on(const MatrixXd& A, double step, int number) const {
  const MatrixXd AN = A * null_space_;
  VectorXd wander(null_space_.cols());
  for (Index i = 0; i < wander.size(); ++i) {
    const auto index = static_cast<std::uint64_t>(number * wander.size() + i);
    wander[i] = kWander * step * (2 * random_unit(seed_, RandomStream::start_system, index) - 1);
  }
  const VectorXd wanted = VectorXd::Constant(A.rows(), step) - AN * wander;
  return null_space_ * (wander + shortest_solution(AN, wanted));
}

// Phi(q + C z) = 0, A z = step (1, 1, ..., 1).
std::optional<VectorXd> Slicing::arrival(const MatrixXd& A, double step, VectorXd z) const {
  const Index m = phi_.size();
  const Index d = A.rows();
  const double most = kNeighbourhood * std::abs(step);
  VectorXd rest(m + d);
  MatrixXd J(m + d, z.size());
  for (int k = 0; k < kMaximumIterations; ++k) {
    const VectorXd y = q_of(z);
    rest << weight_.cwiseProduct(phi_.value(y, t_)), A * z - VectorXd::Constant(d, step);
    if (!rest.allFinite()) return std::nullopt;
    if (rest.lpNorm<Eigen::Infinity>() <= kOnTheSet) return z;
    J << weight_.asDiagonal() * jacobian(y), A;
    z -= shortest_solution(J, rest);
    if (!(z.lpNorm<Eigen::Infinity>() <= most)) return std::nullopt;
  }
  return std::nullopt;
}

std::optional<VectorXd> Slicing::pose_on(Index d, double step, int slice) const {
  const MatrixXd A = planes(d, slice);
  for (int start = 0; start < kStarts; ++start) {
    auto z = arrival(A, step, start_on(A, step, slice * kStarts + start));
    if (z) return z;
  }
  return std::nullopt;
}

}  // namespace moivre
