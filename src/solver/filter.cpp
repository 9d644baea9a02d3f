// SPDX-License-Identifier: MIT
// Roots beside what is wanted of them.
#include "moivre/solver/filter.h"

#include <algorithm>
#include <cmath>

#include "condition_value.h"
#include "drop_solutions.h"
#include "moivre/expression/joined.h"
#include "moivre/numeric/invalid_input.h"
#include "solver_sentences.h"

namespace moivre {
namespace {

bool asks_of_coordinates(const RootFilter& filter) {
  return filter.real || filter.positive || filter.nonzero || !filter.box.empty();
}

bool is_wanted(const RootFilter& filter, const std::vector<std::size_t>& places,
               const Solution& root) {
  const double error = root.accuracy * std::max(1.0, max_norm(root.x));
  const bool must_be_real = filter.real || filter.positive || !filter.box.empty();
  if (must_be_real && !root.real) return false;
  const auto all = [&](auto holds) { return std::all_of(root.x.begin(), root.x.end(), holds); };
  if (filter.positive && !all([&](const Complex& x) { return x.real() > error; })) return false;
  if (filter.nonzero && !all([&](const Complex& x) { return std::abs(x) > error; })) return false;
  for (std::size_t k = 0; k < places.size(); ++k) {
    const double x = root.x[places[k]].real();
    if (x < filter.box[k].from - error || x > filter.box[k].to + error) return false;
  }
  return true;
}

/// Whether no point of the plane is wanted, by the coordinates that are 0 there.
bool is_unwanted(const RootFilter& filter, const std::vector<std::size_t>& places,
                 const CoordinatePlane& plane) {
  if (filter.positive || filter.nonzero) return true;
  for (std::size_t k = 0; k < places.size(); ++k) {
    const bool is_zero = std::count(plane.zeros.begin(), plane.zeros.end(), places[k]) > 0;
    if (is_zero && (filter.box[k].from > 0 || filter.box[k].to < 0)) return true;
  }
  return false;
}

void keep_by_coordinates(const RootFilter& filter, SolveResult& result) {
  const std::vector<std::string>& unknowns = result.system.variables;
  std::vector<std::size_t> places;
  for (const WantedRange& range : filter.box) {
    const auto at = std::find(unknowns.begin(), unknowns.end(), range.unknown);
    places.push_back(static_cast<std::size_t>(at - unknowns.begin()));
  }
  const std::size_t before = result.solutions.size();
  result.filtered += drop_solutions_where(
      result, [&](const Solution& root) { return !is_wanted(filter, places, root); });
  std::erase_if(result.planes,
                [&](const CoordinatePlane& plane) { return is_unwanted(filter, places, plane); });
  const std::uint64_t left = before - result.solutions.size();
  result.left_out.push_back(unwanted_roots_left_out(filter, left));
}

/// The boundary, as far as digits tell, belongs to p >= 0 and not to p > 0.
bool meets(const Condition& condition, Sign sign) {
  return sign == Sign::positive || (sign == Sign::unknown && !condition.is_strict);
}

/// Whether p is a constant on the plane that does not meet the condition.
bool fails_throughout(const Condition& condition, const CoordinatePlane& plane) {
  const Polynomial left = on_plane(condition.p, plane.zeros);
  if (left.terms.empty()) return condition.is_strict;
  return degree(left) == 0 && left.terms.front().coefficient.re < 0;
}

/// Takes out the roots that do not meet the condition, and notes which are on its boundary.
void keep_met(const Condition& condition, SolveResult& result) {
  const auto fails = [&](const Solution& point) {
    return !point.real || !meets(condition, sign_at(condition.p, point));
  };
  std::erase_if(result.on_sets, fails);
  std::erase_if(result.planes,
                [&](const CoordinatePlane& plane) { return fails_throughout(condition, plane); });
  std::vector<bool> is_left_out;
  std::uint64_t hidden_by_digits = 0;
  for (Solution& root : result.solutions) {
    const Sign sign = root.real ? sign_at(condition.p, root) : Sign::negative;
    if (sign == Sign::unknown) root.on_boundary.push_back(condition.text);
    if (sign == Sign::unknown && condition.is_strict) ++hidden_by_digits;
    is_left_out.push_back(!meets(condition, sign));
  }
  const auto left =
      static_cast<std::uint64_t>(std::count(is_left_out.begin(), is_left_out.end(), true));
  result.filtered += drop_solutions(result, is_left_out);
  result.left_out.push_back(roots_off_condition_left_out(condition.text, left, hidden_by_digits));
}

}  // namespace

std::vector<std::string> broken_rules(const RootFilter& filter,
                                      const std::vector<std::string>& unknowns) {
  std::vector<std::string> broken;
  for (const WantedRange& range : filter.box) {
    if (std::find(unknowns.begin(), unknowns.end(), range.unknown) == unknowns.end()) {
      broken.push_back("there is no unknown '" + range.unknown + "'; the unknowns are " +
                       joined(unknowns, ", "));
    }
    if (!(range.from <= range.to)) {
      broken.push_back("the range of '" + range.unknown +
                       "' must go from the lower number to the upper");
    }
  }
  for (const Condition& condition : filter.conditions) {
    const std::vector<std::string> of_condition = broken_rules(condition, unknowns.size());
    broken.insert(broken.end(), of_condition.begin(), of_condition.end());
  }
  return broken;
}

void keep_wanted(const RootFilter& filter, SolveResult& result) {
  require_unbroken(broken_rules(filter, result.system.variables));
  if (asks_of_coordinates(filter)) keep_by_coordinates(filter, result);
  for (const Condition& condition : filter.conditions) keep_met(condition, result);
}

}  // namespace moivre
