// SPDX-License-Identifier: MIT
// What is a family of systems, and what is known of it once it is learned? F(x; p) and all roots of
// one generic member.
//
//   F(x; p) = (F_1, ..., F_n), polynomials in n unknowns x and k parameters p, coefficients exactly
//   as read
//   p*: a random complex member;  roots: the regular isolated roots of F(x; p*), as many as a
//                                 generic member has
//
// The isolated roots of a member are ends of the paths from p* to it. A generic member has as many,
// and none has more [SommeseWampler05, ch. 7]. The system is polynomial in the parameters. A number
// and its complex conjugate are two parameters.
// Dependent numbers, such as sine and cosine of an angle, must be expressed by free parameters.
// Edges: multiple roots and sets of roots at p* belong to every member. They are not kept, and the
// learning says so.
#pragma once

#include <string>
#include <vector>

#include "moivre/solver/solve.h"

namespace moivre {

/// How the roots at p* were found, and what is known about their number.
struct Learning {
  std::string start;        ///< kind of the start system, or "monodromy"
  std::uint64_t paths = 0;  ///< that were followed
  std::uint64_t certified = 0;
  std::uint64_t dropped = 0;  ///< multiple roots, and ends on sets of roots, of every member
  /// Every path was decided, or the trace test holds, and nothing was dropped.
  bool complete = false;
  std::string standing;  ///< in a sentence
  std::optional<MetBound>
      bound;  ///< a proved bound on the isolated roots, for every member, met at p*

  friend bool operator==(const Learning& a, const Learning& b);
};

struct Family {
  System system;              ///< n polynomials in the unknowns and, behind these, the parameters
  std::vector<double> sizes;  ///< typical size of each parameter, > 0
  std::uint64_t seed = 0;     ///< of p* and of the search for its roots
  Point generic;              ///< p*
  std::vector<Point> roots;   ///< at p*, n coordinates each
  /// Roots with a coordinate 0 are left out. Closure equations are Laurent polynomials multiplied
  /// out; such roots are no closures.
  bool nonzero = false;
  Learning learning;

  std::size_t unknowns() const { return system.polynomials.size(); }
  std::size_t parameters() const { return system.variables.size() - unknowns(); }
  /// Names of the unknowns, and of the parameters.
  std::vector<std::string> unknown_names() const;
  std::vector<std::string> parameter_names() const;

  friend bool operator==(const Family& a, const Family& b);
};

/// Every broken rule as a sentence, empty where there is none: the system's own, and that sizes, p*
/// and the roots have as many finite numbers as there are parameters and unknowns.
std::vector<std::string> broken_rules(const Family& family);
/// The same of a family that is not learned: of its system and sizes.
std::vector<std::string> broken_rules_of_unlearned(const Family& family);

/// Values of the parameters, exact.
using ParameterValues = std::vector<Coefficient>;

/// F(x; p) in the unknowns alone. Throws InvalidInput when p has another size than the family.
System member_system(const Family& family, const ParameterValues& p);

/// The double itself. Throws InvalidInput where it is not finite.
Coefficient exact_value(const Complex& x);
ParameterValues exact_values(const Point& p);

/// Every coefficient is c_0 + sum_j c_j p_j.
bool is_linear_in_parameters(const Family& family);

}  // namespace moivre
