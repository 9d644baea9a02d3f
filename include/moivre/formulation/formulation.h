// SPDX-License-Identifier: MIT
// Which polynomials does an assembled mechanism satisfy? Its joints in suitable coordinates,
// drivers substituted.
//
// Planar mechanisms, in isotropic coordinates:
// Body i:  p_i = x + iy,  pb_i its conjugate as an unknown of its own,  t_i = exp(i phi_i),  u_i =
//                         1/t_i.
// Bodies with a known relative angle (weld, prismatic, driven angle) share one t:  t_i = gamma_i
// t_class.
//   body       t u = 1                                            one equation per class, ground's
//              t is 1
//   revolute   p_i + a t_i = p_j + b t_j,  and the conjugate      linear
//   line       (eb u_i) D = (e t_i) Db                            prismatic and slot; D = p_j + b
//              t_j - p_i - a t_i
//   slide      D = s e t_i,  Db = s eb u_i                        a driven line: linear
//   rod        D Db = L^2                                       and an actuator that is driven
//   gear       t_i^zi t_c^(zj-zi) t_j^-zj = exp(-i zj phase)      powers moved to the side that
//              keeps the degree low
//   driven x   p + a t + pb + ab u = 2 x
//   rack, cam  eb u_i D + e t_i Db = 2 s                         its slide s is known
//              (src/formulation/known_motions.h)
// Typed equations: cos and sin of whole multiples of angles become polynomials in t and u, lengths
// stay.
// A real pose is a fixed point of x_v -> conj(x_mirror(v)): mirror swaps p and pb, t and u, and
// keeps a length.
// Coefficients are the shortest decimals that read back as the file's doubles; exp(i phi) is a
// rational point of the unit circle within 2^-126 of the direction that was typed, so that t u = 1
// holds exactly. What is true of the mechanism is proved with EnclosedPolynomials, in which each
// number that was rounded has a factor of its own. The drivers stand at the time given.
// Spatial mechanisms: half angles and dual quaternions (src/formulation/spatial_bodies.h,
// docs/decisions/0020-spatial-closures.md).
// Not supported: typed equations with angles outside cos and sin (std::invalid_argument, the
// reason).
// Source: [Wampler96], with the slide of prismatic joints eliminated, since that halves their
// degree.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "moivre/formulation/pose_reading.h"
#include "moivre/mechanism/mechanism.h"
#include "moivre/numeric/complex.h"
#include "moivre/polynomial/system.h"

namespace moivre {

/// The polynomials of the mechanism as it was typed, in the unknowns and in factors that are known
/// to lie near 1: w_k, variable n + k where there are n unknowns. With every w_k = 1 they are those
/// of the formulation, but for terms that were taken for rounding.
struct EnclosedPolynomials {
  std::vector<Polynomial> polynomials;
  std::vector<double> factor_errors;  ///< |w_k - 1| is no more
  bool has_same_terms = true;         ///< no term was taken for rounding, and none has cancelled
};

struct Formulation {
  System system;  ///< all polynomials of the mechanism, square or not; drivers first
  std::vector<std::string> equation_names;
  std::vector<std::size_t> mirror;  ///< of each variable
  std::vector<bool>
      is_direction;   ///< of each variable: t or u, of size 1 where real; else a length
  double length = 0;  ///< the mechanism's largest; 0 of typed equations, which have none
  /// The coefficients are what the file's numbers make them, not right to rounding only. Of spatial
  /// mechanisms.
  bool is_exact = true;
  /// Axes and turns are right to rounding only, and so is what is made of them: what a proof says
  /// of two roots that rounding may merge is not said of the file's numbers. Of spatial mechanisms.
  bool has_rounded_frames = false;
  /// Links were taken for special ones that are no farther from those of the file, in radians and
  /// beside their size: roots lie beside closures. Of spatial mechanisms with spare equations.
  double meant_within = 0;
  /// Terms of exact numbers were taken for rounding, since they are as small: a platform typed with
  /// 14 digits is the symmetric one.
  bool lacks_typed_terms = false;
  /// A driver's angle is known within an error only: that something vanishes here may be its
  /// rounding. Of planar mechanisms.
  bool has_rounded_angles = false;
  /// Made where it is asked for; empty where the system itself is what proofs are of.
  std::function<EnclosedPolynomials()> enclosed;
  std::vector<std::vector<std::string>> owners;  ///< bodies (or unknowns) that a variable places
  /// Why there is no closure, each a clause. What is a number, and no equation any more, stays in
  /// the system all the same.
  std::vector<std::string> contradictions;

