// SPDX-License-Identifier: MIT
// Where is a fault in a mechanism that a program wrote? In a section and its key, since nobody has
// seen the text's lines.
#include <map>
#include <string_view>
#include <vector>

#include "moivre/expression/words.h"
#include "moivre/mechanism/read.h"

namespace moivre {
namespace {

/// A section as its text goes on: what it is called, and what its first keys say of it.
struct Section {
  std::string name;    ///< "body 'crank'", "joint 2"
  std::string key_is;  ///< what its keys are: "point"; empty: keys of the file format
  std::string type, at;
};

/// Names in it as they were given: a quote or backslash of theirs has one before it in the text.
std::string without_quotes(std::string_view text) {
  std::string bare;
  bool is_escaped = false;
  for (const char c : trimmed(text)) {
    const bool is_of_name = c != '"' && c != '\\';
    if (is_escaped && is_of_name) bare += '\\';
    if (is_escaped || is_of_name) bare += c;
    is_escaped = !is_escaped && c == '\\';
  }
  return bare;
}

/// "body.crank.points", the inside of a header.
Section section_of(std::string_view header, bool is_list, std::map<std::string, int>& counts) {
  const std::string path = without_quotes(header);
  if (is_list) return {path + " " + std::to_string(++counts[path]), "", "", ""};
  constexpr std::string_view kPoints = ".points", kBody = "body.";
  const bool has_points = path.ends_with(kPoints);
  const std::string owner = has_points ? path.substr(0, path.size() - kPoints.size()) : path;
  const std::string key_is = has_points ? "point" : "";
  if (owner.starts_with(kBody)) {
    return {"body '" + owner.substr(kBody.size()) + "'", key_is, "", ""};
  }
  return {owner, key_is, "", ""};
}

/// "joint 2 (revolute at [crank.B, coupler.B])".
std::string called(const Section& section) {
  if (section.type.empty() && section.at.empty()) return section.name;
  const std::string between = section.type.empty() || section.at.empty() ? "" : " ";
  return section.name + " (" + section.type + between + section.at + ")";
}

/// Where each line of a text is, in words; empty in front of all sections where it has no key.
std::vector<std::string> places_in(std::string_view text) {
  std::map<std::string, int> counts;
  std::vector<Section> sections{Section{}};
  struct Line {
    std::size_t section;
    std::string key;
  };
  std::vector<Line> lines;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    const std::string_view line = trimmed(text.substr(0, end));
    text.remove_prefix(std::min(end + 1, text.size()));
    const bool is_list = line.starts_with("[[");
    if (line.starts_with("[")) {
      const std::size_t edge = is_list ? 2 : 1;
      const std::size_t inside = line.size() < 2 * edge ? 0 : line.size() - 2 * edge;
      sections.push_back(section_of(line.substr(edge, inside), is_list, counts));
      lines.push_back({sections.size() - 1, ""});
      continue;
    }
    const std::size_t equals = std::min(line.find(" = "), line.size());
    const std::string key = without_quotes(line.substr(0, equals));
    const std::string value = equals == line.size() ? "" : without_quotes(line.substr(equals + 3));
    Section& section = sections.back();
    const bool is_listed = counts.contains(section.name.substr(0, section.name.find(' ')));
    if (is_listed && key == "type") section.type = value;
    if (is_listed && (key == "at" || key == "bodies")) section.at = "at " + value;
    lines.push_back({sections.size() - 1, key});
  }
  std::vector<std::string> places;
  for (const Line& line : lines) {
    const Section& section = sections[line.section];
    const std::string what = called(section);
    const std::string key =
        line.key.empty()
            ? ""
            : (section.key_is.empty() ? "" : section.key_is + " ") + "'" + line.key + "'";
    places.push_back(what + (what.empty() || key.empty() ? "" : ", ") + key);
  }
  return places;
}

}  // namespace

Mechanism read_mechanism_in_code(const std::string& text) {
  try {
    return read_mechanism({"mechanism", text});
  } catch (const ParseError& refusal) {
    const std::vector<std::string> places = places_in(text);
    std::vector<std::string> rules;
    for (const Diagnostic& fault : refusal.diagnostics()) {
      const std::size_t line = fault.at.line - 1;
      // A fault at the very beginning is of the whole mechanism.
      const bool is_anywhere = fault.at.offset == 0 || line >= places.size();
      const std::string place = is_anywhere ? "" : places[line];
      rules.push_back(place + (place.empty() ? "" : ": ") + fault.message);
    }
    throw InvalidInput(rules);
  }
}

}  // namespace moivre
