// SPDX-License-Identifier: MIT
// Where do the m sheets of a path that closes around t = 1 end, all together? Their power sums are
// known there.
//
//   z_1(s) ... z_m(s), s = 1 - t on |s| = r:  a quantity of the path on the m turns after which it
//                                             closes
//   p_k(s) = (z_1^k + ... + z_m^k) / m         one-valued, so analytic in |s| <= r, branch points
//                                              or not
//   p_k(0) = mean of z^k over all N m samples  (Cauchy), k = 1 ... m
//
// p_1(0) ... p_m(0) determine the m limits up to order. All limits are 0 if and only if all m sums
// are; whatever finite root the circle has among its sheets, be it far nearer to t = 1 than r,
// leaves a sum that is not 0. A sum counts as 0 where it is lost in the errors of the samples
// relative to the mean of |z|^k; then no limit exceeds limit_bound().
// Poles of z inside the circle are excluded: z is a coordinate on an affine patch that the path
// does not leave there.
//
//   Edges: m = 1: the mean. Many sheets: the m-th root of the errors is no longer small, and
//   limit_bound() says so.
// Private to the module. Source: [MSW91] for the mean; the power sums are Newton's.
#pragma once

#include <vector>

#include "moivre/endgame/end_parameters.h"
#include "moivre/numeric/complex.h"

namespace moivre {

/// max |z_j(0)| is not above this: 2 max_k (m |p_k(0)|)^{1/k} (Fujiwara's bound on the roots of the
/// polynomial with these sums). z: samples of m turns.
double limit_bound(const std::vector<Complex>& z, int m);

/// All limits are 0 as far as the samples can tell, and nearer to 0 than the samples are.
bool vanish_together(const std::vector<Complex>& z, int m, const EndParameters& ends);

/// The power sums beside what has to vanish with them, their Laurent coefficients of negative order
/// (p_k is analytic). These tell the errors of the samples and of their number, whatever those come
/// from.
struct SumsAndErrors {
  /// The largest p_k(0), in its errors: of the order of 1 or less where all limits are 0.
  double sum = 0;
  double error = 0;  ///< the largest of the errors, relative
};

/// known: relative, to which z is known otherwise. changes: of z, what each of the file's numbers
/// may change in it; the sums may differ from 0 by what these make of them, to first order.
SumsAndErrors sums_and_errors(const std::vector<Complex>& z, int m, double known,
                              const EndParameters& ends,
                              const std::vector<std::vector<Complex>>& changes = {});

/// No limit exceeds `bound`, and all are nearer to 0 than the samples are.
bool end_beyond(double bound, const std::vector<Complex>& z, int m);

/// No sum tells the limits apart: as far as the samples can tell z_j(0) = `common` for all j.
bool meet_together(const std::vector<Complex>& z, const Complex& common, int m,
                   const EndParameters& ends);

/// How often each coordinate turns around 0 on the m turns: so many more zeros than poles it has
/// inside the circle. Coordinates that are 0 have no meaning here.
std::vector<int> turns_around_zero(const std::vector<Point>& samples);

/// Exact leading exponents: how often x_j / x_0 turns around 0 on the m turns, over m, for the
/// coordinates j other than x_0, the one numbered `homogenizing`. Coordinates that are 0 have no
/// meaning here.
std::vector<double> valuations(const std::vector<Point>& samples, std::size_t homogenizing, int m);

}  // namespace moivre
