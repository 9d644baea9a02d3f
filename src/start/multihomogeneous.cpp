// SPDX-License-Identifier: MIT
// Degrees by group, and the table of the ways in which the equations left can take the factors
// left.
#include "moivre/start/multihomogeneous.h"

#include <algorithm>
#include <limits>
#include <numeric>

#include "exponent_table.h"
#include "moivre/numeric/invalid_input.h"
#include "moivre/numeric/saturating.h"

namespace moivre {
namespace {

/// Group of every unknown. Throws where one stands in no group, in two, or is none of the n.
std::vector<std::uint32_t> group_of_unknowns(const Partition& groups, std::size_t n) {
  constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();
  std::vector<std::uint32_t> group_of(n, kNone);
  for (std::size_t j = 0; j < groups.size(); ++j) {
    for (const std::uint32_t v : groups[j]) {
      if (v >= n || group_of[v] != kNone) {
        throw InvalidInput(
            "group " + std::to_string(j + 1) + " holds unknown " + std::to_string(v + 1) +
            (v >= n ? ", which is none of the system" : ", which stands in a group already"));
      }
      group_of[v] = static_cast<std::uint32_t>(j);
    }
  }
  const auto left = std::find(group_of.begin(), group_of.end(), kNone);
  if (left != group_of.end()) {
    throw InvalidInput("unknown " + std::to_string(left - group_of.begin() + 1) +
                       " stands in no group");
  }
  return group_of;
}

void check_square(const GroupDegrees& degrees, const Partition& groups) {
  std::size_t unknowns = 0;
  for (const auto& group : groups) unknowns += group.size();
  if (degrees.size() != unknowns) {
    throw InvalidInput("a number of roots by groups needs as many equations as unknowns: " +
                       std::to_string(degrees.size()) + " are not " + std::to_string(unknowns));
  }
}

}  // namespace

Partition one_group(std::size_t unknowns) {
  Partition groups(1, std::vector<std::uint32_t>(unknowns));
  std::iota(groups[0].begin(), groups[0].end(), 0U);
  return groups;
}

std::optional<Partition> declared_partition(const System& f) {
  if (f.groups.empty()) return std::nullopt;
  Partition groups;
  for (const VariableGroup& group : f.groups) groups.push_back(group.variables);
  group_of_unknowns(groups, f.variables.size());
  for (auto& group : groups) std::sort(group.begin(), group.end());
  std::sort(groups.begin(), groups.end());
  return groups;
}

GroupDegrees group_degrees(const System& f, const Partition& groups) {
  const std::vector<std::uint32_t> group_of = group_of_unknowns(groups, f.variables.size());
  GroupDegrees degrees;
  std::vector<std::uint64_t> sums(groups.size());
  for (const Polynomial& p : f.polynomials) {
    std::vector<std::uint64_t> row(groups.size(), 0);
    for (const Term& term : p.terms) {
      std::fill(sums.begin(), sums.end(), 0U);
      for (const Power& power : term.monomial) sums[group_of[power.variable]] += power.exponent;
      for (std::size_t j = 0; j < row.size(); ++j) row[j] = std::max(row[j], sums[j]);
    }
    degrees.push_back(std::move(row));
  }
  return degrees;
}

std::optional<ExponentTable> exponent_table(const Partition& groups) {
  ExponentTable table;
  for (const auto& group : groups) {
    if (table.entries > kMaximumTable / (group.size() + 1)) return std::nullopt;
    table.sizes.push_back(group.size());
    table.strides.push_back(table.entries);
    table.entries *= group.size() + 1;
  }
  return table;
}

std::optional<std::vector<std::uint64_t>> completion_table(const GroupDegrees& degrees,
                                                           const Partition& groups) {
  check_square(degrees, groups);
  const auto shape = exponent_table(groups);
  if (!shape) return std::nullopt;
  return completions(
      *shape, std::uint64_t{1}, [&](std::uint64_t i, std::size_t j) { return degrees[i][j]; },
      saturating_product, saturating_sum);
}

std::optional<std::uint64_t> multihomogeneous_number(const GroupDegrees& degrees,
                                                     const Partition& groups) {
  const auto table = completion_table(degrees, groups);
  if (!table || is_saturated(table->back())) return std::nullopt;
  return table->back();
}

std::optional<std::uint64_t> multihomogeneous_number(const System& f, const Partition& groups) {
  return multihomogeneous_number(group_degrees(f, groups), groups);
}

}  // namespace moivre
