// SPDX-License-Identifier: MIT
// Are the digits beyond double those of the root? Each decimal against a certificate of as many
// bits.
#include <algorithm>
#include <cctype>
#include <string_view>

#include "bench.h"
#include "moivre/numeric/integer.h"

namespace moivre {
namespace {

// Bits of a decimal digit, and some to spare.
constexpr int kBitsPerDigit = 4;
constexpr int kSpareBits = 64;
// A decimal's exponent beyond this is none of double's range.
constexpr long kMostExponent = 400;
constexpr std::size_t kMostCharacters = 2000;

/// A decimal and one unit of its last digit.
struct Decimal {
  Rational value, unit;
};

Rational power_of_ten(long exponent) {
  const Integer power =
      boost::multiprecision::pow(Integer(10), static_cast<unsigned>(std::abs(exponent)));
  return exponent < 0 ? ratio(1, power) : ratio(power);
}

std::optional<Decimal> read_decimal(std::string_view text) {
  if (text.size() > kMostCharacters) return std::nullopt;
  const bool is_negative = !text.empty() && text.front() == '-';
  if (is_negative) text.remove_prefix(1);
  long exponent = 0;
  if (const std::size_t e = text.find('e'); e != std::string_view::npos) {
    const std::string tail(text.substr(e + 1));
    char* end = nullptr;
    exponent = std::strtol(tail.c_str(), &end, 10);
    if (tail.empty() || *end != '\0') return std::nullopt;
    text = text.substr(0, e);
  }
  std::string digits;
  bool behind_point = false;
  for (const char c : text) {
    if (c == '.' && !behind_point) {
      behind_point = true;
    } else if (std::isdigit(static_cast<unsigned char>(c)) != 0) {
      digits += c;
      exponent -= behind_point ? 1 : 0;
    } else {
      return std::nullopt;
    }
  }
  const auto most = static_cast<long>(kMostExponent + kMostCharacters);
  if (digits.empty() || std::abs(exponent) > most) return std::nullopt;
  // A leading zero would make the number octal.
  digits.erase(0, std::min(digits.find_first_not_of('0'), digits.size() - 1));
  const Rational unit = power_of_ten(exponent);
  const Rational value = ratio(Integer(digits)) * unit;
  return Decimal{is_negative ? -value : value, unit};
}

struct ExactPart {
  Rational re, im;
};

ExactPart middle(const Certificate& c, std::size_t j) {
  ExactPart m{Rational(c.midpoint[j].real()), Rational(c.midpoint[j].imag())};
  for (const Point& part : c.finer) {
    m.re += Rational(part[j].real());
    m.im += Rational(part[j].imag());
  }
  return m;
}

/// In the order in which one outweighs another.
enum class Fit { right, unknown, wrong };

/// "0" stands for a part of which no digit is known: it vanishes relative to the point.
Fit fit(const std::string& text, const Rational& part, double error, const Rational& vanishing) {
  const auto decimal = read_decimal(text);
  if (!decimal) return Fit::wrong;
  const Rational unit = text == "0" ? vanishing : decimal->unit;
  const Rational off = abs(decimal->value - part);
  const Rational slack(error);
  if (off + slack <= unit) return Fit::right;
  return off > unit + slack ? Fit::wrong : Fit::unknown;
}

int bits_of_digits(const Bench& bench) {
  const int digits = bench.claims.digits.value_or(0);
  return std::clamp(kBitsPerDigit * digits + kSpareBits, kFirstArbBits, kMostArbBits);
}

void judge_root(Bench& bench, Entry& entry, std::size_t number) {
  const RootClaim& root = bench.claims.roots[number - 1];
  if (root.x_digits.size() != root.x.size()) {
    return bench.verdicts.refute(ClaimKind::digits, "digits of other coordinates than x has",
                                 number);
  }
  if (!entry.certificate.holds_root()) {
    return bench.verdicts.leave_open(ClaimKind::digits, "no certificate to compare with", number);
  }
  const int digits = bench.claims.digits.value_or(0);
  Certificate c = entry.certificate;
  const int bits = bits_of_digits(bench);
  if (bits > c.bits) bench.certifier.sharpen(c, bits);
  const Rational vanishing =
      Rational(std::max(1.0, max_norm(root.x))) * power_of_ten(1 - std::max(1, digits));
  Fit worst = Fit::right;
  for (std::size_t j = 0; j < root.x.size(); ++j) {
    const ExactPart m = middle(c, j);
    worst = std::max({worst, fit(root.x_digits[j].re, m.re, c.error(j), vanishing),
                      fit(root.x_digits[j].im, m.im, c.error(j), vanishing)});
  }
  if (worst == Fit::unknown) {
    return bench.verdicts.leave_open(ClaimKind::digits, "more than certificates have", number);
  }
  bench.verdicts.judge(ClaimKind::digits, worst == Fit::right,
                       "its decimals are not those of the root", number);
}

}  // namespace

Certificate certificate_at_digits(const Bench& bench, const RootClaim& root) {
  const std::size_t n = root.x.size();
  if (root.x_digits.size() != n || bench.stand_in.has_patches()) return {};
  const int bits = bits_of_digits(bench);
  // A sum of doubles, largest first.
  std::vector<Point> parts(1 + static_cast<std::size_t>(bits / kDoubleBits), Point(n));
  for (std::size_t j = 0; j < n; ++j) {
    const auto re = read_decimal(root.x_digits[j].re);
    const auto im = read_decimal(root.x_digits[j].im);
    if (!re || !im) return {};
    Coefficient rest{re->value, im->value};
    for (Point& part : parts) {
      part[j] = to_complex(rest);
      if (!is_finite(part[j])) return {};
      rest = rest - Coefficient(part[j]);
    }
  }
  const std::vector<Point> finer(parts.begin() + 1, parts.end());
  Certificate c;
  for (int more = bits; !c.holds_root() && more <= kMostArbBits; more *= 2) {
    c = bench.certifier.certify_near(parts.front(), finer, more);
  }
  return c;
}

void judge_digits(Bench& bench) {
  if (!bench.claims.digits || bench.stand_in.has_patches() || !bench.stand_in.proves_roots) return;
  for (std::size_t k = 0; k < bench.entries.size(); ++k) {
    bench.require_time();
    if (!bench.claims.roots[k].x_digits.empty()) judge_root(bench, bench.entries[k], k + 1);
  }
}

}  // namespace moivre
