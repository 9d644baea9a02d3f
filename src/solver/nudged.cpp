// SPDX-License-Identifier: MIT
// Each root beside its nearest one of the other reading.
#include "nudged.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "account.h"
#include "solution_distance.h"
#include "solver_sentences.h"

namespace moivre {
namespace {

constexpr double kShareOfRoom = 1e-6;
// Double tells no condition beyond it.
constexpr double kMostCondition = 1e14;

double largest_imaginary_part(const Solution& root) {
  double largest = 0;
  const auto look_at = [&](const Point& part) {
    for (const Complex& x : part) largest = std::max(largest, std::abs(x.imag()));
  };
  look_at(root.x);
  for (const Point& part : root.finer) look_at(part);
  return largest;
}

double room_of(const SolveResult& result, std::size_t k) {
  const Solution& root = result.solutions[k];
  double room = std::max(1.0, max_norm(root.x));
  if (!root.real) room = std::min(room, largest_imaginary_part(root));
  for (std::size_t other = 0; other < result.solutions.size(); ++other) {
    if (other != k) room = std::min(room, distance(root, result.solutions[other]));
  }
  return room;
}

/// Of the same kind; infinity where there is none.
double distance_to_nearest(const Solution& root, const SolveResult& nudged) {
  double nearest = std::numeric_limits<double>::infinity();
  for (const Solution& other : nudged.solutions) {
    if (other.real != root.real || other.multiplicity != root.multiplicity) continue;
    nearest = std::min(nearest, distance(root, other));
  }
  return nearest;
}

}  // namespace

void keep_what_rounding_leaves(const SolveResult& nudged, SolveResult& result) {
  std::uint64_t in_doubt = 0;
  for (std::size_t k = 0; k < result.solutions.size(); ++k) {
    Solution& root = result.solutions[k];
    const double moved = distance_to_nearest(root, nudged);
    const bool is_told = root.singular || root.condition <= kMostCondition;
    if (is_told && moved <= kShareOfRoom * room_of(result, k)) {
      root.accuracy = std::max(root.accuracy, moved / std::max(1.0, max_norm(root.x)));
    } else {
      ++in_doubt;
      if (root.certified) root.certified = false;
    }
  }
  if (in_doubt > 0) result.left_out.push_back(roots_that_may_be_none_left_out(in_doubt));
  if (!nudged.complete) return put_in_doubt(result, nudged.message);
  const bool is_one_system = nudged.solutions.size() == result.solutions.size() &&
                             nudged.completeness == result.completeness;
  if (in_doubt == 0 && is_one_system) return;
  put_in_doubt(result, doubt_message(SolveDoubt::roots_hang_on_hidden_digits));
}

}  // namespace moivre
