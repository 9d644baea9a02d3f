// SPDX-License-Identifier: MIT
// The roots' digits from the module multiprecision, where it was built.
#include "moivre/solver/digits.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <stdexcept>
#include <utility>

#include "moivre/multiprecision/reference_roots.h"
#include "moivre/numeric/near_points.h"
#include "moivre/numeric/stopwatch.h"
#include "moivre/polynomial/patches.h"
#include "solution_distance.h"
#include "solver_sentences.h"

namespace moivre {

namespace {

// Of roots of equations whose numbers have 40.
constexpr int kDigitsOfRounded = 30;

/// Beside coordinates of 1e16 two roots may be one in double: Newton's method may come to the other
/// one.
bool leads_elsewhere(const ReferenceRoot& found, const Solution& root) {
  return found.forward_error > std::max(root.accuracy, std::numeric_limits<double>::epsilon() / 2);
}

/// How far the root is from x + finer[0] + ..., relative to max(1, |x|_inf).
double known_to(const Solution& root, const ReferenceRoot& found) {
  return found.converged ? found.forward_error : root.accuracy;
}

/// False: another simple root may be the one that was found. Their points are one as far as they
/// are known.
bool is_told_apart(const std::vector<Solution>& roots, const std::vector<ReferenceRoot>& found,
                   std::size_t k) {
  constexpr double kMargin = 2;
  const double size = std::max(1.0, max_norm(roots[k].x));
  for (std::size_t other = 0; other < roots.size(); ++other) {
    if (other == k || roots[other].singular) continue;
    const double known = known_to(roots[k], found[k]) + known_to(roots[other], found[other]);
    if (distance(roots[k], roots[other]) <= kMargin * known * size) return false;
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
  if (!f.nudged.empty() && digits > kDigitsOfRounded) {
    result.left_out.push_back(digits_of_rounded_left_out(kDigitsOfRounded));
    digits = kDigitsOfRounded;
  }
  result.digits = digits;
  std::vector<ApproximateRoot> points;
  for (const Solution& root : result.solutions) points.push_back({root.x, root.finer});
  const auto roots = reference_roots_near(f, points, digits, result.time.threads, stop);
  std::uint64_t without = 0;
  std::uint64_t not_begun = 0;
  for (std::size_t k = 0; k < roots.size(); ++k) {
    if (roots[k].working_digits == 0) {
      ++not_begun;
    } else if (!roots[k].converged || leads_elsewhere(roots[k], result.solutions[k]) ||
               !is_told_apart(result.solutions, roots, k)) {
      ++without;
    } else {
      result.solutions[k].x_digits = roots[k].x;
    }
  }
  if (without > 0) result.left_out.push_back(digits_not_guaranteed_left_out(digits, without));
  if (not_begun > 0) {
    result.complete = false;
    result.message = solve_message(SolveVerdict::interrupted);
    result.left_out.push_back(digits_interrupted_left_out(digits, not_begun));
  }
  result.time.total += watch.total();
}

int digits_that_part(const System& f, const SolveResult& result) {
  constexpr int kTold = 4;
  if (!is_square(f)) return 0;
  std::map<std::vector<std::pair<double, double>>, std::vector<const Solution*>> by_point;
  for (const Solution& root : result.solutions) {
    if (root.finer.empty()) continue;
    std::vector<std::pair<double, double>> key;
    for (const Complex& xi : root.x) key.emplace_back(xi.real(), xi.imag());
    by_point[std::move(key)].push_back(&root);
  }
  double digits = 0;
  for (const auto& [point, roots] : by_point) {
    for (std::size_t k = 1; k < roots.size(); ++k) {
      for (std::size_t j = 0; j < k; ++j) {
        const double apart = distance(*roots[j], *roots[k]) / max_norm(roots[k]->x);
        if (apart > 0) digits = std::max(digits, kTold - std::floor(std::log10(apart)));
      }
    }
  }
  return static_cast<int>(std::min(digits, static_cast<double>(kMostDigits)));
}

}  // namespace moivre
