// SPDX-License-Identifier: MIT
// Eight-vectors: their spans and complements by exact elimination, their ranks by singular values.
#include "dyad.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "moivre/factorization/svd.h"

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

Eigen::Matrix<double, 8, 4> plain_span(const LoopElement& a, const LoopElement& b, double length) {
  Eigen::Matrix<double, 8, 4> span;
  const ExactPose one = identity_pose();
  const ExactPose poses[] = {one, a.axis, b.axis, a.axis * b.axis};
  for (Eigen::Index k = 0; k < 4; ++k) span.col(k) = to_vector(poses[k], length).normalized();
  return span;
}

/// Four eight-vectors by Gauss and Jordan, as combinations of which they are: [A B | A], 1 and 0 in the pivots' columns of A B.
class ReducedRows {
 public:
  /// Pivots are the largest entries, lengths in units of `length`. There are fewer than four where the vectors depend on each other.
  ReducedRows(const std::array<ExactPose, 4>& vectors, double length);

  bool is_pivot(std::size_t column) const {
    return std::find(pivots_.begin(), pivots_.end(), column) != pivots_.end();
  }
  /// A vector orthogonal to all four: 1 in this column, else 0 outside the pivots.
  std::array<Rational, 8> normal(std::size_t column) const;
  /// What gives coordinate i of a vector v of the span: v = sum_i c_i vectors_i, c_i = sum_j v[pivot j] A_ji.
  std::array<Rational, 8> coordinate(std::size_t i) const;

 private:
  static constexpr std::size_t kRows = 4;
  static constexpr std::size_t kColumns = kEntries + kRows;

  bool bring_largest_to(std::size_t row, double length);
  void clear_column_but(std::size_t row);

  std::array<std::array<Rational, kColumns>, kRows> rows_;
  std::vector<std::size_t> pivots_;  ///< column of each row that has one
};

ReducedRows::ReducedRows(const std::array<ExactPose, 4>& vectors, double length) {
  for (std::size_t i = 0; i < kRows; ++i) {
    for (std::size_t k = 0; k < kEntries; ++k) rows_[i][k] = entry(vectors[i], k);
    rows_[i][kEntries + i] = 1;
  }
  for (std::size_t row = 0; row < kRows && bring_largest_to(row, length); ++row) {
    clear_column_but(row);
  }
}

/// False where nothing is left of this row and those below.
bool ReducedRows::bring_largest_to(std::size_t row, double length) {
  double largest = 0;
  std::size_t from = row;
  std::size_t column = 0;
  for (std::size_t i = row; i < kRows; ++i) {
    for (std::size_t k = 0; k < kEntries; ++k) {
      const double size = std::abs(to_double(rows_[i][k])) / (k < 4 ? 1 : length);
      if (size <= largest || is_pivot(k)) continue;
      largest = size;
      from = i;
      column = k;
    }
  }
  if (largest == 0) return false;
  std::swap(rows_[row], rows_[from]);
  pivots_.push_back(column);
  return true;
}

void ReducedRows::clear_column_but(std::size_t row) {
  const std::size_t column = pivots_[row];
  const Rational inverse = 1 / rows_[row][column];
  for (Rational& x : rows_[row]) x *= inverse;
  for (std::size_t i = 0; i < kRows; ++i) {
    const Rational factor = rows_[i][column];
    if (i == row || factor.is_zero()) continue;
    for (std::size_t k = 0; k < kColumns; ++k) rows_[i][k] -= factor * rows_[row][k];
  }
}

std::array<Rational, 8> ReducedRows::normal(std::size_t column) const {
  std::array<Rational, 8> normal;
  normal[column] = 1;
  for (std::size_t j = 0; j < pivots_.size(); ++j) normal[pivots_[j]] = -rows_[j][column];
  return normal;
}

std::array<Rational, 8> ReducedRows::coordinate(std::size_t i) const {
  std::array<Rational, 8> row;
  for (std::size_t j = 0; j < pivots_.size(); ++j) row[pivots_[j]] = rows_[j][kEntries + i];
  return row;
}

}  // namespace

ExactPose shortened(const ExactPose& pose) {
  const DualQuaternion<double> rounded = to_double(pose);
  const Quaternion<double> half = scaled(0.5, shift_of(rounded));
  const ExactPose shifted{{1, 0, 0, 0},
                          {0, Rational(half[1]), Rational(half[2]), Rational(half[3])}};
  return shifted * turn_by(rounded.q);
}

ExactPose axis_at(const ExactPose& frame, bool is_turn) {
  const ExactPose near = shortened(frame);
  const ExactPose z = is_turn ? ExactPose{{0, 0, 0, 1}, {}} : ExactPose{{}, {0, 0, 0, {1, 2}}};
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
  for (std::size_t k = 0; k < 4; ++k) space.basis[k] = basis_a[k / 2] * basis_b[k % 2];
  const ReducedRows reduced(space.basis, length);
  for (std::size_t k = 0; k < kEntries; ++k) {
    if (!reduced.is_pivot(k)) space.normals.push_back(reduced.normal(k));
  }
  for (std::size_t i = 0; i < 4; ++i) space.coordinates[i] = reduced.coordinate(i);
  return space;
}

std::array<Polynomial, 4> add_dyad_coordinates(SpatialFrame& frame, const LoopElement& a,
                                               const LoopElement& b) {
  std::vector<std::string> owners = a.owners;
  owners.insert(owners.end(), b.owners.begin(), b.owners.end());
  Polynomial patch = constant({-1, 0});
  std::array<Polynomial, 4> c;
  for (std::size_t i = 0; i < c.size(); ++i) {
    c[i] =
        frame.add_unknown("c_" + a.name + "_" + std::to_string(i), a.is_turn && b.is_turn, owners);
    patch = patch + Coefficient{frame.random_number(), 0} * c[i];
  }
  frame.add_equation("patch of " + a.name, patch);
  return c;
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
    for (std::size_t k = 0; k < kEntries; ++k) {
      coordinates[i] = coordinates[i] + Coefficient{space.coordinates[i][k], 0} * entry(pose, k);
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
