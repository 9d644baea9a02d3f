// SPDX-License-Identifier: MIT
// From the outside's tangents to the inside's.
#include "read_back.h"

#include <Eigen/Core>
#include <array>
#include <cmath>

#include "moivre/factorization/qr.h"

namespace moivre {
namespace {

/// Joints without an inverse miss that by rounding, or by some hundred times their own error.
constexpr double kNull = 1e-13;
constexpr double kNullPerError = 1e2;
/// Sine of the angle between the inside's product and what it must be: closures have 1e-13, roots
/// of the combinations alone 1e-5 at the least. A root that is known to few digits may miss by some
/// thousand times its error.
constexpr double kMissed = 1e-9;
constexpr double kMissedPerError = 1e3;
/// Where no equations were combined there are no others to tell apart, and closures of nearly
/// special arms, next to joints without an inverse, miss by 1e-9.
constexpr double kMissedByRounding = 1e-6;
/// A quadratic whose coefficients are this small relative to what they were summed from has no
/// roots of its own.
constexpr double kVanishing = 1e-11;

/// Coordinates in W of a pair: c c, c s, s c, s s.
using Coordinates = Eigen::Matrix<Complex, 4, 1>;

class Pair {
 public:
  Pair(const Loop& loop, std::size_t a, std::size_t b) : products_(products(loop, a, b)) {}
  Coordinates coordinates(const ComplexDisplacement& g) const { return products_.solve(column(g)); }

 private:
  static Eigen::MatrixXcd products(const Loop& loop, std::size_t a, std::size_t b) {
    Eigen::MatrixXcd columns(8, 4);
    Eigen::Index k = 0;
    for (const RealDisplacement& product : pair_products(loop, a, b, &LoopJoint::rounded)) {
      columns.col(k++) = column(product).cast<Complex>();
    }
    return columns;
  }

