// SPDX-License-Identifier: MIT
// How are values taken from a TOML table? With a fault, its place and what was expected, where they
// do not fit.
#include "toml_reading.h"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>

#include "moivre/expression/counted.h"
#include "moivre/mechanism/mechanism.h"
#include "moivre/mechanism/nearest.h"

namespace moivre {

namespace {

/// Of a decimal number, without zeros before and behind. Other notations, 0x10, have few digits:
/// none.
std::string digits_of(const std::string& text) {
  std::string digits;
  for (const char c : text) {
    if (c == 'e' || c == 'E') break;
    if (c < '0' || c > '9') continue;
    if (c != '0' || !digits.empty()) digits += c;
  }
  digits.erase(digits.find_last_not_of('0') + 1);
  // With up to so many digits programs write doubles.
  constexpr std::size_t kSureDigits = 17;
  return digits.size() <= kSureDigits ? "" : digits;
}

std::string shortest_text(double value) {
  constexpr std::size_t kLongestDouble = 32;
  char text[kLongestDouble];
  return {text, std::to_chars(text, text + sizeof text, value, std::chars_format::scientific).ptr};
}

}  // namespace

Reading::Reading(const Source& source) : source_(source), line_offsets_{0} {
  for (std::size_t k = 0; k < source.text.size(); ++k) {
    if (source.text[k] == '\n') line_offsets_.push_back(k + 1);
  }
}

void Reading::fault(const SourcePosition& at, const std::string& message) {
  faults_.push_back({at, message});
}

void Reading::fault(const toml::node& at, const std::string& message) {
  fault(position(at), message);
}

// toml++ counts columns in code points; a SourcePosition counts bytes.
SourcePosition Reading::position(const toml::source_position& at) const {
  SourcePosition result;
  if (at.line == 0 || at.line > line_offsets_.size()) return result;
  result.line = at.line;
  result.offset = line_offsets_[at.line - 1];
  std::size_t points = 1;
  while (points < at.column && result.offset < source_.text.size() &&
         source_.text[result.offset] != '\n') {
    const auto is_continuation = [&](std::size_t k) {
      return k < source_.text.size() &&
             (static_cast<unsigned char>(source_.text[k]) & 0xC0U) == 0x80U;
    };
    ++result.offset;
    while (is_continuation(result.offset)) ++result.offset;
    ++points;
  }
  result.column = result.offset - line_offsets_[at.line - 1] + 1;
  return result;
}

SourcePosition Reading::position(const toml::node& node) const {
  return position(node.source().begin);
}

std::vector<const toml::key*> Reading::keys_in_order(const toml::table& table) const {
  std::vector<const toml::key*> keys;
  for (const auto& [key, value] : table) keys.push_back(&key);
  std::stable_sort(keys.begin(), keys.end(), [](const toml::key* a, const toml::key* b) {
    return a->source().begin < b->source().begin;
  });
  return keys;
}

void Reading::check_keys(const toml::table& table, const std::vector<std::string>& known,
                         const std::string& what,
                         const std::map<std::string, std::string>& called) {
  for (const toml::key* key : keys_in_order(table)) {
    const std::string name(key->str());
    if (std::find(known.begin(), known.end(), name) != known.end()) continue;
    const auto advice = called.find(name);
    fault(position(key->source().begin),
          "unknown key '" + name + "' in " + what +
              (advice == called.end() ? suggestion(name, known) : "; " + advice->second));
  }
}

const toml::table* Reading::table(const toml::table& in, const std::string& key) {
  const toml::node* node = in.get(key);
  if (node == nullptr) return nullptr;
  if (node->is_table()) return node->as_table();
  fault(*node, "'" + key + "' must be a table, [" + key + "], not " + kind_of(*node));
  return nullptr;
}

const toml::array* Reading::array(const toml::table& in, const std::string& key) {
  const toml::node* node = in.get(key);
  if (node == nullptr) return nullptr;
  if (node->is_array()) return node->as_array();
  const std::string advice = node->is_table() ? "; write [[" + key + "]] above each" : "";
  fault(*node, "'" + key + "' must be an array, not " + kind_of(*node) + advice);
  return nullptr;
}

std::optional<double> Reading::number(const toml::node& node, const std::string& what) {
  const auto value = node.is_number() ? node.value<double>() : std::nullopt;
  if (!value) {
    const std::string advice = node.is_string() ? "; numbers stand without quotes and units" : "";
    fault(node, what + " must be a number, not " + kind_of(node) + advice);
    return std::nullopt;
  }
  if (!std::isfinite(*value)) {
    fault(node, what + " must be finite, not inf or nan");
    return std::nullopt;
  }
  if (!is_workable(*value)) {
    fault(node, what + " must not be beyond 1e50; choose another unit");
    return std::nullopt;
  }
  has_rounded_numbers_ = has_rounded_numbers_ || is_rounded(node, *value);
  return value;
}

bool Reading::is_rounded(const toml::node& node, double value) const {
  const std::size_t begin = position(node).offset;
  const std::size_t end = source_.text.find_first_not_of("0123456789.+-_eE", begin);
  const std::string typed = digits_of(source_.text.substr(begin, end - begin));
  return !typed.empty() && typed != digits_of(shortest_text(value));
}

std::optional<double> Reading::number(const toml::table& in, const std::string& key) {
  const toml::node* node = in.get(key);
  return node == nullptr ? std::nullopt : number(*node, "'" + key + "'");
}

std::optional<bool> Reading::truth(const toml::table& in, const std::string& key) {
  const toml::node* node = in.get(key);
  if (node == nullptr) return std::nullopt;
  if (node->is_boolean()) return node->value<bool>();
  fault(*node, "'" + key + "' must be true or false, not " + kind_of(*node));
  return std::nullopt;
}

std::optional<std::string> Reading::text(const toml::table& in, const std::string& key) {
  const toml::node* node = in.get(key);
  if (node == nullptr) return std::nullopt;
  if (node->is_string()) return node->value<std::string>();
  fault(*node, "'" + key + "' must be a string, not " + kind_of(*node));
  return std::nullopt;
}

std::optional<std::vector<std::string>> Reading::texts(const toml::table& in,
                                                       const std::string& key, std::size_t count,
                                                       const std::string& example) {
  const toml::node* node = in.get(key);
  if (node == nullptr) return std::nullopt;
  std::vector<std::string> values;
  if (const toml::array* entries = node->as_array()) {
    for (const toml::node& entry : *entries) {
      if (const auto value = entry.is_string() ? entry.value<std::string>() : std::nullopt) {
        values.push_back(*value);
      }
    }
    if (values.size() == count && entries->size() == count) return values;
  }
  fault(*node, "'" + key + "' must be an array of " + std::to_string(count) + " strings, such as " +
                   example);
  return std::nullopt;
}

std::optional<std::vector<double>> Reading::numbers(const toml::node& node, const std::string& what,
                                                    std::size_t count) {
  const toml::array* entries = node.as_array();
  if (entries == nullptr || entries->size() != count) {
    fault(node, what + " must be " + counted(count, "number") + " in brackets, not " +
                    (entries == nullptr ? kind_of(node)
                                        : std::to_string(entries->size()) + " entries" +
                                              comma_advice(*entries, count)));
    return std::nullopt;
  }
  std::vector<double> values;
  for (const toml::node& entry : *entries) {
    if (const auto value = number(entry, "an entry of " + what)) values.push_back(*value);
  }
  if (values.size() != count) return std::nullopt;
  return values;
}

std::optional<std::vector<double>> Reading::numbers(const toml::table& in, const std::string& key,
                                                    std::size_t count) {
  const toml::node* node = in.get(key);
  return node == nullptr ? std::nullopt : numbers(*node, "'" + key + "'", count);
}

bool Reading::stands_as_it_is(const toml::node& node, const std::string& value) const {
  const std::size_t behind_quote = position(node).offset + 1;
  return value.find('\n') == std::string::npos && behind_quote <= source_.text.size() &&
         source_.text.compare(behind_quote, value.size(), value) == 0;
}

SourcePosition Reading::text_begin(const toml::node& node, const std::string& value) const {
  SourcePosition at = position(node);
  if (stands_as_it_is(node, value)) {
    ++at.offset;
    ++at.column;
  }
  return at;
}

void Reading::place_faults(const toml::node& node, const std::string& value, std::size_t before) {
  if (stands_as_it_is(node, value)) return;
  for (std::size_t k = before; k < faults_.size(); ++k) faults_[k].at = position(node);
}

/// Advice where a comma stands between two digits, as decimals are written in half the world.
std::string Reading::comma_advice(const toml::array& entries, std::size_t count) const {
  if (entries.size() <= count) return "";
  const std::size_t begin = position(entries).offset;
  const std::size_t end = std::min(source_.text.find(']', begin), source_.text.size());
  const auto is_digit_at = [&](std::size_t k) {
    return k < end && std::isdigit(static_cast<unsigned char>(source_.text[k])) != 0;
  };
  for (std::size_t k = begin + 1; k < end; ++k) {
    if (source_.text[k] != ',' || !is_digit_at(k - 1) || !is_digit_at(k + 1)) continue;
    std::size_t first = k;
    while (is_digit_at(first - 1)) --first;
    std::size_t last = k + 1;
    while (is_digit_at(last)) ++last;
    std::string meant = source_.text.substr(first, last - first);
    const std::string written = meant;
    meant[k - first] = '.';
    return "; decimals have a point: " + meant + ", not " + written;
  }
  return "";
}

std::string kind_of(const toml::node& node) {
  if (node.is_table()) return "a table";
  if (node.is_array()) return "an array";
  if (node.is_string()) return "a string";
  if (node.is_number()) return "a number";
  if (node.is_boolean()) return "true or false";
  return "a date or time";
}

}  // namespace moivre
