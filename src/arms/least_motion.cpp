// SPDX-License-Identifier: MIT
// Householder's reflections, Laguerre's and inverse iteration on a tridiagonal matrix.
#include "least_motion.h"

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "moivre/factorization/svd.h"
#include "six_equations.h"

namespace moivre {
namespace {

constexpr int kMost = 6;
/// Beside the largest singular value.
constexpr double kClear = 1e-6;

template <int N>
using Square = Eigen::Matrix<double, N, N>;
template <int N>
using Column = Eigen::Matrix<double, N, 1>;

/// T = Q^T G Q, Q the product of reflections 1 - 2 u u^T.
template <int N>
struct Tridiagonal {
  std::array<double, N> diagonal{};
  std::array<double, N> beside{};  ///< [k]: between k and k + 1
  std::array<Column<N>, N> u;
};

template <int N>
Tridiagonal<N> tridiagonal(Square<N> G) {
  Tridiagonal<N> result;
  for (int k = 0; k + 2 < N; ++k) {
    Column<N>& u = result.u[static_cast<std::size_t>(k)];
    u.setZero();
    double size = 0;
    for (int i = k + 1; i < N; ++i) u[i] = G(i, k), size += u[i] * u[i];
    size = std::sqrt(size);
    u[k + 1] += u[k + 1] < 0 ? -size : size;
    const double norm = u.squaredNorm();
    if (!(norm > 0)) continue;
    // G - u w^T - w u^T
    const double factor = 2 / norm;
    Column<N> w = factor * (G * u);
    w -= (factor / 2 * u.dot(w)) * u;
    G.noalias() -= u * w.transpose();
    G.noalias() -= w * u.transpose();
    u *= std::sqrt(factor);  // 1 - u u^T
  }
  for (int k = 0; k < N; ++k) {
    result.diagonal[static_cast<std::size_t>(k)] = G(k, k);
    if (k + 1 < N) result.beside[static_cast<std::size_t>(k)] = G(k + 1, k);
  }
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

/// From 0, which is not above it.
template <int N>
double smallest_eigenvalue(const Tridiagonal<N>& T) {
  constexpr int kSteps = 12;
  double x = 0;
  for (int k = 0; k < kSteps; ++k) {
    const Value at = characteristic(T, x);
    if (!(at.p > 0)) break;  // rounding has passed it
    const double G = at.slope / at.p, H = G * G - at.bend / at.p;
    const double root = std::sqrt(std::max(0.0, (N - 1) * (N * H - G * G)));
    const double step = N / (root - G);
    if (!(step > 1e-14 * x)) break;
    x += step;
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
  std::array<double, N> pivot{}, factor{};
  for (std::size_t k = 0; k < N; ++k) {
    pivot[k] = T.diagonal[k] - shift - (k > 0 ? factor[k - 1] * T.beside[k - 1] : 0);
    if (!(pivot[k] > 0)) return std::nullopt;
    factor[k] = T.beside[k] / pivot[k];
  }
  Column<N> t;
  for (int k = 0; k < N; ++k) t[k] = 1 + 0.3 * k * (k % 2 == 0 ? 1 : -1);
  double turned = 1;
  for (int step = 0; step < kSteps; ++step) {
    const Column<N> before = t.normalized();
    t = before;
    for (int k = 1; k < N; ++k) t[k] -= factor[static_cast<std::size_t>(k - 1)] * t[k - 1];
    for (int k = 0; k < N; ++k) t[k] /= pivot[static_cast<std::size_t>(k)];
    for (int k = N - 2; k >= 0; --k) t[k] -= factor[static_cast<std::size_t>(k)] * t[k + 1];
    t.normalize();
    turned = (t - before).squaredNorm();
  }
  if (!(turned < kSettled * kSettled)) return std::nullopt;
  return t;
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
    v -= u.dot(v) * u;
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
  constexpr double kTold = 1e-10, kPivot = 1e-12;  // beside the sum of squares
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
