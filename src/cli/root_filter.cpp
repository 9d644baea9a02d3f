// SPDX-License-Identifier: MIT
// Ranges as they are typed, NAME=FROM:TO.
#include "root_filter.h"

#include <cstdlib>
#include <limits>
#include <optional>

#include "moivre/numeric/invalid_input.h"
#include "moivre/polynomial/read.h"

namespace moivre {
namespace {

/// All of the word is a number; nothing typed is `otherwise`.
std::optional<double> bound_in(const std::string& word, double otherwise) {
  if (word.empty()) return otherwise;
  char* end = nullptr;
  const double number = std::strtod(word.c_str(), &end);
  if (end != word.c_str() + word.size()) return std::nullopt;
  return number;
}

std::optional<WantedRange> range_in(const std::string& text) {
  const std::size_t sign = text.find('=');
  const std::size_t colon = text.find(':', sign == std::string::npos ? 0 : sign);
  if (sign == 0 || sign == std::string::npos || colon == std::string::npos) return std::nullopt;
  constexpr double kEndless = std::numeric_limits<double>::infinity();
  const auto from = bound_in(text.substr(sign + 1, colon - sign - 1), -kEndless);
  const auto to = bound_in(text.substr(colon + 1), kEndless);
  if (!from || !to) return std::nullopt;
  return WantedRange{text.substr(0, sign), *from, *to};
}

}  // namespace

void add_filter_options(CLI::App& app, FilterChoice& choice) {
  app.add_flag("--real", choice.flags.real, "tell real roots alone; the others are counted");
  app.add_flag("--positive", choice.flags.positive,
               "tell real roots alone whose coordinates are all above zero");
  app.add_flag("--nonzero", choice.flags.nonzero, "tell roots alone that have no coordinate zero");
  app.add_option(
         "--box", choice.box,
         "tell real roots alone with x from 0 to 1: x=0:1; a side may be left open, several "
         "ranges are separated by commas")
      ->type_name("NAME=FROM:TO")
      ->delimiter(',');
  app.add_option(
         "--where", choice.where,
         "tell real roots alone that meet a condition, such as \"x*y > 2\" or \"0 < x <= 1\"; "
         "may stand several times, and conditions may stand in the file")
      ->type_name("CONDITION")
      ->expected(1)
      ->take_all();
}

RootFilter filter_of(const FilterChoice& choice) {
  RootFilter filter = choice.flags;
  std::vector<std::string> broken;
  for (const std::string& text : choice.box) {
    if (const auto range = range_in(text)) {
      filter.box.push_back(*range);
    } else {
      broken.push_back("--box " + text + ": expected NAME=FROM:TO, such as x=0:1");
    }
  }
  require_unbroken(broken);
  return filter;
}

std::vector<Condition> conditions_of(const FilterChoice& choice, const System& f) {
  std::vector<Condition> conditions = f.conditions;
  for (const std::string& text : choice.where) {
    for (Condition& typed : read_conditions({"--where", text}, f.variables)) {
      conditions.push_back(std::move(typed));
    }
  }
  return conditions;
}

}  // namespace moivre
