// SPDX-License-Identifier: MIT
// Householder's reflections, Laguerre's and inverse iteration on a tridiagonal matrix.
#include "least_motion.h"

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>

#include "moivre/factorization/svd.h"
#include "six_equations.h"

namespace moivre {
namespace {

constexpr int kMost = 6;
/// Relative to the largest singular value.
constexpr double kClear = 1e-6;

template <int N>
using Square = Eigen::Matrix<double, N, N>;
template <int N>
using Column = Eigen::Matrix<double, N, 1>;

/// T = Q^T G Q, Q the product of reflections 1 - share u u^T.
template <int N>
struct Tridiagonal {
  std::array<double, N> diagonal{};
  std::array<double, N> beside{};  ///< [k]: between k and k + 1
  std::array<Column<N>, N> u;      ///< [k]: from k + 1 on, where the others are 0
  std::array<double, N> share{};
};

/// Takes row and column k of G, whose lower half is read and written, to `beside`.
template <int N, int k>
void reflect(Square<N>& G, Tridiagonal<N>& T) {
  constexpr int kRest = N - k - 1;
  using Rest = Column<kRest>;
  auto& result = T.u[k];
  result.setZero();
  Rest u = G.template block<kRest, 1>(k + 1, k);
  const double square = u.squaredNorm();
  const double size = u[0] < 0 ? -std::sqrt(square) : std::sqrt(square);
  const double half = square + size * u[0];  // of |u|^2, with size added to its first number
  T.beside[k] = half > 0 ? -size : 0;
  if (!(half > 0)) return;
  u[0] += size;
  T.share[k] = 1 / half;
  // G - u w^T - w u^T, w = (1 - u u^T share / 2) G u share
  auto rest = G.template bottomRightCorner<kRest, kRest>();
  Rest w = Rest::Zero();
  for (int j = 0; j < kRest; ++j) {
    w[j] += rest(j, j) * u[j];
    for (int i = j + 1; i < kRest; ++i) {
      w[i] += rest(i, j) * u[j];
      w[j] += rest(i, j) * u[i];
    }
  }
  w *= T.share[k];
  w -= (T.share[k] / 2 * u.dot(w)) * u;
  for (int j = 0; j < kRest; ++j) {
    for (int i = j; i < kRest; ++i) rest(i, j) -= u[i] * w[j] + w[i] * u[j];
  }
  result.template tail<kRest>() = u;
}

template <int N>
Tridiagonal<N> tridiagonal(Square<N> G) {
  Tridiagonal<N> result;
  [&]<int... k>(std::integer_sequence<int, k...>) { (reflect<N, k>(G, result), ...); }
  (std::make_integer_sequence<int, N - 2>());
  for (std::size_t k = 0; k < N; ++k) result.diagonal[k] = G(Eigen::Index(k), Eigen::Index(k));
  result.beside[N - 2] = G(N - 1, N - 2);
  return result;
}

/// The characteristic polynomial of T at x, with two derivatives.
struct Value {
  double p = 1, slope = 0, bend = 0;
};
template <int N>
Value characteristic(const Tridiagonal<N>& T, double x) {
  Value before{0, 0, 0}, here;
  double square = 0;
  for (std::size_t k = 0; k < N; ++k) {
    const double d = T.diagonal[k] - x;
    const Value next{d * here.p - square * before.p,
                     d * here.slope - here.p - square * before.slope,
                     d * here.bend - 2 * here.slope - square * before.bend};
    before = here;
    here = next;
    square = T.beside[k] * T.beside[k];
  }
  return here;
}

/// From 0, which is not above it. A last step that is a small share of it leaves less than that
/// share's cube.
template <int N>
double smallest_eigenvalue(const Tridiagonal<N>& T) {
  constexpr int kSteps = 12;
  constexpr double kLastStep = 1e-5;
  double x = 0;
  for (int k = 0; k < kSteps; ++k) {
    const Value at = characteristic(T, x);
    if (!(at.p > 0)) break;  // rounding has passed it
    const double G = at.slope / at.p, H = G * G - at.bend / at.p;
    const double root = std::sqrt(std::max(0.0, (N - 1) * (N * H - G * G)));
    const double step = N / (root - G);
    if (!(step > 0)) break;
    x += step;
    if (step <= kLastStep * x) break;
  }
  return x;
}

/// Nothing where it does not settle.
template <int N>
std::optional<Column<N>> eigenvector(const Tridiagonal<N>& T, double value, double largest) {
  constexpr int kSteps = 3;
  constexpr double kSettled = 1e-10;
  // Below the eigenvalue all pivots are positive.
  const double shift = value - 1e-13 * largest;
  std::array<double, N> share{}, factor{};  // 1 / pivot
  for (std::size_t k = 0; k < N; ++k) {
    const double pivot = T.diagonal[k] - shift - (k > 0 ? factor[k - 1] * T.beside[k - 1] : 0);
    if (!(pivot > 0)) return std::nullopt;
    share[k] = 1 / pivot;
    factor[k] = T.beside[k] * share[k];
  }
  Column<N> t;
  for (int k = 0; k < N; ++k) t[k] = 1 + 0.3 * k * (k % 2 == 0 ? 1 : -1);
  t.normalize();
  for (int step = 0; step < kSteps; ++step) {
    const Column<N> before = t;
    for (int k = 1; k < N; ++k) t[k] -= factor[static_cast<std::size_t>(k - 1)] * t[k - 1];
    for (int k = 0; k < N; ++k) t[k] *= share[static_cast<std::size_t>(k)];
    for (int k = N - 2; k >= 0; --k) t[k] -= factor[static_cast<std::size_t>(k)] * t[k + 1];
    t *= 1 / t.norm();
    if ((t - before).squaredNorm() < kSettled * kSettled) return t;
  }
  return std::nullopt;
}

template <int N>
std::optional<LeastMotion> by_gram(const Screws<double>& screws) {
  const Eigen::Matrix<double, 6, N> A = screws;
  const Square<N> G = A.transpose() * A;
  const double largest = G.trace();
  const Tridiagonal<N> T = tridiagonal<N>(G);
  const double value = smallest_eigenvalue<N>(T);
  if (!(value > kClear * kClear * largest)) return std::nullopt;
  const auto in_T = eigenvector<N>(T, value, largest);
  if (!in_T) return std::nullopt;
  Column<N> v = *in_T;
  for (int k = N - 3; k >= 0; --k) {
    const Column<N>& u = T.u[static_cast<std::size_t>(k)];
    v -= (T.share[static_cast<std::size_t>(k)] * u.dot(v)) * u;
  }
  LeastMotion least;
  const Velocity6<double> moved = A * v;
  least.singular_value = moved.norm();
  least.joints = v;
  least.tip = moved / least.singular_value;
  return least;
}

LeastMotion by_rotations(const Screws<double>& screws) {
  const Svd stretch = svd(screws, SingularVectors::full);
  const Eigen::Index last = stretch.sigma.size() - 1;
  return {stretch.sigma[last], stretch.V.col(stretch.V.cols() - 1), stretch.U.col(last)};
}

}  // namespace

LeastMotion least_motion(const Screws<double>& screws) {
  constexpr int kFive = 5, kFour = 4;
  std::optional<LeastMotion> least;
  if (screws.cols() == kMost) least = by_gram<kMost>(screws);
  if (screws.cols() == kFive) least = by_gram<kFive>(screws);
  if (screws.cols() == kFour) least = by_gram<kFour>(screws);
  return least ? *least : by_rotations(screws);
}

// As many as pivots of the Gram matrix, less by the bound's square, are negative [Sylvester].
int still_count(const Screws<double>& screws, double bound) {
  constexpr double kTold = 1e-10, kPivot = 1e-12;  // relative to the sum of squares
  const double size = screws.squaredNorm();
  if (screws.cols() == kMost && bound * bound > kTold * size) {
    Matrix6d shifted = gram_of(screws);
    shifted.diagonal().array() -= bound * bound;
    const SixFactors factors = factors_of(shifted);
    int count = 0;
    bool are_told = true;
    for (const double share : factors.share) {
      count += share < 0 ? 1 : 0;
      are_told = are_told && std::abs(share) * kPivot * size < 1;
    }
    if (are_told) return count;
  }
  const Eigen::VectorXd sigma = svd(screws, SingularVectors::full).sigma;
  const auto more = std::max<Eigen::Index>(0, screws.cols() - sigma.size());
  return static_cast<int>((sigma.array() <= bound).count() + more);
}

}  // namespace moivre
