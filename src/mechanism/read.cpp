// SPDX-License-Identifier: MIT
// How is a mechanism file read? TOML first, then section by section, every fault noted, thrown together.
#include "moivre/mechanism/read.h"

#include <algorithm>
#include <cctype>
#include <map>
#include <numbers>

#include "moivre/mechanism/nearest.h"
#include "read_parts.h"

namespace moivre {
namespace {

const std::vector<std::string> kLengthUnits{"m", "mm", "cm", "dm", "km", "um", "in", "ft", "yd"};
const std::vector<std::string> kAngleUnits{"rad", "deg"};

/// The unit that others write so; empty where it has no other name.
std::string unit_called(const std::string& word) {
  static const std::map<std::string, std::string> names{
      {"inch", "in"},       {"inches", "in"},      {"\"", "in"},          {"foot", "ft"},
      {"feet", "ft"},       {"yard", "yd"},        {"yards", "yd"},       {"meter", "m"},
      {"metre", "m"},       {"meters", "m"},       {"metres", "m"},       {"millimeter", "mm"},
      {"millimetre", "mm"}, {"millimeters", "mm"}, {"millimetres", "mm"}, {"MM", "mm"},
      {"centimeter", "cm"}, {"centimetre", "cm"},  {"centimeters", "cm"}, {"centimetres", "cm"},
      {"micron", "um"},     {"\u00b5m", "um"},     {"micrometer", "um"},  {"kilometer", "km"},
      {"degree", "deg"},    {"degrees", "deg"},    {"\u00b0", "deg"},     {"radian", "rad"},
      {"radians", "rad"}};
  const auto found = names.find(word);
  return found == names.end() ? "" : found->second;
}

/// One of the known words, or a fault.
std::string read_word(Reading& reading, const toml::table& in, const std::string& key,
                      const std::vector<std::string>& known, const std::string& otherwise) {
  const auto word = reading.text(in, key);
  if (!word) return otherwise;
  if (std::find(known.begin(), known.end(), *word) != known.end()) return *word;
  const std::string called = unit_called(*word);
  const bool is_unit = std::find(known.begin(), known.end(), called) != known.end();
  reading.fault(*in.get(key),
                "unknown " + key + " '" + *word + "'" +
                    (is_unit ? "; here it is called '" + called + "'" : suggestion(*word, known)));
  return otherwise;
}

void read_header(Reading& reading, const toml::table& document, Mechanism& mechanism) {
  reading.check_keys(document,
                     {"title", "space", "units", "ground", "body", "joint", "driver", "guess",
                      "unknowns", "constants", "equations", "fit", "tolerance"},
                     "a mechanism file");
  mechanism.title = reading.text(document, "title").value_or("");
  mechanism.fit = reading.number(document, "fit");
  if (mechanism.fit && !(*mechanism.fit > 0)) {
    reading.fault(*document.get("fit"), "'fit' must be a length above 0");
  }
  mechanism.tolerance = read_tolerance(reading, document);
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
    if (mechanism.tolerance) {
      reading.fault(*document.get("tolerance"),
                    "tolerances are of the dimensions of bodies; this file has typed equations");
    }
  }
  read_drivers(reading, document, mechanism);
  read_guess(reading, document, mechanism);
  if (reading.faults().empty()) check_structure(reading, mechanism);
}

/// "[[joint]] has two brackets" where one pair was written for an array; empty for another name that is taken.
std::string bracket_advice(const std::string& fault) {
  for (const std::string name : {"joint", "driver"}) {
    if (fault.find("'" + name + "'") == std::string::npos) continue;
    return "; every " + name + " begins with [[" + name + "]], in two brackets";
  }
  return "";
}

bool is_digit(char c) { return c >= '0' && c <= '9'; }

/// Where a number goes on with something that is none of it: a decimal comma, or a unit.
std::string number_advice(const Source& source, std::size_t at) {
  std::size_t end = std::min(at, source.text.size());
  while (end > 0 && source.text[end - 1] == ' ') --end;
  if (at >= source.text.size() || end == 0 || !is_digit(source.text[end - 1])) return "";
  if (source.text[at] == ',') return "; decimals have a point: 40.5, not 40,5";
  const auto c = static_cast<unsigned char>(source.text[at]);
  const bool is_word = std::isalpha(c) != 0 || c >= 0x80U || c == '%';
  return is_word ? "; numbers stand without a unit, [units] says it once for the whole file" : "";
}

/// What to do about a fault of TOML's own, where its words need it.
std::string advice(const std::string& fault) {
  const auto says = [&](const char* words) { return fault.find(words) != std::string::npos; };
  if (says("root table") && says("saw '{'")) {
    return "; a mechanism file is TOML, not JSON: docs/mechanism-file.md shows one";
  }
  if (says("redefine")) {
    const std::string brackets = bracket_advice(fault);
    return brackets.empty() ? "; two bodies, points or keys have one name, rename one of them"
                            : brackets;
  }
  if (says("boolean") || says("value type"))
    return "; text stands in quotes, as in title = \"...\"";
  if (says("table header")) return "; names have letters, digits, '_' and '-', and no blanks";
  return "";
}

[[noreturn]] void throw_toml_fault(const Reading& reading, const toml::parse_error& error) {
  const std::string fault(error.description());
  const SourcePosition at = reading.position(error.source().begin);
  const std::string about_number = number_advice(reading.source(), at.offset);
  throw ParseError(reading.source(),
                   {{at, fault + (about_number.empty() ? advice(fault) : about_number)}});
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

toml::table parse_toml(const Reading& reading) {
  refuse_deep_keys(reading.source());
  try {
    return toml::parse(reading.source().text, reading.source().name);
  } catch (const toml::parse_error& error) {
    throw_toml_fault(reading, error);
  }
}

void throw_faults(Reading& reading) {
  std::vector<Diagnostic>& faults = reading.faults();
  if (faults.empty()) return;
  std::stable_sort(faults.begin(), faults.end(), [](const Diagnostic& a, const Diagnostic& b) {
    return a.at.offset < b.at.offset;
  });
  throw ParseError(reading.source(), faults);
}

Mechanism read_mechanism(const Source& source) {
  Reading reading(source);
  const toml::table document = parse_toml(reading);
  Mechanism mechanism;
  read_header(reading, document, mechanism);
  read_sections(reading, document, mechanism);
  throw_faults(reading);
  return mechanism;
}

}  // namespace moivre
