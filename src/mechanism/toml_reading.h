// SPDX-License-Identifier: MIT
// What stands in this TOML table? Typed look-ups that note every fault with its place instead of
// stopping.
#pragma once

#include <toml++/toml.h>

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "moivre/expression/expression.h"
#include "moivre/mechanism/formula.h"
#include "names.h"

namespace moivre {

class Reading {
 public:
  explicit Reading(const Source& source);

  const Source& source() const { return source_; }
  std::vector<Diagnostic>& faults() { return faults_; }
  void fault(const SourcePosition& at, const std::string& message);
  void fault(const toml::node& at, const std::string& message);
  SourcePosition position(const toml::source_position& at) const;
  SourcePosition position(const toml::node& node) const;

  /// Faults of keys that are not `known`; `what` names the table ("a joint"), `called` has advice
  /// on words that others use.
  void check_keys(const toml::table& table, const std::vector<std::string>& known,
                  const std::string& what, const std::map<std::string, std::string>& called = {});
  /// Keys in the order of the file.
  std::vector<const toml::key*> keys_in_order(const toml::table& table) const;

  /// Nothing where the key is absent; nothing and a fault where its value is of another kind (or
  /// not finite).
  const toml::table* table(const toml::table& in, const std::string& key);
  const toml::array* array(const toml::table& in, const std::string& key);
  std::optional<double> number(const toml::table& in, const std::string& key);
  std::optional<bool> truth(const toml::table& in, const std::string& key);
  std::optional<std::string> text(const toml::table& in, const std::string& key);
  std::optional<std::vector<std::string>> texts(const toml::table& in, const std::string& key,
                                                std::size_t count, const std::string& example);
  std::optional<std::vector<double>> numbers(const toml::table& in, const std::string& key,
                                             std::size_t count);
  /// A finite number, or a fault; `what` names it.
  std::optional<double> number(const toml::node& node, const std::string& what);
  /// `count` finite numbers in an array, or a fault.
  std::optional<std::vector<double>> numbers(const toml::node& node, const std::string& what,
                                             std::size_t count);

  /// Some number has more digits than a double holds, and was rounded.
  bool has_rounded_numbers() const { return has_rounded_numbers_; }

  /// Where the characters of a string value begin in the file: behind the quote, where they stand
  /// there as they are.
  SourcePosition text_begin(const toml::node& node, const std::string& value) const;
  /// Faults found in a string value since there were `before` of them: where the file has the
  /// string with escapes or over several lines, places inside it are not known, and they point to
  /// its beginning.
  void place_faults(const toml::node& node, const std::string& value, std::size_t before);

 private:
  std::string comma_advice(const toml::array& entries, std::size_t count) const;
  bool stands_as_it_is(const toml::node& node, const std::string& value) const;

  /// The digits of the number as it stands in the file are not those of its double.
  bool is_rounded(const toml::node& node, double value) const;

  const Source& source_;
  bool has_rounded_numbers_ = false;
  std::vector<std::size_t> line_offsets_;
  std::vector<Diagnostic> faults_;
};

/// "a string", "a number", ...
std::string kind_of(const toml::node& node);

}  // namespace moivre
