// SPDX-License-Identifier: MIT
// Is a text well-formed markup? Elements closed in order, attributes quoted, entities known: what
// an XML parser insists on.
// HTML's elements without content (input) are taken as closed.
#pragma once

#include <gtest/gtest.h>

#include <cctype>
#include <string>
#include <vector>

namespace moivre::test {

/// Elements in the order in which they open; fails where the text is not well-formed. No comments,
/// no declarations.
class Markup {
 public:
  explicit Markup(const std::string& text) : text_(text) {
    while (at_ < text_.size() && is_well_formed_) {
      if (text_[at_] == '<') {
        read_tag();
      } else if (text_[at_] == '&') {
        read_entity();
      } else {
        require(text_[at_] != '>', "a bare >");
        ++at_;
      }
    }
    require(open_.empty(), "an element is not closed");
  }

  bool is_well_formed() const { return is_well_formed_; }
  const std::vector<std::string>& elements() const { return elements_; }

 private:
  void require(bool holds, const std::string& what) {
    if (holds || !is_well_formed_) return;
    is_well_formed_ = false;
    ADD_FAILURE() << what << " at " << at_ << ": " << text_.substr(at_, 60);
  }

  std::string read_name() {
    const std::size_t begin = at_;
    while (at_ < text_.size() && (std::isalnum(static_cast<unsigned char>(text_[at_])) != 0 ||
                                  text_[at_] == '-' || text_[at_] == ':')) {
      ++at_;
    }
    require(at_ > begin, "a name is missing");
    return text_.substr(begin, at_ - begin);
  }

  void read_tag() {
    ++at_;
    const bool closes = text_[at_] == '/';
    at_ += closes ? 1 : 0;
    const std::string name = read_name();
    if (closes) {
      require(!open_.empty() && open_.back() == name, "closes what is not open");
      if (!open_.empty()) open_.pop_back();
      ++at_;
      return;
    }
    elements_.push_back(name);
    while (is_well_formed_ && at_ < text_.size() && text_[at_] == ' ') read_attribute();
    const bool is_empty = text_[at_] == '/';
    at_ += is_empty ? 1 : 0;
    require(at_ < text_.size() && text_[at_] == '>', "a tag does not end");
    if (!is_empty) open_.push_back(name);
    ++at_;
  }

  void read_attribute() {
    ++at_;
    read_name();
    require(text_.compare(at_, 2, "=\"") == 0, "an attribute without a quoted value");
    const std::size_t end = text_.find('"', at_ + 2);
    require(end != std::string::npos, "an attribute does not end");
    require(text_.substr(at_ + 2, end - at_ - 2).find('<') == std::string::npos,
            "a < in an attribute");
    at_ = end + 1;
  }

  void read_entity() {
    const std::size_t end = text_.find(';', at_);
    const std::string name = text_.substr(at_ + 1, end - at_ - 1);
    require(name == "amp" || name == "lt" || name == "gt" || name == "quot" || name == "#39",
            "an unknown entity");
    at_ = end == std::string::npos ? text_.size() : end + 1;
  }

  const std::string& text_;
  std::size_t at_ = 0;
  bool is_well_formed_ = true;
  std::vector<std::string> open_;
  std::vector<std::string> elements_;
};

}  // namespace moivre::test
