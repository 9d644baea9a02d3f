// SPDX-License-Identifier: MIT
// Is a report the same whether it is written piece by piece or as one tree, and is so little of it
// held?
#include "moivre/report/json_writer.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <stdexcept>

namespace moivre::test {
namespace {

std::string written(const std::function<void(JsonWriter&)>& write) {
  std::string text;
  write_json([&text](std::string_view piece) { text += piece; }, write);
  return text;
}

const std::vector<int> kNumbers{1, 2, 3};

Json square(int n) { return {{"n", n}, {"square", std::int64_t{n} * n}}; }

TEST(JsonWriter, ListsStandAsTheyDoInATree) {
  const Json tree = {{"title", "a \"b\""},
                     {"none", Json::array()},
                     {"squares", list_json(kNumbers, square)},
                     {"end", true}};
  EXPECT_EQ(written([](JsonWriter& report) {
              report.members({{"title", "a \"b\""}});
              report.list("none", std::vector<int>(), square);
              report.list("squares", kNumbers, square);
              report.member("end", true);
            }),
            to_text(tree));
}

TEST(JsonWriter, ListsInListsStandAsTheyDoInATree) {
  const Json branch = {
      {"id", "A"}, {"samples", list_json(kNumbers, square)}, {"empty", Json::array()}};
  const Json tree = {{"branches", Json::array({branch, branch})}};
  EXPECT_EQ(written([](JsonWriter& report) {
              report.long_list("branches", std::vector<int>(2), [&](int) {
                report.member("id", "A");
                report.list("samples", kNumbers, square);
                report.list("empty", std::vector<int>(), square);
              });
            }),
            to_text(tree));
}

TEST(JsonWriter, LinesAreThoseOfTheReportAndOfItsLists) {
  EXPECT_EQ(written([](JsonWriter& report) {
              report.member("seed", 1);
              report.list("squares", std::vector<int>{1, 2}, square);
            }),
            "{\n  \"seed\": 1,\n  \"squares\": [\n    {\"n\":1,\"square\":1},\n    "
            "{\"n\":2,\"square\":4}\n  ]\n}\n");
}

TEST(JsonWriter, NoMoreIsHeldThanAPiece) {
  constexpr std::size_t kElements = 100000;
  constexpr std::size_t kMostHeld = 100000;  // bytes; the report has some megabytes
  std::vector<int> numbers(kElements);
  std::iota(numbers.begin(), numbers.end(), 0);
  std::size_t largest = 0;
  std::size_t made = 0;
  std::size_t made_at_first_piece = 0;
  write_json(
      [&](std::string_view piece) {
        largest = std::max(largest, piece.size());
        if (made_at_first_piece == 0) made_at_first_piece = made;
      },
      [&](JsonWriter& report) {
        report.long_list("branches", std::vector<int>(1), [&](int) {
          report.list("samples", numbers, [&](int n) {
            ++made;
            return square(n);
          });
        });
      });
  EXPECT_LT(largest, kMostHeld);
  EXPECT_LT(made_at_first_piece, kElements / 10);
}

TEST(JsonWriter, AFullDiskEndsTheWriting) {
  const auto full = [](std::string_view) { throw std::invalid_argument("disk full"); };
  EXPECT_THROW(write_json(full, [](JsonWriter& report) { report.member("seed", 1); }),
               std::invalid_argument);
}

TEST(Refill, PutsNumbersWhereNumbersWere) {
  Json tree = {{"crank", {{"x", nullptr}, {"q", {1, 2}}}}, {"phi", 3}};
  refill(tree, std::vector<double>{0.5, 1.5, 2.5, 3.5});
  EXPECT_EQ(tree.dump(), R"({"crank":{"x":0.5,"q":[1.5,2.5]},"phi":3.5})");
}

TEST(SolutionJson, TellsOneAfterAnotherAsIfEachWereTheFirst) {
  Solution first;
  first.x = {{1, 2}, {3, 4}};
  Solution second;
  second.path = 7;
  second.x = {{5, 6}, {7, 8}};
  Solution longer;
  longer.x = {{1, 0}, {2, 0}, {3, 0}};
  const Solution without_unknowns;
  SolutionJson json;
  for (const Solution& solution : {without_unknowns, first, second, longer, without_unknowns}) {
    EXPECT_EQ(json.read(solution), to_json(solution));
  }
}

}  // namespace
}  // namespace moivre::test
