// SPDX-License-Identifier: MIT
// How is a mechanism file read? TOML first, then section by section, every fault noted, thrown together.
#include "moivre/mechanism/read.h"

#include <algorithm>
#include <numbers>

#include "nearest.h"
#include "read_parts.h"

namespace moivre {
namespace {

const std::vector<std::string> kLengthUnits{"m", "mm", "cm", "dm", "km", "um", "in", "ft", "yd"};
const std::vector<std::string> kAngleUnits{"rad", "deg"};

/// One of the known words, or a fault.
std::string read_word(Reading& reading, const toml::table& in, const std::string& key,
                      const std::vector<std::string>& known, const std::string& otherwise) {
  const auto word = reading.text(in, key);
  if (!word) return otherwise;
  if (std::find(known.begin(), known.end(), *word) != known.end()) return *word;
  reading.fault(*in.get(key), "unknown " + key + " '" + *word + "'" + suggestion(*word, known));
  return otherwise;
}

void read_header(Reading& reading, const toml::table& document, Mechanism& mechanism) {
  reading.check_keys(document,
                     {"title", "space", "units", "ground", "body", "joint", "driver", "guess",
                      "unknowns", "constants", "equations"},
                     "a mechanism file");
  mechanism.title = reading.text(document, "title").value_or("");
  const std::string space = read_word(reading, document, "space", {"planar", "spatial"}, "planar");
  mechanism.space = space == "spatial" ? Space::spatial : Space::planar;
  if (const toml::table* units = reading.table(document, "units")) {
    reading.check_keys(*units, {"length", "angle"}, "[units]");
    mechanism.units.length = read_word(reading, *units, "length", kLengthUnits, "");
    mechanism.units.angle = read_word(reading, *units, "angle", kAngleUnits, "rad");
  }
}

bool has_any(const toml::table& document, const std::vector<std::string>& keys) {
  return std::any_of(keys.begin(), keys.end(),
                     [&](const std::string& key) { return document.contains(key); });
}

/// Reads the sections of the file's kind; a file of both kinds or of neither is a fault.
void read_sections(Reading& reading, const toml::table& document, Mechanism& mechanism) {
  const bool has_bodies = has_any(document, {"ground", "body", "joint"});
  const bool has_equations = has_any(document, {"unknowns", "equations", "constants"});
  if (has_bodies && has_equations) {
    reading.fault(SourcePosition{},
                  "the file has bodies and equations; write either [body...] and [[joint]], or "
                  "[unknowns] and [equations]");
    return;
  }
  if (!has_bodies && !has_equations) {
    reading.fault(SourcePosition{},
                  "the file describes no mechanism; write [body.NAME.points] and [[joint]], or "
                  "[unknowns] and [equations]");
    return;
  }
  if (has_bodies) {
    read_bodies(reading, document, mechanism);
    read_joints(reading, document, mechanism);
  } else {
    read_equations(reading, document, mechanism);
  }
  read_drivers(reading, document, mechanism);
  read_guess(reading, document, mechanism);
  if (reading.faults().empty()) check_structure(reading, mechanism);
}

/// What to do about a fault of TOML's own, where its words need it.
std::string advice(const std::string& fault) {
  const auto says = [&](const char* words) { return fault.find(words) != std::string::npos; };
  if (says("root table") && says("saw '{'")) {
    return "; a mechanism file is TOML, not JSON: docs/mechanism-file.md shows one";
  }
  if (says("redefine")) return "; two bodies, points or keys have one name, rename one of them";
  if (says("boolean") || says("value type"))
    return "; text stands in quotes, as in title = \"...\"";
  if (says("table header")) return "; names have letters, digits, '_' and '-', and no blanks";
  return "";
}

[[noreturn]] void throw_toml_fault(const Reading& reading, const toml::parse_error& error) {
  const std::string fault(error.description());
  throw ParseError(reading.source(),
                   {{reading.position(error.source().begin), fault + advice(fault)}});
}

/// The TOML parser calls itself for each part of a dotted key: as deep as for brackets, and no deeper.
void refuse_deep_keys(const Source& source) {
  constexpr std::ptrdiff_t kDeepest = 256;
  std::size_t begin = 0;
  for (std::size_t line = 1; begin < source.text.size(); ++line) {
    const std::size_t end = std::min(source.text.find('\n', begin), source.text.size());
    const std::size_t value = std::min(source.text.find('=', begin), end);
    const auto at = source.text.begin() + static_cast<std::ptrdiff_t>(begin);
    if (std::count(at, at + static_cast<std::ptrdiff_t>(value - begin), '.') > kDeepest) {
      throw ParseError(source, {{{begin, line, 1}, "a key has more than 256 parts"}});
    }
    begin = end + 1;
  }
}

}  // namespace

double angle_unit(const Mechanism& mechanism) {
  constexpr double kDegree = std::numbers::pi / 180;
  return mechanism.units.angle == "deg" ? kDegree : 1;
}

Mechanism read_mechanism(const Source& source) {
  refuse_deep_keys(source);
  Reading reading(source);
  toml::table document;
  try {
    document = toml::parse(source.text, source.name);
  } catch (const toml::parse_error& error) {
    throw_toml_fault(reading, error);
  }
  Mechanism mechanism;
  read_header(reading, document, mechanism);
  read_sections(reading, document, mechanism);
  if (!reading.faults().empty()) {
    std::stable_sort(
        reading.faults().begin(), reading.faults().end(),
        [](const Diagnostic& a, const Diagnostic& b) { return a.at.offset < b.at.offset; });
    throw ParseError(source, reading.faults());
  }
  return mechanism;
}

}  // namespace moivre
