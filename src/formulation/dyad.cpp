// SPDX-License-Identifier: MIT
// Eight-vectors, their spans and complements by singular values.
#include "dyad.h"

#include <Eigen/Geometry>
#include <cmath>

#include "moivre/numeric/svd.h"

namespace moivre {
namespace {

using Vector8 = Eigen::Matrix<double, 8, 1>;

/// Entries with lengths in units of `length`.
Vector8 to_vector(const ExactPose& pose, double length) {
  const DualQuaternion<double> rounded = to_double(pose);
  Vector8 v;
  for (std::size_t k = 0; k < kEntries; ++k) {
    v[static_cast<Eigen::Index>(k)] = entry(rounded, k) / (k < 4 ? 1 : length);
  }
  return v;
}

Rational number(double x) { return Rational(x); }

Eigen::Matrix<double, 8, 4> plain_span(const LoopElement& a, const LoopElement& b, double length) {
  Eigen::Matrix<double, 8, 4> span;
  const ExactPose one = identity_pose();
  const ExactPose poses[] = {one, a.axis, b.axis, a.axis * b.axis};
  for (Eigen::Index k = 0; k < 4; ++k) span.col(k) = to_vector(poses[k], length).normalized();
  return span;
}

}  // namespace

ExactPose shortened(const ExactPose& pose) {
  const DualQuaternion<double> rounded = to_double(pose);
  const Quaternion<double>& q = rounded.q;
  std::size_t largest = 0;
  for (std::size_t k = 1; k < q.size(); ++k) {
    if (std::abs(q[k]) > std::abs(q[largest])) largest = k;
  }
  ExactPose turn;
  for (std::size_t k = 0; k < q.size(); ++k) turn.q[k] = without_noise(q[k] / q[largest]);
  const Quaternion<double> shift =
      scaled(1 / dot(q, q), product(rounded.g, conjugate(q)));  // half of it
  const ExactPose shifted{{1, 0, 0, 0}, {0, number(shift[1]), number(shift[2]), number(shift[3])}};
  return shifted * turn;
}

ExactPose axis_at(const ExactPose& frame) {
  const ExactPose near = shortened(frame);
  const ExactPose z{{0, 0, 0, 1}, {}};
  return 1 / norm(near) * (near * z * conjugate(near));
}

ExactPose slide_at(const ExactPose& frame) {
  const ExactPose near = shortened(frame);
  const ExactPose z{{}, {0, 0, 0, Rational(1, 2)}};
  return 1 / norm(near) * (near * z * conjugate(near));
}

MovingPose element_pose(const LoopElement& element) {
  const auto basis = basis_of(element);
  return to_moving(basis[0]) + element.unknown * to_moving(basis[1]);
}

DyadSpace dyad_space(const LoopElement& a, const LoopElement& b, double length) {
  const auto basis_a = basis_of(a);
  const auto basis_b = basis_of(b);
  DyadSpace space;
  Eigen::Matrix<double, 8, 4> span;
  for (std::size_t k = 0; k < 4; ++k) {
    space.basis[k] = basis_a[k / 2] * basis_b[k % 2];
    span.col(static_cast<Eigen::Index>(k)) = to_vector(space.basis[k], length);
  }
  const auto [U, sigma, V] = svd(span, SingularVectors::full);
  const Eigen::MatrixXd inverse = V * sigma.cwiseInverse().asDiagonal() * U.leftCols(4).transpose();
  for (std::size_t i = 0; i < 4; ++i) {
    const auto row = static_cast<Eigen::Index>(i);
    for (std::size_t k = 0; k < kEntries; ++k) {
      const auto column = static_cast<Eigen::Index>(k);
      const double unit = k < 4 ? 1 : length;
      space.normals[i][k] = U(column, row + 4) / unit;
      space.coordinates[i][k] = inverse(row, column) / unit;
    }
  }
  return space;
}

std::array<Polynomial, 4> coordinates_in(const DyadSpace& space, const MovingPose& pose) {
  std::array<Polynomial, 4> coordinates;
  for (std::size_t i = 0; i < coordinates.size(); ++i) {
    for (std::size_t k = 0; k < kEntries; ++k) {
      coordinates[i] =
          coordinates[i] + Coefficient{number(space.coordinates[i][k]), 0} * entry(pose, k);
    }
  }
  return coordinates;
}

double distance_from_quadric(const LoopElement& a, const LoopElement& b, double length) {
  const Eigen::Matrix<double, 8, 4> span = plain_span(a, b, length);
  const Eigen::Matrix4d form = span.topRows<4>().transpose() * span.bottomRows<4>();
  return (form + form.transpose()).cwiseAbs().maxCoeff();
}

bool spans_common_space(const LoopElement& a, const LoopElement& b, const LoopElement& c,
                        double length) {
  constexpr double kInside = 1e-11;
  constexpr Eigen::Index kDimension = 4;
  const ExactPose one = identity_pose();
  const ExactPose poses[] = {one,
                             a.axis,
                             b.axis,
                             c.axis,
                             a.axis * b.axis,
                             a.axis * c.axis,
                             b.axis * c.axis,
                             a.axis * b.axis * c.axis};
  Eigen::Matrix<double, 8, 8> span = Eigen::Matrix<double, 8, 8>::Zero();
  for (Eigen::Index k = 0; k < 8; ++k) {
    const Vector8 v = to_vector(poses[k], length);
    if (v.norm() > 0) span.col(k) = v.normalized();
  }
  const Eigen::VectorXd sigma = singular_values(span);
  return sigma[kDimension] <= kInside * sigma[0] &&
         distance_from_quadric(a, b, length) <= kInside &&
         distance_from_quadric(b, c, length) <= kInside;
}

}  // namespace moivre
