// SPDX-License-Identifier: MIT
// Which system does this file hold, and how is one written down again? Readers of PHCpack's,
// Bertini's, msolve's and HomotopyContinuation.jl's text, told apart by content.
//
// PHCpack: an optional count line `n` or `n m`, polynomials ended by `;`, `i`/`I` the imaginary
// unit, `^` or `**`, text behind the last polynomial (TITLE, THE SOLUTIONS, ...) ignored. The
// format declares no variables: they are the names in order of first appearance. Bertini:
// CONFIG/INPUT sections, `variable_group`, `hom_variable_group`, `function`, `constant`,
// subfunctions, `%` comments. Its groups are System::groups, in the file's order; unknowns of
// `variable` are the last group where there are others. In a hom_variable_group every function must
// be homogeneous;
// such a system has an equation less than unknowns a group (polynomial/patches.h). Every fault is
// named in one ParseError (expression/source.h).
//
// msolve: a line of names with commas, the characteristic 0, polynomials with commas between.
// HomotopyContinuation.jl: @var, assignments, System([...], variables=[...], parameters=[...]);
// other statements of Julia are passed over.
//
// Written are PHCpack's and Bertini's text. Reading it back gives the same System: coefficients are
// written exactly, as they were typed, and so that the variables come in their order. Groups stand
// in Bertini's text alone.
//
// All as people write them: divisions by polynomials and negative exponents (System::denominators
// keeps what is cleared), functions and roots of numbers (sqrt(2), 2^(1/3), cos(0.3)), 2x. Beside
// Bertini's form also: pi, # comments, and in PHCpack's left = right and conditions, x > 0, which
// no count line counts (System::conditions).
// Not supported: Bertini's pathvariable and parameters (refused with the reason, but by
// read_parametric()).
#pragma once

#include <map>
#include <string>
#include <vector>

#include "moivre/expression/source.h"
#include "moivre/polynomial/system.h"

namespace moivre {

/// msolve's and HomotopyContinuation.jl's are read, not written: PHCpack's is written instead.
enum class PolynomialFormat { phcpack, bertini, msolve, julia };

/// What the content looks like; never throws.
PolynomialFormat detect_format(const std::string& text);

/// Throws ParseError with every fault. The system may have more or fewer polynomials than variables
/// where the file says so (`n m` count line); whether it can be solved is the caller's to decide.
System read_system(const Source& source);
System read_system(const Source& source, PolynomialFormat format);

/// Conditions typed beside a system, in its unknowns: "x > 0", "0 < x*y <= 2", several with `;`
/// between. Throws ParseError with every fault.
std::vector<Condition> read_conditions(const Source& source,
                                       const std::vector<std::string>& unknowns);

/// A system with names that are parameters: what a file declares by Bertini's `parameter`, and
/// those of its constants that are asked for.
struct ParametricSystem {
  System system;                      ///< in all names; it has more of them than equations
  std::vector<std::string> declared;  ///< by `parameter`
  std::map<std::string, Coefficient>
      constants;  ///< the values that the file gives to those asked for
};

/// Throws as read_system(). `constants`: names that stay names where the file gives them a value.
ParametricSystem read_parametric(const Source& source, const std::vector<std::string>& constants);

/// Throws std::invalid_argument when there is nothing to write, a variable's name has a meaning of
/// its own in the format, or (Bertini) the variables do not come group by group.
std::string to_text(const System& f, PolynomialFormat format);

}  // namespace moivre
