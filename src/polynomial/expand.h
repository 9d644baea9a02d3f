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

class Account;

/// Parses and expands the expressions of one file. Faults (of the grammar, an exponent that is no
/// integer, an unknown name, a limit passed) are appended to the list given; all those of an
/// expression are. Only what is kept of a file, an equation, a denominator, a condition, has to be
/// held by double (double_range.h).
///
/// 1/d of a polynomial d is an unknown of its own until the denominators are cleared: unknown
/// kFirstReciprocal + k is 1/d_k.
/// Functions and roots of numbers (number_functions.h) are decimals of 40 digits, and count as
/// rounded.
class Expander {
 public:
  static constexpr std::uint32_t kFirstReciprocal = 0x80000000;

  explicit Expander(std::vector<Diagnostic>& faults) : faults_(faults) {}

  /// nullopt when something in the text, which begins at `begin`, was at fault. Only one summand's
  /// tree is in memory at a time. Reciprocals are left in.
  std::optional<Polynomial> expand(std::string_view text, const SourcePosition& begin,
                                   const Environment& names);

  /// "left = right" as left - right, or an expression alone.
  std::optional<Polynomial> expand_equation(std::string_view text, const SourcePosition& begin,
                                            const Environment& names);

  /// Adds p = 0, times the least powers of denominators that leave no reciprocal in it, to the
  /// system's equations; false and a fault at `at` where a limit is passed or double holds no
  /// multiple of it.
  bool add_equation(const Polynomial& p, const SourcePosition& at, System& system);

  /// By which the expressions so far divide: none constant, none twice, each held by double.
  std::vector<Polynomial> denominators() const;

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
  Value reciprocal_of(const Polynomial& p, const SourcePosition& at);
  Value function_of_number(const Expression& e, const Environment& names);
  Value root_of_number(const Coefficient& base, const Rational& exponent, const SourcePosition& at);
  Value rounded_number(const std::optional<Rational>& number, const SourcePosition& at,
                       const std::string& what);
  std::optional<Polynomial> cleared(const Polynomial& p, const SourcePosition& at);
  Polynomial without_reciprocals(const Polynomial& p, Polynomial& factor, Account& account) const;
  Value power(const Expression& e, const Environment& names);
  Value named(const Expression& e, const Environment& names);
  Value refuse(const SourcePosition& at, const std::string& message);
  /// A number; nullopt and a fault where it is none, or not real.
  std::optional<Rational> exponent(const Expression& e, const Environment& names);
  template <class Operation>
  Value within_limits(const SourcePosition& at, Operation operation);

  std::vector<Diagnostic>& faults_;
  std::vector<Polynomial> denominators_;  // monic
  std::uint64_t work_ = 0;
  bool has_rounded_number_ = false;
};

}  // namespace moivre
