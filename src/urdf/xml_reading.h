// SPDX-License-Identifier: MIT
// What stands in this XML element? Typed look-ups that note every fault with its place instead of
// stopping.
//
// pugixml parses a copy of the text in place, so that names and values are pointers into it: where
// they point is where they stand.
#pragma once

#include <optional>
#include <pugixml.hpp>
#include <string>
#include <vector>

#include "moivre/urdf/robot.h"

namespace moivre {

class XmlReading {
 public:
  /// Throws ParseError where the text is no XML that is taken.
  explicit XmlReading(const Source& source);
  XmlReading(const XmlReading&) = delete;
  XmlReading& operator=(const XmlReading&) = delete;

  const Source& source() const { return source_; }
  pugi::xml_node root() const { return document_.document_element(); }
  std::vector<Diagnostic>& faults() { return faults_; }

  void fault(std::size_t offset, const std::string& message);
  void fault(const pugi::xml_node& at, const std::string& message);
  /// At the attribute's value, at `within` bytes of it.
  void fault(const pugi::xml_attribute& at, const std::string& message, std::size_t within = 0);
  SourcePosition position(const pugi::xml_node& node) const;

  /// The child of that name; a second one is a fault.
  pugi::xml_node only_child(const pugi::xml_node& in, const char* name);
  /// The attribute's text; nothing and a fault where it is absent or empty. `what` has it ("a
  /// joint").
  std::optional<std::string> text(const pugi::xml_node& in, const char* attribute,
                                  const std::string& what);
  /// Nothing where the attribute is absent; nothing and faults where it is not three numbers.
  std::optional<ExactVector> vector(const pugi::xml_node& in, const char* attribute);
  /// Nothing where the attribute is absent; nothing and a fault where it is no number.
  std::optional<double> number(const pugi::xml_node& in, const char* attribute);
  /// A fault of every child whose name is nearly one of `known`, and of every attribute that is.
  void check_spelling(const pugi::xml_node& in, const std::vector<std::string>& children,
                      const std::vector<std::string>& attributes);

 private:
  SourcePosition position(std::size_t offset) const;
  std::size_t offset_of(const pugi::xml_node& node) const;
  std::optional<Rational> decimal(const pugi::xml_attribute& at, std::string_view word,
                                  std::size_t within);

  const Source& source_;
  std::string parsed_;  ///< what pugixml points into
  pugi::xml_document document_;
  std::vector<std::size_t> line_offsets_;
  std::vector<Diagnostic> faults_;
};

}  // namespace moivre
