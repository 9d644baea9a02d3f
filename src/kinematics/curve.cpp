// SPDX-License-Identifier: MIT
// The curve's derivatives from those of Phi, its points by Newton's method on the equations and a plane.
#include "curve.h"

#include <Eigen/Dense>
#include <cmath>

#include "moivre/numeric/svd.h"

namespace moivre {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

// A correction this small leaves an error of its square, below rounding.
constexpr double kConverged = 1e-9;
// Near a crossing corrections shrink by half at worst; one that needs more began too far away.
constexpr int kCorrections = 8;
constexpr double kShrinks = 0.7;
// Least squares can come to rest off the curve; there a row of length 1 misses by more than rounding.
constexpr double kOnCurve = 1e-8;
// Of inverse iteration from the vector of the point before: each brings the ratio of the two smallest, squared.
constexpr int kInverseIterations = 4;

MatrixXd bordered(const MatrixXd& E, const VectorXd& row) {
  MatrixXd K(E.rows() + 1, E.cols());
  K << E, row.transpose();
  return K;
}

/// v without its part along the tangent; where that is all there is, another direction across.
VectorXd across(const VectorXd& tangent, const VectorXd& v) {
  constexpr double kLittle = 1e-3;
  VectorXd rest = v - tangent.dot(v) * tangent;
  if (!(rest.norm() > kLittle)) {
    Index least = 0;
    tangent.cwiseAbs().minCoeff(&least);
    rest = VectorXd::Unit(v.size(), least) - tangent[least] * tangent;
  }
  return rest.normalized();
}

/// The right singular vector of the smallest singular value of K = Q R = [E; tangent], among those of E.
VectorXd weakest(const Eigen::HouseholderQR<MatrixXd>& qr, const VectorXd& tangent, VectorXd v) {
  const Index size = v.size();
  const auto R = qr.matrixQR().topRows(size).triangularView<Eigen::Upper>();
  v = across(tangent, v);
  for (int k = 0; k < kInverseIterations; ++k) {
    const VectorXd next = R.solve(R.transpose().solve(v));
    if (!next.allFinite() || !(next.norm() > 0)) break;
    v = across(tangent, next.normalized());
  }
  return v;
}

}  // namespace

struct Curve::Rows {
  MatrixXd E;
  VectorXd length;
};

VectorXd Curve::point(const VectorXd& q, double t) const {
  VectorXd y(q.size() + 1);
  y << q.cwiseQuotient(scale_.w), (t - scale_.t0) / scale_.T;
  return y;
}

VectorXd Curve::q_of(const VectorXd& y) const {
  return y.head(y.size() - 1).cwiseProduct(scale_.w);
}

double Curve::t_of(const VectorXd& y) const { return scale_.t0 + scale_.T * y[y.size() - 1]; }

Curve::Rows Curve::rows(const VectorXd& y) const {
  const VectorXd q = q_of(y);
  const double t = t_of(y);
  MatrixXd E(phi_.size(), y.size());
  E << phi_.jacobian(q, t) * scale_.w.asDiagonal(), phi_.partial_t(q, t) * scale_.T;
  VectorXd length = E.rowwise().norm();
  for (Index i = 0; i < E.rows(); ++i) {
    if (!(length[i] > 0)) length[i] = 1;
    E.row(i) /= length[i];
  }
  return {std::move(E), std::move(length)};
}

double Curve::sigma(const VectorXd& y) const { return singular_values(rows(y).E)[y.size() - 2]; }

VectorXd Curve::bend(const VectorXd& y, const VectorXd& tangent) const {
  const VectorXd q = q_of(y);
  const double t = t_of(y);
  const VectorXd qdot = tangent.head(q.size()).cwiseProduct(scale_.w);
  const double tdot = tangent[q.size()] * scale_.T;
  return phi_.quadratic(q, qdot, t) + tdot * phi_.mixed(q, qdot, t) +
         tdot * tdot * phi_.partial_tt(q, t);
}

CurvePoint Curve::described(const VectorXd& y, const Rows& rows, const VectorXd& tangent,
                            const VectorXd& v) const {
  const Eigen::HouseholderQR<MatrixXd> qr(bordered(rows.E, tangent));
  CurvePoint point;
  point.y = y;
  point.tangent = tangent;
  VectorXd rhs(rows.E.rows() + 1);
  rhs << -bend(y, tangent).cwiseQuotient(rows.length), 0;
  point.curvature = qr.solve(rhs);
  point.v = weakest(qr, tangent, v);
  const VectorXd image = rows.E * point.v;
  point.sigma = image.norm();
  point.u = point.sigma > 0 ? VectorXd(image / point.sigma) : image;
  return point;
}

CurvePoint Curve::begin(const VectorXd& y) const {
  const Rows at = rows(y);
  const MatrixXd V = right_singular_vectors(at.E);
  const Index n = y.size() - 1;
  VectorXd tangent = V.col(n);
  if (tangent[n] < 0) tangent = -tangent;
  return described(y, at, tangent, n > 0 ? V.col(n - 1) : tangent);
}

CurvePoint Curve::next(const VectorXd& y, const CurvePoint& before) const {
  const Rows at = rows(y);
  const Eigen::HouseholderQR<MatrixXd> qr(bordered(at.E, before.tangent));
  VectorXd rhs = VectorXd::Zero(at.E.rows() + 1);
  rhs[at.E.rows()] = 1;
  return described(y, at, qr.solve(rhs).normalized(), before.v);
}

std::optional<VectorXd> Curve::corrected(VectorXd y, const VectorXd& normal, double offset) const {
  double last = 0;
  for (int k = 0; k < kCorrections; ++k) {
    const Rows at = rows(y);
    VectorXd rhs(at.E.rows() + 1);
    rhs << -phi_.value(q_of(y), t_of(y)).cwiseQuotient(at.length), offset - normal.dot(y);
    if (!at.E.allFinite() || !rhs.allFinite()) return std::nullopt;
    const VectorXd step = Eigen::HouseholderQR<MatrixXd>(bordered(at.E, normal)).solve(rhs);
    const double size = step.norm();
    if (!std::isfinite(size) || (k > 0 && size > kShrinks * last && size > kConverged)) {
      return std::nullopt;
    }
    const bool is_on_curve = rhs.norm() <= std::max(kOnCurve, slack_);
    y += step;
    if (size <= kConverged) return is_on_curve ? std::optional(std::move(y)) : std::nullopt;
    last = size;
  }
  return std::nullopt;
}

}  // namespace moivre
