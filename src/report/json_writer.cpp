// SPDX-License-Identifier: MIT
// The layout of JSON reports: lines for the members of the report and the elements of its lists of
// objects, none deeper.
#include "moivre/report/json_writer.h"

namespace moivre {
namespace {

constexpr std::size_t kPiece = 1 << 16;    ///< bytes that are sent at once, or more
constexpr std::size_t kLevelsInLines = 2;  ///< the report, and its lists of objects

/// Bytes that are not UTF-8 are replaced.
std::string on_one_line(const Json& value) {
  return value.dump(-1, ' ', false, Json::error_handler_t::replace);
}

bool is_list_of_objects(const Json& value) {
  return value.is_array() && !value.empty() && value.front().is_object();
}

}  // namespace

void JsonWriter::member(std::string_view key, const Json& value) {
  if (levels_.size() == 1 && is_list_of_objects(value)) {
    open_list(key);
    for (const Json& element : value) add_element(element);
    close();
    return;
  }
  write_key(key);
  text_ += on_one_line(value);
  send_piece();
}

void JsonWriter::members(const Json& object) {
  for (const auto& [key, value] : object.items()) member(key, value);
}

void JsonWriter::add_element(const Json& value) {
  separate();
  text_ += on_one_line(value);
  send_piece();
}

void JsonWriter::open(char opening, char closing) {
  text_ += opening;
  levels_.push_back({closing});
}

void JsonWriter::open_list(std::string_view key) {
  write_key(key);
  open('[', ']');
}

void JsonWriter::open_element() {
  separate();
  open('{', '}');
}

void JsonWriter::close() {
  const Level level = levels_.back();
  const std::size_t depth = levels_.size();
  levels_.pop_back();
  if (depth <= kLevelsInLines && !level.is_empty) text_ += '\n' + std::string(2 * (depth - 1), ' ');
  text_ += level.closing;
  send_piece();
}

void JsonWriter::separate() {
  if (!levels_.back().is_empty) text_ += ',';
  levels_.back().is_empty = false;
  const std::size_t depth = levels_.size();
  if (depth <= kLevelsInLines) text_ += '\n' + std::string(2 * depth, ' ');
}

void JsonWriter::write_key(std::string_view key) {
  separate();
  text_ += on_one_line(Json(key)) + (levels_.size() == 1 ? ": " : ":");
}

void JsonWriter::send_piece() {
  if (text_.size() < kPiece) return;
  sink_(text_);
  text_.clear();
}

void write_json(const TextSink& sink, const std::function<void(JsonWriter&)>& write) {
  JsonWriter report(sink);
  report.open('{', '}');
  write(report);
  report.close();
  report.text_ += '\n';
  sink(report.text_);
}

}  // namespace moivre
