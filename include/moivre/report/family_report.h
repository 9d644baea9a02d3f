// SPDX-License-Identifier: MIT
// How are a family and its members reported? As text for people, as JSON and CSV for programs.
//
//   family      what it is and what is known of its roots; command: "family learn" or "family info"
//   one member  as for solve() (report/solve_report.h), with the values of its parameters
//   a table     JSON everything, CSV one root per line, text the numbers of roots
//
// The same bytes for every number of threads, but for the run times. `name`: of the family's file,
// as the user gave it.
#pragma once

#include <string>
#include <vector>

#include "moivre/family/family_file.h"
#include "moivre/family/members.h"
#include "moivre/report/solve_report.h"

namespace moivre {

std::string family_report_text(const FamilyFile& file, const std::string& name);
std::string family_report_json(const FamilyFile& file, const std::string& name,
                               const std::string& command);

std::string member_text(const SolveResult& result, const std::string& name, ListedRoots listed);
std::string member_json(const SolveResult& result, const Family& family, const ParameterValues& p,
                        const std::string& name);

/// Members of a table and what became of them.
struct MembersRun {
  const Family& family;
  const std::vector<Point>& members;
  const std::vector<MemberRoots>& roots;
  std::string name;   ///< of the family's file
  std::string table;  ///< the table's
  std::string tracker;
  OptionsInForce tracker_options;
  int threads = 1;
  double seconds = 0;
};

bool is_complete(const MembersRun& run);
std::string members_text(const MembersRun& run);
std::string members_json(const MembersRun& run);
std::string members_csv(const MembersRun& run);
/// The same, member by member.
void write_members_json(const TextSink& sink, const MembersRun& run);
void write_members_csv(const TextSink& sink, const MembersRun& run);

}  // namespace moivre
