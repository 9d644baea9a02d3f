// SPDX-License-Identifier: MIT
// How is a value taken out of JSON that may be anything? By its place and its kind; what is wrong
// is noted, and reading goes on.
#pragma once

#include <cstdint>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

namespace moivre {

using JsonValue = nlohmann::json;

/// A value and where it stands, as in "solutions[3].x".
class JsonPlace {
 public:
  JsonPlace(const JsonValue& value, std::string name, std::vector<std::string>& faults)
      : value_(&value), name_(std::move(name)), faults_(&faults) {}

  const JsonValue& value() const { return *value_; }
  /// Missing and null are the same: nullopt, noted where it is required.
  std::optional<JsonPlace> member(const char* key, bool required = false) const;
  JsonPlace element(std::size_t k) const;
  /// 0 where it is no list.
  std::size_t size() const { return value_->is_array() ? value_->size() : 0; }

  bool is_object() const;
  bool is_list() const;
  std::uint64_t count() const;  ///< 0 where it is none
  double number() const;
  bool flag() const;
  std::string text() const;
  std::vector<std::uint64_t> counts() const;
  std::vector<std::string> texts() const;

  void fault(const std::string& message) const;
  /// One that was found elsewhere, with its place.
  void note(const std::string& fault) const { faults_->push_back(fault); }

 private:
  /// Notes a value that is not what was expected.
  bool expect(bool is_kind, const char* kind) const;

  const JsonValue* value_;
  std::string name_;
  std::vector<std::string>* faults_;
};

}  // namespace moivre
