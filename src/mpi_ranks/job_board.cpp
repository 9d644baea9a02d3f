// SPDX-License-Identifier: MIT
// The board: a number for each job of the lists that are not done.
#include "job_board.h"

#include <algorithm>

namespace moivre {
namespace {

constexpr std::int32_t kFree = -1, kDone = -2;
// Of what is free each rank gets a half of its share, and no more than that many: others may ask
// later than the first.
constexpr std::uint64_t kPiecesOfAShare = 2, kMostOfAPiece = 512;

}  // namespace

JobBoard::List& JobBoard::list_of(const ListKey& key, std::uint64_t jobs) {
  const auto [place, is_new] = lists_.try_emplace(key);
  List& list = place->second;
  if (is_new) {
    list.holder.assign(jobs, kFree);
    list.free = list.left = jobs;
  }
  return list;
}

JobPiece JobBoard::take(const ListKey& key, std::uint64_t jobs, int rank) {
  List& list = list_of(key, jobs);
  JobPiece piece;
  if (list.free == 0) return piece;
  const auto ranks = static_cast<std::uint64_t>(ranks_);
  const std::uint64_t most =
      std::clamp<std::uint64_t>(list.free / (kPiecesOfAShare * ranks), 1, kMostOfAPiece);
  while (list.holder[list.first_free] != kFree) ++list.first_free;
  piece.first = list.first_free;
  while (piece.count < most && list.first_free < list.holder.size() &&
         list.holder[list.first_free] == kFree) {
    list.holder[list.first_free++] = rank;
    ++piece.count;
  }
  list.free -= piece.count;
  return piece;
}

void JobBoard::set_done(const ListKey& key, std::uint64_t jobs, std::uint64_t job) {
  List& list = list_of(key, jobs);
  if (list.left == 0 || list.holder.at(job) == kDone) return;
  if (list.holder[job] == kFree) --list.free;
  list.holder[job] = kDone;
  if (--list.left == 0) std::vector<std::int32_t>().swap(list.holder);
}

std::vector<ListKey> JobBoard::give_back(int rank) {
  std::vector<ListKey> lists;
  for (auto& [key, list] : lists_) {
    const std::uint64_t before = list.free;
    for (std::uint64_t job = 0; job < list.holder.size(); ++job) {
      if (list.holder[job] != rank) continue;
      list.holder[job] = kFree;
      list.first_free = std::min(list.first_free, job);
      ++list.free;
    }
    if (list.free > before) lists.push_back(key);
  }
  return lists;
}

}  // namespace moivre
