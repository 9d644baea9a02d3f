// SPDX-License-Identifier: MIT
// Decimal text to rational, with the range judged on the text before anything huge is computed.
#include "number.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>

#include "moivre/numeric/integer.h"

namespace moivre {

namespace {

/// Reading and reducing costs the square of the digits; no data of a mechanism has as many.
constexpr long long kMaximumDigits = 5000;
/// A number in [10^(k-1), 10^k) is below the least denormal, 4.9e-324, for k <= kTooSmall, and
/// above the greatest double, 1.8e308, for k >= kTooLarge.
constexpr long long kTooSmall = -325;
constexpr long long kTooLarge = 310;
/// A message quotes at most this much of a number.
constexpr std::size_t kQuoted = 40;

struct Decimal {
  std::string digits;  // without leading zeros; its value is an integer
  long long exponent = 0;
};

/// The exponent's digits as a number, or the nearest end of a range that no number of 10 MB leaves.
long long saturated(std::string_view digits, bool negative) {
  constexpr long long kEnd = std::numeric_limits<long long>::max() / 4;
  long long value = 0;
  const auto result = std::from_chars(digits.data(), digits.data() + digits.size(), value);
  if (result.ec != std::errc{} || value > kEnd) value = kEnd;
  return negative ? -value : value;
}

Decimal split(std::string_view text) {
  Decimal decimal;
  const std::size_t mark = std::min(text.find_first_of("eE"), text.size());
  const std::string_view mantissa = text.substr(0, mark);
  if (mark < text.size()) {
    std::string_view exponent = text.substr(mark + 1);
    const bool negative = exponent.front() == '-';
    if (negative || exponent.front() == '+') exponent.remove_prefix(1);
    decimal.exponent = saturated(exponent, negative);
  }
  const std::size_t point = std::min(mantissa.find('.'), mantissa.size());
  decimal.digits = mantissa.substr(0, point);
  if (point < mantissa.size()) {
    const std::string_view fraction = mantissa.substr(point + 1);
    decimal.digits += fraction;
    decimal.exponent -= static_cast<long long>(fraction.size());
  }
  decimal.digits.erase(0, std::min(decimal.digits.find_first_not_of('0'), decimal.digits.size()));
  const std::size_t end = decimal.digits.find_last_not_of('0') + 1;
  decimal.exponent += static_cast<long long>(decimal.digits.size() - end);
  decimal.digits.erase(end);
  return decimal;
}

Rational value_of(const Decimal& decimal) {
  const Integer digits(decimal.digits);
  const Integer scale = pow(Integer(10), static_cast<unsigned>(std::abs(decimal.exponent)));
  return decimal.exponent < 0 ? ratio(digits, scale) : ratio(digits * scale);
}

std::string quoted(std::string_view text) {
  std::string quote(text.substr(0, kQuoted));
  if (text.size() > kQuoted) quote += "...";
  return '`' + quote + '`';
}

}  // namespace

ParsedNumber parse_number(std::string_view text, NumberRange range) {
  const Decimal decimal = split(text);
  if (decimal.digits.empty()) return {};
  const auto digits = static_cast<long long>(decimal.digits.size());
  const long long magnitude = digits + decimal.exponent;
  const std::string too_long =
      "the number " + quoted(text) + " has more than " + std::to_string(kMaximumDigits) + " digits";
  if (range == NumberRange::any) {
    const long long longest = std::max({digits, magnitude, -decimal.exponent});
    if (longest > kMaximumDigits) return {.value = {}, .refusal = too_long};
    return {.value = value_of(decimal), .refusal = {}};
  }
  const std::string too_large =
      "the number " + quoted(text) + " is beyond the range of double (1.8e308)";
  const std::string too_small =
      "the number " + quoted(text) + " is not zero but below the range of double (4.9e-324)";
  if (magnitude >= kTooLarge) return {.value = {}, .refusal = too_large};
  if (magnitude <= kTooSmall) return {.value = {}, .refusal = too_small};
  if (digits > kMaximumDigits) return {.value = {}, .refusal = too_long};
  Rational value = value_of(decimal);
  const double rounded = to_double(value);
  if (std::isinf(rounded)) return {.value = {}, .refusal = too_large};
  if (rounded == 0.0) return {.value = {}, .refusal = too_small};
  return {.value = std::move(value), .refusal = {}};
}

}  // namespace moivre
