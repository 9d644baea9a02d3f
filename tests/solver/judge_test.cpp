// SPDX-License-Identifier: MIT
// judge(): what ends of paths come to, and what is open. Laws that hold whatever was seen.
#include "judge.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <fstream>
#include <functional>
#include <map>
#include <numeric>
#include <string>

#include "certificates.h"
#include "group_lists.h"
#include "moivre/tracker_cvode/cvode_tracker.h"
#include "problem_set.h"
#include "settle.h"

namespace moivre {
namespace {

using test::read;
using test::with_seed;

using Groups = test::GroupLists;

/// Ends that were seen of paths of (x - 1)^2 (x - 2) (x - 3) = 0, given by hand.
class JudgedPaths : public testing::Test {
 protected:
  void simple(std::uint64_t path, Complex x) {
    Refiner refiner(setting.refiner_program);
    Root root;
    root.certificate = Prover(setting.certify_program).prove({x});
    ASSERT_NE(root.certificate, nullptr);
    root.point = refiner.take(*root.certificate);
    root.tolerance = 1e-13;
    run.table.enter_root(path, std::move(root));
  }
  void cycle(std::uint64_t path, Complex x, int winding) {
    Root root;
    root.point.x = {x};
    root.point.accuracy = 1e-9;
    root.winding = winding;
    root.tolerance = 1e-7;
    root.on_set = SetHere::none;
    run.table.enter_root(path, std::move(root));
  }
  void on_curve(std::uint64_t path, Complex x) {
    cycle(path, x, 2);
    run.table.tell_curve(path);
  }
  void lost(std::uint64_t path) { run.table.enter_failure({path, Failure::step_limit, 0.5}); }
  /// By the first path of each root.
  std::map<std::uint64_t, Ground> grounds() {
    std::map<std::uint64_t, Ground> grounds;
    for (const JudgedRoot& root : judge(run).roots) {
      grounds.emplace(root.paths.front(), root.ground);
    }
    return grounds;
  }
  Groups roots() {
    Groups groups = test::lists_of(judge(run).roots);
    std::sort(groups.begin(), groups.end());
    return groups;
  }

