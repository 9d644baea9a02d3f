// SPDX-License-Identifier: MIT
// Numbers as text, by std::to_chars where every digit counts and by printf where columns do.
#include "moivre/report/number_text.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdio>

namespace moivre {
namespace {

// Enough for the longest double in any of the forms below.
constexpr std::size_t kNumberLength = 40;
// A double holds no more significant digits than these.
constexpr int kMostDigits = 17;

std::string formatted(const char* format, int digits, double x) {
  char text[kNumberLength];
  const int length = std::snprintf(text, sizeof text, format, digits, x);
  return std::string(text, static_cast<std::size_t>(length));
}

int decimal_exponent(double x) { return static_cast<int>(std::floor(std::log10(x))); }

}  // namespace

std::string exact_text(double x) {
  if (!std::isfinite(x)) return "";
  char text[kNumberLength];
  const auto end = std::to_chars(text, text + sizeof text, x);
  return std::string(text, end.ptr);
}

std::string known_digits(double x, double error) {
  if (!std::isfinite(x) || !std::isfinite(error)) return "unknown";
  if (std::abs(x) <= error) return "0";
  int digits = kMostDigits;
  if (error > 0) {
    // The last digit's unit is the least power of ten that is not below the error.
    digits = decimal_exponent(std::abs(x)) - static_cast<int>(std::ceil(std::log10(error))) + 1;
  }
  return formatted("%.*g", std::clamp(digits, 1, kMostDigits), x);
}

std::string known_digits(Complex x, double error) {
  std::string re = known_digits(x.real(), error);
  const std::string im = known_digits(std::abs(x.imag()), error);
  if (im == "0") return re;
  return re + (x.imag() < 0 ? " - " : " + ") + im + " i";
}

std::string short_text(double x, int digits) { return formatted("%.*g", digits, x); }

std::string rough_text(double x) { return std::isfinite(x) ? formatted("%.*g", 2, x) : "unknown"; }

std::string phc_text(Complex x) {
  return formatted("% .*E", kMostDigits - 1, x.real()) + "  " +
         formatted("% .*E", kMostDigits - 1, x.imag());
}

}  // namespace moivre
