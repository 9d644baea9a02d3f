// SPDX-License-Identifier: MIT
// Where does a linkage get from one pose when a hand moves it? Its curve of poses by arc length, no driver, no branch, no event.
//
// The judge of circuits: it knows Phi without its drivers alone. A step of fixed length along the null vector of Phi_q, Newton's
// method back to the curve, until the curve closes.
#pragma once

#include <Eigen/QR>
#include <cmath>
#include <numbers>
#include <vector>

#include "moivre/kinematics/newton.h"

namespace moivre::test {

struct TracedCircuit {
  std::vector<Eigen::VectorXd> crossings;  ///< poses in which the drivers stand as at time 0
  Eigen::VectorXd lower;  ///< of each coordinate, angles unrolled from the first pose
  Eigen::VectorXd upper;
  Eigen::VectorXd turns;  ///< of each angle, once round
  bool is_closed = false;
};

class CircuitTracer {
 public:
  CircuitTracer(const Mechanism& mechanism, double step)
      : mechanism_(mechanism), phi_(mechanism), joints_(phi_.without_drivers()), step_(step) {}

  TracedCircuit trace(const Eigen::VectorXd& start) const {
    constexpr int kMostSteps = 60000;
    TracedCircuit traced{{}, start, start, Eigen::VectorXd::Zero(start.size()), false};
    Eigen::VectorXd q = start;
    Eigen::VectorXd tangent = null_vector(q);
    const Eigen::VectorXd first = tangent;
    for (int k = 0; k < kMostSteps && !traced.is_closed; ++k) {
      const Eigen::VectorXd next = corrected(q + step_ * tangent);
      look_for_crossing(q, next, traced);
      Eigen::VectorXd turned = null_vector(next);
      if (turned.dot(tangent) < 0) turned = -turned;
      q = next;
      tangent = turned;
      traced.lower = traced.lower.cwiseMin(q);
      traced.upper = traced.upper.cwiseMax(q);
      const Eigen::VectorXd gap = phi_.canonical(q - start);
      // The start lies behind the last step.
      const double along = gap.dot(first);
      traced.is_closed = k > 2 && along >= 0 && along <= 1.5 * step_ && gap.norm() <= 1.5 * step_ &&
                         tangent.dot(first) > 0.5;
    }
    for (Eigen::Index k = 0; k < q.size(); ++k) {
      traced.turns[k] = std::round((q[k] - start[k]) / (2 * std::numbers::pi));
    }
    return traced;
  }

 private:
  /// Of unit length. Phi_q^T has one column less than rows: the last column of its Q.
  Eigen::VectorXd null_vector(const Eigen::VectorXd& q) const {
    const Eigen::MatrixXd J = joints_.jacobian(q, 0);
    const Eigen::HouseholderQR<Eigen::MatrixXd> qr(J.transpose());
    const Eigen::VectorXd last = Eigen::VectorXd::Unit(J.cols(), J.cols() - 1);
    return qr.householderQ() * last;
  }

  Eigen::VectorXd corrected(Eigen::VectorXd q) const {
    for (int k = 0; k < 4; ++k) {
      const Eigen::MatrixXd J = joints_.jacobian(q, 0);
      q -= J.transpose() * (J * J.transpose()).ldlt().solve(joints_.value(q, 0));
    }
    return q;
  }

  double driver_gap(const Eigen::VectorXd& q) const {
    return phi_.value(q, 0)[phi_.size() - phi_.driver_size()];
  }

  void look_for_crossing(const Eigen::VectorXd& q, const Eigen::VectorXd& next,
                         TracedCircuit& traced) const {
    const double before = driver_gap(q);
    const double after = driver_gap(next);
    if (before * after > 0 || std::abs(before - after) > 1) return;
    const double share = before / (before - after);
    const NewtonResult pose = newton(phi_, q + share * (next - q), 0);
    if (pose.status == NewtonStatus::converged) traced.crossings.push_back(pose.q);
  }

  const Mechanism& mechanism_;
  const Phi phi_;
  const Phi joints_;
  const double step_;
};

}  // namespace moivre::test
