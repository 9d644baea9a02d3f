// SPDX-License-Identifier: MIT
// Who does which jobs of which list? Rank 0 keeps this board.
//
// A list is opened by the first who asks for a piece of it, and lasts as a line of some bytes when
// it is done. Pieces are a share of what is left, so that the last ranks end together.
#pragma once

#include <cstdint>
#include <map>
#include <vector>

#include "moivre/numeric/fingerprint.h"

namespace moivre {

/// A list, the n-th time that it comes up: two solves may ask for the same.
struct ListKey {
  Fingerprint list;
  std::uint64_t time = 0;
  auto operator<=>(const ListKey&) const = default;
};

/// Jobs [first, first + count).
struct JobPiece {
  std::uint64_t first = 0;
  std::uint64_t count = 0;
};

class JobBoard {
 public:
  explicit JobBoard(int ranks) : ranks_(ranks) {}

  /// Of a list of so many jobs; count 0: all are done or in hand.
  JobPiece take(const ListKey& key, std::uint64_t jobs, int rank);
  void set_done(const ListKey& key, std::uint64_t jobs, std::uint64_t job);
  /// What the rank has in hand is free again. The lists of which that is so.
  std::vector<ListKey> give_back(int rank);

 private:
  struct List {
    std::vector<std::int32_t> holder;  ///< of each job; empty when all are done
    std::uint64_t first_free = 0;      ///< before it none is free
    std::uint64_t free = 0;
    std::uint64_t left = 0;
  };
  List& list_of(const ListKey& key, std::uint64_t jobs);

  int ranks_;
  std::map<ListKey, List> lists_;
};

}  // namespace moivre
