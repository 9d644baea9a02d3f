// SPDX-License-Identifier: MIT
// Which roots of the closure polynomials are proved, and what is proved of them? Certificates,
// group of blocks after group.
//
// Blocks solved in turn are a triangular system. Where the values of the blocks before lie in
// balls, the next ones are proved for all numbers in these (certify/certifier.h): the product of
// all balls holds exactly one root of all equations so far. A group is a block that was solved by
// homotopy, with the lone linear equations that were solved since the one before.
//   vanishes   E(x) at a root x: z = E(x) is one more unknown, known to 256 bits. Its ball holds 0;
//              or, where coefficients were rounded, z is no further from 0 than it would move if
//              they all changed in their last digits. It is no proof, but what is tiny because
//              lengths are off by 1e-9 is seen not to be 0
//   real       the mirror image of a root is a root; it lies in the ball that holds one root only
// Proofs are of the mechanism as it was typed: a number of it that was rounded, the sine of a
// driver's angle, is known to lie in a disc, and what is proved is proved for all numbers in it
// (EnclosedPolynomials).
// Edges: a multiple root has no proof, and no root above it has one. Nothing is proved where the
// program has no digits beyond double.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "moivre/formulation/block_structure.h"
#include "moivre/formulation/formulation.h"

namespace moivre {

/// What is proved of one group's unknowns, and of those before.
struct RootProof;
/// nullptr: nothing is.
using KnownProof = std::shared_ptr<const RootProof>;

/// A root x* of all equations, known to be the only one within `accuracy` of x.
struct ProvedRoot {
  Point x;
  double accuracy = 0;       ///< |x - x*|_inf / max(1, |x|_inf) is no more
  std::optional<bool> real;  ///< it is its mirror image; nullopt: unknown
};

class RootProver {
 public:
  /// Proves nothing unless `is_wanted`. The formulation has to outlive it.
  RootProver(const Formulation& formulation, bool is_wanted);
  ~RootProver();

  bool is_on() const { return work_ != nullptr; }

  /// The polynomials that are solved have every term that the mechanism as typed has.
  bool knows_terms() const;
  /// None of the mechanism's numbers was rounded.
  bool has_exact_numbers() const;
  /// Of numbers rounded so finely that what holds for them holds for almost all: they have no fewer
  /// roots than those they stand for.
  bool has_general_numbers() const;

  /// The block waits for the next group.
  void add(const Block& block);
  /// What waits is the last group from now on; false where nothing waits.
  bool close();

  /// Of the last group. before: of the group before it, of the same root. values: of all unknowns
  /// so far, the others are not looked at.
  KnownProof prove(const KnownProof& before, const Point& values);
  /// Which of these, of one group and of the same root before, are proofs of roots that no earlier
  /// one may be.
  static std::vector<bool> are_new(const std::vector<KnownProof>& proofs);
  /// Whether one of the formulation's exclusions, in unknowns that are proved, is 0 at the root;
  /// nullopt: unknown.
  std::optional<bool> vanishes(const KnownProof& proof, const Formulation::Exclusion& exclusion);
  /// How far each unknown of the root may lie from that of the mechanism as typed, where all
  /// coefficients are known to rounding only, to first order. Of a proof of all unknowns; nullopt:
  /// unknown.
  std::optional<std::vector<double>> moved_by_rounding(const KnownProof& proof);
  /// These unknowns of the last proof's group to more digits than double has; empty where that
  /// failed.
  std::vector<Coefficient> fine_values(const KnownProof& proof,
                                       const std::vector<std::size_t>& unknowns);
  /// Of a proof of all unknowns.
  ProvedRoot root(const KnownProof& proof);

 private:
  struct Work;
  std::unique_ptr<Work> work_;
};

}  // namespace moivre
