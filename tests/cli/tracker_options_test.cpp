// SPDX-License-Identifier: MIT
// Do --help, refusals, JSON and docs/trackers.md all say what the trackers' tables of options say?
#include <gtest/gtest.h>

#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>

#include "moivre/expression/joined.h"
#include "moivre/report/number_text.h"
#include "program.h"
#include "tracker_choice.h"

namespace moivre::test {
namespace {

using Json = nlohmann::json;

const std::string kTwoConics = "2\nx^2 + y^2 - 5;\nx*y - 2;\n";

std::string text_of(const OptionValue& value) {
  if (const auto* word = std::get_if<std::string>(&value)) return *word;
  if (const auto* number = std::get_if<double>(&value)) return exact_text(*number);
  return std::to_string(std::get<std::int64_t>(value));
}

std::string row_of(const TrackerOption& option) {
  const OptionFacts& facts = option.facts;
  const std::string takes = facts.words.empty() ? facts.range : joined(facts.words, ", ");
  return "| `" + facts.flag + "` | `" + facts.name + "` | " + joined(option.trackers, ", ") +
         " | " + text_of(facts.standard) + " | " + takes + " | " + facts.sentence + " |\n";
}

TEST(TrackerOptions, HaveTheirRowsInTheDocumentation) {
  std::ifstream file(std::string(MOIVRE_SOURCE_DIR) + "/docs/trackers.md");
  std::stringstream page;
  page << file.rdbuf();
  std::string table =
      "| flag | JSON | tracker | default | takes | what it is |\n|---|---|---|---|---|---|\n";
  for (const TrackerOption& option : tracker_options()) table += row_of(option);
  EXPECT_TRUE(contains(page.str(), table)) << "docs/trackers.md should have\n" << table;
}

TEST(TrackerOptions, AreExplainedByEachCommandThatTracks) {
  for (const std::vector<std::string>& command : {std::vector<std::string>{"solve"},
                                                  {"track"},
                                                  {"closures"},
                                                  {"motion"},
                                                  {"guesses"},
                                                  {"sweep"},
                                                  {"family", "learn"},
                                                  {"family", "solve"}}) {
    std::vector<std::string> words = command;
    words.emplace_back("--help");
    const std::string help = Scene().run(words).out;
    for (const TrackerOption& option : tracker_options()) {
      EXPECT_TRUE(contains(help, option.facts.flag + ' ')) << joined(command, " ");
      const std::string standard = text_of(option.facts.standard);  // CLI11 2.1: =0.01, 2.4: [0.01]
      EXPECT_TRUE(contains(help, "=" + standard) || contains(help, "[" + standard + "]"))
          << option.facts.flag;
      EXPECT_TRUE(contains(help, option.facts.sentence)) << option.facts.flag;
    }
  }
}

TEST(TrackerOptions, StandInTheResultAsTheyWereGiven) {
  const Scene scene;
  scene.write("conics.phc", kTwoConics);
  for (const std::string tracker : {"cvode", "lanes"}) {
    std::vector<std::string> words{"solve",  "conics.phc", "--tracker", tracker,
                                   "--json", "-",          "--quiet"};
    std::vector<std::pair<std::string, std::string>> chosen;
    for (const auto& [facts, trackers] : tracker_options()) {
      if (trackers.size() == 1 && trackers.front() != tracker) continue;
      // The last word, or half of the default.
      const std::string value = !facts.words.empty() ? facts.words.back()
                                : std::holds_alternative<double>(facts.standard)
                                    ? exact_text(std::get<double>(facts.standard) / 2)
                                    : std::to_string(std::get<std::int64_t>(facts.standard) / 2);
      words.insert(words.end(), {facts.flag, value});
      chosen.emplace_back(facts.name, value);
    }
    const Json told = Json::parse(scene.run(words).out).at("tracker");
    for (const auto& [name, value] : chosen) {
      const Json& shown = told.at(name);
      EXPECT_EQ(shown.is_string() ? shown.get<std::string>() : exact_text(shown.get<double>()),
                value)
          << name;
    }
  }
}

TEST(TrackerOptions, AreRefusedByTheirOwnRules) {
  const Scene scene;
  scene.write("conics.phc", kTwoConics);
  for (const auto& [facts, trackers] : tracker_options()) {
    const std::string wrong = facts.words.empty() ? "0" : "x";
    const Outcome outcome =
        scene.run({"solve", "conics.phc", "--tracker", trackers.front(), facts.flag, wrong});
    EXPECT_EQ(outcome.exit_code, 1) << facts.flag;
    const std::string rule =
        facts.words.empty() ? facts.name + ' ' + facts.range : refusal_of_word(facts, wrong);
    EXPECT_EQ(outcome.err, "moivre: " + rule + '\n');
  }
}

}  // namespace
}  // namespace moivre::test
