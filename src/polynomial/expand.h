// SPDX-License-Identifier: MIT
// Which polynomial is an expression? Products and powers multiplied out exactly, within stated
// limits.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
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

/// Expands the expressions of one file. Faults (a non-integer exponent, division by a variable, an
/// unknown name, a limit passed) are appended to the list given; all those of an expression are.
class Expander {
 public:
  explicit Expander(std::vector<Diagnostic>& faults) : faults_(faults) {}

  /// nullopt when something in `e` was at fault.
  std::optional<Polynomial> expand(const Expression& e, const Environment& names);

 private:
  using Value = std::optional<Polynomial>;

  Value sum(const Expression& e, const Environment& names);
  Value product(const Expression& e, const Environment& names);
  Value reciprocal(const Expression& e, const Environment& names);
  Value power(const Expression& e, const Environment& names);
  Value named(const Expression& e, const Environment& names);
  Value refuse(const SourcePosition& at, const std::string& message);
  std::optional<std::int64_t> exponent(const Expression& e, const Environment& names);
  template <class Operation>
  Value within_limits(const SourcePosition& at, Operation operation);

  std::vector<Diagnostic>& faults_;
  std::uint64_t work_ = 0;
};

}  // namespace moivre
