// SPDX-License-Identifier: MIT
// Where does a linkage get from one pose when a hand moves it? Its curve of poses by arc length, no
// driver, no branch, no event.
//
// The judge of circuits: it knows Phi without its drivers alone. Steps of fixed length along the
// null vector of Phi_q, lengths beside the mechanism's, Newton's method back to the curve, until
// the curve closes. Extremes: of parabolas through three poses.
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "moivre/factorization/qr.h"
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
      : phi_(mechanism), joints_(phi_.without_drivers()), step_(step) {
    weights_ = Eigen::VectorXd::Ones(phi_.dimension());
    for (Eigen::Index k = 0; k < phi_.dimension(); ++k) {
      const Coordinate& coordinate = phi_.coordinates()[static_cast<std::size_t>(k)];
      if (coordinate.kind == CoordinateKind::length) weights_[k] = phi_.length();
    }
  }

  TracedCircuit trace(const Eigen::VectorXd& start) const {
    constexpr int kMostSteps = 60000;
    TracedCircuit traced{{}, start, start, Eigen::VectorXd::Zero(start.size()), false};
    Eigen::VectorXd tangent = null_vector(start);
    const Eigen::VectorXd first = tangent;
    std::vector<Eigen::VectorXd> way{start};
    for (int k = 0; k < kMostSteps && !traced.is_closed; ++k) {
      const Eigen::VectorXd q = way.back();
      way.push_back(corrected(q + step_ * tangent.cwiseProduct(weights_)));
      look_for_crossing(q, way.back(), traced);
      Eigen::VectorXd turned = null_vector(way.back());
      if (turned.dot(tangent) < 0) turned = -turned;
      tangent = turned;
      // The start lies behind the last step.
      const Eigen::VectorXd gap = phi_.canonical(way.back() - start).cwiseQuotient(weights_);
      const double along = gap.dot(first);
      traced.is_closed = k > 2 && along >= 0 && along <= 1.5 * step_ && gap.norm() <= 1.5 * step_ &&
                         tangent.dot(first) > 0.5;
    }
    for (Eigen::Index k = 0; k < start.size(); ++k) {
      traced.turns[k] = std::round((way.back()[k] - start[k]) / (2 * std::numbers::pi));
    }
    take_extremes(way, traced);
    return traced;
  }

 private:
  static void take_extremes(const std::vector<Eigen::VectorXd>& way, TracedCircuit& traced) {
    for (std::size_t j = 1; j + 1 < way.size(); ++j) {
      for (Eigen::Index k = 0; k < way[j].size(); ++k) {
        const double slope = (way[j + 1][k] - way[j - 1][k]) / 2;
        const double bend = way[j + 1][k] - 2 * way[j][k] + way[j - 1][k];
        const bool is_extreme = (way[j + 1][k] - way[j][k]) * (way[j][k] - way[j - 1][k]) <= 0;
        const double value =
            is_extreme && bend != 0 ? way[j][k] - slope * slope / (2 * bend) : way[j][k];
        traced.lower[k] = std::min(traced.lower[k], value);
        traced.upper[k] = std::max(traced.upper[k], value);
      }
    }
  }

  /// In coordinates beside the weights, of unit length. Phi_q^T has one column less than rows: the
  /// last column of its Q.
  Eigen::VectorXd null_vector(const Eigen::VectorXd& q) const {
    const Eigen::MatrixXd J = joints_.jacobian(q, 0) * weights_.asDiagonal();
    return PivotedQr<double>(J.transpose()).last_columns_of_Q(1);
  }

  Eigen::VectorXd corrected(Eigen::VectorXd q) const {
    for (int k = 0; k < 4; ++k) {
      const Eigen::MatrixXd J = joints_.jacobian(q, 0) * weights_.asDiagonal();
      const Eigen::VectorXd step = Qr(J.transpose()).solve_transposed(joints_.value(q, 0));
      q -= step.cwiseProduct(weights_);
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

  const Phi phi_;
  const Phi joints_;
  const double step_;
  Eigen::VectorXd weights_;  ///< 1 of an angle, the mechanism's length of a length
};

}  // namespace moivre::test
