// SPDX-License-Identifier: MIT
// The partition of the least number: all of them tried, or good ones improved until nothing helps.
#include <algorithm>
#include <array>
#include <limits>
#include <numeric>
#include <set>
#include <utility>

#include "moivre/numeric/invalid_input.h"
#include "moivre/start/multihomogeneous.h"
#include "partition_judge.h"

namespace moivre {
namespace {

/// Beginnings with a group for every unknown cost 2^n table entries; beyond this they are left out.
constexpr std::size_t kSingletonUnknowns = 16;

/// Bell's numbers: the partitions of 0, 1, 2, ... unknowns.
constexpr std::array<std::uint64_t, kExhaustiveUnknowns + 1> kPartitions = {1,  1,   2,   5,   15,
                                                                            52, 203, 877, 4140};

/// Every partition of n unknowns, one after another, as restricted growth strings: unknown v goes
/// to group g(v), and g(v) <= 1 + max of those before.
void try_all(PartitionJudge& judge, std::size_t n) {
  std::vector<std::uint32_t> g(n, 0);
  for (;;) {
    Partition groups(1 + *std::max_element(g.begin(), g.end()));
    for (std::uint32_t v = 0; v < n; ++v) groups[g[v]].push_back(v);
    judge.try_once(groups);
    std::size_t v = n;
    while (--v > 0) {
      if (g[v] <= *std::max_element(g.begin(), g.begin() + static_cast<std::ptrdiff_t>(v))) break;
    }
    if (v == 0) return;
    ++g[v];
    std::fill(g.begin() + static_cast<std::ptrdiff_t>(v) + 1, g.end(), 0U);
  }
}

Partition ordered(Partition groups) {
  groups.erase(
      std::remove_if(groups.begin(), groups.end(), [](const auto& g) { return g.empty(); }),
      groups.end());
  for (auto& group : groups) std::sort(group.begin(), group.end());
  std::sort(groups.begin(), groups.end());
  return groups;
}

/// `groups` with unknown v in group `to`; to = number of groups: in one of its own.
Partition moved(Partition groups, std::uint32_t v, std::size_t to) {
  for (auto& group : groups) group.erase(std::remove(group.begin(), group.end(), v), group.end());
  if (to == groups.size()) groups.emplace_back();
  groups[to].push_back(v);
  return ordered(std::move(groups));
}

Partition exchanged(Partition groups, std::uint32_t v, std::uint32_t w) {
  for (auto& group : groups) {
    for (std::uint32_t& u : group) {
      if (u == v || u == w) u = u == v ? w : v;
    }
  }
  return ordered(std::move(groups));
}

Partition joined(Partition groups, std::size_t a, std::size_t b) {
  groups[a].insert(groups[a].end(), groups[b].begin(), groups[b].end());
  groups[b].clear();
  return ordered(std::move(groups));
}

/// One local search: `groups` as long as a move of one unknown, the union of two groups or an
/// exchange of two unknowns makes the number less.
class Descent {
 public:
  Descent(PartitionJudge& judge, Partition groups, std::uint64_t until)
      : judge_(judge), groups_(std::move(groups)), until_(until), number_(judge.number(groups_)) {}

  void run() {
    bool helps = true;
    while (helps && may_go_on()) {
      helps = move_unknowns();
      helps = join_groups() || helps;
      if (!helps) helps = exchange_unknowns();
    }
  }

 private:
  bool may_go_on() const { return judge_.work() < until_; }

  bool take(const Partition& groups) {
    const double number = judge_.number(groups);
    const bool is_less = number < number_ || (number == number_ && groups.size() < groups_.size());
    if (!is_less) return false;
    number_ = number;
    groups_ = groups;
    return true;
  }

  bool move_unknowns() {
    bool helps = false;
    for (std::uint32_t v = 0; v < judge_.unknowns(); ++v) {
      const Partition from = groups_;
      for (std::size_t to = 0; to <= from.size() && may_go_on(); ++to) {
        helps = take(moved(from, v, to)) || helps;
      }
    }
    return helps;
  }

  bool join_groups() {
    bool helps = false;
    for (std::size_t a = 0; a < groups_.size(); ++a) {
      for (std::size_t b = a + 1; b < groups_.size() && may_go_on(); ++b) {
        helps = take(joined(groups_, a, b)) || helps;
      }
    }
    return helps;
  }

  bool exchange_unknowns() {
    bool helps = false;
    for (std::uint32_t v = 0; v < judge_.unknowns(); ++v) {
      for (std::uint32_t w = v + 1; w < judge_.unknowns() && may_go_on(); ++w) {
        helps = take(exchanged(groups_, v, w)) || helps;
      }
    }
    return helps;
  }

