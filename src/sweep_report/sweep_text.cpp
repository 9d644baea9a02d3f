// SPDX-License-Identifier: MIT
// A sweep as text, JSON and CSV.
#include <cmath>
#include <map>

#include "moivre/expression/counted.h"
#include "moivre/report/json.h"
#include "moivre/report/number_text.h"
#include "moivre/sweep_report/sweep_report.h"

namespace moivre {
namespace {

Json at_json(const SweepResult& result, const std::vector<double>& at) {
  Json json = Json::object();
  for (std::size_t j = 0; j < at.size(); ++j) json[result.varied[j].name] = to_json(at[j]);
  return json;
}

constexpr std::size_t kBordersShown = 50;

}  // namespace

std::string sweep_text(const SweepResult& result, const std::string& file) {
  std::string text = file + ": " + counted(result.samples.size(), "sample");
  for (const Varied& number : result.varied) {
    text +=
        ", " + number.name + " from " + exact_text(number.from) + " to " + exact_text(number.to);
  }
  text += '\n';
  std::map<std::uint64_t, std::uint64_t> samples;
  std::uint64_t undecided = 0;
  std::uint64_t moving = 0;
  for (const SweepSample& sample : result.samples) {
    sample.complete ? ++samples[sample.real] : ++undecided;
    if (sample.moves) ++moving;
  }
  for (const auto& [real, count] : samples) {
    text += "  " + counted(real, "real closure") + ": " + counted(count, "sample") + '\n';
  }
  if (moving > 0) {
    text += "  of these, it moves though the drivers stand: " + counted(moving, "sample") + '\n';
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
            ": " + std::to_string(border.below) + " | " + std::to_string(border.above) + '\n';
  }
  return text;
}

std::string sweep_json(const SweepResult& result, const std::string& file) {
  Json report = report_head("sweep", file);
  report["complete"] = result.complete;
  report["parameters"] = list_json(result.varied, [](const Varied& number) {
    return Json{{"name", number.name},
                {"from", to_json(number.from)},
                {"to", to_json(number.to)},
                {"count", number.count}};
  });
  report["samples"] = list_json(result.samples, [&](const SweepSample& sample) {
    return Json{{"at", at_json(result, sample.at)},
                {"complex", sample.complex},
                {"real", sample.real},
                {"complete", sample.complete},
                {"moves", sample.moves}};
  });
  report["borders"] = list_json(result.borders, [&](const SweepBorder& border) {
    return Json{{"at", at_json(result, border.at)},
                {"along", result.varied[border.along].name},
                {"real", Json::array({border.below, border.above})}};
  });
  report["families"] = result.families;
  report["time_s"] = {{"threads", result.threads}, {"total", to_json(result.seconds)}};
  return to_text(report);
}

std::string sweep_csv(const SweepResult& result) {
  std::string text;
  for (const Varied& number : result.varied) text += number.name + ',';
  text += "complex,real,complete,moves\n";
  for (const SweepSample& sample : result.samples) {
    for (const double value : sample.at) text += exact_text(value) + ',';
    text += std::to_string(sample.complex) + ',' + std::to_string(sample.real) +
            (sample.complete ? ",1" : ",0") + (sample.moves ? ",1\n" : ",0\n");
  }
  return text;
}

}  // namespace moivre
