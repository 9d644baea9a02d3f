// SPDX-License-Identifier: MIT
// The roots' digits from the module multiprecision, where it was built.
#include "moivre/solver/digits.h"

#include <algorithm>
#include <limits>
#include <stdexcept>

#include "moivre/expression/counted.h"
#include "moivre/multiprecision/reference_roots.h"
#include "moivre/numeric/near_points.h"
#include "moivre/numeric/stopwatch.h"
#include "moivre/polynomial/patches.h"

namespace moivre {

namespace {

/// Beside coordinates of 1e16 two roots may be one in double: Newton's method may come to the other
/// one.
bool leads_elsewhere(const ReferenceRoot& found, const Solution& root) {
  return found.forward_error > std::max(root.accuracy, std::numeric_limits<double>::epsilon() / 2);
}

/// False: another simple root may be the one that was found. Their points are one as far as they
/// are known.
bool is_told_apart(const std::vector<Solution>& roots, std::size_t k) {
  const Point& x = roots[k].x;
  for (std::size_t other = 0; other < roots.size(); ++other) {
    if (other == k || roots[other].singular) continue;
    const double known = roots[k].accuracy + roots[other].accuracy;
    if (max_distance(x, roots[other].x) <= known * std::max(1.0, max_norm(x))) return false;
  }
  return true;
}

}  // namespace

void require_digits(int digits) {
  if (digits >= 1 && digits <= kMostDigits) return;
  throw std::invalid_argument("the number of digits must lie between 1 and " +
                              std::to_string(kMostDigits));
}

void give_digits(const System& f, int digits, SolveResult& result, const std::atomic<bool>& stop) {
  require_digits(digits);
  if (!is_square(f)) {
    throw std::invalid_argument(
        "digits need as many equations as unknowns, and no homogeneous groups");
  }
  const Stopwatch watch;
  result.digits = digits;
  std::vector<Point> points;
  for (const Solution& solution : result.solutions) points.push_back(solution.x);
  const auto roots = reference_roots(f, points, digits, result.time.threads, stop);
  std::uint64_t without = 0;
  std::uint64_t not_begun = 0;
  for (std::size_t k = 0; k < roots.size(); ++k) {
    if (roots[k].working_digits == 0) {
      ++not_begun;
    } else if (!roots[k].converged || leads_elsewhere(roots[k], result.solutions[k]) ||
               !is_told_apart(result.solutions, k)) {
      ++without;
    } else {
      result.solutions[k].x_digits = roots[k].x;
    }
  }
  if (without > 0) {
    result.left_out.push_back(
        {std::to_string(digits) + " digits of " + counted(without, "root"),
         "Newton's method does not converge quadratically there, as at every "
         "singular root, or leads to another root, or double does not tell the "
         "root from another one; no digit could be guaranteed"});
  }
  if (not_begun > 0) {
    result.complete = false;
    result.message = "interrupted: what is finished is reported";
    result.left_out.push_back({std::to_string(digits) + " digits of " + counted(not_begun, "root"),
                               "the run was interrupted before"});
  }
  result.time.total += watch.total();
}

}  // namespace moivre
