// SPDX-License-Identifier: MIT
// What do all JSON reports share? Numbers that are null where unknown, complex pairs, keys in
// order, a layout for people.
// For modules that report. Including it needs nlohmann-json.
#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "moivre/numeric/complex.h"
#include "moivre/solver/solve.h"

namespace moivre {

using Json = nlohmann::ordered_json;

/// null where x is not finite.
Json to_json(double x);
/// [re, im].
Json to_json(Complex x);
Json to_json(const Point& x);
/// null where there is no value.
Json to_json(const std::optional<std::uint64_t>& x);
Json to_json(const std::vector<LeftOut>& left_out);
Json to_json(const Solution& solution);
Json to_json(const PathCounts& paths);
Json to_json(const MetBound& bound);
Json to_json(const FailedPath& failure);
Json to_json(const SolveTime& time);
Json to_json(const SystemFacts& system);
Json to_json(const StartCounts& counts);
Json to_json(const StartFacts& start);
/// What was tracked: the number of its variables, which have no names of their own, and its
/// degrees.
Json reduced_json(const SystemFacts& reduced);
/// Kind, and every option in force; numbers as numbers.
Json tracker_json(const std::string& kind, const OptionsInForce& options);

Json work_json(const StepCount& work);

/// `element` of each item.
template <class List, class Element>
Json list_json(const List& list, Element element) {
  Json array = Json::array();
  for (const auto& item : list) array.push_back(element(item));
  return array;
}

/// Puts numbers in the places of the numbers and nulls of a tree, in order, as many as it has: the
/// same names with other numbers.
void refill(Json& tree, std::span<const double> numbers);

/// Solutions of one system, one after another: room for the coordinates is made once.
class SolutionJson {
 public:
  /// It stands until the next solution is read.
  const Json& read(const Solution& solution);

 private:
  Json solution_;
};

/// {"moivre": version, "command": command, "file": file}: how every report begins.
Json report_head(const std::string& command, const std::string& file);

/// One key a line, and one element a line in arrays of objects. Bytes that are not UTF-8 are
/// replaced.
std::string to_text(const Json& report);

}  // namespace moivre
