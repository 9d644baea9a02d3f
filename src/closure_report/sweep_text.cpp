// SPDX-License-Identifier: MIT
// A sweep as text, JSON and CSV.
#include <cmath>
#include <map>

#include "assemblies_text.h"
#include "moivre/closure_report/sweep_report.h"
#include "moivre/expression/counted.h"
#include "moivre/expression/joined.h"
#include "moivre/report/csv_cell.h"
#include "moivre/report/json.h"
#include "moivre/report/number_text.h"

namespace moivre {
namespace {

Json at_json(const SweepResult& result, const std::vector<double>& at) {
  Json json = Json::object();
  for (std::size_t j = 0; j < at.size(); ++j) json[result.varied[j].name] = to_json(at[j]);
  return json;
}

constexpr std::size_t kBordersShown = 50;

/// Of a border: "2", "2 (1 outside limits)", "moves".
std::string side_text(const Assemblies& found) {
  std::vector<std::string> beside;
  if (found.filtered > 0) beside.push_back(std::to_string(found.filtered) + " outside limits");
  if (found.fitted > 0) beside.push_back(std::to_string(found.fitted) + " within fit");
  std::string text = found.moves && found.real == 0 ? "" : std::to_string(found.real);
  if (!beside.empty()) text += " (" + joined(beside, ", ") + ")";
  if (found.moves) text += text.empty() ? "moves" : " and moves";
  return text;
}

Json sides_json(const SweepBorder& border, auto value) {
  return Json::array({value(border.below), value(border.above)});
}

}  // namespace

std::string sweep_text(const SweepResult& result, const std::string& file,
                       const std::vector<std::string>& warnings) {
  std::string text = file + ": " + counted(result.samples.size(), "sample");
  for (const Varied& number : result.varied) {
    text +=
        ", " + number.name + " from " + exact_text(number.from) + " to " + exact_text(number.to);
  }
  text += '\n';
  for (const std::string& warning : warnings) text += "warning: " + warning + '\n';
  std::map<Assemblies, std::uint64_t> samples;
  std::uint64_t undecided = 0;
  for (const SweepSample& sample : result.samples) {
    sample.complete ? ++samples[sample.found] : ++undecided;
  }
  for (const auto& [found, count] : samples) {
    text += "  " + counted(found.real, "real closure") + beside_text(found) + ": " +
            counted(count, "sample") + '\n';
  }
  if (undecided > 0) text += "  not decided: " + counted(undecided, "sample") + '\n';
  if (result.varied.size() > 1) {
    return text + counted(result.borders.size(), "border point") + '\n';
  }
  std::size_t shown = 0;
  for (const SweepBorder& border : result.borders) {
    if (++shown > kBordersShown) break;
    text += "border at " + result.varied[0].name + " = " +
            known_digits(border.at[0],
                         kBorder * std::abs(result.varied[0].to - result.varied[0].from)) +
            ": " + side_text(border.below) + " | " + side_text(border.above) + '\n';
  }
  return text;
}

std::string sweep_json(const SweepResult& result, const std::string& file,
                       const std::vector<std::string>& warnings) {
  Json report = report_head("sweep", file);
  report["complete"] = result.complete;
  report["warnings"] = warnings;
  report["parameters"] = list_json(result.varied, [](const Varied& number) {
    return Json{{"name", number.name},
                {"from", to_json(number.from)},
                {"to", to_json(number.to)},
                {"count", number.count}};
  });
  report["samples"] = list_json(result.samples, [&](const SweepSample& sample) {
    return Json{{"at", at_json(result, sample.at)}, {"complex", sample.complex},
                {"real", sample.found.real},        {"filtered", sample.found.filtered},
                {"fitted", sample.found.fitted},    {"complete", sample.complete},
                {"moves", sample.found.moves}};
  });
  report["borders"] = list_json(result.borders, [&](const SweepBorder& border) {
    return Json{{"at", at_json(result, border.at)},
                {"along", result.varied[border.along].name},
                {"real", sides_json(border, [](const Assemblies& a) { return a.real; })},
                {"filtered", sides_json(border, [](const Assemblies& a) { return a.filtered; })},
                {"fitted", sides_json(border, [](const Assemblies& a) { return a.fitted; })},
                {"moves", sides_json(border, [](const Assemblies& a) { return a.moves; })}};
  });
  report["families"] = result.families;
  report["time_s"] = {{"threads", result.threads}, {"total", to_json(result.seconds)}};
  return to_text(report);
}

std::string sweep_csv(const SweepResult& result) {
  std::string text;
  for (const Varied& number : result.varied) text += csv_cell(number.name) + ',';
  text += "complex,real,complete,moves,filtered,fitted\n";
  for (const SweepSample& sample : result.samples) {
    for (const double value : sample.at) text += exact_text(value) + ',';
    text += std::to_string(sample.complex) + ',' + std::to_string(sample.found.real) +
            (sample.complete ? ",1" : ",0") + (sample.found.moves ? ",1," : ",0,") +
            std::to_string(sample.found.filtered) + ',' + std::to_string(sample.found.fitted) +
            '\n';
  }
  return text;
}

}  // namespace moivre
