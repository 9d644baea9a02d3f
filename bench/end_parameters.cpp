// SPDX-License-Identifier: MIT
// Does any verdict hang on the exact value of a number? Each of the endgame's, times and over a
// factor, on random systems.
//
//   end_parameters FOLDER [--limit N] [--factor X] [--only NAME]
//
// FOLDER: systems.jsonl and truth.jsonl of bench/random_systems/generate and truth. Every system of
// isolated roots is solved by the lanes, seed 1, one thread. Printed: systems told completely and
// wrongly, those left open, and the seconds of the CPU.
// A number that is an integer is rounded. Exit: 0 nothing was wrong, 1 something was, 2 usage.
#include <cmath>
#include <cstdio>
#include <ctime>
#include <exception>
#include <fstream>
#include <functional>
#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "moivre/polynomial/read.h"
#include "moivre/solver/solve.h"
#include "moivre/tracker_lanes/lane_tracker.h"

namespace {

using moivre::EndParameters;

struct Judged {
  std::string id;
  moivre::System f;
  std::uint64_t with_multiplicity = 0;
  std::uint64_t distinct = 0;
};

struct Request {
  std::string folder;
  std::size_t limit = 1000;
  double factor = 4;
  std::string only;
};

struct Row {
  int wrong = 0;
  int open = 0;
  double seconds = 0;
};

/// One number of EndParameters, and how it is multiplied.
struct Change {
  const char* name;
  std::function<void(EndParameters&, double)> multiply;
};

template <class T>
Change change_of(const char* name, T EndParameters::*member) {
  return {name, [member](EndParameters& ends, double factor) {
            const double value = factor * static_cast<double>(ends.*member);
            ends.*member = std::is_integral_v<T> ? static_cast<T>(std::max(1.0, std::round(value)))
                                                 : static_cast<T>(value);
          }};
}

const std::vector<Change> kChanges = {
    change_of("watch_radius", &EndParameters::watch_radius),
    change_of("creeping_radius", &EndParameters::creeping_radius),
    change_of("first_radius", &EndParameters::first_radius),
    change_of("least_radius", &EndParameters::least_radius),
    change_of("shrink", &EndParameters::shrink),
    change_of("samples", &EndParameters::samples),
    change_of("maximum_winding", &EndParameters::maximum_winding),
    change_of("maximum_steps", &EndParameters::maximum_steps),
    change_of("rounding", &EndParameters::rounding),
    change_of("sample_error", &EndParameters::sample_error),
    change_of("agreement", &EndParameters::agreement),
    change_of("regular_condition", &EndParameters::regular_condition),
    change_of("singular_condition", &EndParameters::singular_condition),
    change_of("zero_sum", &EndParameters::zero_sum),
    change_of("beyond", &EndParameters::beyond),
    change_of("known_size", &EndParameters::known_size),
    change_of("valuation_error", &EndParameters::valuation_error),
    change_of("face_threshold", &EndParameters::face_threshold),
    change_of("face_progress", &EndParameters::face_progress),
    change_of("fine_rounding", &EndParameters::fine_rounding)};

std::vector<Judged> judged_systems(const Request& request) {
  std::map<std::string, nlohmann::json> truths;
  std::ifstream truth(request.folder + "/truth.jsonl");
  for (std::string line; std::getline(truth, line);) {
    const nlohmann::json told = nlohmann::json::parse(line);
    truths[told["id"]] = told;
  }
  std::vector<Judged> result;
  std::ifstream systems(request.folder + "/systems.jsonl");
  for (std::string line; result.size() < request.limit && std::getline(systems, line);) {
    const nlohmann::json system = nlohmann::json::parse(line);
    const std::string id = system["id"];
    const auto told = truths.find(id);
    if (told == truths.end() || told->second.value("dimension", -1) != 0) continue;
    result.push_back({id, moivre::read_system(moivre::Source{id, system["phc"]}),
                      told->second["with_multiplicity"], told->second["distinct"]});
  }
  return result;
}

Row row_of(const std::vector<Judged>& systems, const EndParameters& ends) {
  const auto tracker = moivre::make_lane_tracker();
  moivre::SolveOptions options;
  options.threads = 1;
  options.endgame.ends = ends;
  Row row;
  const std::clock_t begin = std::clock();
  for (const Judged& system : systems) {
    const moivre::SolveResult result = moivre::solve(system.f, *tracker, options);
    std::uint64_t roots = 0;
    for (const moivre::Solution& root : result.solutions) roots += root.multiplicity;
    const bool is_right =
        roots == system.with_multiplicity && result.solutions.size() == system.distinct;
    if (!result.complete) ++row.open;
    if (result.complete && !is_right) {
      ++row.wrong;
      std::fprintf(stderr, "  wrong: %s\n", system.id.c_str());
    }
  }
  row.seconds = static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC;
  return row;
}

void print(const std::string& name, const Row& row) {
  std::printf("%-24s %7d %7d %9.1f\n", name.c_str(), row.wrong, row.open, row.seconds);
  std::fflush(stdout);
}

int run(const Request& request) {
  const std::vector<Judged> systems = judged_systems(request);
  std::printf("%zu systems, factor %g\n%-24s %7s %7s %9s\n", systems.size(), request.factor,
              "number", "wrong", "open", "CPU s");
  const Row as_it_is = row_of(systems, {});
  print("as it is", as_it_is);
  int wrong = as_it_is.wrong;
  for (const Change& change : kChanges) {
    if (!request.only.empty() && request.only != change.name) continue;
    for (const double factor : {request.factor, 1 / request.factor}) {
      EndParameters ends;
      change.multiply(ends, factor);
      if (!validate(ends).empty()) continue;
      const Row row = row_of(systems, ends);
      print(std::string(change.name) + (factor > 1 ? " times" : " over"), row);
      wrong += row.wrong;
    }
  }
  return wrong == 0 ? 0 : 1;
}

/// Throws std::invalid_argument when a word is none of the usage.
Request request_of(int argc, char** argv) {
  Request request;
  for (int k = 1; k < argc; ++k) {
    const std::string word = argv[k];
    const bool is_option = word.rfind("--", 0) == 0;
    if (is_option && k + 1 == argc) throw std::invalid_argument(word + " needs a value");
    if (word == "--limit") {
      request.limit = std::stoull(argv[++k]);
    } else if (word == "--factor") {
      request.factor = std::stod(argv[++k]);
    } else if (word == "--only") {
      request.only = argv[++k];
    } else if (is_option || !request.folder.empty()) {
      throw std::invalid_argument("no option " + word);
    } else {
      request.folder = word;
    }
  }
  if (request.folder.empty()) throw std::invalid_argument("which folder?");
  return request;
}

}  // namespace

int main(int argc, char** argv) {
  try {
    return run(request_of(argc, argv));
  } catch (const std::exception& fault) {
    std::fprintf(stderr, "end_parameters: %s\n", fault.what());
    return 2;
  }
}
