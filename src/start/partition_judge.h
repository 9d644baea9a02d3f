// SPDX-License-Identifier: MIT
// Which of many partitions of one system has the least number? Degrees by group are kept, work is
// counted. Private to the module.
#pragma once

#include <cstdint>
#include <map>
#include <vector>

#include "moivre/start/multihomogeneous.h"

namespace moivre {

class PartitionJudge {
 public:
  /// A table of few entries takes as long as this many products; making and comparing a partition
  /// takes no less for each unknown, of more than twenty of them.
  static constexpr std::uint64_t kOverhead = 500;
  static constexpr std::uint64_t kOverheadOfUnknown = 25;

  explicit PartitionJudge(const System& f);

  std::size_t unknowns() const { return unknowns_; }

  /// The number of a partition (ordered as multihomogeneous.h says) in double: exact below 2^53,
  /// and telling more beyond 64 bits than an integer would. Infinity where the table would be too
  /// large.
  double number(const Partition& groups);
  /// The same where no partition comes twice: nothing is kept but the best.
  void try_once(const Partition& groups);

  /// Degree of every equation in these unknowns.
  const std::vector<std::uint64_t>& column(const std::vector<std::uint32_t>& group);

  /// Of all asked for: least number, then fewest groups, then the first.
  const Partition& best() const { return best_; }
  std::uint64_t tried() const { return tried_; }
  /// Products and sums until now, and what else a number costs in their unit.
  std::uint64_t work() const { return work_; }

 private:
  double fresh_number(const Partition& groups);
  void keep_best(const Partition& groups, double number);

  std::size_t unknowns_;
  std::vector<std::vector<Monomial>>
      supports_;  // of every equation, without monomials that divide another
  std::map<std::vector<std::uint32_t>, std::vector<std::uint64_t>> columns_;
  std::map<Partition, double> numbers_;
  Partition best_;
  double least_ = 0;
  std::uint64_t tried_ = 0;
  std::uint64_t work_ = 0;
};

}  // namespace moivre
