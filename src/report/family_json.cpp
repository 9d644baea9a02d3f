// SPDX-License-Identifier: MIT
// A family and its members as JSON and CSV.
#include "moivre/report/family_report.h"
#include "moivre/report/json.h"
#include "moivre/report/json_writer.h"
#include "moivre/report/number_text.h"
#include "moivre/report/text_pieces.h"

namespace moivre {
namespace {

Json learning_json(const Learning& learning) {
  return {{"start", learning.start},
          {"paths", learning.paths},
          {"certified", learning.certified},
          {"dropped", learning.dropped},
          {"complete", learning.complete},
          {"standing", learning.standing},
          {"bound", learning.bound ? to_json(*learning.bound) : Json()}};
}

Json parameters_json(const Family& family) {
  const std::vector<std::string> names = family.parameter_names();
  Json list = Json::array();
  for (std::size_t j = 0; j < names.size(); ++j) {
    list.push_back({{"name", names[j]}, {"size", family.sizes[j]}});
  }
  return list;
}

Json family_json(const Family& family) {
  return {{"unknowns", family.unknown_names()},
          {"parameters", parameters_json(family)},
          {"roots", family.roots.size()},
          {"nonzero", family.nonzero},
          {"seed", family.seed},
          {"learning", learning_json(family.learning)}};
}

/// A real number stays one.
Json value_json(const Complex& value) {
  return value.imag() == 0 ? to_json(value.real()) : to_json(value);
}

Json at_json(const Family& family, const Point& p) {
  const std::vector<std::string> names = family.parameter_names();
  Json at = Json::object();
  for (std::size_t j = 0; j < names.size(); ++j) at[names[j]] = value_json(p[j]);
  return at;
}

Json root_json(const MemberRoot& root) {
  return {{"x", to_json(root.x)},
          {"real", root.real},
          {"singular", root.singular},
          {"multiplicity", root.multiplicity},
          {"accuracy", to_json(root.accuracy)},
          {"condition", to_json(root.condition)},
          {"certified", root.certified ? Json(*root.certified) : Json()}};
}

Json member_of_run(const MembersRun& run, std::size_t k) {
  const MemberRoots& member = run.roots[k];
  return {
      {"at", at_json(run.family, run.members[k])},
      {"complex", member.roots.size()},
      {"real", member.real_count()},
      {"at_infinity", member.at_infinity},
      {"failed", member.failed},
      {"not_needed", member.not_needed},
      {"complete", member.complete},
      {"completeness", member.completeness ? Json(to_string(*member.completeness)) : Json(nullptr)},
      {"judged", member.judged},
      {"solutions", list_json(member.roots, root_json)}};
}

std::string lines_of_member(const MembersRun& run, std::size_t k) {
  std::string head = std::to_string(k);
  for (const Complex& value : run.members[k]) {
    head += ',' + exact_text(value.real());
    if (value.imag() == 0) continue;
    head += (value.imag() < 0 ? "" : "+") + exact_text(value.imag()) + "*i";
  }
  std::string text;
  for (std::size_t r = 0; r < run.roots[k].roots.size(); ++r) {
    const MemberRoot& root = run.roots[k].roots[r];
    text += head + ',' + std::to_string(r) + (root.real ? ",1," : ",0,") +
            (root.singular ? "1," : "0,") + std::to_string(root.multiplicity) + ',' +
            exact_text(root.accuracy);
    for (const Complex& xj : root.x) {
      text += ',' + exact_text(xj.real()) + ',' + exact_text(xj.imag());
    }
    text += '\n';
  }
  return text;
}

}  // namespace

std::string family_report_json(const FamilyFile& file, const std::string& name,
                               const std::string& command) {
  Json report = report_head(command, name);
  report["kind"] = file.kind;
  report["source"] = file.source;
  report["families"] = list_json(file.families, family_json);
  return to_text(report);
}

std::string member_json(const SolveResult& result, const Family& family, const ParameterValues& p,
                        const std::string& name) {
  Point values;
  for (const Coefficient& pj : p) values.push_back(to_complex(pj));
  const Json solved = Json::parse(solve_json(result, name));
  Json report = report_head("family solve", name);
  report["at"] = at_json(family, values);
  for (const auto& [key, value] : solved.items()) {
    if (!report.contains(key)) report[key] = value;
  }
  return to_text(report);
}

void write_members_json(const TextSink& sink, const MembersRun& run) {
  write_json(sink, [&](JsonWriter& report) {
    report.members(report_head("family solve", run.name));
    report.member("table", run.table);
    report.member("complete", is_complete(run));
    report.member("generic_roots", run.family.roots.size());
    report.member("unknowns", run.family.unknown_names());
    report.member("tracker", tracker_json(run.tracker, run.tracker_options));
    std::size_t number = 0;
    report.list("members", run.members, [&](const Point&) { return member_of_run(run, number++); });
    report.member("time_s", {{"threads", run.threads}, {"total", to_json(run.seconds)}});
  });
}

std::string members_json(const MembersRun& run) {
  return whole_text([&](const TextSink& sink) { write_members_json(sink, run); });
}

void write_members_csv(const TextSink& sink, const MembersRun& run) {
  TextPieces text(sink);
  text += "member";
  for (const std::string& name : run.family.parameter_names()) text += ',' + name;
  text += ",root,real,singular,multiplicity,accuracy";
  for (const std::string& name : run.family.unknown_names()) {
    text += ',' + name + ".re," + name + ".im";
  }
  text += "\n";
  for (std::size_t k = 0; k < run.members.size(); ++k) text += lines_of_member(run, k);
  text.flush();
}

std::string members_csv(const MembersRun& run) {
  return whole_text([&](const TextSink& sink) { write_members_csv(sink, run); });
}

}  // namespace moivre