  System f = read("1\n (x - 1)^2*(x - 2)*(x - 3);\n");
  SolveOptions options = with_seed(1);
  std::atomic<bool> stop{false};
  std::unique_ptr<Tracker> tracker = make_cvode_tracker();
  Setting setting{f, *tracker, options, stop};
  moivre::Run run{setting};
};

TEST_F(JudgedPaths, StandAtASimpleRootAloneAndAtASingularOneInWholeCycles) {
  simple(0, 2);
  simple(1, 3);
  cycle(2, 1, 2);
  cycle(3, 1, 2);
  const JudgedEnds judged = judge(run);
  EXPECT_EQ(roots(), (Groups{{0}, {1}, {2, 3}}));
  EXPECT_TRUE(judged.open.empty());
  EXPECT_TRUE(judged.in_doubt.empty());
}

TEST_F(JudgedPaths, HaveOneGroundEach) {
  using enum Ground;
  simple(0, 2);
  cycle(1, 1, 2);
  cycle(2, 1, 2);
  on_curve(3, 5);
  for (const std::uint64_t path : {4U, 5U}) {
    cycle(path, 3, 2);
    Root exact = run.table.roots().at(path);
    exact.is_exact = true;
    run.table.enter_root(path, std::move(exact));
  }
  EXPECT_EQ(grounds(), (std::map<std::uint64_t, Ground>{
                           {0, proved}, {1, whole_cycles}, {3, on_set}, {4, exact}}));
  for (const PathGroups::Group group : groups_of(run)) {
    EXPECT_EQ(known_ground(run, group), grounds().at(group.front()));
  }
}

TEST_F(JudgedPaths, HaveNoGroundThatWasNotAskedFor) {
  cycle(0, 1, 2);
  cycle(1, 1, 2);
  for (const std::uint64_t path : {0U, 1U}) {
    Root unasked = run.table.roots().at(path);
    unasked.on_set.reset();
    run.table.enter_root(path, std::move(unasked));
  }
  const std::uint64_t both[]{0, 1};
  EXPECT_EQ(known_ground(run, both), std::nullopt);
  EXPECT_EQ(grounds().at(0), Ground::whole_cycles);  // judging asks
  EXPECT_EQ(known_ground(run, both), Ground::whole_cycles);
}

// A root of multiplicity two that is known exactly, to which only one path leads.
TEST_F(JudgedPaths, HaveNoGroundAtAnExactRootThatLacksPaths) {
  cycle(0, 1, 1);
  Root exact = run.table.roots().at(0);
  exact.is_exact = true;
  run.table.enter_root(0, std::move(exact));
  const std::uint64_t path[]{0};
  EXPECT_EQ(known_ground(run, path), std::nullopt);
  EXPECT_EQ(judge(run).open.at(0), Question::no_root);
}

TEST_F(JudgedPaths, StandOnASetOneByOne) {
  on_curve(0, 1);
  on_curve(1, 4);
  on_curve(2, 4);
  on_curve(3, 4);
  EXPECT_EQ(roots(), (Groups{{0}, {1, 2, 3}}));
  EXPECT_TRUE(judge(run).open.empty());
  // What came back to a shared sheet is open, and the others of its place are not.
  run.sheets.set(3, 0.25);
  run.sheets.set(5, 0.25);
  run.table.enter_infinity(5);
  EXPECT_EQ(roots(), (Groups{{0}, {1, 2}}));
  EXPECT_EQ(judge(run).open,
            (std::map<std::uint64_t, Question>{{3, Question::jumped}, {5, Question::jumped}}));
}

TEST_F(JudgedPaths, HaveNoRootWhereACycleIsNotWhole) {
  cycle(0, 1, 2);
  cycle(1, 1, 2);
  cycle(2, 1, 2);
  const JudgedEnds judged = judge(run);
  EXPECT_TRUE(judged.roots.empty());
  for (const std::uint64_t path : {0U, 1U, 2U}) {
    EXPECT_EQ(judged.open.at(path), Question::no_root);
    EXPECT_EQ(told_as_failed(run, path, Question::no_root).failure, Failure::precision);
  }
}

TEST_F(JudgedPaths, HaveJumpedWhereAnotherEndsAtTheSameSimpleRoot) {
  simple(0, 2);
  simple(1, 2);
  const JudgedEnds judged = judge(run);
  EXPECT_EQ(test::lists_of(judged.roots), (Groups{{0}}));
  EXPECT_EQ(judged.open.at(1), Question::jumped);
  EXPECT_EQ(judged.in_doubt, (PathSet{0, 1}));  // which of them, nothing tells
}

TEST_F(JudgedPaths, HaveJumpedWhereTheyCameBackToOneSheet) {
  simple(0, 2);
  cycle(1, 1, 2);
  cycle(2, 1, 2);
  run.sheets.set(2, 0.25);
  run.sheets.set(3, 0.25);
  run.table.enter_infinity(3);
  const JudgedEnds judged = judge(run);
  EXPECT_EQ(test::lists_of(judged.roots), (Groups{{0}}));
  EXPECT_EQ(judged.open.at(1), Question::no_root);  // its cycle has lost a sheet
  EXPECT_EQ(judged.open.at(2), Question::jumped);
  EXPECT_EQ(judged.open.at(3), Question::jumped);
  EXPECT_EQ(judge_ends_alone(run).roots.size(), 2U);
}

TEST_F(JudgedPaths, ThatAreRefutedAreOpenUntilAnotherEndIsSeen) {
  cycle(0, 1, 2);
  cycle(1, 1, 2);
  run.table.refute(0);
  run.table.refute(1);
  EXPECT_TRUE(judge(run).roots.empty());
  EXPECT_EQ(judge(run).open.at(0), Question::no_root);
  EXPECT_EQ(run.table.roots().size(), 2U);  // what was seen stays on record
  cycle(0, 1, 2);
  cycle(1, 1, 2);
  EXPECT_TRUE(judge(run).open.empty());
}

TEST_F(JudgedPaths, WithoutAnEndAreToldAsTheyWereLost) {
  lost(4);
  const JudgedEnds judged = judge(run);
  ASSERT_EQ(judged.open.at(4), Question::no_end);
  EXPECT_EQ(told_as_failed(run, 4, Question::no_end).failure, Failure::step_limit);
  EXPECT_TRUE(open_to_more_digits(run).empty());
}

TEST_F(JudgedPaths, ComeToTheSameInAnyOrder) {
  std::vector<std::uint64_t> order(6);
  std::iota(order.begin(), order.end(), 0U);
  do {
    run.table = {};
    for (const std::uint64_t path : order) {
      if (path == 0) simple(0, 2);
      if (path == 1) simple(1, 3);
      if (path == 2) simple(2, 3);
      if (path == 3 || path == 4) cycle(path, 1, 2);
      if (path == 5) lost(5);
    }
    EXPECT_EQ(roots(), (Groups{{0}, {1}, {3, 4}}));
    EXPECT_EQ(judge(run).open,
              (std::map<std::uint64_t, Question>{{2, Question::jumped}, {5, Question::no_end}}));
  } while (std::next_permutation(order.begin(), order.end()));
}

TEST_F(JudgedPaths, DoNotLoseAProvedRootByEndsThatAgree) {
  simple(0, 2);
  EXPECT_EQ(roots(), (Groups{{0}}));
  simple(1, 2);
  EXPECT_EQ(roots(), (Groups{{0}}));
  cycle(2, 2, 2);
  EXPECT_EQ(roots(), (Groups{{0}}));
  cycle(3, 2, 2);
  EXPECT_EQ(roots(), (Groups{{0}}));
}

// What was seen of the other paths is enough for no end that has lost what it rests on.
TEST_F(JudgedPaths, AreNotDecidedByTakingAGroundAway) {
  const auto decided = [&] {
    simple(0, 2);
    simple(1, 3);
    cycle(2, 1, 2);
    cycle(3, 1, 2);
  };
  const auto with_a_jump = [&] {
    simple(0, 2);
    simple(1, 2);
    cycle(2, 1, 2);
    cycle(3, 1, 2);
  };
  const auto with_half_a_cycle = [&] {
    simple(0, 2);
    simple(1, 3);
    cycle(2, 1, 2);
    lost(3);
  };
  for (const std::function<void()>& seen :
       {std::function<void()>(decided), {with_a_jump}, {with_half_a_cycle}}) {
    run.table = {};
    seen();
    for (const auto& [path, root] : std::map(run.table.roots())) {
      Root groundless = root;
      groundless.certificate.reset();
      groundless.point.simple = false;
      groundless.winding.reset();
      groundless.on_set = SetHere::none;
      run.table.enter_root(path, std::move(groundless));
      EXPECT_FALSE(judge(run).open.empty()) << path;
      run.table.enter_root(path, Root(root));
    }
  }
}

TEST_F(JudgedPaths, AreJudgedTheSameFromWhatIsToldOfThem) {
  simple(0, 2);
  simple(1, 2);
  cycle(2, 1, 2);
  cycle(3, 1, 2);
  cycle(4, 3, 2);
  lost(5);
  const JudgedEnds once = judge(run);
  moivre::Run told(setting);
  for (const JudgedRoot& root : once.roots) {
    for (const std::uint64_t path : root.paths) {
      told.table.enter_root(path, Root(run.table.roots().at(path)));
    }
  }
  for (const auto& [path, question] : once.open) {
    told.table.enter_failure(told_as_failed(run, path, question));
  }
  const JudgedEnds twice = judge(told);
  EXPECT_EQ(test::lists_of(once.roots), test::lists_of(twice.roots));
  EXPECT_EQ(once.open.size(), 3U);
  EXPECT_EQ(once.open.size(), twice.open.size());
  for (const auto& [path, question] : once.open) EXPECT_TRUE(twice.open.contains(path)) << path;
}

// Four roots with their multiplicities are all that a quartic has: what came back to a shared sheet
// does not matter any more.
TEST_F(JudgedPaths, HaveNoOpenSheetsWhereACountSettlesTheRun) {
  simple(0, 2);
  simple(1, 3);
  cycle(2, 1, 2);
  cycle(3, 1, 2);
  run.sheets.set(0, 0.25);
  run.sheets.set(1, 0.25);
  EXPECT_EQ(judge(run).open.size(), 2U);
  ASSERT_TRUE(is_settled(run));
  EXPECT_TRUE(judge(run).open.empty());
}

/// The words of a file between `begin` at the start of a line and the next `end`; lines without are
/// left out.
std::vector<std::string> words_between(const std::string& begin, const std::string& end,
                                       const std::string& file) {
  std::vector<std::string> words;
  std::ifstream lines(std::string(MOIVRE_SOURCE_DIR) + file);
  for (std::string line; std::getline(lines, line);) {
    const std::size_t at = line.find(end, begin.size());
    if (line.rfind(begin, 0) != 0 || at == std::string::npos) continue;
    words.push_back(line.substr(begin.size(), at - begin.size()));
  }
  return words;
}

TEST(Remedies, StandInTheDocumentInTheirOrder) {
  const auto in_code = words_between("    ", ",", "/src/solver/settle.cpp");
  const auto in_document = words_between("| `", "`", "/docs/algorithms/end-of-path.md");
  ASSERT_EQ(in_code.size(), 13U);
  ASSERT_GE(in_document.size(), in_code.size());
  EXPECT_TRUE(std::equal(in_code.begin(), in_code.end(), in_document.begin()));
}

}  // namespace
}  // namespace moivre
