// SPDX-License-Identifier: MIT
// Which poses miss by no more than Mechanism::fit, and which of them hang together?
//
//   W = {q: misfit(q) <= fit}      misfit: mechanism/phi.h
// All of W is as good an answer as the least squares in it.
// Where Phi_q fixes a pose, W is a small piece around it. Along directions v that Phi_q hardly sees
// it is a valley, |Phi_q v| s + b s^2 / 2 <= fit: at a fold as long as the root of fit; where the
// linkage that is meant moves, as a rhombus folded upon itself does, it goes round.
// sigma: singular values of Phi_q in own units (kinematics/own_units.h). A direction is weak where
// sigma is below the root of fit: then fit, and not Phi_q, says how far the pose can go, and no
// root need be near.
// play: how far from a pose W reaches, angles in radians and lengths by that pose's size: 1e3 and
// more where something slides without end along lines that fit does not part from parallel ones.
// Edges: a valley that branches is followed from the pose alone, along its weak directions and
// their sums.
#pragma once

#include <Eigen/Core>

#include "moivre/mechanism/phi.h"

namespace moivre {

class WithinFit {
 public:
  WithinFit(const Phi& phi, double fit, double t);

  /// Whether q is in W.
  bool has(const Eigen::VectorXd& q) const;
  /// Takes q, where |Phi| is least in own units, into W, where W can be next to it: in W |Phi| is
  /// at most that of rows that all miss by fit, and at q it is no more than in W.
  bool enter(Eigen::VectorXd& q) const;
  /// Whether Phi_q leaves a direction at q to fit.
  bool is_weak(const Eigen::VectorXd& q) const;
  /// Whether Phi_q fixes q so well that as many of its rows as there are unknowns, or as many
  /// combinations of them, have a root beside it.
  bool is_beside_roots(const Eigen::VectorXd& q) const;
  /// Whether W has a way between two of its poses, that leads from a towards b.
  bool joins(const Eigen::VectorXd& a, const Eigen::VectorXd& b) const;
  double play(const Eigen::VectorXd& q) const;

 private:
  Eigen::MatrixXd weak_directions(const Eigen::VectorXd& q) const;
  bool enter(Eigen::VectorXd& q, const Eigen::VectorXd& way, int fewest_steps, double inside) const;
  bool correct(Eigen::VectorXd& q, const Eigen::VectorXd& way) const;
  double next_length(const Eigen::VectorXd& q, const Eigen::VectorXd& way, double length,
                     double correction) const;
  double reach(const Eigen::VectorXd& q, Eigen::VectorXd way) const;

  const Phi& phi_;
  const double fit_;
  const double t_;
  const double share_;  ///< fit beside the mechanism's length
  const Eigen::VectorXd unit_;
};

}  // namespace moivre
