// SPDX-License-Identifier: MIT
// What do Arb's balls prove of the root near a point, in b bits? Newton's method, then Krawczyk's test, as in double.
//
// The midpoint is a sum of doubles, exactly: a certificate can hold it without Arb. Radii are doubles too, so that
// a root needs coordinates and radii within their range.
#pragma once

#include <map>
#include <span>
#include <vector>

#include "arb_ball.h"
#include "program.h"

namespace moivre {

/// A matrix that owns its entries.
class ArbMatrix {
 public:
  ArbMatrix(std::size_t rows, std::size_t columns) {
    arb().acb_mat_init(value_, static_cast<slong>(rows), static_cast<slong>(columns));
  }
  ArbMatrix(const ArbMatrix&) = delete;
  ArbMatrix& operator=(const ArbMatrix&) = delete;
  ~ArbMatrix() { arb().acb_mat_clear(value_); }

  acb_mat_struct* get() { return value_; }
  acb_ptr entry(std::size_t i, std::size_t j) {
    return acb_mat_entry(value_, static_cast<slong>(i), static_cast<slong>(j));
  }

 private:
  acb_mat_t value_;
};

/// What came of a precision.
enum class ArbOutcome {
  proved,
  not_proved,
  converged,  ///< not proved, but Newton's method converged quadratically: the proof lacks digits
  left  ///< Newton's method left the neighbourhood by steps that are not made of rounding: with more digits it would, too
};

class ArbStage {
 public:
  explicit ArbStage(const CertifyProgram& program);

  /// Seeks a proof in b bits, beginning at the point `midpoint + finer`, for all given numbers in their discs; where it is found,
  /// `result` has midpoint, finer, radius, error and bits. farthest: Newton's method has left where it went farther than this, |x|_inf.
  ArbOutcome prove(std::span<const Complex> midpoint, std::span<const Point> finer,
                   std::span<const Enclosure> given, int bits, double farthest,
                   Certificate& result);

 private:
  void take(std::span<const Enclosure> given);
  ArbOutcome approach(double farthest);
  double largest_coordinate() const;
  void split_midpoint(Certificate& result);
  bool find_radii(Certificate& result);
  void image(const std::vector<double>& rho, std::vector<double>& kappa);
  void tighten(std::vector<double>& kappa);
  std::vector<double> apply(const std::vector<double>& reach);
  void evaluate_at(std::span<const ArbBall> unknowns);
  bool find_step();
  const std::vector<ArbBall>& coefficients();

  const CertifyProgram& program_;
  std::size_t n_;
  slong bits_ = 0;
  std::map<slong, std::vector<ArbBall>> coefficients_;  // by precision
  std::vector<ArbBall> start_, m_, ball_;
  std::vector<ArbBall> x_, registers_, values_,
      jacobian_;  // of the tape; x_: unknowns, then given numbers
  ArbMatrix j_, y_, g_;
  ArbMatrix f_, step_;         // F and its radii; J^-1 or Y times these
  std::vector<double> fixed_;  // |Y F(m)|
};

}  // namespace moivre
