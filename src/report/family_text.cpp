// SPDX-License-Identifier: MIT
// A family and its members for people.
#include <map>

#include "moivre/expression/counted.h"
#include "moivre/expression/joined.h"
#include "moivre/report/family_report.h"
#include "moivre/report/number_text.h"

namespace moivre {
namespace {

std::string one_family_text(const Family& family) {
  const Learning& learning = family.learning;
  std::string text = counted(family.unknowns(), "equation") + " in " +
                     counted(family.unknowns(), "unknown") + " and " +
                     counted(family.parameters(), "parameter") + "\n";
  text += "a generic member has " + counted(family.roots.size(), "root") +
          (family.nonzero ? " without zero coordinates" : "") + "; learned by " +
          counted(learning.paths, "path") + " (" + learning.start + ", seed " +
          std::to_string(family.seed) + "), " + std::to_string(learning.certified) + " certified\n";
  return text + learning.standing + '\n';
}

}  // namespace

std::string family_report_text(const FamilyFile& file, const std::string& name) {
  std::string text = name + ": a family of " +
                     (file.kind == kMechanismKind ? "the mechanism " : "") + file.source + '\n';
  if (file.kind == kPolynomialsKind) {
    text += "unknowns " + joined(file.families.front().unknown_names(), ", ") + "; parameters " +
            joined(file.families.front().parameter_names(), ", ") + '\n';
  }
  for (const Family& family : file.families) text += one_family_text(family);
  if (file.families.empty()) {
    text += "nothing to learn: every part of it is solved by formula\n";
  }
  return text;
}

std::string member_text(const SolveResult& result, const std::string& name, ListedRoots listed) {
  return solve_text(result, name, listed);
}

bool is_complete(const MembersRun& run) {
  for (const MemberRoots& member : run.roots) {
    if (!member.complete) return false;
  }
  return true;
}

std::string members_text(const MembersRun& run) {
  std::map<std::pair<std::size_t, std::uint64_t>, std::uint64_t> counts;
  std::uint64_t judged = 0;
  std::uint64_t undecided = 0;
  for (const MemberRoots& member : run.roots) {
    if (!member.complete) ++undecided;
    if (member.judged) ++judged;
    if (member.complete) ++counts[{member.roots.size(), member.real_count()}];
  }
  std::string text =
      run.table + ": " + counted(run.roots.size(), "member") + " of " + run.name + '\n';
  for (const auto& [count, members] : counts) {
    text += "  " + counted(members, "member") + " with " + counted(count.first, "root") + ", " +
            std::to_string(count.second) + " real\n";
  }
  if (judged > 0) text += counted(judged, "member") + " solved again, with endgames\n";
  if (undecided > 0) text += counted(undecided, "member") + " not decided\n";
  if (!run.family.learning.complete) {
    text +=
        "the family may lack roots, and so may its members: " + run.family.learning.standing + '\n';
  }
  return text;
}

}  // namespace moivre
