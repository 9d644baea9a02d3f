// SPDX-License-Identifier: MIT
// How is a mechanism put together in code? By names, with the keys of a mechanism file; the reader
// of files checks it.
//
//   MechanismBuilder m("Four-bar");
//   m.units("mm", "deg");
//   m.ground({{"A", {0, 0}}, {"D", {100, 0}}});
//   m.body("crank", {{"A", {0, 0}}, {"B", {40, 0}}});
//   m.joint("revolute", {"ground.A", "crank.A"});
//   m.driver("angle", "crank", {{"start", 40}, {"velocity", 360}});
//   const Mechanism mechanism = m.build();
//
// What is built is a mechanism file (text()), read by read_mechanism(): every key of
// docs/mechanism-file.md may stand in the lists of settings, and every rule is the reader's.
// Numbers are written with as many digits as it takes to read them back.
#pragma once

#include <concepts>
#include <initializer_list>
#include <string>
#include <utility>
#include <vector>

#include "moivre/mechanism/mechanism.h"

namespace moivre {

/// A number, a word, true or false, or a list of these, as it stands in a mechanism file.
class FileValue {
 public:
  template <std::integral I>
  requires(!std::same_as<I, bool>) FileValue(I whole) : text_(std::to_string(whole)) {}
  template <std::floating_point F>
  FileValue(F number) : text_(of_number(static_cast<double>(number))) {}
  template <std::same_as<bool> B>
  FileValue(B truth) : text_(truth ? "true" : "false") {}
  FileValue(const char* word) : text_(of_word(word)) {}
  FileValue(const std::string& word) : text_(of_word(word)) {}
  FileValue(std::initializer_list<FileValue> list)
      : text_(of_list(std::vector<FileValue>(list.begin(), list.end()))) {}
  FileValue(const std::vector<double>& list)
      : text_(of_list(std::vector<FileValue>(list.begin(), list.end()))) {}
  FileValue(const std::vector<FileValue>& list) : text_(of_list(list)) {}

  const std::string& text() const { return text_; }

 private:
  static std::string of_number(double number);
  static std::string of_word(const std::string& word);
  static std::string of_list(const std::vector<FileValue>& list);

  std::string text_;
};

/// Keys of a joint, a driver, ... with their values, in any order.
using FileKeys = std::vector<std::pair<std::string, FileValue>>;

/// A point's name, and where it is in its body: two numbers in the plane, three in space.
using NamedPoint = std::pair<std::string, std::vector<double>>;

class MechanismBuilder {
 public:
  explicit MechanismBuilder(const std::string& title = "", Space space = Space::planar);

  /// Default: none of length, radians.
  MechanismBuilder& units(const std::string& length, const std::string& angle);
  /// A key above all sections: fit, tolerance.
  MechanismBuilder& set(const std::string& key, const FileValue& value);

  MechanismBuilder& ground(const std::vector<NamedPoint>& points, const FileKeys& settings = {});
  MechanismBuilder& body(const std::string& name, const std::vector<NamedPoint>& points,
                         const FileKeys& settings = {});
  /// between: two points, "body.point"; of a gear, belt or cam-lever two bodies.
  MechanismBuilder& joint(const std::string& type,
                          const std::pair<std::string, std::string>& between,
                          const FileKeys& settings = {});
  /// drives: "angle", "slide", "x", "y", "z" or "unknown" of what is named; settings: its law.
  MechanismBuilder& driver(const std::string& drives, const FileValue& of,
                           const FileKeys& settings);
  MechanismBuilder& guess(const std::string& coordinate, double value);

  /// Of constraint equations instead of bodies: "r^2 - x*cos(phi)".
  MechanismBuilder& unknowns(const std::vector<std::string>& angles,
                             const std::vector<std::string>& lengths);
  MechanismBuilder& constant(const std::string& name, double value);
  MechanismBuilder& equation(const std::string& name, const std::string& expression);

  /// The mechanism file.
  std::string text() const;
  /// Throws InvalidInput with every broken rule and the body, point or joint that breaks it.
  Mechanism build() const;

 private:
  std::string head_, bodies_, joints_, drivers_, guess_, unknowns_, constants_, equations_;
};

}  // namespace moivre
