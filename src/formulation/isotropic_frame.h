// SPDX-License-Identifier: MIT
// What do closure polynomials of bodies and of typed equations share? Unknowns with mirrors, angles
// as t and u, sums.
#pragma once

#include <array>
#include <utility>
#include <variant>

#include "angle_classes.h"
#include "arithmetic.h"
#include "frame.h"
#include "moivre/formulation/exact.h"
#include "typed_numbers.h"

namespace moivre {

/// A number in isotropic coordinates with its conjugate.
struct Mirrored {
  Polynomial z;
  Polynomial conjugate;
};

inline Mirrored operator+(const Mirrored& a, const Mirrored& b) {
  return {a.z + b.z, a.conjugate + b.conjugate};
}
inline Mirrored operator-(const Mirrored& a, const Mirrored& b) {
  return {a.z - b.z, a.conjugate - b.conjugate};
}
inline Mirrored operator*(const Mirrored& a, const Mirrored& b) {
  return {a.z * b.z, a.conjugate * b.conjugate};
}
inline Mirrored operator*(const Coefficient& c, const Mirrored& a) {
  return {c * a.z, conjugate(c) * a.conjugate};
}

inline Mirrored operator*(const Polynomial& real, const Mirrored& a) {
  return {real * a.z, real * a.conjugate};
}

inline Mirrored swapped(const Mirrored& a) { return {a.conjugate, a.z}; }

/// Variables from this number on are factors near 1: the unknowns are fewer by far.
inline constexpr std::uint32_t kFirstFactor = std::uint32_t{1} << 30;

/// Puts a Formulation together.
class IsotropicFrame : public Frame {
 public:
  /// Nodes of the angle classes: 0 the ground, then one a name. With factors, what is known up to
  /// an error only is multiplied by them.
  explicit IsotropicFrame(std::vector<std::string> names, bool has_factors = false);

  bool has_factors() const { return has_factors_; }
  /// p w, |w - 1| <= error, w a new factor; p where there are no factors, or no error.
  Polynomial enclosed(const Polynomial& p, double error);
  Mirrored enclosed(const Mirrored& z, double error);
  /// As a constant: value + (w - 1), |w - 1| <= error.
  Polynomial number(const EnclosedNumber& number);
  const std::vector<double>& factor_errors() const { return factor_errors_; }

  /// t_j = factor t_i. Where the angle is held already `name` is left out, or contradicts.
  void hold_angle(std::size_t i, std::size_t j, const EnclosedUnit& factor,
                  const std::string& name);
  /// Notes that `name` wants another angle than the one that is held.
  void contradict(const std::string& name);
  /// Ends the holding of angles: t and u of every class that is left, with t u = 1.
  void add_angles();

  /// A new pair, mirrors of each other.
  Mirrored add_pair(const std::array<std::string, 2>& names, bool is_direction,
                    const std::vector<std::string>& owners);

  void add_equation(const std::string& name, Polynomial p);
  void add_equations(const std::string& name, const Mirrored& z);

  /// Once angles are added.
  const Mirrored& t(std::size_t node) const { return t_[node]; }
  SharedAngle angle(std::size_t node) const { return classes_.find(node); }
  /// prod t_node^power = value, as one polynomial of low degree.
  void add_turn(const std::string& name, const std::vector<std::pair<std::size_t, int>>& powers,
                const EnclosedUnit& value);

 private:
  std::vector<std::string> names_;
  AngleClasses classes_;
  std::vector<Mirrored> t_;  ///< of each node
  bool has_factors_;
  std::vector<double> factor_errors_;  ///< of variable kFirstFactor + k
};

/// p to a power >= 0.
Polynomial power(const Polynomial& p, int exponent);

/// The polynomials of the formulation in the same order, made by the frame of the same mechanism
/// with factors.
EnclosedPolynomials with_factors(const Formulation& formulation, const IsotropicFrame& frame);

Formulation isotropic_bodies(const Mechanism& mechanism, double t);
Formulation isotropic_equations(const Mechanism& mechanism, double t);

}  // namespace moivre
