// SPDX-License-Identifier: MIT
// Kinematic coefficients from one factorization of Phi_q; the mixed second-order term by
// polarization.
#include "moivre/kinematics/coefficients.h"

#include <limits>

#include "moivre/kinematics/own_units.h"

namespace moivre {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

KinematicCoefficients kinematic_coefficients(const Phi& phi, const VectorXd& q, double t) {
  require_place(phi, q, t);
  const Index drivers = phi.driver_size();
  const MatrixXd unknown =
      MatrixXd::Constant(phi.dimension(), drivers, std::numeric_limits<double>::quiet_NaN());
  KinematicCoefficients result{false, unknown,
                               std::vector<MatrixXd>(static_cast<std::size_t>(drivers), unknown)};
  const Factorization factors = factorization_of(phi, phi.jacobian(q, t));
  if (factors.rank() != phi.dimension()) return result;
  result.is_determined = true;
  const DriverRates rates = phi.driver_rates(q, t);
  for (Index a = 0; a < drivers; ++a) result.first.col(a) = factors.solve(-rates.first.col(a));
  for (Index a = 0; a < drivers; ++a) {
    for (Index b = 0; b <= a; ++b) {
      const VectorXd sum = result.first.col(a) + result.first.col(b);
      const VectorXd difference = result.first.col(a) - result.first.col(b);
      // (Phi_q u)_q v = ((Phi_q (u+v))_q (u+v) - (Phi_q (u-v))_q (u-v)) / 4
      VectorXd bent = (phi.quadratic(q, sum, t) - phi.quadratic(q, difference, t)) * 0.25;
      if (a == b) bent += rates.second.col(a);
      const VectorXd k = factors.solve(-bent);
      result.second[static_cast<std::size_t>(a)].col(b) = k;
      result.second[static_cast<std::size_t>(b)].col(a) = k;
    }
  }
  return result;
}

}  // namespace moivre
