// SPDX-License-Identifier: MIT
// Sylvester's matrix of four multilinear equations, its eigenvalues by Francis' iteration, each
// vector by inverse iteration on Hessenberg's form.
#include "pair_formula.h"

#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <array>
#include <cmath>
#include <utility>

namespace moivre {
namespace {

constexpr int kSize = 24;
using Matrix24 = Eigen::Matrix<double, kSize, kSize>;
template <class S>
using Vector24 = Eigen::Matrix<S, kSize, 1>;

/// Columns: of the monomials in four tangents, bit k of the index is the exponent of t_k+1.
using Products = Eigen::Matrix<double, 8, 16>;

/// Of t_1, t_2, t_3 with exponents up to (1, 2, 3).
constexpr int place_of(int a, int b, int c) { return a + 2 * (b + 3 * c); }

/// A + t_4 B
struct Pencil {
  Matrix24 A, B;
};
Pencil pencil_of(const Eigen::Matrix<double, 4, 16>& equations) {
  Pencil pencil{Matrix24::Zero(), Matrix24::Zero()};
  int row = 0;
  for (int i = 0; i < equations.rows(); ++i) {
    for (int multiplier = 0; multiplier < 6; ++multiplier, ++row) {
      const int b = multiplier % 2, c = multiplier / 2;
      for (int bits = 0; bits < 8; ++bits) {
        const int column = place_of(bits & 1, (bits >> 1 & 1) + b, (bits >> 2 & 1) + c);
        pencil.A(row, column) = equations(i, bits);
        pencil.B(row, column) = equations(i, bits + 8);
      }
    }
  }
  return pencil;
}

/// x with (H - value) x = 0, nearly: U x = 1 for the factor U by rows, two of which are exchanged
/// at the most.
template <class S>
Vector24<S> hessenberg_vector(const Matrix24& H, const S& value) {
  Eigen::Matrix<S, kSize, kSize, Eigen::RowMajor> U = H.cast<S>();
  U.diagonal().array() -= value;
  const double least = 1e-16 * H.norm();
  for (int k = 0; k < kSize; ++k) {
    const int behind = kSize - k;
    if (k + 1 < kSize) {
      if (std::norm(U(k + 1, k)) > std::norm(U(k, k))) {
        U.row(k).tail(behind).swap(U.row(k + 1).tail(behind));
      }
      if (U(k, k) == S(0)) U(k, k) = least;
      const S factor = U(k + 1, k) / U(k, k);
      U.row(k + 1).tail(behind) -= factor * U.row(k).tail(behind);
    } else if (std::abs(U(k, k)) < least) {
      U(k, k) = least;
    }
  }
  Vector24<S> x = Vector24<S>::Constant(least);
  U.template triangularView<Eigen::Upper>().solveInPlace(x);
  return x.normalized();
}

/// t_1, t_2, t_3 of a vector of monomials, where they are determined best.
template <class S>
std::array<S, 3> tangents_of(const Vector24<S>& m) {
  const auto ratio = [&m](int step, const auto& is_start) {
    int best = -1;
    double largest = -1;
    for (int k = 0; k < kSize; ++k) {
      if (!is_start(k)) continue;
      const double size = std::norm(m[k]) + std::norm(m[k + step]);
      if (size > largest) largest = size, best = k;
    }
    return m[best + step] / m[best];
  };
  return {ratio(place_of(1, 0, 0), [](int k) { return k % 2 == 0; }),
          ratio(place_of(0, 1, 0), [](int k) { return k / 2 % 3 < 2; }),
          ratio(place_of(0, 0, 1), [](int k) { return k / 6 < 3; })};
}

/// Joint values of a root.
Eigen::Matrix<Complex, 6, 1> values_at(const Loop& loop, const Cut& cut,
                                       const Eigen::Matrix<double, 4, 16>& pair,
                                       const std::array<Complex, 4>& t) {
  Eigen::Matrix<Complex, 16, 1> monomials;
  monomials[0] = 1;
  for (int k = 0; k < 4; ++k) {
    const int size = 1 << k;
    for (int i = 0; i < size; ++i) {
      monomials[size + i] = monomials[i] * t[static_cast<std::size_t>(k)];
    }
  }
  const Eigen::Matrix<Complex, 4, 1> at = pair * monomials;
  std::array<Tangent, 6> tangents;
  for (std::size_t k = 0; k < 4; ++k) tangents[cut.outside[k]] = {1.0, t[k]};
  // A matrix of rank 1, by its larger row and column.
  const bool is_upper = std::norm(at[0]) + std::norm(at[2]) >= std::norm(at[1]) + std::norm(at[3]);
  const bool is_left = std::norm(at[0]) + std::norm(at[1]) >= std::norm(at[2]) + std::norm(at[3]);
  tangents[cut.inside[0]] = is_upper ? Tangent{at[0], at[2]} : Tangent{at[1], at[3]};
  tangents[cut.inside[1]] = is_left ? Tangent{at[0], at[1]} : Tangent{at[2], at[3]};
  Eigen::Matrix<Complex, 6, 1> values;
  for (std::size_t k = 0; k < 6; ++k) {
    values[static_cast<Eigen::Index>(k)] = complex_joint_value(loop, k, tangents[k]);
  }
  return values;
}

/// Whether the joint has no inverse there. Where several such roots are one they are known to half
/// the digits or fewer; a closure is as near where angles have imaginary parts above 10.
bool is_null(const LoopJoint& joint, const Complex& t) {
  constexpr double kNull = 1e-4;
  return std::abs(1.0 + joint.exact_length * joint.exact_length * t * t) < kNull;
}

}  // namespace

std::optional<PairFormula> pair_formula(const Arm& arm, std::uint64_t seed) {
  if (has_slides(arm) || arm.joints.size() != 6) return std::nullopt;
  PairFormula formula{pose_loop(arm, seed), {}, {}};
  const Cut& cut = formula.loop.cut;
  if (cut.kind != CutKind::two || cut.forms.size() != 4) return std::nullopt;
  for (Eigen::Index i = 0; i < 4; ++i) {
    const auto& form = cut.forms[static_cast<std::size_t>(i)];
    formula.forms.row(i) = column(unit(rounded(form))).transpose();
  }
  Eigen::Matrix<double, 8, 4> products;
  Eigen::Index k = 0;
  for (const RealDisplacement& product :
       pair_products(formula.loop.open, cut.inside[0], cut.inside[1], &LoopJoint::rounded)) {
    products.col(k++) = column(product);
  }
  const Eigen::Matrix4d gram = products.transpose() * products;
  formula.coordinates = gram.inverse() * products.transpose();
  return formula;
}

ProposedClosures proposed_closures(const PairFormula& formula, const Eigen::Isometry3d& pose) {
  ProposedClosures proposed;
  const Loop loop = loop_at(formula.loop, pose);
  const Cut& cut = formula.loop.cut;
  Products products;
  Eigen::Index column_number = 0;
  for (const RealDisplacement& product : outside_product(loop, cut, &LoopJoint::rounded)) {
    products.col(column_number++) = column(product);
  }
  const Pencil pencil = pencil_of(formula.forms * products);
  const Eigen::Matrix<double, 4, 16> pair = formula.coordinates * products;
  const Matrix24 quotient = Matrix24(pencil.B.partialPivLu().solve(pencil.A)) * -1.0;
  if (!quotient.allFinite()) return proposed;
  const Eigen::HessenbergDecomposition<Matrix24> hessenberg(quotient);
  const Matrix24 H = hessenberg.matrixH(), Q = hessenberg.matrixQ();
  Eigen::RealSchur<Matrix24> schur(kSize);
  schur.computeFromHessenberg(H, Q, false);
  if (schur.info() != Eigen::Success) return proposed;
  const Matrix24& T = schur.matrixT();
  const LoopJoint& hidden = loop.joints[cut.outside[3]];
  const auto take = [&]<class S>(const S& t) {
    if (is_null(hidden, t)) return;
    const auto [t1, t2, t3] = tangents_of<S>(Q * hessenberg_vector<S>(H, t));
    const auto values = values_at(loop, cut, pair, {t1, t2, t3, t});
    constexpr bool is_real = std::is_same_v<S, double>;
    std::size_t& count = is_real ? proposed.reals : proposed.pair_count;
    if (count == ProposedClosures::kMost) return;
    if constexpr (is_real) {
      proposed.real[count++] = values.real();
    } else {
      proposed.pairs[count++] = values;
    }
  };
  for (int k = 0; k < kSize; ++k) {
    if (k + 1 == kSize || T(k + 1, k) == 0) {
      take(T(k, k));
      continue;
    }
    const double p = (T(k, k) - T(k + 1, k + 1)) / 2;
    const double under_root = p * p + T(k + 1, k) * T(k, k + 1);
    take(Complex(T(k + 1, k + 1) + p, std::sqrt(std::abs(under_root))));
    ++k;
  }
  return proposed;
}

}  // namespace moivre