  /// Where q is read from: q_k = Re or Im of a number, or its argument. The number is `of`; of a
  /// body that follows a rack or a cam it is `of` + `arm` f(root), where f is no polynomial: a
  /// direction, a displacement.
  struct Reading {
    enum class Part { re, im, argument } part = Part::re;
    Polynomial of;
    Complex arm = 0;
    std::function<Complex(const Point&)> f = {};
  };
  std::vector<Reading> coordinates;  ///< planar mechanisms and typed equations
  PoseReading poses;                 ///< spatial mechanisms

  /// A root where this vanishes, relative to its terms, is no pose.
  struct Exclusion {
    Polynomial of;
    std::string reason;
  };
  std::vector<Exclusion> exclusions;

  /// A member of a class in general position. On almost every line of coefficients through it and
  /// another member, from which no exclusion vanishes, there are as many roots as it has.
  struct GeneralMember {
    System system;  ///< equation by equation of the same kind as the formulation's, in its unknowns
    std::vector<Point> roots;
  };
  /// A theorem on the first unknowns: no member of this class has more isolated poses, complex ones
  /// included.
  struct Theorem {
    std::string of;            ///< "a body on six rods"
    std::size_t unknowns = 0;  ///< which these and as many equations, the first ones, say all of
    std::uint64_t most = 0;
    std::function<GeneralMember()> general;  ///< one with as many; made where it is asked for
  };
  std::optional<Theorem> theorem;
  /// Another one, on a block of these unknowns, ascending: no member of the class has more isolated
  /// poses, and each is one root of the block.
  struct Bound {
    std::string of;  ///< "a loop of six joints"
    std::vector<std::size_t> unknowns;
    std::uint64_t most = 0;
  };
  std::vector<Bound> bounds;
  std::vector<std::pair<std::string, std::string>> left_out;  ///< what was left out, and why
};

/// What is left of an exclusion's terms, 0 to 1; nullopt where it has a variable whose value is not
/// known.
std::optional<double> share_left(const Formulation::Exclusion& exclusion,
                                 const std::vector<std::optional<Complex>>& values);

/// The polynomials at time t.
Formulation formulate(const Mechanism& mechanism, double t);

/// The same with every term that was typed, none of them taken for rounding; nullopt where none
/// was. A mechanism that is meant to be special, typed with all digits of a double, is then another
/// one.
std::optional<Formulation> with_typed_terms(const Formulation& formulation);

/// q of a root; meaningful where the root is real.
Eigen::VectorXd coordinates_of_root(const Formulation& formulation, const Point& root);

/// max_i |F_i| / sum |terms of F_i|, where a direction counts as at least 1 and a length as at
/// least the largest one, of the root and of the mechanism. Without this an equation like p = 0
/// would have rounding errors as its only scale.
double residual_of_root(const Formulation& formulation, const Point& root);

/// The same of many roots.
class ResidualOfRoots {
 public:
  /// The formulation has to outlive it.
  explicit ResidualOfRoots(const Formulation& formulation);
  /// Of these equations alone; unknowns in which none of them is may have any value.
  ResidualOfRoots(const Formulation& formulation, const std::vector<std::size_t>& equations);
  double operator()(const Point& root) const;

 private:
  const Formulation& formulation_;
  struct Equation {
    const Polynomial* polynomial;
    Point coefficients;
  };
  std::vector<Equation> equations_;
};

/// max_v |x_v - conj(x_mirror(v))| / size_v: 0 for a real pose. size_v: of a direction the largest
/// one, 1 at least; of a length the largest one, of the root and of the mechanism.
double distance_from_real(const Formulation& formulation, const Point& root);

/// The image of a root under the real structure: a root as well.
Point mirrored(const Formulation& formulation, const Point& root);

}  // namespace moivre
