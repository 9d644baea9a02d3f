// SPDX-License-Identifier: MIT
// Which polynomial is an expression?
// Products and powers multiplied out exactly, within stated limits.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "moivre/expression/expression.h"
#include "moivre/polynomial/system.h"

namespace moivre {

/// What names stand for; nullopt is a name whose own definition is at fault (no second message).
using Environment = std::unordered_map<std::string, std::optional<Polynomial>>;

/// The most terms that a polynomial may have, also on the way to it.
inline constexpr std::size_t kMaximumTerms = 1'000'000;
/// Products and sums of coefficients that one file may cost, about ten seconds; long coefficients
/// count for more.
inline constexpr std::uint64_t kMaximumWork = 50'000'000;
/// Bits of a coefficient's numerator or denominator: 5000 digits fit.
inline constexpr std::size_t kMaximumBits = 17'000;

/// Parses and expands the expressions of one file. Faults (of the grammar, a non-integer exponent,
/// division by a variable, an unknown name, a limit passed, a coefficient out of double's range) are
/// appended to the list given; all those of an expression are.
class Expander {
 public:
  explicit Expander(std::vector<Diagnostic>& faults) : faults_(faults) {}

  /// nullopt when something in the text, which begins at `begin`, was at fault. Only one summand's tree is
  /// in memory at a time.
  std::optional<Polynomial> expand(std::string_view text, const SourcePosition& begin,
                                   const Environment& names);

  /// Among the numbers of all expressions so far (digits.h).
  bool has_rounded_number() const { return has_rounded_number_; }

 private:
  using Value = std::optional<Polynomial>;
  /// Once it is unsound, summands are only searched for further faults.
  struct Sum {
    TermMap terms;
    bool is_sound = true;
  };

  Value value(const Expression& e, const Environment& names);
  void add_summand(const Expression& summand, const Environment& names, Sum& sum);
  Value sum_of(const Expression& e, const Environment& names);
  Value product_of(const Expression& e, const Environment& names);
  Value reciprocal(const Expression& e, const Environment& names);
  Value power(const Expression& e, const Environment& names);
  Value named(const Expression& e, const Environment& names);
  Value refuse(const SourcePosition& at, const std::string& message);
  std::optional<std::int64_t> exponent(const Expression& e, const Environment& names);
  template <class Operation>
  Value within_limits(const SourcePosition& at, Operation operation);

  std::vector<Diagnostic>& faults_;
  std::uint64_t work_ = 0;
  bool has_rounded_number_ = false;
};

}  // namespace moivre
