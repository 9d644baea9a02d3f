// SPDX-License-Identifier: MIT
// How far is q from an assembled mechanism, and how does that change? The constraints Phi(q, t) = 0
// with all their derivatives.
//
//   Phi: R^n x R -> R^m, first the joints' rows (or the typed equations), one row per held spin
//   (spins.h), then one per driver.
//   velocity      Phi_q q'  = -Phi_t
//   acceleration  Phi_q q'' = gamma = -((Phi_q q')_q q' + 2 Phi_qt q' + Phi_tt)
// Symbols: q (n coordinates), t seconds, Phi_q (m x n, row i = constraint i), qdot = q'.
// Rows that compare angles (turns, gears, angle drivers) are taken to the nearest whole turn: an
// angle and the same angle plus 2 pi are the same pose. Derivatives come from Taylor arithmetic,
// exact to rounding.
// Not defined: derivatives where a rod's ends meet are zero rows (the rank shows it); where sqrt or
// log leave their domain the row is NaN.
#pragma once

#include <Eigen/Core>
#include <memory>
#include <string>
#include <vector>

#include "moivre/mechanism/mechanism.h"

namespace moivre {

class Constraint;
struct Magnitude;

/// How each row of Phi changes with the value that one driver prescribes, whatever its speed: -1 in
/// the row of a driven angle, -2 L in that of an actuator of length L.
struct DriverRates {
  Eigen::MatrixXd first;   ///< m x d, d Phi / d f_a
  Eigen::MatrixXd second;  ///< m x d, d2 Phi / d f_a^2; the mixed ones are 0
};

class Phi {
 public:
  explicit Phi(const Mechanism& mechanism);

  Eigen::Index size() const { return static_cast<Eigen::Index>(row_names_.size()); }         ///< m
  Eigen::Index dimension() const { return static_cast<Eigen::Index>(coordinates_.size()); }  ///< n
  Eigen::Index driver_size() const { return driver_size_; }  ///< the last rows, which are drivers

  const std::vector<Coordinate>& coordinates() const { return coordinates_; }
  /// "revolute A: x", "driver crank: angle", or the equation's name.
  const std::vector<std::string>& row_names() const { return row_names_; }
  /// The coordinates that each row reads: elsewhere Phi_q is zero at every pose.
  std::vector<std::vector<Eigen::Index>> reads() const;
  /// Names of the bodies (or unknowns) that Coordinate::group refers to.
  const std::vector<std::string>& group_names() const { return group_names_; }
  /// The mechanism's size: its largest length, of points in their bodies and of rods; 1 where it
  /// has none.
  double length() const { return length_; }
  /// The mean of its lengths (the geometric one) for each coordinate that is a length; 1 for an
  /// angle.
  Eigen::VectorXd own_units() const;
  /// Of each row the power of that mean that it is: its square of a rod, 1 of an angle.
  Eigen::VectorXd own_row_units() const;

  Eigen::VectorXd value(const Eigen::VectorXd& q, double t) const;
  /// Sum of the magnitudes of the terms of each row: |Phi_i| is small when it is small relative to
  /// this.
  Eigen::VectorXd term_magnitudes(const Eigen::VectorXd& q, double t) const;
  Eigen::MatrixXd jacobian(const Eigen::VectorXd& q, double t) const;
  /// [Phi_q Phi_t], m x (n + 1)
  Eigen::MatrixXd extended_jacobian(const Eigen::VectorXd& q, double t) const;
  Eigen::VectorXd partial_t(const Eigen::VectorXd& q, double t) const;
  Eigen::VectorXd partial_tt(const Eigen::VectorXd& q, double t) const;
  /// (Phi_q q')_q q'
  Eigen::VectorXd quadratic(const Eigen::VectorXd& q, const Eigen::VectorXd& qdot, double t) const;
  /// 2 Phi_qt q'
  Eigen::VectorXd mixed(const Eigen::VectorXd& q, const Eigen::VectorXd& qdot, double t) const;

  /// The second derivative along the line (q + s qdot, t + s tdot): (Phi_q q')_q q' + 2 t' Phi_qt
  /// q' + t'^2 Phi_tt.
  Eigen::VectorXd second_derivative(const Eigen::VectorXd& q, const Eigen::VectorXd& qdot, double t,
                                    double tdot) const;