  PartitionJudge& judge_;
  Partition groups_;
  std::uint64_t until_;
  double number_;
};

/// Unknowns of one key together.
template <class Key>
Partition grouped_by(const std::vector<Key>& keys) {
  std::vector<Key> found;
  Partition groups;
  for (std::uint32_t v = 0; v < keys.size(); ++v) {
    const auto at =
        static_cast<std::size_t>(std::find(found.begin(), found.end(), keys[v]) - found.begin());
    if (at == found.size()) {
      found.push_back(keys[v]);
      groups.emplace_back();
    }
    groups[at].push_back(v);
  }
  return groups;
}

/// meets[v][w]: some term holds both, v != w.
std::vector<std::vector<bool>> meetings(const System& f) {
  const std::size_t n = f.variables.size();
  std::vector<std::vector<bool>> meets(n, std::vector<bool>(n, false));
  for (const Polynomial& p : f.polynomials) {
    for (const Term& term : p.terms) {
      for (const Power& a : term.monomial) {
        for (const Power& b : term.monomial)
          meets[a.variable][b.variable] = a.variable != b.variable;
      }
    }
  }
  return meets;
}

/// Unknowns that never multiply each other, as far as taking them one by one brings them together.
Partition never_multiplied(const std::vector<std::vector<bool>>& meets) {
  Partition groups;
  for (std::uint32_t v = 0; v < meets.size(); ++v) {
    const auto fits = [&](const std::vector<std::uint32_t>& group) {
      return std::none_of(group.begin(), group.end(), [&](std::uint32_t w) { return meets[v][w]; });
    };
    const auto place = std::find_if(groups.begin(), groups.end(), fits);
    if (place == groups.end()) {
      groups.push_back({v});
    } else {
      place->push_back(v);
    }
  }
  return groups;
}

/// Unknowns that multiply each other, directly or through others.
Partition multiplied(const std::vector<std::vector<bool>>& meets) {
  std::vector<std::uint32_t> root(meets.size());
  std::iota(root.begin(), root.end(), 0U);
  for (std::size_t v = 0; v < meets.size(); ++v) {
    for (std::size_t w = 0; w < v; ++w) {
      if (meets[v][w]) std::replace(root.begin(), root.end(), root[v], root[w]);
    }
  }
  return grouped_by(root);
}

std::vector<Partition> beginnings(const System& f, PartitionJudge& judge) {
  const std::size_t n = f.variables.size();
  const auto meets = meetings(f);
  std::vector<std::vector<std::uint64_t>> columns;
  std::vector<std::vector<bool>> occurs;
  for (std::uint32_t v = 0; v < n; ++v) {
    columns.push_back(judge.column({v}));
    std::vector<bool> is_there;
    for (const std::uint64_t d : columns.back()) is_there.push_back(d > 0);
    occurs.push_back(std::move(is_there));
  }
  std::vector<Partition> found{one_group(n), never_multiplied(meets), multiplied(meets),
                               grouped_by(columns), grouped_by(occurs)};
  if (const auto declared = declared_partition(f)) found.push_back(*declared);
  if (n <= kSingletonUnknowns) {
    std::vector<std::uint32_t> own(n);
    std::iota(own.begin(), own.end(), 0U);
    found.push_back(grouped_by(own));
  }
  return found;
}

std::uint64_t allowed_work(const System& f) {
  const auto paths = total_degree(degrees(f));
  if (!paths || *paths > kMostSearchWork / kSearchWorkPerPath) return kMostSearchWork;
  return std::max(kLeastSearchWork, *paths * kSearchWorkPerPath);
}

/// Each beginning may use an equal share of the work that is left, so that none starves those
/// behind it.
void improve_beginnings(PartitionJudge& judge, const std::vector<Partition>& from,
                        std::uint64_t allowed) {
  for (std::size_t k = 0; k < from.size() && judge.work() < allowed; ++k) {
    const std::uint64_t share = (allowed - judge.work()) / (from.size() - k);
    Descent(judge, from[k], judge.work() + share).run();
  }
}

}  // namespace

PartitionSearch find_partition(const System& f, std::uint64_t most_work) {
  const std::size_t n = f.variables.size();
  if (f.polynomials.size() != n || n == 0) {
    throw InvalidInput("groups are looked for in square systems only");
  }
  if (std::any_of(f.polynomials.begin(), f.polynomials.end(),
                  [](const Polynomial& p) { return p.terms.empty(); })) {
    throw InvalidInput("groups are not looked for where an equation is 0 = 0");
  }
  PartitionJudge judge(f);
  const std::uint64_t allowed = std::min(allowed_work(f), std::max(kLeastSearchWork, most_work));
  const bool tries_all =
      n <= kExhaustiveUnknowns && kPartitions[n] * PartitionJudge::kOverhead <= allowed;
  if (tries_all) {
    try_all(judge, n);
  } else {
    judge.number(one_group(n));  // long equations may leave time for no other
    improve_beginnings(judge, beginnings(f, judge), allowed);
  }
  PartitionSearch search;
  search.groups = judge.best();
  search.paths = multihomogeneous_number(f, search.groups);
  search.is_least = tries_all;
  search.is_cut = allowed < allowed_work(f) && judge.work() >= allowed;
  search.tried = judge.tried();
  return search;
}

}  // namespace moivre
