// SPDX-License-Identifier: MIT
// What do PHCpack's lists prove? Roots certified, doubled, made up; whether a bound is met.
#include <gtest/gtest.h>

#include <regex>
#include <stdexcept>

#include "results.h"

namespace moivre::test {
namespace {

std::string replaced(std::string text, const std::string& what, const std::string& with) {
  const std::size_t begin = text.rfind(what);
  if (begin == std::string::npos) throw std::logic_error("not in the list: " + what);
  return text.replace(begin, what.size(), with);
}

std::string list() { return result_text("eco-6.out"); }

/// The text of the last list's solution of that number, from its head to its figures.
std::string solution(const std::string& text, int number) {
  const std::size_t begin = text.rfind("solution " + std::to_string(number) + " :");
  const std::size_t end = text.find('\n', text.find("== err", begin));
  return text.substr(begin, end + 1 - begin);
}

TEST(SolutionList, OfPhcpackIsProvedToHoldAllRoots) {
  const Judgement judgement = judged("eco-6", list());
  EXPECT_EQ(judgement.form, ClaimForm::solution_list);
  EXPECT_TRUE(judgement.holds()) << lines(judgement.refuted);
  EXPECT_EQ(judgement.roots.listed, 16U);
  EXPECT_EQ(judgement.roots.certified, 16U);
  EXPECT_EQ(judgement.roots.distinct, 16U);
  EXPECT_EQ(judgement.proved_by, BoundKind::stable_mixed_volume);
}

TEST(SolutionList, WithARootTwiceIsFoundOut) {
  const std::string text = list();
  const std::string first = solution(text, 1);
  const std::string twice = replaced(
      text, solution(text, 7), std::regex_replace(first, std::regex("^solution 1"), "solution 7"));
  const Judgement judgement = judged("eco-6", twice);
  EXPECT_TRUE(refutes(judgement, ClaimKind::distinct, 7)) << lines(judgement.refuted);
  EXPECT_EQ(judgement.roots.doubled, 1U);
  EXPECT_FALSE(judgement.proved_by);
}

TEST(SolutionList, WithAPointThatIsNoRootIsFoundOut) {
  const std::string text = list();
  const std::string entry = solution(text, 3);
  const std::string moved = std::regex_replace(entry, std::regex(R"((x2 : *-?[0-9])\.)"), "$1.5",
                                               std::regex_constants::format_first_only);
  ASSERT_NE(moved, entry);
  const Judgement judgement = judged("eco-6", replaced(text, entry, moved));
  EXPECT_TRUE(refutes(judgement, ClaimKind::root, 3)) << lines(judgement.refuted);
  EXPECT_EQ(judgement.roots.not_roots, 1U);
}

TEST(SolutionList, ThatIsCutOffIsFoundOut) {
  const std::string text = list();
  const Judgement judgement = judged("eco-6", text.substr(0, text.rfind("solution 16 :")));
  EXPECT_TRUE(refutes(judgement, ClaimKind::complete)) << lines(judgement.refuted);
}

TEST(SolutionList, IsJudgedByItsMissingConjugates) {
  const std::string head =
      "THE SOLUTIONS :\n1 3\n===\nsolution 1 :\nt : 1.0 0.0\nm : 1\nthe solution for t :\n";
  const Judgement judgement =
      judged("plane", head +
                          " x : 0.0 2.23606797749979\n y : 0.0 -2.23606797749979\n z : 4.0 0.0\n"
                          "== err : 1E-16 = rco : 0.1 = res : 1E-16 ==\n");
  EXPECT_TRUE(refutes(judgement, ClaimKind::complete, 1)) << lines(judgement.refuted);
  EXPECT_EQ(judgement.roots.certified, 1U);
}

TEST(SolutionList, IsRefusedWhereANumberIsNone) {
  const std::string head = "THE SOLUTIONS :\n1 3\n===\nsolution 1 :\nm : 1\nthe solution for t :\n";
  const auto first_line = [&](const std::string& coordinates) {
    try {
      judged("plane", head + coordinates);
    } catch (const std::invalid_argument& error) {
      const std::string text = error.what();
      return text.substr(0, text.find('\n'));
    }
    return std::string();
  };
  EXPECT_EQ(first_line(" x : NaN 0.0\n y : 0 0\n z : 0 0\n"),
            "result:7:1: error: expected a finite real and imaginary part");
  EXPECT_EQ(first_line(" x : 1.0 1E+999\n y : 0 0\n z : 0 0\n"),
            "result:7:1: error: expected a finite real and imaginary part");
  EXPECT_EQ(first_line(" x : 1.0 0.0\n"), "result:4:1: error: the solution does not say y");
  EXPECT_EQ(first_line(" w : 1.0 0.0\n"), "result:7:1: error: w is not a variable of the system");
}

}  // namespace
}  // namespace moivre::test