  DriverRates driver_rates(const Eigen::VectorXd& q, double t) const;

  /// -Phi_t
  Eigen::VectorXd velocity_rhs(const Eigen::VectorXd& q, double t) const;
  /// gamma
  Eigen::VectorXd acceleration_rhs(const Eigen::VectorXd& q, const Eigen::VectorXd& qdot,
                                   double t) const;

  /// The same constraints without the driver rows.
  Phi without_drivers() const;

  /// The same pose with periodic angles in (-pi, pi] and rotation vectors no longer than pi.
  Eigen::VectorXd canonical(const Eigen::VectorXd& q) const;

  /// Whether a rotation vector is longer than 5 pi / 4, and on its way to 2 pi, where its
  /// derivative is singular.
  bool has_long_rotation(const Eigen::VectorXd& q) const;

 private:
  Phi() = default;
  struct Line;
  Eigen::VectorXd derivative(const Line& line, int order) const;
  void add_jacobian(const Eigen::VectorXd& q, double t, Eigen::MatrixXd& to) const;
  std::vector<Magnitude> magnitudes(const Eigen::VectorXd& q, double t) const;
  friend double scaled_residual(const Phi& phi, const Eigen::VectorXd& q, double t);

  std::vector<Coordinate> coordinates_;
  std::vector<std::string> group_names_;
  std::vector<std::string> row_names_;
  std::vector<int> row_powers_;  ///< of a length, that each row is
  std::vector<std::shared_ptr<const Constraint>> constraints_;
  std::vector<std::shared_ptr<const Constraint>>
      moving_drivers_;  ///< the drivers' rows, each with its own value growing at rate 1
  Eigen::Index driver_size_ = 0;
  std::size_t timeless_ =
      0;  ///< so many constraints, the first ones, do not read t: those of joints
  double length_ = 1;
  double mean_length_ = 1;
};

/// Throws InvalidInput where q has not one finite number for each coordinate, or t is not finite.
/// Phi itself may be evaluated anywhere: at NaN it is NaN.
void require_place(const Phi& phi, const Eigen::VectorXd& q, double t);

/// phi.length(), where nothing else is asked of Phi.
double largest_length(const Mechanism& mechanism);
/// Whether coordinate k is a length.
bool is_length(const Phi& phi, Eigen::Index k);
/// The size of a pose: its largest length, phi.length() at least.
double size_of(const Phi& phi, const Eigen::VectorXd& q);
/// That for each coordinate that is a length; 1, a radian, for an angle.
Eigen::VectorXd sizes_of(const Phi& phi, const Eigen::VectorXd& q);
/// Of the mechanism, whatever its pose: phi.length() for a length, 1 for an angle.
Eigen::VectorXd own_sizes(const Phi& phi);

/// max_i |Phi_i| / (sum of |terms| of Phi_i), 0 for a row without terms.
double scaled_residual(const Phi& phi, const Eigen::VectorXd& q, double t);

/// The scale of each row at poses of the mechanism's size: its terms, and its derivatives times the
/// largest length, or a radian.
/// The terms alone may be rounding noise; this scale is not.
Eigen::VectorXd row_sizes(const Phi& phi, const Eigen::VectorXd& q, double t);

/// scaled_residual where that is rounding, else max_i |Phi_i| / row_sizes_i: small at assembled
/// poses, at the origin too.
double residual_by_size(const Phi& phi, const Eigen::VectorXd& q, double t);
/// A pose counts as assembled up to this residual_by_size. Poses from Newton's method are exact to
/// rounding.
inline constexpr double kAssembled = 1e-9;

/// What each row is where it misses by 1 of the file's unit of length; m.
Eigen::VectorXd misfit_units(const Phi& phi, const Eigen::MatrixXd& jacobian);
/// By how much each row does not close, as a length in the file's unit; m. A row that compares
/// angles is taken at a lever arm of phi.length().
Eigen::VectorXd row_misfits(const Phi& phi, const Eigen::VectorXd& q, double t);
/// Of the worst row: by how much the pose does not close.
double misfit(const Phi& phi, const Eigen::VectorXd& q, double t);

}  // namespace moivre
