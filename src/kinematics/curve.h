// SPDX-License-Identifier: MIT
// What is the curve Phi(q, t) = 0 like at a point, and where does it meet a plane? Tangent,
// curvature, distance from losing rank.
//
//   y = (q / w, (t - t0) / T)    n + 1 numbers; w: the mechanism's length for lengths, 1 for angles
//   E = [Phi_q w, Phi_t T]       m x (n + 1), each row brought to length 1
//   tangent    E y' = 0, |y'| = 1          curvature    E y'' = -(Phi_yy y') y', y''.y' = 0
//   sigma      n-th singular value of E, with its vectors E v = sigma u: 0 where branches cross;
//              regular where a branch turns back in t
// With m = n, E^T = Q R in its stairs (staircase_qr.h): the last column of Q is the tangent.
// Symbols: n coordinates, m >= n rows.
#pragma once

#include <Eigen/Core>
#include <optional>

#include "moivre/mechanism/phi.h"
#include "staircase_qr.h"

namespace moivre {

struct CurveScale {
  Eigen::VectorXd w;  ///< n
  double t0 = 0;
  double T = 1;  ///< negative where time runs backwards: the curve's own time always grows
};

struct CurvePoint {
  Eigen::VectorXd y;
  Eigen::VectorXd tangent;
  Eigen::VectorXd curvature;
  double sigma = 0;
  Eigen::VectorXd u;  ///< m
  Eigen::VectorXd v;  ///< n + 1

  double time() const { return y[y.size() - 1]; }  ///< the curve's own
  double time_rate() const { return tangent[tangent.size() - 1]; }
  double time_bend() const { return curvature[curvature.size() - 1]; }
};

class Curve {
 public:
  /// `slack`: what the rows, of length 1, may leave together where constraints contradict each
  /// other a little.
  /// `only_drivers_read_time`: as in mechanisms of bodies; then stairs are known, and used where m
  /// = n.
  Curve(const Phi& phi, CurveScale scale, double slack = 0, bool only_drivers_read_time = false);

  Eigen::VectorXd point(const Eigen::VectorXd& q, double t) const;
  Eigen::VectorXd q_of(const Eigen::VectorXd& y) const;
  double t_of(const Eigen::VectorXd& y) const;
  const CurveScale& scale() const { return scale_; }

  /// sigma to rounding; that of a CurvePoint is iterated, good to a few digits where it is small.
  double sigma(const Eigen::VectorXd& y) const;
  /// The first point: its tangent points forwards in time.
  CurvePoint begin(const Eigen::VectorXd& y) const;
  /// The point y on the curve, its tangent along that of `before`.
  CurvePoint next(const Eigen::VectorXd& y, const CurvePoint& before) const;
  /// Newton's method from y to the curve's point in the plane normal.y = offset; nullopt where it
  /// does not converge.
  std::optional<Eigen::VectorXd> corrected(Eigen::VectorXd y, const Eigen::VectorXd& normal,
                                           double offset) const;

 private:
  struct Rows;  ///< E and the lengths that its rows had
  Rows rows(const Eigen::VectorXd& y) const;
  Eigen::VectorXd bend(const Eigen::VectorXd& y, const Eigen::VectorXd& tangent) const;
  class Bordered;  ///< equations with E and one more row
  CurvePoint described(const Eigen::VectorXd& y, const Rows& rows, Bordered& equations,
                       const Eigen::VectorXd& tangent, const Eigen::VectorXd& v) const;
  const StaircaseOrder* stairs() const { return order_ ? &*order_ : nullptr; }

  const Phi& phi_;
  CurveScale scale_;
  double slack_;
  Pattern pattern_;                      ///< of E
  std::optional<StaircaseOrder> order_;  ///< of E^T
};

}  // namespace moivre
