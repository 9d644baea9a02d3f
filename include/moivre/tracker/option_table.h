// SPDX-License-Identifier: MIT
// Which options has a tracker? One table each. The command line, its --help, validation, JSON and
// docs/trackers.md are made of it.
//
// A row ties a member of the tracker's options to its name in JSON, its flag, the words or the
// range of numbers that it takes, and a sentence. Its default is that of the member: it stands in
// the struct and nowhere else.
// Edges: a value that nobody can choose (how many lanes there are) has no row, and stands among the
// options in force all the same.
#pragma once

#include <algorithm>
#include <functional>
#include <map>
#include <stdexcept>

#include "moivre/numeric/invalid_input.h"
#include "moivre/tracker/tracker.h"
#include "moivre/tracker/tracker_options.h"

namespace moivre {

/// What is known of an option without the tracker that has it.
struct OptionFacts {
  std::string name;                     ///< in JSON and in sentences
  std::string flag;                     ///< on the command line
  std::string sentence;                 ///< what it is
  std::string range = {};               ///< of a number: "must lie in (0, 0.5]"
  OptionValue standard = {};            ///< the default
  std::vector<std::string> words = {};  ///< it takes one of these; empty: a number
  std::string plural = {};              ///< of the words: "methods"
  /// Words that one may expect, and why there are none.
  std::map<std::string, std::string> absent = {};
};

template <class Options>
struct OptionRow {
  OptionFacts facts;
  std::function<OptionValue(const Options&)> get;
  /// Throws std::invalid_argument for a word that is none of `facts.words`.
  std::function<void(Options&, const OptionValue&)> set;
  std::function<bool(const Options&)> is_in_range;
};

template <class Options>
using OptionTable = std::vector<OptionRow<Options>>;

const OptionTable<CvodeOptions>& cvode_table();
const OptionTable<LaneOptions>& lane_table();

/// "--method x: the methods are a, b and c", or why there is no x.
std::string refusal_of_word(const OptionFacts& facts, const std::string& word);

/// A number, in a range that `is_in_range` decides and `range` tells.
template <class Options, class Number>
OptionRow<Options> number_row(const OptionFacts& facts, Number Options::*member,
                              bool (*is_in_range)(Number)) {
  OptionRow<Options> row{facts, {}, {}, {}};
  row.get = [member](const Options& options) { return OptionValue(options.*member); };
  row.set = [member](Options& options, const OptionValue& value) {
    options.*member = std::get<Number>(value);
  };
  row.is_in_range = [=](const Options& options) { return is_in_range(options.*member); };
  row.facts.standard = row.get({});
  return row;
}

/// One of several words: those that to_string() has for these values.
template <class Options, class Choice>
OptionRow<Options> word_row(OptionFacts facts, Choice Options::*member,
                            const std::vector<Choice>& choices) {
  for (const Choice choice : choices) facts.words.push_back(to_string(choice));
  OptionRow<Options> row{facts, {}, {}, {}};
  row.get = [member](const Options& options) { return OptionValue(to_string(options.*member)); };
  row.set = [=](Options& options, const OptionValue& value) {
    const auto& word = std::get<std::string>(value);
    const auto place = std::find(facts.words.begin(), facts.words.end(), word);
    if (place == facts.words.end()) throw InvalidInput(refusal_of_word(facts, word));
    options.*member = choices[static_cast<std::size_t>(place - facts.words.begin())];
  };
  row.is_in_range = [](const Options&) { return true; };
  row.facts.standard = row.get({});
  return row;
}

/// The budget of a path segment, which every tracker has.
template <class Options>
OptionRow<Options> steps_row() {
  return number_row<Options, std::int64_t>({.name = "maximum_steps",
                                            .flag = "--max-steps",
                                            .sentence = "limit on the steps of one path segment",
                                            .range = "must be at least 1"},
                                           &Options::maximum_steps,
                                           [](std::int64_t steps) { return steps >= 1; });
}

template <class Options>
OptionsInForce in_force(const OptionTable<Options>& table, const Options& options) {
  OptionsInForce values;
  for (const auto& row : table) values.push_back({row.facts.name, row.get(options)});
  return values;
}

/// A sentence for each number that is out of range.
template <class Options>
std::vector<std::string> broken_rules(const OptionTable<Options>& table, const Options& options) {
  std::vector<std::string> broken;
  for (const auto& row : table) {
    if (!row.is_in_range(options)) broken.push_back(row.facts.name + " " + row.facts.range);
  }
  return broken;
}

template <class Options>
std::vector<OptionFacts> facts_of(const OptionTable<Options>& table) {
  std::vector<OptionFacts> facts;
  for (const auto& row : table) facts.push_back(row.facts);
  return facts;
}

}  // namespace moivre
