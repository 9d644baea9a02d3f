// SPDX-License-Identifier: MIT
// Which blocks need no paths? Those that come down to one quadratic equation, as every dyad does,
// or to none.
//
// Linear equations are solved for an unknown each, and quadratic ones combined so that their
// highest terms cancel, until one unknown is left: what polynomial/eliminate.h does exactly, here
// in double, since the numbers of the blocks before are rounded already. The formula's roots are
// refined by Newton's method on the block's own equations, with residuals in double-double as a
// solve's are [Tisseur01].
// Symbols: n unknowns x; y those that are left; T with [x; 1] = T [y; 1]; a quadric is a symmetric
// matrix M, q(x) = [x; 1]^T M [x; 1].
// S has, for each entry of M, the sum of the moduli of what it was added from: an entry is 0 where
// it is rounding beside that.
// Edges: where anything is less than clear there is no answer, and a solve with all its checks
// decides: an entry that cancels to a small rest, roots near each other or far away, an
// ill-conditioned root, sets of roots.
// Not supported: equations of a higher degree in the block's unknowns.
#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "moivre/closures/stages.h"
#include "moivre/formulation/block_structure.h"
#include "moivre/formulation/formulation.h"
#include "moivre/numeric/double_double.h"
#include "moivre/solver/solve.h"

namespace moivre {

class QuadraticBlock {
 public:
  QuadraticBlock(const Formulation& f, const Block& block);

  /// One or two simple roots of the block in the order of its variables, `path` their number; all
  /// values before it are known.
  std::optional<std::vector<Solution>> roots(const std::vector<KnownValue>& values) const;
  /// No more isolated roots than this, whatever the known values: the total degree, or the
  /// multihomogeneous number of two groups, one the mirror image of the other. 0 where an equation
  /// is of a higher degree.
  std::uint64_t bound() const { return bound_; }

 private:
  /// c times powers of known values, times x_i x_j; x_n = 1.
  struct Product {
    ComplexDoubleDouble c;
    Monomial known;
    Eigen::Index i = 0;
    Eigen::Index j = 0;
  };

  using Equation = std::vector<Product>;

  std::vector<Equation> equations_at(const std::vector<KnownValue>& values) const;
  std::optional<Solution> refined(const std::vector<Equation>& equations, Point x) const;

  Eigen::Index n_ = 0;
  bool is_quadratic_ = true;  ///< no equation has a higher degree
  std::uint64_t bound_ = 0;
  std::vector<Equation> equations_;
};

}  // namespace moivre
