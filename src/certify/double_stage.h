// SPDX-License-Identifier: MIT
// What does double prove of the root near a point? Newton's method with residuals in double-double,
// then Krawczyk's test.
//
//   kappa_j = |c_j| + sum_k |Y_jk| (e_k + sum_l (k_n |J_kl| + R_kl) rho_l) + k_n rho_j + sum_l
//   |G_jl| rho_l
//
//   c = fl(Y f),  G = fl(I - Y J),  J, R: middles and radii of the discs J(B);  f: F(m), e: its
//                                   radii + k_n |f|
//   k_n: relative rounding of a sum of n complex products [Higham02, ch. 3]
// Everything is evaluated to nearest and raised (upward.h). Radii rho are tried, wide ones first: a
// wide ball tells more roots apart. A radius that kappa reaches is doubled a few times, since
// coordinates of unlike sizes need unlike radii.
#pragma once

#include <span>
#include <vector>

#include "ball.h"
#include "moivre/factorization/lu.h"
#include "program.h"

namespace moivre {

class DoubleStage {
 public:
  explicit DoubleStage(const CertifyProgram& program);

  /// True where a root is proved; then `result` has midpoint, radius and error.
  bool prove(std::span<const Complex> x, std::span<const Enclosure> given, double accuracy,
             Certificate& result);

 private:
  void take(std::span<const Enclosure> given);
  bool approach(std::span<const Complex> x, double accuracy);
  bool linearize();
  void residual();
  double correction();
  void invert();
  bool find_radii();
  bool inflate(int attempts);
  void jacobian_of_ball(bool with_radii);
  void image();
  void tighten();
  void apply(std::span<const double> reach);

  const CertifyProgram& program_;
  std::size_t n_;
  double rounding_;  // k_n
  Lu lu_;
  Point m_;                      // midpoint
  double largest_ = 0;           // |m|_inf
  Point f_, step_;               // F(m), Newton's correction J^{-1} F(m)
  std::vector<double> e_;        // what f_ may differ from F(m)
  std::vector<double> weights_;  // sizes of the unknowns
  std::vector<FineBall> fine_x_, fine_registers_, fine_values_;
  std::vector<Ball> x_, registers_, values_, jacobian_;
  // Column by column: entry (j, k) stands at k n + j.
  std::vector<Complex> y_, g_;
  std::vector<double> size_y_, size_g_;
  std::vector<double> fixed_;  // the part of kappa that is free of rho
  std::vector<double> load_;   // a vector that |Y| is applied to
  std::vector<double> rho_, kappa_, image_;
};

}  // namespace moivre
