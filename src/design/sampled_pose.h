// SPDX-License-Identifier: MIT
// What do several quantities of one pose share? The mechanism, Phi_q and the coefficients, each
// found once and only where wanted.
#pragma once

#include <limits>
#include <optional>

#include "moivre/design/readings.h"
#include "moivre/kinematics/coefficients.h"
#include "moivre/kinematics/transmission.h"
#include "observable.h"

namespace moivre {

/// Where a quantity is not defined.
inline constexpr double kNothing = std::numeric_limits<double>::quiet_NaN();

/// A pose, and what was found of it.
class SampledPose {
 public:
  SampledPose(const Phi& phi, const BranchSample& pose) : phi_(phi), pose_(pose) {}

  const Phi& phi() const { return phi_; }
  const BranchSample& pose() const { return pose_; }
  bool has_velocity() const { return pose_.is_determined && pose_.velocity.size() > 0; }
  const Eigen::MatrixXd& jacobian() const;
  const KinematicCoefficients& coefficients() const;
  /// First and second derivative by driver `a`.
  ScalarState along(const Observable& what, Eigen::Index a) const;
  /// The mixed second derivative.
  double mixed(const Observable& what, Eigen::Index a, Eigen::Index b) const;
  /// Whether the observable's velocity has no bound here: a dead point's free direction moves it.
  bool runs_away(const Observable& what) const;

 private:
  const Phi& phi_;
  const BranchSample& pose_;
  mutable std::optional<Eigen::MatrixXd> jacobian_;
  mutable std::optional<KinematicCoefficients> coefficients_;
};

/// How one quantity is read.
struct QuantityRule {
  Quantity quantity;
  std::function<double(const SampledPose&)> value;
  std::optional<Observable> moves;                 ///< what runs away with it
  std::function<double(const SampledPose&)> rate;  ///< of an advantage
};

}  // namespace moivre
