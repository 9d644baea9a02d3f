// SPDX-License-Identifier: MIT
// What is the loop that an arm makes with the pose of its tip? Joints round a circle, with constant
// displacements between.
//
//   B_1 J_1 B_2 J_2 ... B_n J_n = 1 up to a factor, the tool and the pose taken into B_1: B_1 = T
//   pose^-1 B_1 of the arm.
// J = c one + s step, `one` a power of two near the length of `step`: an axis of fifteen decimals
// is a step of 1e15, and its tangents would be 1e-15. Each turn is counted from a random angle, so
// that no closure that anybody asks for has an infinite tangent.
// Lengths are in units of 2^unit_exponent, near the arm's own.
// What is summed over the loop is so in integers, and in doubles where the loop is one of many.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "moivre/arms/arm.h"
#include "moivre/numeric/complex.h"
#include "moivre/numeric/exact_displacement.h"

namespace moivre {

using RealDisplacement = DualQuaternion<double>;
using ComplexDisplacement = DualQuaternion<Complex>;

/// `before`, then J.
template <class S>
struct JointMotion {
  DualQuaternion<S> before = DualQuaternion<S>::identity();
  S one = S(1);
  DualQuaternion<S> step;
};

struct LoopJoint {
  JointMotion<Integer> exact;
  JointMotion<double> rounded;  ///< `before` of norm 1, `one` 1
  bool is_slide = false;
  /// Of rounded.step: a turn is 2 atan(exact_length s/c) + zero, a slide exact_length s/c.
  double exact_length = 1;
  double zero = 0;  ///< radians: where the tangent is 0
};

/// In which numbers: &LoopJoint::exact or &LoopJoint::rounded.
template <class S>
using JointNumbers = JointMotion<S> LoopJoint::*;

struct Loop {
  std::vector<LoopJoint> joints;
  int unit_exponent = 0;
};

/// The loop without its tool and pose: B_1 is the arm's own.
Loop open_loop(const Arm& arm, std::uint64_t seed);
Loop make_loop(const Arm& arm, const Eigen::Isometry3d& pose, std::uint64_t seed);

template <class S>
Eigen::Matrix<S, 8, 1> column(const DualQuaternion<S>& g) {
  Eigen::Matrix<S, 8, 1> result;
  for (std::size_t k = 0; k < g.size(); ++k) result[static_cast<Eigen::Index>(k)] = g[k];
  return result;
}

/// Of norm 1 as eight numbers.
RealDisplacement unit(const RealDisplacement& g);

/// J_a = 1 or step, times before, times J_b = 1 or step: four of them, spanning all that the pair
/// can do.
template <class S>
std::vector<DualQuaternion<S>> pair_products(const Loop& loop, std::size_t a, std::size_t b,
                                             JointNumbers<S> numbers) {
  const auto& [before, one, step] = loop.joints[b].*numbers;
  const DualQuaternion<S> moved = (loop.joints[a].*numbers).step * before;
  return {before, before * step, moved, moved * step};
}

/// A joint's place on the projective line.
struct Tangent {
  Complex c{1};
  Complex s{0};
};

/// The same place, with |c|^2 + |exact_length s|^2 = 1.
Tangent unit(const LoopJoint& joint, const Tangent& at);
/// J = c + s step.
ComplexDisplacement joint_displacement(const LoopJoint& joint, const Tangent& at);
/// How near the joint is to no displacement, between 0 (J has no inverse) and 1; of a unit tangent.
double distance_from_null(const LoopJoint& joint, const Tangent& at);
/// |Im| of its place on the circle, 0 for a real one; of a unit tangent.
double imaginary_part(const LoopJoint& joint, const Tangent& at);
/// Value of the joint nearest to it: a turn in (-pi, pi], a slide in the arm's unit.
double joint_value(const Loop& loop, std::size_t joint, const Tangent& at);
/// Its value, the angle of a turn with real part in (-pi, pi].
Complex complex_joint_value(const Loop& loop, std::size_t joint, const Tangent& at);

}  // namespace moivre
