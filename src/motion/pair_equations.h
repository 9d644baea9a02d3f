// SPDX-License-Identifier: MIT
// Which equations do two closures satisfy that are mirror images of each other, or both real?
//
// A block of the closure polynomials has, above real values p of the blocks that it needs, two
// roots that are images of each other:
//   x = m +- sqrt(s) u,    |u| = 1,    s < 0 where they are complex, s > 0 where both are real.
// p, m, u and s are real (fixed under the mirror), and regular functions of the time where the
// roots themselves are not: at s = 0, where they meet. In numbers a + b e with e^2 = s, F(m + u e)
// = A + B e, and
//   P(p; t) = 0,   A(p, m, u, s; t) = 0,   B(p, m, u, s; t) = 0,   u0.u = 1
// is a curve. It is regular where p turns back in time, too.
// Symbols: n unknowns z = (p, m, u, s), y = (z, tau), tau = (t - from) / (to - from); x in units
// (moving_polynomials.h).
// Edges: singular where three roots meet. A block whose unknowns are not their own mirror images
// has no pairs.
#pragma once

#include <Eigen/Core>
#include <array>
#include <optional>
#include <vector>

#include "moivre/formulation/block_structure.h"
#include "moving_polynomials.h"

namespace moivre {

/// y
using PairVector = Eigen::VectorXcd;

/// A point of the curve.
struct PairPoint {
  PairVector y;
  PairVector tangent;  ///< y', |y'| = 1
};

/// P, A and B of one block.
class PairEquations {
 public:
  /// All must outlive it.
  PairEquations(const MovingPolynomials& polynomials, const std::vector<Block>& blocks,
                std::size_t block, double from, double to);

  /// Whether the block's unknowns are their own mirror images.
  bool has_mirror() const { return has_mirror_; }
  /// Of the formulation: first those that the block needs, then the block's own.
  const std::vector<std::uint32_t>& variables() const { return variables_; }
  std::size_t needed() const { return needed_; }  ///< how many of the variables the block needs
  double tau(double time) const { return (time - from_) / duration_; }
  double time(double tau) const { return from_ + tau * duration_; }
  double duration() const { return duration_; }
  Eigen::Index at_s() const { return size() - 1; }  ///< place of s in y
  Eigen::Index at_tau() const { return size(); }    ///< place of tau

  /// Values of variables() in a root of the formulation, in units.
  Point restricted(const Point& root) const;
  /// The mirror image of values of variables().
  Point image(const Point& x) const;
  /// y of a pair that is not real.
  PairVector point(const Point& x, double tau) const;
  /// Both roots of y.
  std::array<Point, 2> roots(const PairVector& y) const;
  /// p, m and tau: what does not depend on the length of u.
  PairVector without_u_and_s(PairVector y) const;
  /// With |u| = 1.
  PairVector normalized(PairVector y) const;
  /// Newton's method on the plane normal.y = offset, with u0 that of `base`; the tangent goes the
  /// way of `before`. nullopt where it does not converge.
  std::optional<PairPoint> corrected(PairVector y, const PairVector& base, const PairVector& normal,
                                     double offset, const PairVector& before) const;
  /// s at the time of y, near which the curve is, in double-double: to 1e-25 or so. nullopt:
  /// likewise.
  std::optional<double> sharp_s(const PairVector& y) const;

 private:
  struct Linearized;
  bool linearize(const PairVector& y, const PairVector& base, Linearized& to) const;
  PairVector made_real(const PairVector& y) const;
  /// n
  Eigen::Index size() const {
    return static_cast<Eigen::Index>(2 * variables_.size() - needed_ + 1);
  }
  Eigen::Index own() const { return static_cast<Eigen::Index>(variables_.size() - needed_); }
  Eigen::Index first_u() const { return static_cast<Eigen::Index>(variables_.size()); }

  const MovingPolynomials& polynomials_;
  double from_;
  double duration_;
  std::vector<std::uint32_t> variables_;
  std::size_t needed_ = 0;
  std::vector<std::size_t> rows_;     ///< of the needed blocks first
  std::vector<std::size_t> place_;    ///< of a variable of the formulation among variables_
  std::vector<Eigen::Index> mirror_;  ///< of each of variables_
  bool has_mirror_ = true;
};

}  // namespace moivre
