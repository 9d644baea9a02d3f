// SPDX-License-Identifier: MIT
// What is proved of the ends of a run? That a simple root lies there, and that two of them are
// different roots or one.
//
// Certificates (certify/certifier.h) are of the square system that is solved, with its exact
// coefficients. They decide what numerical tests cannot: whether an end is a simple root, and,
// where points coincide to their tolerances, which ends are one root.
// Edges: a program without digits beyond double (certify/certifier.h) knows no simple root that
// double does not prove. Private to the module.
#pragma once

#include <memory>

#include "moivre/certify/certifier.h"
#include "run.h"

namespace moivre {

/// From an end a root is no farther than this; how much nearer it must be is for the end's own
/// accuracy to say.
inline constexpr double kFarthestRoot = 1e-5;
/// More digits part roots that the ends, points of double, do not: that is for paths of more
/// digits.
inline constexpr int kMostProofBits = 256;

/// Proves roots near points; one a thread, made and ended by that thread.
class Prover {
 public:
  /// farthest: that a root may be from the point, relative to max(1, |x|_inf). most_bits: of the
  /// balls' arithmetic.
  explicit Prover(std::shared_ptr<const CertifyProgram> program, double farthest = kFarthestRoot,
                  int most_bits = kMostProofBits);

  /// The certificate of a root that Newton's method reaches from x; nullptr where there is no
  /// proof.
  std::shared_ptr<const Certificate> prove(const Point& x);
  /// The same in so many bits, however slowly Newton's method comes there.
  std::shared_ptr<const Certificate> prove_slowly(const Point& x, int bits);
  /// The same as prove() in double alone, nullptr as well where more digits have more to tell.
  std::shared_ptr<const Certificate> prove_in_double(const Point& x);
  /// The same root in so many bits; nullptr where they tell no more.
  std::shared_ptr<const Certificate> sharpened(const Certificate& proof, int bits);

 private:
  Certifier certifier_;
  Certifier double_certifier_;
};

/// Paths that end at one point as far as their ends are known, as PathTable::groups(). Groups of
/// their own are ends that are proved to be different roots, by certificates or since they are
/// known exactly, and ends on a set of positive dimension that passes beside a simple root. An end
/// of which nothing is proved stays with the first of its group.
PathGroups groups_of(const Run& run);

/// So many different roots are proved: by these, none of them nullptr; by all certificates of a
/// run.
std::uint64_t proved_roots(const Setting& setting,
                           const std::vector<std::shared_ptr<const Certificate>>& proofs);
std::uint64_t proved_roots(const Run& run);

}  // namespace moivre
