// SPDX-License-Identifier: MIT
// What do mixed cells cost? Mixed volumes, cells, steps and CPU seconds of families, beside
// PHCpack's MixedVol and DEMiCs.
//
//   mixed_cells [--seeds N] [--no-peer] [FAMILY-N...]    families: cyclic, noon, eco, katsura,
//   reimer
//
// volume, cells, steps: seed 1; cpu_s: a seed's mean. zero: mixed volume with 0 added to every
// support; stable: the stable one. phc: `phc -m` where it is on the PATH, its own figure of user
// seconds for the cells alone; a run of more than ten minutes is left out.
// Exit: 0 every peer's mixed volume is ours, 1 some differ, 2 usage.
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <exception>
#include <filesystem>
#include <fstream>
#include <functional>
#include <iterator>
#include <map>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "families.h"
#include "moivre/start/mixed_volume.h"

namespace {

using moivre::Support;
using Supports = std::vector<Support>;

struct Request {
  std::uint64_t seeds = 3;
  bool peer = true;
  std::vector<std::string> names{"cyclic-7",  "cyclic-8",  "cyclic-9",   "cyclic-10",  "noon-5",
                                 "noon-7",    "noon-9",    "eco-8",      "eco-12",     "eco-14",
                                 "katsura-6", "katsura-8", "katsura-10", "katsura-12", "reimer-5"};
};

Request request_of(int argc, char** argv) {
  Request request;
  std::vector<std::string> names;
  for (int k = 1; k < argc; ++k) {
    const std::string word = argv[k];
    if (word == "--no-peer") {
      request.peer = false;
    } else if (word == "--seeds") {
      if (k + 1 == argc) throw std::invalid_argument(word + " needs a value");
      request.seeds = std::stoull(argv[++k]);
    } else {
      names.push_back(word);
    }
  }
  if (request.seeds == 0) throw std::invalid_argument("--seeds must be at least 1");
  if (!names.empty()) request.names = names;
  return request;
}

Supports supports_named(const std::string& name) {
  const std::map<std::string, std::function<Supports(std::size_t)>> families{
      {"cyclic", moivre::cyclic},
      {"noon", moivre::noon},
      {"eco", moivre::eco},
      {"katsura", moivre::katsura},
      {"reimer", moivre::reimer}};
  const std::size_t dash = name.find('-');
  const auto family = families.find(name.substr(0, dash));
  if (dash == std::string::npos || family == families.end()) {
    throw std::invalid_argument("no family and number: " + name);
  }
  return family->second(std::stoul(name.substr(dash + 1)));
}

std::string phcpack_text(const Supports& supports) {
  std::string text = std::to_string(supports.size()) + "\n";
  std::size_t coefficient = 1;
  for (const Support& support : supports) {
    for (const moivre::Exponents& term : support.terms) {
      text += " + " + std::to_string(coefficient++);
      for (std::size_t j = 0; j < term.size(); ++j) {
        if (term[j] != 0) text += "*x" + std::to_string(j + 1) + "^" + std::to_string(term[j]);
      }
    }
    text += ";\n";
  }
  return text;
}

struct PeerRun {
  std::string volume;
  double cpu_s = 0;
};

/// The number behind `label` in the text.
std::optional<std::string> number_behind(const std::string& text, const std::string& label) {
  const std::size_t found = text.find(label);
  if (found == std::string::npos) return std::nullopt;
  const std::size_t begin = text.find_first_not_of(' ', found + label.size());
  return text.substr(begin, text.find_first_of(" \n", begin) - begin);
}

/// `choices`: what the menus of `phc -m` are answered with after the names of the files.
std::optional<PeerRun> run_peer(const Supports& supports, const std::string& choices,
                                const std::string& label) {
  const std::filesystem::path folder =
      std::filesystem::temp_directory_path() / "moivre-mixed-cells";
  std::filesystem::remove_all(folder);
  std::filesystem::create_directory(folder);
  std::ofstream(folder / "source") << phcpack_text(supports);
  std::ofstream(folder / "answers") << "y\nsource\ntarget\n" << choices;
  const std::string command =
      "cd '" + folder.string() + "' && timeout 600 phc -m < answers > printed 2>&1";
  if (std::system(command.c_str()) != 0) return std::nullopt;
  std::ifstream file(folder / "target");
  const std::string text{std::istreambuf_iterator<char>(file), {}};
  const auto volume = number_behind(text, label);
  const auto seconds = number_behind(text, "User time in seconds was");
  if (!volume || !seconds) return std::nullopt;
  return PeerRun{*volume, std::stod(*seconds)};
}

double cpu_seconds() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

/// False: a peer's mixed volume is another.
bool print_peers(const Supports& supports, std::uint64_t volume) {
  bool agree = true;
  // MixedVol without a random coefficient system, stable mixed volumes or separate file; DEMiCs
  // alike.
  for (const auto& [choices, label] : {std::pair{"4\n0\nn\nn\n", "common mixed volume :"},
                                       std::pair{"5\nn\nn\nn\nn\n", "The mixed volume :"}}) {
    const std::optional<PeerRun> run = run_peer(supports, choices, label);
    if (!run) {
      std::printf(" %10s", "-");
    } else if (run->volume == std::to_string(volume)) {
      std::printf(" %10.4f", run->cpu_s);
    } else {
      std::printf(" %10s", ("!" + run->volume).c_str());
      agree = false;
    }
  }
  return agree;
}

bool measure(const std::string& name, const Request& request, bool peer) {
  const Supports supports = supports_named(name);
  const Supports with_zero = moivre::with_origin(supports, supports.size()).supports;
  const double begin = cpu_seconds();
  for (std::uint64_t seed = 2; seed <= request.seeds; ++seed) {
    moivre::verified_mixed_volume(supports, seed);
  }
  const moivre::CellSearch search = moivre::mixed_cells(supports, 1);
  // A verified mixed volume is two searches.
  const double searches = 2 * static_cast<double>(request.seeds) - 1;
  const double cpu_s = (cpu_seconds() - begin) / searches;
  if (!search.subdivision) throw std::runtime_error(name + ": " + description(search.end));
  const moivre::MixedSubdivision& s = *search.subdivision;
  std::printf("%-12s %10llu %8zu %9llu %9.4f %10llu %10llu", name.c_str(),
              static_cast<unsigned long long>(s.mixed_volume), s.cells.size(),
              static_cast<unsigned long long>(search.steps), cpu_s,
              static_cast<unsigned long long>(mixed_volume(with_zero, 1).value.value_or(0)),
              static_cast<unsigned long long>(stable_mixed_volume(supports, 1).value.value_or(0)));
  const bool agree = !peer || print_peers(supports, s.mixed_volume);
  std::printf("\n");
  std::fflush(stdout);
  return agree;
}

}  // namespace

int main(int argc, char** argv) {
  try {
    const Request request = request_of(argc, argv);
    const bool peer = request.peer && std::system("command -v phc > /dev/null") == 0;
    std::printf("%-12s %10s %8s %9s %9s %10s %10s %10s %10s\n", "system", "volume", "cells",
                "steps", "cpu_s", "zero", "stable", peer ? "MixedVol_s" : "",
                peer ? "DEMiCs_s" : "");
    bool agree = true;
    for (const std::string& name : request.names) agree = measure(name, request, peer) && agree;
    return agree ? 0 : 1;
  } catch (const std::exception& fault) {
    std::fprintf(stderr, "mixed_cells: %s\n", fault.what());
    return 2;
  }
}
