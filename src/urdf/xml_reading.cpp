// SPDX-License-Identifier: MIT
// How are values taken from XML? With a fault, its place and what was expected, where they do not
// fit.
#include "xml_reading.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "decimal.h"
#include "moivre/expression/utf8.h"
#include "moivre/expression/words.h"
#include "moivre/mechanism/nearest.h"

namespace moivre {
namespace {

/// Some forty bytes of memory stand for each byte of the smallest elements; no robot's tree needs a
/// megabyte.
constexpr std::size_t kLongestXml = 16'000'000;

std::string advice(pugi::xml_parse_status status) {
  static const std::map<pugi::xml_parse_status, std::string> sentences{
      {pugi::status_end_element_mismatch,
       "this end tag closes another element than the one that is open, or there is none open"},
      {pugi::status_bad_start_element,
       "an element begins badly here; a name follows '<', and attributes stand as name=\"value\""},
      {pugi::status_bad_attribute,
       "an attribute is written badly; they stand as name=\"value\", with blanks between"},
      {pugi::status_bad_end_element, "an end tag is written badly: </name>"},
      {pugi::status_bad_comment, "a comment does not end: <!-- ... -->"},
      {pugi::status_bad_cdata, "a CDATA section does not end: <![CDATA[ ... ]]>"},
      {pugi::status_bad_doctype, "a DOCTYPE does not end"},
      {pugi::status_bad_pi, "an XML declaration does not end: <?xml version=\"1.0\"?>"},
      {pugi::status_no_document_element,
       "there is no element; a URDF is <robot name=\"...\"> ... </robot>"},
      {pugi::status_unrecognized_tag, "this tag is none of XML's"}};
  const auto found = sentences.find(status);
  return found == sentences.end() ? "this is no XML" : found->second;
}

/// Whether a word of `known` is so near that it was meant; its name.
std::optional<std::string> meant(const std::string& word, const std::vector<std::string>& known) {
  const std::string text = suggestion(word, known);
  const std::string mark = "did you mean '";
  const std::size_t at = text.find(mark);
  if (at == std::string::npos) return std::nullopt;
  const std::size_t begin = at + mark.size();
  return text.substr(begin, text.find('\'', begin) - begin);
}

}  // namespace

XmlReading::XmlReading(const Source& source)
    : source_(source), parsed_(source.text), line_offsets_{0} {
  for (std::size_t k = 0; k < source.text.size(); ++k) {
    if (source.text[k] == '\n') line_offsets_.push_back(k + 1);
  }
  if (source.text.size() > kLongestXml) {
    throw ParseError(source, {{{}, "the file is longer than 16 MB, more than any robot's tree"}});
  }
  const std::size_t zero = source.text.find('\0');
  if (zero != std::string::npos) {
    throw ParseError(source, {{position(zero), "a zero byte stands here; a URDF is UTF-8 text"}});
  }
  const std::size_t stranger = first_no_utf8(source.text);
  if (stranger != std::string::npos) {
    throw ParseError(source, {{position(stranger),
                               "a byte that is no UTF-8 stands here; save the file as UTF-8"}});
  }
  const auto parsed =
      document_.load_buffer_inplace(parsed_.data(), parsed_.size(),
                                    pugi::parse_default | pugi::parse_doctype, pugi::encoding_utf8);
  if (!parsed) {
    // That nothing is there is reported at the beginning.
    const bool is_empty = parsed.status == pugi::status_no_document_element;
    const auto offset =
        is_empty ? 0 : static_cast<std::size_t>(std::max<std::ptrdiff_t>(parsed.offset, 0));
    throw ParseError(source, {{position(offset), advice(parsed.status)}});
  }
  for (const pugi::xml_node& node : document_.children()) {
    if (node.type() != pugi::node_doctype) continue;
    fault(source.text.find("<!DOCTYPE"),
          "a DOCTYPE is refused: its entities are not expanded, and a URDF needs none; remove it");
  }
}

SourcePosition XmlReading::position(std::size_t offset) const {
  offset = std::min(offset, source_.text.size());
  const auto behind = std::upper_bound(line_offsets_.begin(), line_offsets_.end(), offset);
  const auto line = static_cast<std::size_t>(behind - line_offsets_.begin());
  return {offset, line, offset - line_offsets_[line - 1] + 1};
}

/// Of the "<" of an element.
std::size_t XmlReading::offset_of(const pugi::xml_node& node) const {
  const auto name = static_cast<std::size_t>(std::max<std::ptrdiff_t>(node.offset_debug(), 1));
  return name - 1;
}

SourcePosition XmlReading::position(const pugi::xml_node& node) const {
  return position(offset_of(node));
}

void XmlReading::fault(std::size_t offset, const std::string& message) {
  faults_.push_back({position(offset), message});
}

void XmlReading::fault(const pugi::xml_node& at, const std::string& message) {
  fault(offset_of(at), message);
}

void XmlReading::fault(const pugi::xml_attribute& at, const std::string& message,
                       std::size_t within) {
  const auto name = static_cast<std::size_t>(at.name() - parsed_.data());
  const char* const value = at.value();
  const bool is_inside = value >= parsed_.data() && value < parsed_.data() + parsed_.size();
  if (!is_inside) return fault(name, message);
  const auto begin = static_cast<std::size_t>(value - parsed_.data());
  // Behind an escaped character the copy is shorter than the text.
  const bool is_as_typed = source_.text.compare(begin, within, value, within) == 0;
  fault(is_as_typed ? begin + within : begin, message);
}

pugi::xml_node XmlReading::only_child(const pugi::xml_node& in, const char* name) {
  const pugi::xml_node child = in.child(name);
  const pugi::xml_node second = child ? child.next_sibling(name) : pugi::xml_node();
  if (second) fault(second, std::string("a second <").append(name) + ">; remove one of them");
  return child;
}

std::optional<std::string> XmlReading::text(const pugi::xml_node& in, const char* attribute,
                                            const std::string& what) {
  const pugi::xml_attribute found = in.attribute(attribute);
  if (!found) {
    fault(in, what + std::string(" needs the attribute '").append(attribute) + "'");
    return std::nullopt;
  }
  if (trimmed(found.value()).empty()) {
    fault(found, what + std::string(" has an empty '").append(attribute) + "'");
    return std::nullopt;
  }
  return found.value();
}

std::optional<Rational> XmlReading::decimal(const pugi::xml_attribute& at, std::string_view word,
                                            std::size_t within) {
  Decimal decimal = read_decimal(word);
  if (decimal.refusal.empty() && !is_workable(to_double(decimal.value))) {
    decimal.refusal = std::string("'").append(at.name()) + "' must not be beyond 1e50";
  }
  if (decimal.refusal.empty()) return decimal.value;
  fault(at, decimal.refusal, within);
  return std::nullopt;
}

std::optional<ExactVector> XmlReading::vector(const pugi::xml_node& in, const char* attribute) {
  const pugi::xml_attribute found = in.attribute(attribute);
  if (!found) return std::nullopt;
  const std::string_view value = found.value();
  std::vector<std::optional<Rational>> numbers;
  std::size_t k = 0;
  while ((k = value.find_first_not_of(kBlanks, k)) != std::string_view::npos) {
    const std::size_t end = std::min(value.find_first_of(kBlanks, k), value.size());
    if (numbers.size() < 3) {
      numbers.push_back(decimal(found, value.substr(k, end - k), k));
    } else {
      numbers.emplace_back();
    }
    k = end;
  }
  if (numbers.size() != 3) {
    fault(found, std::string("'").append(attribute) +
                     "' must be three numbers with blanks between, not " +
                     std::to_string(numbers.size()));
    return std::nullopt;
  }
  if (!numbers[0] || !numbers[1] || !numbers[2]) return std::nullopt;
  return ExactVector{*numbers[0], *numbers[1], *numbers[2]};
}

std::optional<double> XmlReading::number(const pugi::xml_node& in, const char* attribute) {
  const pugi::xml_attribute found = in.attribute(attribute);
  if (!found) return std::nullopt;
  const std::string_view value = found.value();
  const std::string_view word = trimmed(value);
  const auto exact = decimal(found, word, static_cast<std::size_t>(word.data() - value.data()));
  if (!exact) return std::nullopt;
  return to_double(*exact);
}

void XmlReading::check_spelling(const pugi::xml_node& in, const std::vector<std::string>& children,
                                const std::vector<std::string>& attributes) {
  const auto is_known = [](const std::string& word, const std::vector<std::string>& known) {
    return std::find(known.begin(), known.end(), word) != known.end();
  };
  for (const pugi::xml_node& child : in.children()) {
    if (child.type() != pugi::node_element || is_known(child.name(), children)) continue;
    if (const auto name = meant(child.name(), children)) {
      fault(child, std::string("unknown element <").append(child.name()) + ">; did you mean <" +
                       *name + ">?");
    }
  }
  for (const pugi::xml_attribute& attribute : in.attributes()) {
    if (is_known(attribute.name(), attributes)) continue;
    if (const auto name = meant(attribute.name(), attributes)) {
      fault(attribute, std::string("unknown attribute '").append(attribute.name()) +
                           "'; did you mean '" + *name + "'?");
    }
  }
}

}  // namespace moivre
