// SPDX-License-Identifier: MIT
// Values with bounds on their errors.
#include "condition_value.h"

#include <cmath>
#include <limits>

namespace moivre {
namespace {

/// Of one operation, with its share of what the bounds themselves lose.
constexpr double kRounding = 2 * std::numeric_limits<double>::epsilon();

struct BoundedValue {
  double value = 0;
  double error = 0;
};

BoundedValue product(const BoundedValue& a, const BoundedValue& b) {
  const double value = a.value * b.value;
  const double error =
      std::abs(a.value) * b.error + a.error * std::abs(b.value) + a.error * b.error;
  // Below the smallest normal number a rounding is as large as that number's.
  constexpr double kSmallest = std::numeric_limits<double>::min();
  return {value, error * (1 + kRounding) + kRounding * std::abs(value) + kSmallest};
}

BoundedValue sum(const BoundedValue& a, const BoundedValue& b) {
  const double value = a.value + b.value;
  return {value, (a.error + b.error) * (1 + kRounding) + kRounding * std::abs(value)};
}

BoundedValue power(BoundedValue base, std::uint32_t exponent) {
  BoundedValue result{1, 0};
  for (; exponent > 0; exponent /= 2) {
    if (exponent % 2 == 1) result = product(result, base);
    if (exponent > 1) base = product(base, base);
  }
  return result;
}

}  // namespace

Sign sign_at(const Polynomial& p, const Solution& root) {
  const double known = root.accuracy * std::max(1.0, max_norm(root.x));
  const double error = root.cluster ? std::max(known, root.radius) : known;
  BoundedValue total;
  for (const Term& term : p.terms) {
    const double c = to_double(term.coefficient.re);
    BoundedValue summand{c, kRounding * std::abs(c)};
    for (const Power& factor : term.monomial) {
      const BoundedValue x{root.x[factor.variable].real(), error};
      summand = product(summand, power(x, factor.exponent));
    }
    total = sum(total, summand);
  }
  // What overflows is no number, or has an endless error: neither comparison holds.
  if (total.value > total.error) return Sign::positive;
  if (total.value < -total.error) return Sign::negative;
  return Sign::unknown;
}

}  // namespace moivre
