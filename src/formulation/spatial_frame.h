// SPDX-License-Identifier: MIT
// How are unknowns and equations of spatial closure polynomials collected, and how does a tie move
// with its unknowns?
//
//   turn   1 + t k after a fixed turn 1 + o k: (1 - o t) + (o + t) k. The fixed turn, random, keeps
//          half a turn at t finite.
//   slide  (1 - o u) + eps u k / 2, the slide u / (1 - o u): with o = 0 u is the slide itself, else
//          infinity is brought to a finite place
//   any turn    four homogeneous unknowns with a random patch, a . x = 1
//   any pose    eight, the patch on the first four: what has q = 0 is infinitely far
// Every unknown is real where the pose is: the mirror of each is itself.
// Exclusions: 1 + t^2 = 0, 1 - o u = 0, and |q|^2 = 0 of homogeneous ones; there the polynomials
// hold and nothing is turned.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "arithmetic.h"
#include "frame.h"
#include "rigid_groups.h"

namespace moivre {

using MovingPose = DualQuaternion<Polynomial>;

/// A constant pose among polynomials.
MovingPose to_moving(const ExactPose& pose);

Polynomial real_constant(const Rational& c);

/// p but for terms that are rounding relative to `size`.
Polynomial without_noise(Polynomial p, double size);

class SpatialFrame : public Frame {
 public:
  /// length: the mechanism's size, in the file's unit of length. has_exact_frames: no joint's frame
  /// was rounded.
  explicit SpatialFrame(double length, bool has_exact_frames = false)
      : length_(length), has_exact_frames_(has_exact_frames) {}
  double length() const { return length_; }

  /// As without_noise; notes where a term was dropped.
  Polynomial without_rounding(Polynomial p, double size);
  /// a - b but for what rounding of typed numbers leaves.
  Polynomial difference(const Polynomial& a, const Polynomial& b);
  /// The coefficients are not exact from now on.
  void note_rounding() { result().is_exact = false; }
  /// Nothing where p is zero; a contradiction where it is another number.
  void add_equation(const std::string& name, Polynomial p);
  /// What is left of an equation without unknowns, and why there is no closure.
  void add_contradiction(const std::string& clause, const Rational& left);
  /// An equation that the others imply but for a factor. It comes behind all others, so that it is
  /// checked, not solved, where they suffice.
  void add_check(const std::string& name, Polynomial p);
  /// Adds what waits as a check.
  void add_checks();
  void exclude(Polynomial p, const std::string& reason);
  void bound(Formulation::Bound bound) { result().bounds.push_back(std::move(bound)); }
  /// Notes where a group stands: at this pose in a placed one.
  void place(std::size_t group, std::size_t parent, const MovingPose& relative);

  /// A random number of size 1/2 to 2, positive or negative.
  Rational random_number();

  /// t of a turn about z, u of a slide along it; `fixed` is the number o.
  Polynomial add_turn(const std::string& name, const std::vector<std::string>& owners);
  Polynomial add_slide(const std::string& name, const Rational& fixed,
                       const std::vector<std::string>& owners);
  /// Four homogeneous unknowns on a random patch.
  Quaternion<Polynomial> add_patched(const std::string& name, bool is_direction,
                                     const std::vector<std::string>& owners);
  MovingPose add_any_turn(const std::string& name, const std::vector<std::string>& owners);
  MovingPose add_any_pose(const std::string& name, const std::vector<std::string>& owners);

 private:
  void note_dropped();

  double length_;
  bool has_exact_frames_;
  std::vector<std::pair<std::string, Polynomial>> checks_;
  std::uint64_t random_count_ = 0;
};

/// The turn of t and the slide of u.
MovingPose turn_of(const Polynomial& t, const Rational& fixed);
MovingPose slide_of(const Polynomial& u, const Rational& fixed);

/// What lies between the groups of a tie, one after the other.
struct TieStep {
  enum class Kind { fixed, turn, slide, any_turn } kind = Kind::fixed;
  ExactPose pose = {};    ///< of a fixed one
  std::string name = {};  ///< of the others' unknowns
};
/// From group i to group j. Turns come first where `turns_first`; but for any_turn they commute
/// with the tie's slides.
std::vector<TieStep> steps_of(const Tie& tie, bool turns_first);

/// Adds the tie's unknowns and gives the pose of group j in group i.
MovingPose add_motion(SpatialFrame& frame, const Tie& tie, const std::vector<std::string>& owners);

/// The equation of a rod: |4 g g - L^2 q q| of the shift between its ends.
Polynomial rod_equation(SpatialFrame& frame, const Tie& tie, const MovingPose& j_in_i);

/// The equations of another tie between groups whose relative pose is known as polynomials.
void add_closing(SpatialFrame& frame, const Tie& tie, const MovingPose& j_in_i);

}  // namespace moivre
