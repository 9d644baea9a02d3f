// SPDX-License-Identifier: MIT
// Values of JSON by kind, with a note for each that is of another.
#include "json_reader.h"

namespace moivre {

void JsonPlace::fault(const std::string& message) const {
  faults_->push_back((name_.empty() ? "the file" : name_) + ": " + message);
}

bool JsonPlace::expect(bool is_kind, const char* kind) const {
  if (!is_kind) fault(std::string("expected ") + kind + ", found " + value_->type_name());
  return is_kind;
}

std::optional<JsonPlace> JsonPlace::member(const char* key, bool required) const {
  const std::string place = name_.empty() ? key : name_ + '.' + key;
  if (value_->is_object()) {
    const auto found = value_->find(key);
    if (found != value_->end() && !found->is_null()) return JsonPlace(*found, place, *faults_);
  }
  if (required) faults_->push_back(place + ": missing");
  return std::nullopt;
}

JsonPlace JsonPlace::element(std::size_t k) const {
  return {(*value_)[k], name_ + '[' + std::to_string(k) + ']', *faults_};
}

bool JsonPlace::is_object() const { return expect(value_->is_object(), "an object"); }
bool JsonPlace::is_list() const { return expect(value_->is_array(), "a list"); }

std::uint64_t JsonPlace::count() const {
  return expect(value_->is_number_unsigned(), "a whole number from 0")
             ? value_->get<std::uint64_t>()
             : 0;
}

double JsonPlace::number() const {
  return expect(value_->is_number(), "a number") ? value_->get<double>() : 0;
}

bool JsonPlace::flag() const {
  return expect(value_->is_boolean(), "true or false") && value_->get<bool>();
}

std::string JsonPlace::text() const {
  return expect(value_->is_string(), "a text") ? value_->get<std::string>() : "";
}

std::vector<std::uint64_t> JsonPlace::counts() const {
  std::vector<std::uint64_t> list;
  if (!is_list()) return list;
  for (std::size_t k = 0; k < size(); ++k) list.push_back(element(k).count());
  return list;
}

std::vector<std::string> JsonPlace::texts() const {
  std::vector<std::string> list;
  if (!is_list()) return list;
  for (std::size_t k = 0; k < size(); ++k) list.push_back(element(k).text());
  return list;
}

}  // namespace moivre
