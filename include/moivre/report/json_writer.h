// SPDX-License-Identifier: MIT
// How is a long JSON report written without holding all of it? Member by member, in the order of
// the calls.
//
// The layout is that of to_text (json.h): one key a line, and one element a line in lists of
// objects; what is deeper stands on one line. Text goes on in pieces of some tens of kilobytes. For
// modules that report. Including it needs nlohmann-json.
#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "moivre/report/json.h"
#include "moivre/report/text_sink.h"

namespace moivre {

class JsonWriter {
 public:
  /// A member of the object that is open.
  void member(std::string_view key, const Json& value);
  /// Each member of `object`.
  void members(const Json& object);

  /// A member that is a list: `element` of each item, a JSON object. One is held at a time.
  template <class List, class Element>
  void list(std::string_view key, const List& items, Element element) {
    open_list(key);
    for (const auto& item : items) add_element(element(item));
    close();
  }

  /// A member that is a list of objects too long to be held: `write(item)` writes the members of
  /// one.
  template <class List, class Write>
  void long_list(std::string_view key, const List& items, Write write) {
    open_list(key);
    for (const auto& item : items) {
      open_element();
      write(item);
      close();
    }
    close();
  }

 private:
  friend void write_json(const TextSink& sink, const std::function<void(JsonWriter&)>& write);

  /// What is open: an object or a list.
  struct Level {
    char closing;
    bool is_empty = true;
  };

  explicit JsonWriter(const TextSink& sink) : sink_(sink) {}
  void open(char opening, char closing);
  void open_list(std::string_view key);
  void open_element();
  void add_element(const Json& value);
  void close();
  void separate();
  void write_key(std::string_view key);
  void send_piece();

  const TextSink& sink_;
  std::vector<Level> levels_;
  std::string text_;  ///< what is not sent yet
};

/// A whole report: `write` writes the members of its object.
void write_json(const TextSink& sink, const std::function<void(JsonWriter&)>& write);

}  // namespace moivre
