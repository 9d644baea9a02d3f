// SPDX-License-Identifier: MIT
// Steps along a valley, each put right across it by damped least squares.
#include "within_fit.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <vector>

#include "moivre/closures/same_pose.h"
#include "moivre/factorization/svd.h"
#include "moivre/kinematics/own_units.h"

namespace moivre {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

// Of the root of fit. At a fold b s^2 / 2, b about 1, two closures that fit does not part have
// sigma = b s <= 2 roots of fit b.
constexpr double kWeak = 4;
// Where all rows miss by fit at least squares, those that are met leave so many times that to the
// others.
constexpr double kOfSolved = 20;
constexpr double kFirstStep = 0.25;
constexpr double kLeastStep = 0.01;
// Least squares settle in so many steps. Sharing out what they leave takes some more, and still
// more where all rows together miss by no more than if each missed by fit, and none by twice that.
constexpr int kPlainSteps = 4;
constexpr int kStepsAcross = 8;
constexpr int kStepsInto = 24;
constexpr double kNearlyIn = 2;
// Of fit: at its very end rounding would say whether a pose is within it.
constexpr double kInside = 0.95;
// In radians and of the mechanism's mean length: steps that a valley's bends allow, and so many
// that a whole turn is within them. Along a straight valley lengths go by the pose's own size: what
// slides along lines that fit does not part from parallel ones goes on without end.
constexpr double kLongestStep = 0.1;
constexpr int kSteps = 100;
// Of a step: what a bend of a tenth of a step's length puts right is more.
constexpr double kStraight = 0.01;
// Where valleys cross, their directions are sums of the weakest ones.
constexpr Index kCrossing = 3;

}  // namespace

WithinFit::WithinFit(const Phi& phi, double fit, double t)
    : phi_(phi), fit_(fit), t_(t), share_(fit / phi.length()), unit_(phi.own_units()) {}

bool WithinFit::has(const VectorXd& q) const { return misfit(phi_, q, t_) <= fit_; }

MatrixXd WithinFit::weak_directions(const VectorXd& q) const {
  const Svd J = svd(in_own_units(phi_, phi_.jacobian(q, t_)), SingularVectors::full);
  const double most = kWeak * std::sqrt(share_);
  const auto strong =
      std::count_if(J.sigma.begin(), J.sigma.end(), [most](double sigma) { return sigma > most; });
  return J.V.rightCols(J.V.cols() - strong);
}

bool WithinFit::is_weak(const VectorXd& q) const { return weak_directions(q).cols() > 0; }

bool WithinFit::is_beside_roots(const VectorXd& q) const {
  const VectorXd sigma = singular_values(in_own_units(phi_, phi_.jacobian(q, t_)));
  return phi_.size() >= phi_.dimension() && sigma.size() > 0 &&
         sigma.minCoeff() > kWeak * std::sqrt(kOfSolved * share_);
}

/// Puts q into W across `way`, in own units. Directions along which fit leaves the pose free are
/// not gone along: damped by sigma^2 = fit.
/// Least squares of what rows miss by, at their lever arms. Rows that these leave beyond fit count
/// for more, until fit is shared out.
bool WithinFit::enter(VectorXd& q, const VectorXd& way, int fewest_steps, double inside) const {
  VectorXd weight = VectorXd::Ones(phi_.size());
  const double most = fit_ * std::sqrt(static_cast<double>(phi_.size()));
  for (int k = 0; q.allFinite(); ++k) {
    const MatrixXd jacobian = phi_.jacobian(q, t_);
    const VectorXd unit = misfit_units(phi_, jacobian);
    const VectorXd value = phi_.value(q, t_).cwiseQuotient(unit);
    const VectorXd share = value.cwiseAbs() / (inside * fit_);
    if (k >= fewest_steps && (share.array() <= 1).all()) return true;
    if (k == kStepsInto) return has(q);
    if (k == kStepsAcross && (value.norm() > most || share.maxCoeff() > kNearlyIn)) return false;
    if (k >= kPlainSteps) weight = weight.cwiseProduct(share.cwiseMax(1));
    const VectorXd of_row = weight / phi_.length();
    const MatrixXd J = of_row.cwiseQuotient(unit).asDiagonal() * jacobian * unit_.asDiagonal();
    // LDL^T reads the lower half alone.
    MatrixXd normal = MatrixXd::Zero(J.cols(), J.cols());
    normal.selfadjointView<Eigen::Lower>().rankUpdate(J.transpose()).rankUpdate(way);
    normal.diagonal().array() += share_;
    VectorXd step = normal.ldlt().solve(-J.transpose() * value.cwiseProduct(of_row));
    step -= way.dot(step) * way;
    q += unit_.cwiseProduct(step);
  }
  return false;
}

