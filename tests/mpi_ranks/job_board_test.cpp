// SPDX-License-Identifier: MIT
// Is every job in one hand, until it is done or given back?
#include "job_board.h"

#include <gtest/gtest.h>

namespace moivre::test {
namespace {

constexpr std::uint64_t kJobs = 1000;
const ListKey kList{{1, 2}, 0};

TEST(JobBoard, HandsOutEachJobOnceAndSmallerPiecesTowardsTheEnd) {
  JobBoard board(4);
  std::vector<int> handed(kJobs, 0);
  std::uint64_t last = kJobs;
  while (true) {
    const JobPiece piece = board.take(kList, kJobs, 1);
    if (piece.count == 0) break;
    EXPECT_LE(piece.count, last);
    last = piece.count;
    for (std::uint64_t k = 0; k < piece.count; ++k) ++handed.at(piece.first + k);
  }
  EXPECT_EQ(handed, std::vector<int>(kJobs, 1));
  EXPECT_EQ(last, 1U);
}

TEST(JobBoard, HandsOutNothingThatIsDone) {
  JobBoard board(2);
  for (std::uint64_t job = 0; job < kJobs; job += 2) board.set_done(kList, kJobs, job);
  std::uint64_t handed = 0;
  for (JobPiece piece; (piece = board.take(kList, kJobs, 0)).count > 0; handed += piece.count) {
    EXPECT_EQ(piece.count, 1U);
    EXPECT_EQ(piece.first % 2, 1U);
  }
  EXPECT_EQ(handed, kJobs / 2);
}

TEST(JobBoard, WhatARankLeavesIsHandedOutAgain) {
  JobBoard board(2);
  const JobPiece first = board.take(kList, kJobs, 1);
  board.set_done(kList, kJobs, first.first);
  while (board.take(kList, kJobs, 0).count > 0) continue;
  EXPECT_EQ(board.give_back(1), std::vector<ListKey>{kList});
  std::uint64_t again = 0;
  for (JobPiece piece; (piece = board.take(kList, kJobs, 0)).count > 0;) again += piece.count;
  EXPECT_EQ(again, first.count - 1);
  EXPECT_TRUE(board.give_back(1).empty());
}

TEST(JobBoard, AListThatComesUpAgainIsAnother) {
  JobBoard board(1);
  for (std::uint64_t job = 0; job < kJobs; ++job) board.set_done(kList, kJobs, job);
  EXPECT_EQ(board.take(kList, kJobs, 0).count, 0U);
  EXPECT_GT(board.take({kList.list, 1}, kJobs, 0).count, 0U);
}

}  // namespace
}  // namespace moivre::test
