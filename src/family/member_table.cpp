// SPDX-License-Identifier: MIT
// Members solved block by block, and their roots put row under row.
#include <algorithm>

#include "moivre/expression/counted.h"
#include "moivre/family/members.h"
#include "moivre/numeric/invalid_input.h"

namespace moivre {
namespace {

/// Members that are solved before their roots are put into the table.
constexpr std::size_t kMembersTogether = 4096;

void append(const MemberRoots& member, MemberTable& table) {
  for (const MemberRoot& root : member.roots) {
    // A path that broke off has no point.
    if (root.x.size() != table.unknowns) continue;
    table.points.insert(table.points.end(), root.x.begin(), root.x.end());
    table.accuracy.push_back(root.accuracy);
    table.real.push_back(root.real ? 1 : 0);
    table.singular.push_back(root.singular ? 1 : 0);
    table.certified.push_back(root.certified == true ? 1 : 0);
  }
  table.first.push_back(table.accuracy.size());
  table.complete.push_back(member.complete ? 1 : 0);
  table.completeness.push_back(member.completeness.value_or(RootCompleteness::open));
}

/// Rows of k numbers.
std::vector<Point> rows_of(std::span<const Complex> numbers, std::size_t k) {
  std::vector<Point> rows;
  for (std::size_t at = 0; at < numbers.size(); at += k) {
    const auto row = numbers.subspan(at, k);
    rows.emplace_back(row.begin(), row.end());
  }
  return rows;
}

void require_rows(const Family& family, std::span<const Complex> parameters) {
  require_unbroken(broken_rules(family));
  const std::size_t k = family.parameters();
  if (k > 0 && parameters.size() % k == 0) return;
  throw InvalidInput("members are rows of " + counted(k, "parameter") + "; " +
                     counted(parameters.size(), "number") + " are no whole rows");
}

}  // namespace

MemberTable solve_member_table(const Family& family, std::span<const Complex> parameters,
                               const Tracker& tracker, const SolveOptions& options,
                               const std::atomic<bool>& stop) {
  require_rows(family, parameters);
  const std::size_t k = family.parameters();
  const std::size_t members = parameters.size() / k;
  MemberTable table;
  table.unknowns = family.unknowns();
  std::uint64_t finite = 0;
  for (std::size_t begin = 0; begin < members; begin += kMembersTogether) {
    const std::size_t count = std::min(kMembersTogether, members - begin);
    SolveOptions of_block = options;
    if (options.progress) {
      of_block.progress = [&, begin, finite](const Progress& block) {
        Progress whole = block;
        whole.done += begin;
        whole.total = members;
        whole.finite += finite;
        options.progress(whole);
      };
    }
    const std::vector<Point> rows = rows_of(parameters.subspan(begin * k, count * k), k);
    for (const MemberRoots& member : solve_members(family, rows, tracker, of_block, stop)) {
      append(member, table);
    }
    finite = table.accuracy.size();
  }
  return table;
}

}  // namespace moivre