bool WithinFit::correct(VectorXd& q, const VectorXd& way) const { return enter(q, way, 0, 1); }

bool WithinFit::enter(VectorXd& q) const {
  if (!q.allFinite()) return false;
  const VectorXd row_unit = phi_.own_row_units();
  const double least = phi_.value(q, t_).cwiseQuotient(row_unit).norm();
  const double most =
      fit_ * misfit_units(phi_, phi_.jacobian(q, t_)).cwiseQuotient(row_unit).norm();
  return least <= most && enter(q, VectorXd::Zero(phi_.dimension()), kPlainSteps, kInside);
}

/// How long the next step may be, behind one of `length` along `way` to q that was put right by
/// `correction`.
double WithinFit::next_length(const VectorXd& q, const VectorXd& way, double length,
                              double correction) const {
  double longest = kLongestStep;
  if (correction <= kStraight * length) {
    const VectorXd of_pose = way.cwiseProduct(unit_).cwiseQuotient(sizes_of(phi_, q));
    longest = std::max(longest, kLongestStep / of_pose.lpNorm<Eigen::Infinity>());
  }
  return std::min(2 * length, longest);
}

/// How far from q W goes on along a curve that begins along `way`.
double WithinFit::reach(const VectorXd& q, VectorXd way) const {
  const double first = kFirstStep * std::sqrt(share_);
  double length = std::min(first, kLongestStep);
  const VectorXd size = sizes_of(phi_, q);
  double farthest = 0;
  VectorXd here = q;
  for (int k = 0; k < kSteps && length >= kLeastStep * first; ++k) {
    VectorXd next = here + length * unit_.cwiseProduct(way);
    const VectorXd begun = next;
    const bool is_in = correct(next, way);
    const double correction = (next - begun).cwiseQuotient(unit_).norm();
    if (!is_in || correction > 2 * length) {
      length /= 2;
      continue;
    }
    way = (next - here).cwiseQuotient(unit_).normalized();
    here = next;
    const VectorXd gone = phi_.canonical(here - q).cwiseQuotient(size);
    farthest = std::max(farthest, gone.lpNorm<Eigen::Infinity>());
    length = next_length(here, way, length, correction);
  }
  return farthest;
}

double WithinFit::play(const VectorXd& q) const {
  const MatrixXd weak = weak_directions(q);
  if (weak.cols() == 0) {
    if (phi_.dimension() == 0) return 0;
    const double least = singular_values(in_own_units(phi_, phi_.jacobian(q, t_))).minCoeff();
    return share_ * std::sqrt(static_cast<double>(phi_.size())) / least;
  }
  std::vector<VectorXd> ways;
  for (Index i = 0; i < weak.cols(); ++i) {
    ways.push_back(weak.col(i));
    if (weak.cols() - i > kCrossing) continue;
    for (Index j = weak.cols() - std::min(kCrossing, weak.cols()); j < i; ++j) {
      ways.push_back((weak.col(i) + weak.col(j)).normalized());
      ways.push_back((weak.col(i) - weak.col(j)).normalized());
    }
  }
  double farthest = 0;
  for (const VectorXd& way : ways) {
    farthest = std::max({farthest, reach(q, way), reach(q, -way)});
  }
  return farthest;
}

bool WithinFit::joins(const VectorXd& a, const VectorXd& b) const {
  if (is_same_pose(phi_, a, b)) return true;
  const double first = kFirstStep * std::sqrt(share_);
  double length = std::min(first, kLongestStep);
  VectorXd here = a;
  const auto gap_of = [&](const VectorXd& q) -> VectorXd {
    return phi_.canonical(b - q).cwiseQuotient(unit_);
  };
  VectorXd gap = gap_of(here);
  for (int k = 0; k < kSteps && length >= kLeastStep * first; ++k) {
    if (gap.norm() <= first) return true;
    const VectorXd way = gap.normalized();
    const VectorXd begun = here + std::min(length, gap.norm()) * unit_.cwiseProduct(way);
    VectorXd next = begun;
    const bool is_in = correct(next, way);
    const VectorXd left = gap_of(next);
    // No way round: it comes nearer with every step.
    if (!is_in || left.norm() > gap.norm() - length / 4) {
      length /= 2;
      continue;
    }
    here = next;
    gap = left;
    length = next_length(here, way, length, (next - begun).cwiseQuotient(unit_).norm());
  }
  return false;
}

}  // namespace moivre
