// SPDX-License-Identifier: MIT
// The curve's derivatives from those of Phi, its points by Newton's method on the equations and a
// plane.
#include "curve.h"

#include <Eigen/Core>
#include <cmath>

#include "moivre/factorization/qr.h"
#include "moivre/factorization/svd.h"

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
// Least squares can come to rest off the curve; there a row of length 1 misses by more than
// rounding.
constexpr double kOnCurve = 1e-8;
// Of inverse iteration from the vector of the point before: each brings the ratio of the two
// smallest, squared.
constexpr int kInverseIterations = 4;
// From no vector at all.
constexpr int kFirstInverseIterations = 24;
// A diagonal this small, of rows of length 1: what it belongs to may be 0 exactly.
constexpr double kSmallDiagonal = 1e-9;
// Stairs are no cheaper than all of a small matrix.
constexpr Index kStairsPay = 9;

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

/// Of E. The drivers' rows read the time, others where `all_read_time`.
Pattern pattern_of(const Phi& phi, bool all_read_time) {
  Pattern rows = phi.reads();
  const Index first = all_read_time ? 0 : phi.size() - phi.driver_size();
  for (auto row = rows.begin() + first; row != rows.end(); ++row) row->push_back(phi.dimension());
  return rows;
}

}  // namespace

/// E x = r and a further row, normal.x = s: by E^T = Q R where its stairs are known, else by a QR
/// of all rows.
class Curve::Bordered {
 public:
  Bordered(const MatrixXd& E, const StaircaseOrder* order) : E_(E) {
    if (order == nullptr) return;
    stairs_.emplace(StaircaseQr::of_transposed(E, *order));
    tangent_ = stairs_->left_null_vector();
  }

  void border(const VectorXd& normal) {
    normal_ = normal;
    if (!stairs_) dense_ = Qr(bordered(E_, normal));
  }
  VectorXd solve(const VectorXd& r, double s) const {
    if (!stairs_) {
      VectorXd rhs(r.size() + 1);
      rhs << r, s;
      return dense_.solve(rhs);
    }
    const VectorXd x = stairs_->solve_transposed(r);
    return x + (s - normal_.dot(x)) / normal_.dot(tangent_) * tangent_;
  }
  /// The right singular vector of the smallest singular value of E across the tangent, which is the
  /// normal.
  VectorXd weakest(VectorXd v, int iterations) const {
    v = across(normal_, v);
    if (stairs_) return weakest_by_stairs(v, iterations);
    for (int k = 0; k < iterations; ++k) {
      const VectorXd next = dense_.inverse_gram(v);
      if (!next.allFinite() || !(next.norm() > 0)) break;
      v = across(normal_, next.normalized());
    }
    return v;
  }
  /// Whether the tangent and the weakest vector follow from the staircase QR.
  bool is_clear() const { return stairs_ && stairs_->smallest_diagonal() > kSmallDiagonal; }
  const VectorXd& tangent() const { return tangent_; }

 private:
  /// The same iterations; but for the first half and the last one, all of them on the other side of
  /// E, without reflections.
  VectorXd weakest_by_stairs(const VectorXd& v, int iterations) const {
    VectorXd u = stairs_->solve(v);
    for (int k = 1; k < iterations; ++k) u = stairs_->inverse_gram(u.normalized());
    const VectorXd next = stairs_->solve_transposed(u.normalized());
    return next.allFinite() && next.norm() > 0 ? across(normal_, next.normalized()) : v;
  }

  const MatrixXd& E_;
  VectorXd normal_;
  std::optional<StaircaseQr> stairs_;
  VectorXd tangent_;
  Qr dense_;
};

struct Curve::Rows {
  MatrixXd E;
  VectorXd length;
};