  PivotedQr<Complex> products_;
};

/// The two joints that have these coordinates (a matrix of rank 1).
std::array<Tangent, 2> joints_of(const Coordinates& a) {
  const bool is_upper = std::norm(a[0]) + std::norm(a[2]) >= std::norm(a[1]) + std::norm(a[3]);
  const bool is_left = std::norm(a[0]) + std::norm(a[1]) >= std::norm(a[2]) + std::norm(a[3]);
  const Tangent first = is_upper ? Tangent{a[0], a[2]} : Tangent{a[1], a[3]};
  const Tangent second = is_left ? Tangent{a[0], a[1]} : Tangent{a[2], a[3]};
  return {first, second};
}

struct QuadraticRoots {
  std::vector<Tangent> at;
  bool vanishes = false;
};

/// A c^2 - B c s + C s^2 = 0; `size`: of what the coefficients were summed from.
QuadraticRoots quadratic_roots(Complex A, Complex B, Complex C, double size) {
  const double largest = std::max({std::abs(A), std::abs(B), std::abs(C)});
  if (largest <= kVanishing * size) return {{Tangent{}}, true};
  const Complex root = std::sqrt(B * B - 4.0 * A * C);
  const Complex plus = B + root;
  const Complex minus = B - root;
  const Complex q = 0.5 * (std::norm(plus) >= std::norm(minus) ? plus : minus);
  if (q == Complex(0)) {  // A or C, and B, are 0: a double root
    const Tangent both = std::norm(A) > std::norm(C) ? Tangent{0, 1} : Tangent{1, 0};
    return {{both, both}, false};
  }
  return {{Tangent{q, A}, Tangent{C, q}}, false};
}

double form_size(const Coordinates& a, const Coordinates& b) { return a.norm() * b.norm(); }

/// The first of three joints: those of its places for which the others can do what is left.
QuadraticRoots first_of_three(const Loop& loop, const Cut& cut, const Pair& pair,
                              const ComplexDisplacement& wanted) {
  const LoopJoint& first = loop.joints[cut.inside[0]];
  const RealDisplacement back = conjugate(loop.joints[cut.inside[1]].rounded.before);
  // J^-1 is c - s step up to a factor.
  const Coordinates a = pair.coordinates(back * wanted);
  const Coordinates b = pair.coordinates(back * (first.rounded.step * wanted));
  return quadratic_roots(a[0] * a[3] - a[1] * a[2],
                         a[0] * b[3] + b[0] * a[3] - a[1] * b[2] - b[1] * a[2],
                         b[0] * b[3] - b[1] * b[2], form_size(a, a) + form_size(b, b));
}

/// Before J ... before J of these joints.
ComplexDisplacement product_of(const Loop& loop, const std::vector<std::size_t>& joints,
                               const std::vector<Tangent>& at) {
  ComplexDisplacement product = ComplexDisplacement::identity();
  for (const std::size_t k : joints) {
    product = product * loop.joints[k].rounded.before * joint_displacement(loop.joints[k], at[k]);
  }
  return product;
}

/// Whether every joint has an inverse and the product of those inside is `wanted`.
bool is_closure(const Loop& loop, const Cut& cut, const std::vector<Tangent>& at,
                const ComplexDisplacement& wanted, double missed, double null) {
  for (std::size_t k = 0; k < at.size(); ++k) {
    if (!(distance_from_null(loop.joints[k], at[k]) > null)) return false;
  }
  const auto a = column(product_of(loop, cut.inside, at)).normalized().eval();
  const auto b = column(wanted).normalized().eval();
  return (a - b * b.dot(a)).norm() <= missed;
}

}  // namespace

ReadBack read_back(const Loop& loop, const Cut& cut, const Point& x, double accuracy) {
  ReadBack result;
  const bool is_loose = cut.kind == CutKind::two;
  const double least = is_loose ? kMissedByRounding : kMissed;
  const double missed = std::max(least, kMissedPerError * accuracy);
  const double null = std::max(kNull, kNullPerError * accuracy);
  std::vector<Tangent> at(loop.joints.size());
  for (std::size_t k = 0; k < cut.outside.size(); ++k) {
    const std::size_t joint = cut.outside[k];
    const Complex chart(loop.joints[joint].is_slide ? cut.chart : 0);
    at[joint] = unit(loop.joints[joint], {1.0 + chart * x[k], x[k]});
  }
  // What the product inside must be, and without the constant displacement at its beginning.
  const ComplexDisplacement around = conjugate(product_of(loop, cut.outside, at));
  const ComplexDisplacement wanted =
      conjugate(loop.joints[cut.inside.front()].rounded.before) * around;
  const auto take = [&] {
    for (const std::size_t k : cut.inside) at[k] = unit(loop.joints[k], at[k]);
    if (!is_closure(loop, cut, at, around, missed, null)) return;
    LoopRoot root{at, 0};
    for (std::size_t k = 0; k < at.size(); ++k) {
      root.imaginary = std::max(root.imaginary, imaginary_part(loop.joints[k], at[k]));
    }
    result.roots.push_back(std::move(root));
  };
  const std::size_t last = cut.inside.size() - 1;
  const Pair pair(loop, cut.inside[last - 1], cut.inside[last]);
  const auto take_pair = [&](const ComplexDisplacement& of_pair) {
    const auto both = joints_of(pair.coordinates(of_pair));
    at[cut.inside[last - 1]] = both[0];
    at[cut.inside[last]] = both[1];
    take();
  };
  if (cut.kind != CutKind::three) {
    take_pair(wanted);
    return result;
  }
  const QuadraticRoots firsts = first_of_three(loop, cut, pair, wanted);
  result.moves = firsts.vanishes;
  const LoopJoint& first = loop.joints[cut.inside[0]];
  for (const Tangent& tangent : firsts.at) {
    at[cut.inside[0]] = tangent;
    const ComplexDisplacement back =
        conjugate(joint_displacement(first, tangent) * loop.joints[cut.inside[1]].rounded.before);
    take_pair(back * wanted);
  }
  result.moves = result.moves && !result.roots.empty();
  return result;
}

JointVector<Complex> values_of(const Loop& loop, const LoopRoot& root) {
  JointVector<Complex> values(std::ssize(loop.joints));
  for (std::size_t k = 0; k < loop.joints.size(); ++k) {
    values[static_cast<Eigen::Index>(k)] = complex_joint_value(loop, k, root.at[k]);
  }
  return values;
}

}  // namespace moivre
