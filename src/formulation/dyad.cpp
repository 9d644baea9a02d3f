// SPDX-License-Identifier: MIT
// Spans and complements by exact elimination, ranks by singular values.
#include "dyad.h"

#include <algorithm>

#include "moivre/factorization/svd.h"
#include "moivre/numeric/exact_displacement.h"

namespace moivre {
namespace {

using Vector8 = Eigen::Matrix<double, 8, 1>;
using Rounded = DualQuaternion<double>;

/// Numbers with lengths in units of `length`, of norm 1; 0 where all are.
Vector8 unit_vector(const Rounded& pose, double length) {
  Vector8 v;
  for (std::size_t k = 0; k < pose.size(); ++k) v[static_cast<Eigen::Index>(k)] = pose[k];
  v.tail<4>() /= length;
  return v.norm() > 0 ? v.normalized() : v;
}

ExactPose times(const Rational& factor, const ExactDisplacement& form) {
  return mapped(form, [&](const Integer& part) { return factor * ratio(part); });
}

}  // namespace

DyadSpace dyad_space(const LoopElement& a, const LoopElement& b, double length) {
  const auto basis_a = basis_of(a);
  const auto basis_b = basis_of(b);
  DyadSpace space;
  for (std::size_t k = 0; k < 4; ++k) space.basis[k] = basis_a[k / 2] * basis_b[k % 2];
  const Integer common = common_denominator({space.basis.begin(), space.basis.end()});
  std::vector<ExactDisplacement> vectors;
  for (const ExactPose& pose : space.basis) vectors.push_back(whole(pose, common));
  for (const ExactDisplacement& form : vanishing_forms(vectors, length)) {
    space.normals.push_back(times(ratio(1, largest_part(form)), form));
  }
  const auto [forms, factor] = coordinate_forms(vectors, length);
  for (std::size_t i = 0; i < 4; ++i) {
    space.coordinates[i] = times(ratio(common, factor), forms[i]);
  }
  return space;
}

std::array<Polynomial, 4> add_dyad_coordinates(SpatialFrame& frame, const LoopElement& a,
                                               const LoopElement& b) {
  std::vector<std::string> owners = a.owners;
  owners.insert(owners.end(), b.owners.begin(), b.owners.end());
  return frame.add_patched("c_" + a.name + "_", a.is_turn && b.is_turn, owners);
}

MovingPose pose_in(const DyadSpace& space, const std::array<Polynomial, 4>& coordinates) {
  MovingPose pose;
  for (std::size_t i = 0; i < coordinates.size(); ++i) {
    pose = pose + coordinates[i] * to_moving(space.basis[i]);
  }
  return pose;
}

void add_quadric(SpatialFrame& frame, const LoopElement& a, const std::array<Polynomial, 4>& c) {
  const Polynomial outer = c[0] * c[3];
  const Polynomial inner = c[1] * c[2];
  const double size = std::max(largest_coefficient(outer), largest_coefficient(inner));
  frame.add_equation("dyad of " + a.name, without_noise(outer - inner, size));
}

void add_half_angles(SpatialFrame& frame, const LoopElement& a, const LoopElement& b,
                     const std::array<Polynomial, 4>& c) {
  frame.add_equation(a.name, c[0] * a.unknown - c[2]);
  frame.add_equation(b.name, c[0] * b.unknown - c[1]);
}

std::array<Polynomial, 4> coordinates_in(const DyadSpace& space, const MovingPose& pose) {
  std::array<Polynomial, 4> coordinates;
  for (std::size_t i = 0; i < coordinates.size(); ++i) {
    coordinates[i] = value(to_moving(space.coordinates[i]), pose);
  }
  return coordinates;
}

double distance_from_quadric(const LoopElement& a, const LoopElement& b, double length) {
  const Rounded A = to_double(a.axis);
  const Rounded B = to_double(b.axis);
  Eigen::Matrix<double, 8, 4> span;
  span << unit_vector(Rounded::identity(), length), unit_vector(A, length), unit_vector(B, length),
      unit_vector(A * B, length);
  const Eigen::Matrix4d form = span.topRows<4>().transpose() * span.bottomRows<4>();
  return (form + form.transpose()).cwiseAbs().maxCoeff();
}

bool spans_common_space(const LoopElement& a, const LoopElement& b, const LoopElement& c,
                        double length) {
  constexpr double kInside = 1e-11;
  constexpr Eigen::Index kDimension = 4;
  std::vector<Rounded> products{Rounded::identity()};
  for (const LoopElement* element : {&a, &b, &c}) {
    const std::size_t size = products.size();
    for (std::size_t k = 0; k < size; ++k) {
      products.push_back(products[k] * to_double(element->axis));
    }
  }
  Eigen::Matrix<double, 8, 8> span;
  for (Eigen::Index k = 0; k < 8; ++k) {
    span.col(k) = unit_vector(products[static_cast<std::size_t>(k)], length);
  }
  const Eigen::VectorXd sigma = singular_values(span);
  return sigma[kDimension] <= kInside * sigma[0] &&
         distance_from_quadric(a, b, length) <= kInside &&
         distance_from_quadric(b, c, length) <= kInside;
}

}  // namespace moivre
