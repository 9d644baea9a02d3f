// SPDX-License-Identifier: MIT
// What are the largest and the smallest singular value of A, without all the others?
//
// A = Q R, in the stairs of what is not zero in it; Lanczos on R^T R has the largest one, on its
// inverse the smallest, each with all vectors kept orthogonal, until the value stands still: to
// rounding for the smallest, to six digits for the largest.
// Symbols: A m x n, m >= n, not empty, finite; `order`: for a pattern that holds A.
// Edges: a singular R, or no standstill, hands over to the SVD.
// Source: [GolubVanLoan13], ch. 10.
#pragma once

#include <Eigen/Core>

#include "moivre/kinematics/linear.h"
#include "staircase_qr.h"

namespace moivre {

/// An equilibrated matrix whose smallest singular value is larger has full rank by its pivots too:
/// none of them is smaller than that, and none larger than its columns, which are no longer than 1.
inline constexpr double kSurelyRegular = 2 * kRankTolerance;

struct ExtremeSingularValues {
  double largest = 0;
  double smallest = 0;
};

ExtremeSingularValues extreme_singular_values(const Eigen::MatrixXd& A,
                                              const StaircaseOrder& order);
double smallest_singular_value(const Eigen::MatrixXd& A, const StaircaseOrder& order);

/// Whether the smallest singular value is larger than kSurelyRegular. One that is far from it costs
/// a few steps only.
bool is_surely_regular(const Eigen::MatrixXd& A, const StaircaseOrder& order);
/// Whether A, of any shape, is so when it is equilibrated, `smallest` being its smallest singular
/// value as it stands. No row is divided by more than the longest one, and no column of what comes
/// of it by more than the root of its rows.
bool stays_regular(const Eigen::MatrixXd& A, double smallest);
/// The same where `qr` is of A: false where that is less than sure.
bool stays_surely_regular(const Eigen::MatrixXd& A, const StaircaseQr& qr);

}  // namespace moivre
