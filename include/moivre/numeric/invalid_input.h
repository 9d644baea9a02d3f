// SPDX-License-Identifier: MIT
// What does the library throw where it is called wrongly? One exception, before any work, that
// names every broken rule.
//
// A rule is a sentence in the library's words; what() is all of them, separated by "; ". A fault in
// a text has a place as well (ParseError, expression/source.h). What mathematics answers (no root,
// singular, undecided) is a value, never an exception.
#pragma once

#include <stdexcept>
#include <string>
#include <vector>

namespace moivre {

class InvalidInput : public std::invalid_argument {
 public:
  explicit InvalidInput(const std::string& broken_rule);
  explicit InvalidInput(std::vector<std::string> broken_rules);
  ~InvalidInput() override;

  /// One at least.
  const std::vector<std::string>& broken_rules() const noexcept { return broken_rules_; }

 protected:
  /// Where the message is more than the rules.
  InvalidInput(const std::string& message, std::vector<std::string> broken_rules);

 private:
  std::vector<std::string> broken_rules_;
};

/// Throws unless there are none.
void require_unbroken(const std::vector<std::string>& broken_rules);

}  // namespace moivre
