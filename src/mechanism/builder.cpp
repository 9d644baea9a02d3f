// SPDX-License-Identifier: MIT
// How is each part of a mechanism written as a section of its file?
#include "moivre/mechanism/builder.h"

#include <charconv>
#include <cmath>

#include "moivre/mechanism/read.h"
#include "names.h"

namespace moivre {
namespace {

bool is_control(char c) { return static_cast<unsigned char>(c) < 0x20 || c == 0x7F; }

/// A basic string of TOML.
std::string in_quotes(const std::string& word) {
  constexpr const char* kHex = "0123456789ABCDEF";
  std::string text = "\"";
  for (const char c : word) {
    const auto byte = static_cast<unsigned char>(c);
    if (c == '"' || c == '\\') {
      text += '\\';
      text += c;
    } else if (is_control(c)) {
      text += std::string("\\u00") + kHex[byte >> 4U] + kHex[byte & 0xFU];
    } else {
      text += c;
    }
  }
  return text + '"';
}

std::string key_text(const std::string& key) { return is_name(key) ? key : in_quotes(key); }

std::string line(const std::string& key, const FileValue& value) {
  return key_text(key) + " = " + value.text() + '\n';
}

std::string lines(const FileKeys& settings) {
  std::string text;
  for (const auto& [key, value] : settings) text += line(key, value);
  return text;
}

std::string body_text(const std::string& header, const std::vector<NamedPoint>& points,
                      const FileKeys& settings) {
  std::string text;
  if (!settings.empty()) text += "[" + header + "]\n" + lines(settings);
  text += "[" + header + ".points]\n";
  for (const auto& [name, place] : points) text += line(name, place);
  return text;
}

}  // namespace

std::string FileValue::of_number(double number) {
  if (std::isnan(number)) return "nan";
  if (std::isinf(number)) return number < 0 ? "-inf" : "inf";
  char text[32];
  const std::to_chars_result end = std::to_chars(text, text + sizeof text, number);
  return {static_cast<const char*>(text), static_cast<const char*>(end.ptr)};
}

std::string FileValue::of_word(const std::string& word) { return in_quotes(word); }

std::string FileValue::of_list(const std::vector<FileValue>& list) {
  std::string text = "[";
  for (std::size_t k = 0; k < list.size(); ++k) text += (k == 0 ? "" : ", ") + list[k].text();
  return text + "]";
}

MechanismBuilder::MechanismBuilder(const std::string& title, Space space) {
  if (!title.empty()) head_ += line("title", title);
  if (space == Space::spatial) head_ += line("space", "spatial");
}

MechanismBuilder& MechanismBuilder::units(const std::string& length, const std::string& angle) {
  head_ += "units = { " + (length.empty() ? "" : "length = " + in_quotes(length) + ", ") +
           "angle = " + in_quotes(angle) + " }\n";
  return *this;
}

MechanismBuilder& MechanismBuilder::set(const std::string& key, const FileValue& value) {
  head_ += line(key, value);
  return *this;
}

MechanismBuilder& MechanismBuilder::ground(const std::vector<NamedPoint>& points,
                                           const FileKeys& settings) {
  bodies_ += body_text("ground", points, settings);
  return *this;
}

MechanismBuilder& MechanismBuilder::body(const std::string& name,
                                         const std::vector<NamedPoint>& points,
                                         const FileKeys& settings) {
  bodies_ += body_text("body." + key_text(name), points, settings);
  return *this;
}

MechanismBuilder& MechanismBuilder::joint(const std::string& type,
                                          const std::pair<std::string, std::string>& between,
                                          const FileKeys& settings) {
  const bool names_points = between.first.find('.') != std::string::npos;
  joints_ += "[[joint]]\n" + line("type", type) +
             line(names_points ? "at" : "bodies", {between.first, between.second}) +
             lines(settings);
  return *this;
}

MechanismBuilder& MechanismBuilder::driver(const std::string& drives, const FileValue& of,
                                           const FileKeys& settings) {
  drivers_ += "[[driver]]\n" + line(drives, of) + lines(settings);
  return *this;
}

MechanismBuilder& MechanismBuilder::guess(const std::string& coordinate, double value) {
  guess_ += in_quotes(coordinate) + " = " + FileValue(value).text() + '\n';
  return *this;
}

MechanismBuilder& MechanismBuilder::unknowns(const std::vector<std::string>& angles,
                                             const std::vector<std::string>& lengths) {
  const auto list = [](const std::vector<std::string>& names) {
    return FileValue(std::vector<FileValue>(names.begin(), names.end()));
  };
  unknowns_ += line("angles", list(angles)) + line("lengths", list(lengths));
  return *this;
}

MechanismBuilder& MechanismBuilder::constant(const std::string& name, double value) {
  constants_ += line(name, value);
  return *this;
}

MechanismBuilder& MechanismBuilder::equation(const std::string& name,
                                             const std::string& expression) {
  equations_ += line(name, expression);
  return *this;
}

std::string MechanismBuilder::text() const {
  const auto section = [](const char* header, const std::string& content) {
    return content.empty() ? "" : header + content;
  };
  return head_ + bodies_ + joints_ + section("[unknowns]\n", unknowns_) +
         section("[constants]\n", constants_) + section("[equations]\n", equations_) + drivers_ +
         section("[guess]\n", guess_);
}

Mechanism MechanismBuilder::build() const { return read_mechanism_in_code(text()); }

}  // namespace moivre