Curve::Curve(const Phi& phi, CurveScale scale, double slack, bool only_drivers_read_time)
    : phi_(phi),
      scale_(std::move(scale)),
      slack_(slack),
      pattern_(pattern_of(phi, !only_drivers_read_time)) {
  const bool is_square = phi.size() == phi.dimension() && phi.size() > kStairsPay;
  if (is_square && only_drivers_read_time) {
    order_ = staircase_order(transposed(pattern_, phi.dimension() + 1), phi.size());
  }
}

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
  MatrixXd E = phi_.extended_jacobian(q_of(y), t_of(y));
  VectorXd length(E.rows());
  for (Index i = 0; i < E.rows(); ++i) {
    const auto& columns = pattern_[static_cast<std::size_t>(i)];
    double square = 0;
    for (const Index k : columns) {
      E(i, k) *= k < scale_.w.size() ? scale_.w[k] : scale_.T;
      square += E(i, k) * E(i, k);
    }
    length[i] = square > 0 ? std::sqrt(square) : 1;
    for (const Index k : columns) E(i, k) /= length[i];
  }
  return {std::move(E), std::move(length)};
}

double Curve::sigma(const VectorXd& y) const { return singular_values(rows(y).E)[y.size() - 2]; }

VectorXd Curve::bend(const VectorXd& y, const VectorXd& tangent) const {
  const VectorXd q = q_of(y);
  const double t = t_of(y);
  const VectorXd qdot = tangent.head(q.size()).cwiseProduct(scale_.w);
  const double tdot = tangent[q.size()] * scale_.T;
  return phi_.second_derivative(q, qdot, t, tdot);
}

CurvePoint Curve::described(const VectorXd& y, const Rows& rows, Bordered& equations,
                            const VectorXd& tangent, const VectorXd& v) const {
  equations.border(tangent);
  CurvePoint point;
  point.y = y;
  point.tangent = tangent;
  point.curvature = equations.solve(-bend(y, tangent).cwiseQuotient(rows.length), 0);
  point.v = equations.weakest(v, kInverseIterations);
  const VectorXd image = rows.E * point.v;
  point.sigma = image.norm();
  point.u = point.sigma > 0 ? VectorXd(image / point.sigma) : image;
  return point;
}

CurvePoint Curve::begin(const VectorXd& y) const {
  const Rows at = rows(y);
  Bordered equations(at.E, stairs());
  const Index n = y.size() - 1;
  VectorXd tangent;
  VectorXd v;
  if (equations.is_clear()) {
    tangent = equations.tangent();
    equations.border(tangent);
    v = equations.weakest(VectorXd::LinSpaced(n + 1, 1, 2), kFirstInverseIterations);
  } else {
    const MatrixXd V = right_singular_vectors(at.E);
    tangent = V.col(n);
    v = n > 0 ? V.col(n - 1) : tangent;
  }
  if (tangent[n] < 0) tangent = -tangent;
  return described(y, at, equations, tangent, v);
}

CurvePoint Curve::next(const VectorXd& y, const CurvePoint& before) const {
  const Rows at = rows(y);
  Bordered equations(at.E, stairs());
  equations.border(before.tangent);
  const VectorXd tangent = equations.solve(VectorXd::Zero(at.E.rows()), 1).normalized();
  return described(y, at, equations, tangent, before.v);
}

std::optional<VectorXd> Curve::corrected(VectorXd y, const VectorXd& normal, double offset) const {
  double last = 0;
  for (int k = 0; k < kCorrections; ++k) {
    const Rows at = rows(y);
    const VectorXd miss = -phi_.value(q_of(y), t_of(y)).cwiseQuotient(at.length);
    const double to_plane = offset - normal.dot(y);
    if (!at.E.allFinite() || !miss.allFinite() || !std::isfinite(to_plane)) return std::nullopt;
    Bordered equations(at.E, stairs());
    equations.border(normal);
    const VectorXd step = equations.solve(miss, to_plane);
    const double size = step.norm();
    if (!std::isfinite(size) || (k > 0 && size > kShrinks * last && size > kConverged)) {
      return std::nullopt;
    }
    const bool is_on_curve = std::hypot(miss.norm(), to_plane) <= std::max(kOnCurve, slack_);
    y += step;
    if (size <= kConverged) return is_on_curve ? std::optional(std::move(y)) : std::nullopt;
    last = size;
  }
  return std::nullopt;
}

}  // namespace moivre
