// SPDX-License-Identifier: MIT
// Groups of quantities by their names.
#include "column_choice.h"

#include <algorithm>
#include <sstream>
#include <stdexcept>

#include "moivre/expression/joined.h"
#include "moivre/mechanism/nearest.h"

namespace moivre {
namespace {

constexpr const char* kAll = "all";
constexpr const char* kHelp = "help";

std::string groups_text() {
  std::string text;
  for (const QuantityGroup group : quantity_groups()) {
    std::string name = to_string(group);
    name.resize(14, ' ');
    text += "  " + name + description(group) + '\n';
  }
  return text + "  all           all of these\n";
}

std::vector<std::string> words_of(const std::string& list) {
  std::vector<std::string> words;
  std::istringstream stream(list);
  for (std::string word; std::getline(stream, word, ',');) {
    const auto is_space = [](char c) { return c == ' '; };
    word.erase(std::remove_if(word.begin(), word.end(), is_space), word.end());
    words.push_back(word);
  }
  return words;
}

}  // namespace

void add_column_options(CLI::App& app, ColumnChoice& choice) {
  app.add_option("--columns", choice.groups,
                 "groups of design quantities: columns of the table, extremes in text and JSON, "
                 "plots on the page; --columns help lists the groups")
      ->type_name("LIST");
  app.add_option("--output", choice.outputs,
                 "with --columns: the output of mechanical advantage and time ratio: a body, a "
                 "joint or a point's coordinate; may be repeated; default: what is joined to the "
                 "ground and not driven")
      ->type_name("NAME");
}

bool asks_for_help(const ColumnChoice& choice) { return choice.groups == kHelp; }

std::string columns_help(const Mechanism& mechanism) {
  const QuantityReader reader(mechanism, {});
  std::string text =
      "--columns takes groups of quantities, with commas between them:\n" + groups_text();
  if (!reader.outputs().empty())
    text += "outputs, where --output names none: " + joined(reader.outputs(), ", ") + '\n';
  return text;
}

std::vector<QuantityGroup> groups_of(const ColumnChoice& choice) {
  std::vector<QuantityGroup> groups;
  const std::vector<QuantityGroup> known = quantity_groups();
  std::vector<std::string> names;
  for (const QuantityGroup group : known) names.push_back(to_string(group));
  for (const std::string& word : words_of(choice.groups)) {
    if (word == kAll) return known;
    const auto found = std::find(names.begin(), names.end(), word);
    if (found == names.end()) {
      throw std::invalid_argument("--columns: there is no group '" + word + "'" +
                                  suggestion(word, names) + "\nThere are:\n" + groups_text());
    }
    const QuantityGroup group = known[static_cast<std::size_t>(found - names.begin())];
    if (std::find(groups.begin(), groups.end(), group) == groups.end()) groups.push_back(group);
  }
  if (groups.empty() && !choice.outputs.empty()) {
    throw std::invalid_argument(
        "--output says what --columns is of: add --columns advantage, or another group");
  }
  return groups;
}

std::unique_ptr<const QuantityReader> make_reader(const Mechanism& mechanism,
                                                  const ColumnChoice& choice) {
  const std::vector<QuantityGroup> groups = groups_of(choice);
  if (groups.empty()) return nullptr;
  return std::make_unique<const QuantityReader>(mechanism, QuantityChoice{groups, choice.outputs});
}

}  // namespace moivre
