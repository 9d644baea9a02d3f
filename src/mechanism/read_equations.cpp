// SPDX-License-Identifier: MIT
// How are typed unknowns, constants and equations read?
#include <algorithm>
#include <set>

#include "read_formula.h"
#include "read_parts.h"

namespace moivre {
namespace {

/// A name that an expression can hold: a letter or '_' first, no '-'.
bool is_identifier(const std::string& name) {
  const bool starts_well = !name.empty() && !(name[0] >= '0' && name[0] <= '9');
  return starts_well && is_name(name) && name.find('-') == std::string::npos;
}

void check_new_name(Reading& reading, const Mechanism& mechanism, const std::string& name,
                    const SourcePosition& at) {
  static const std::set<std::string> taken{"pi",   "sin",  "cos",  "tan", "asin",
                                           "acos", "atan", "sqrt", "exp", "log"};
  if (!is_identifier(name)) {
    reading.fault(
        at,
        "'" + name +
            "' cannot be used in an equation; names have letters, digits and '_', a letter first");
  } else if (taken.count(name) != 0) {
    reading.fault(at, "'" + name + "' has a meaning of its own; choose another name");
  }
  const bool is_unknown = std::any_of(mechanism.unknowns.begin(), mechanism.unknowns.end(),
                                      [&](const Unknown& unknown) { return unknown.name == name; });
  if (is_unknown || mechanism.constants.count(name) != 0) {
    reading.fault(at, "'" + name + "' is declared twice; rename one of them");
  }
}

void read_unknowns(Reading& reading, const toml::table& document, Mechanism& mechanism) {
  const toml::table* section = reading.table(document, "unknowns");
  if (section != nullptr) {
    reading.check_keys(*section, {"angles", "lengths"}, "[unknowns]");
    for (const toml::key* key : reading.keys_in_order(*section)) {
      const toml::array* names = reading.array(*section, std::string(key->str()));
      if (names == nullptr) continue;
      for (const toml::node& node : *names) {
        const auto name = node.is_string() ? node.value<std::string>() : std::nullopt;
        if (!name) {
          reading.fault(node, "an unknown must be a name in quotes, not " + kind_of(node));
          continue;
        }
        check_new_name(reading, mechanism, *name, reading.position(node));
        mechanism.unknowns.push_back({*name, key->str() == "angles", reading.position(node)});
      }
    }
  }
  if (mechanism.unknowns.empty() && !document.contains("unknowns")) {
    reading.fault(SourcePosition{},
                  "equations need [unknowns] with angles = [...] and lengths = [...]");
  } else if (mechanism.unknowns.empty() && reading.faults().empty()) {
    reading.fault(*document.get("unknowns"),
                  "[unknowns] names none; write angles = [...] or lengths = [...]");
  }
}

/// Plain numbers; those in [constants.angles] are in the file's unit of angle.
void read_constants(Reading& reading, const toml::table& section, double unit,
                    Mechanism& mechanism) {
  for (const toml::key* key : reading.keys_in_order(section)) {
    const std::string name(key->str());
    const toml::node& node = *section.get(name);
    if (name == "angles" && node.is_table()) {
      read_constants(reading, *node.as_table(), angle_unit(mechanism), mechanism);
      continue;
    }
    check_new_name(reading, mechanism, name, reading.position(key->source().begin));
    // A constant without a value is declared all the same, so that its uses are no further faults.
    const auto value = reading.number(node, "constant '" + name + "'");
    mechanism.constants[name] = value.value_or(0) * unit;
  }
}

Names names_of(const Mechanism& mechanism) {
  Names names;
  for (const Unknown& unknown : mechanism.unknowns)
    names.unknowns.emplace(unknown.name, names.unknowns.size());
  names.constants = mechanism.constants;
  return names;
}

void check_every_unknown_occurs(Reading& reading, const Mechanism& mechanism) {
  std::set<std::size_t> used;
  for (const Equation& equation : mechanism.equations) {
    const auto own = unknowns_of(equation.formula);
    used.insert(own.begin(), own.end());
  }
  for (std::size_t k = 0; k < mechanism.unknowns.size(); ++k) {
    if (used.count(k) != 0) continue;
    const Unknown& unknown = mechanism.unknowns[k];
    reading.fault(unknown.where,
                  "no equation contains '" + unknown.name + "'; remove it or write its equation");
  }
}

}  // namespace

void read_equations(Reading& reading, const toml::table& document, Mechanism& mechanism) {
  const std::size_t faults_before = reading.faults().size();
  read_unknowns(reading, document, mechanism);
  if (const toml::table* constants = reading.table(document, "constants")) {
    read_constants(reading, *constants, 1, mechanism);
  }
  const toml::table* section = reading.table(document, "equations");
  if (section == nullptr || section->empty()) {
    if (section != nullptr || !document.contains("equations")) {
      reading.fault(SourcePosition{}, "unknowns need [equations], each name = \"expression\"");
    }
    return;
  }
  const Names names = names_of(mechanism);
  for (const toml::key* key : reading.keys_in_order(*section)) {
    const std::string name(key->str());
    const toml::node& node = *section->get(name);
    const auto text = reading.text(*section, name);
    if (!text) continue;
    const std::size_t before = reading.faults().size();
    const auto expression = read_expression(reading, node, *text);
    if (!expression) check_names(reading, node, *text, names);
    const auto formula = expression ? read_formula(reading, *expression, names) : std::nullopt;
    reading.place_faults(node, *text, before);
    if (!formula) continue;
    mechanism.equations.push_back({name, *expression, *formula, reading.position(node)});
  }
  if (reading.faults().size() == faults_before) check_every_unknown_occurs(reading, mechanism);
}

}  // namespace moivre
