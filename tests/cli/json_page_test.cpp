// SPDX-License-Identifier: MIT
// Is docs/json.md true? Runs each of its commands and compares names and kinds of all values with
// the page.
#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>
#include <set>
#include <sstream>

#include "program.h"

namespace moivre::test {
namespace {

using Json = nlohmann::json;

/// Paths of keys such as "solutions[].x[][]", each with the kinds of value that occur there.
using Shape = std::map<std::string, std::set<std::string>>;

void collect(const Json& value, const std::string& path, Shape& shape) {
  shape[path].insert(value.type_name());
  if (value.is_object()) {
    for (const auto& [key, member] : value.items()) collect(member, path + '.' + key, shape);
  } else if (value.is_array()) {
    for (const Json& element : value) collect(element, path + "[]", shape);
  }
}

Shape shape_of(const std::string& text) {
  Shape shape;
  collect(Json::parse(text), "", shape);
  return shape;
}

std::vector<std::string> lines_of_page() {
  std::ifstream page(std::string(MOIVRE_SOURCE_DIR) + "/docs/json.md");
  std::vector<std::string> lines;
  for (std::string line; std::getline(page, line);) lines.push_back(line);
  return lines;
}

std::string fenced_block(const std::vector<std::string>& lines, std::size_t& k) {
  std::string text;
  for (++k; k < lines.size() && lines[k] != "```"; ++k) text += lines[k] + '\n';
  return text;
}

std::vector<std::string> words_of(const std::string& command) {
  std::istringstream stream(command);
  std::vector<std::string> words;
  for (std::string word; stream >> word;) words.push_back(word);
  return words;
}

bool contains(const std::vector<std::string>& words, const std::string& word) {
  return std::find(words.begin(), words.end(), word) != words.end();
}

TEST(JsonPage, ShowsWhatTheProgramPrints) {
  if (!MOIVRE_WITH_CERTIFY) GTEST_SKIP() << "the page tells of more digits";
  const std::vector<std::string> lines = lines_of_page();
  ASSERT_FALSE(lines.empty());
  const Scene scene;
  std::string file;
  std::vector<std::string> command;
  std::set<std::string> shown;
  for (std::size_t k = 0; k < lines.size(); ++k) {
    if (lines[k].rfind("File `", 0) == 0) file = lines[k].substr(6, lines[k].find('`', 6) - 6);
    if (lines[k] == "```text") scene.write(file, fenced_block(lines, k));
    if (lines[k] == "```sh") command = words_of(fenced_block(lines, k));
    if (lines[k] != "```json") continue;
    const std::string expected = fenced_block(lines, k);
    ASSERT_GE(command.size(), 2U);
    ASSERT_EQ(command.front(), "moivre");
    if (!MOIVRE_WITH_MULTIPRECISION && contains(command, "--digits")) continue;
    shown.insert(command[1]);
    const Outcome outcome = scene.run({command.begin() + 1, command.end()});
    ASSERT_NE(outcome.out, "") << outcome.err;
    EXPECT_EQ(shape_of(outcome.out), shape_of(expected)) << "docs/json.md, line " << k + 1;
  }
  std::set<std::string> expected{"check",  "closures", "family", "guesses", "info",  "mobility",
                                 "motion", "newton",   "solve",  "study",   "sweep", "track"};
  EXPECT_EQ(shown, expected);
}

}  // namespace
}  // namespace moivre::test
