// SPDX-License-Identifier: MIT
// What do Arb's balls prove of the root near a point, in b bits? Newton's method, then Krawczyk's
// test, as in double.
//
// The midpoint is a sum of doubles, exactly: a certificate can hold it without Arb. Radii are
// doubles too, so that a root needs coordinates and radii within their range.
// Edges: where the program was built without Arb (absent_arb_stage.cpp) every precision is `left`.
#pragma once

#include <memory>
#include <span>

#include "program.h"

namespace moivre {

/// What came of a precision.
enum class ArbOutcome {
  proved,
  not_proved,
  converged,  ///< not proved, but Newton's method converged quadratically: the proof lacks digits
  /// Newton's method left the neighbourhood by steps that are not made of rounding: with more
  /// digits it would, too.
  left
};

/// Owns its memory; one a thread.
class ArbStage {
 public:
  explicit ArbStage(const CertifyProgram& program);
  ~ArbStage();

  /// Seeks a proof in b bits, beginning at the point `midpoint + finer`, for all given numbers in
  /// their discs; where it is found, `result` has midpoint, finer, radius, error and bits.
  /// farthest: Newton's method has left where it went farther than this, |x|_inf.
  ArbOutcome prove(std::span<const Complex> midpoint, std::span<const Point> finer,
                   std::span<const Enclosure> given, int bits, double farthest,
                   Certificate& result);

 private:
  class Work;
  std::unique_ptr<Work> work_;
};

}  // namespace moivre
