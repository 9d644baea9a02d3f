// SPDX-License-Identifier: MIT
// Writing families as JSON with a checksum behind it, and reading them with every doubt a refusal.
#include "moivre/family/family_file.h"

#include <cmath>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "judged_claims.h"
#include "moivre/numeric/invalid_input.h"
#include "moivre/polynomial/read.h"

namespace moivre {
namespace {

using Json = nlohmann::ordered_json;

constexpr const char* kVersionKey = "moivre_family";
constexpr std::string_view kChecksumKey = ",\n  \"checksum\": \"";
constexpr std::string_view kEnd = "\"\n}\n";
constexpr std::size_t kChecksumDigits = 16;

/// FNV-1a of 64 bits.
std::uint64_t hash_of(std::string_view text) {
  constexpr std::uint64_t kOffset = 0xcbf29ce484222325;
  constexpr std::uint64_t kPrime = 0x100000001b3;
  std::uint64_t hash = kOffset;
  for (const char c : text) {
    hash ^= static_cast<unsigned char>(c);
    hash *= kPrime;
  }
  return hash;
}

std::string checksum(std::string_view text) {
  char digits[kChecksumDigits + 1];
  std::snprintf(digits, sizeof digits, "%016llx", static_cast<unsigned long long>(hash_of(text)));
  return digits;
}

Json point_json(const Point& x) {
  Json list = Json::array();
  for (const Complex& xj : x) list.push_back({xj.real(), xj.imag()});
  return list;
}

std::string system_text(const System& system) {
  try {
    return to_text(system, PolynomialFormat::phcpack);
  } catch (const std::invalid_argument&) {
    return to_text(system, PolynomialFormat::bertini);
  }
}

Json learning_json(const Learning& learning) {
  Json json = {{"start", learning.start},         {"paths", learning.paths},
               {"certified", learning.certified}, {"dropped", learning.dropped},
               {"complete", learning.complete},   {"standing", learning.standing}};
  json["bound"] = learning.bound ? Json{{"kind", name_in_results(learning.bound->kind)},
                                        {"value", learning.bound->value}}
                                 : Json();
  return json;
}

Json family_json(const Family& family) {
  Json parameters = Json::array();
  const std::vector<std::string> names = family.parameter_names();
  for (std::size_t j = 0; j < names.size(); ++j) {
    parameters.push_back({{"name", names[j]}, {"size", family.sizes[j]}});
  }
  Json roots = Json::array();
  for (const Point& root : family.roots) roots.push_back(point_json(root));
  return {{"system", system_text(family.system)},
          {"unknowns", family.unknown_names()},
          {"parameters", parameters},
          {"nonzero", family.nonzero},
          {"seed", family.seed},
          {"learning", learning_json(family.learning)},
          {"generic", point_json(family.generic)},
          {"roots", roots}};
}

[[noreturn]] void refuse(const Source& source, const std::string& reason) {
  throw InvalidInput(source.name + ": " + reason);
}

double finite(const Json& number) {
  const double x = number.get<double>();
  if (!std::isfinite(x)) throw InvalidInput("a number is not finite");
  return x;
}

Point point_of(const Json& json, std::size_t size) {
  Point x;
  for (const Json& pair : json) {
    if (!pair.is_array() || pair.size() != 2) throw InvalidInput("a number is no pair");
    x.emplace_back(finite(pair[0]), finite(pair[1]));
  }
  if (x.size() != size) throw InvalidInput("a point has too many or too few coordinates");
  return x;
}

Learning learning_of(const Json& json) {
  Learning learning;
  learning.start = json.at("start").get<std::string>();
  learning.paths = json.at("paths").get<std::uint64_t>();
  learning.certified = json.at("certified").get<std::uint64_t>();
  learning.dropped = json.at("dropped").get<std::uint64_t>();
  learning.complete = json.at("complete").get<bool>();
  learning.standing = json.at("standing").get<std::string>();
  const Json& bound = json.at("bound");
  if (!bound.is_null()) {
    const auto name = bound.at("kind").get<std::string>();
    const auto kind = bound_named(name);
    if (!kind) throw InvalidInput("the file has a bound of an unknown kind, " + name);
    learning.bound = MetBound{*kind, bound.at("value").get<std::uint64_t>()};
  }
  return learning;
}

/// The system in the variables as they are listed: reading gives them in the order of their first
/// appearance.
System system_of(const Source& source, const Json& json, const std::vector<std::string>& names) {
  System system = read_system({source.name, json.at("system").get<std::string>()});
  system.groups.clear();
  if (system.variables != names) throw InvalidInput("the system has other names");
  return system;
}

Family family_of(const Source& source, const Json& json) {
  Family family;
  auto names = json.at("unknowns").get<std::vector<std::string>>();
  const std::size_t n = names.size();
  for (const Json& parameter : json.at("parameters")) {
    names.push_back(parameter.at("name").get<std::string>());
    family.sizes.push_back(finite(parameter.at("size")));
    if (!(family.sizes.back() > 0)) throw InvalidInput("a parameter has no size");
  }
  family.system = system_of(source, json, names);
  if (n == 0 || family.system.polynomials.size() != n || family.sizes.empty()) {
    throw InvalidInput("the system is not square");
  }
  family.nonzero = json.at("nonzero").get<bool>();
  family.seed = json.at("seed").get<std::uint64_t>();
  family.learning = learning_of(json.at("learning"));
  family.generic = point_of(json.at("generic"), family.sizes.size());
  for (const Json& root : json.at("roots")) family.roots.push_back(point_of(root, n));
  return family;
}

/// The JSON of a text whose checksum is right.
Json checked_json(const Source& source) {
  const std::string& text = source.text;
  if (text.find(kVersionKey) == std::string::npos) {
    refuse(source, "this is no family file; moivre family learn writes them");
  }
  const std::size_t at = text.rfind(kChecksumKey);
  const std::size_t length = kChecksumKey.size() + kChecksumDigits + kEnd.size();
  if (at == std::string::npos || at + length != text.size() || !text.ends_with(kEnd)) {
    refuse(source, "the file is cut short, or was changed: it does not end with its checksum");
  }
  if (text.substr(at + kChecksumKey.size(), kChecksumDigits) !=
      checksum(std::string_view(text).substr(0, at))) {
    refuse(source, "the file was changed: its checksum is another; learn the family again");
  }
  try {
    return Json::parse(text);
  } catch (const Json::exception& error) {
    refuse(source, std::string("the file is no JSON: ") + error.what());
  }
}

}  // namespace

std::string family_text(const FamilyFile& file) {
  std::string text = "{\n  \"moivre_family\": " + std::to_string(kFamilyFileVersion);
  const auto line = [](const Json& value) {
    return value.dump(-1, ' ', false, Json::error_handler_t::replace);
  };
  text += ",\n  \"kind\": " + line(file.kind) + ",\n  \"source\": " + line(file.source);
  text += ",\n  \"families\": [";
  const char* comma = "\n    ";
  for (const Family& family : file.families) {
    text += comma + line(family_json(family));
    comma = ",\n    ";
  }
  text += "\n  ]";
  return text + std::string(kChecksumKey) + checksum(text) + std::string(kEnd);
}

FamilyFile read_family(const Source& source) {
  const Json json = checked_json(source);
  try {
    const int version = json.at(kVersionKey).get<int>();
    if (version != kFamilyFileVersion) {
      throw InvalidInput("the file has version " + std::to_string(version) +
                         ", this program reads version " + std::to_string(kFamilyFileVersion));
    }
    FamilyFile file;
    file.kind = json.at("kind").get<std::string>();
    file.source = json.at("source").get<std::string>();
    const bool is_polynomials = file.kind == kPolynomialsKind;
    if (!is_polynomials && file.kind != kMechanismKind) {
      throw InvalidInput("the file holds families of an unknown kind, " + file.kind);
    }
    for (const Json& family : json.at("families")) {
      file.families.push_back(family_of(source, family));
      judge_claims(file.families.back(), hash_of(source.text));
    }
    if (is_polynomials && file.families.size() != 1) {
      throw InvalidInput("the file holds not one family");
    }
    return file;
  } catch (const ParseError& error) {
    refuse(source, std::string("the system in the file cannot be read:\n") + error.what());
  } catch (const Json::exception& error) {
    refuse(source, std::string("the file is not as it should be: ") + error.what());
  } catch (const std::logic_error& error) {
    refuse(source, error.what());
  }
}

FamilyFile load_family(const std::string& path) { return read_family(read_source(path)); }

void save_family(const FamilyFile& file, const std::string& path) {
  const std::string text = family_text(file);
  const std::string beside = path + ".part";
  std::ofstream out(beside, std::ios::binary);
  out << text;
  out.close();
  std::error_code error;
  if (out) std::filesystem::rename(beside, path, error);
  if (!out || error) {
    std::error_code ignored;
    std::filesystem::remove(beside, ignored);
    throw InvalidInput("cannot write " + path);
  }
}

}  // namespace moivre
