// SPDX-License-Identifier: MIT
// Numbers as text, all by std::to_chars: as printf writes them, several times as fast.
#include "moivre/report/number_text.h"

#include <algorithm>
#include <charconv>
#include <cmath>

namespace moivre {
namespace {

// Enough for the longest double in any of the forms below.
constexpr std::size_t kNumberLength = 40;
// A double holds no more significant digits than these.
constexpr int kMostDigits = 17;

/// printf's %.*g and %.*e.
std::string formatted(double x, std::chars_format format, int digits) {
  char text[kNumberLength];
  const auto end = std::to_chars(text, text + sizeof text, x, format, digits);
  return std::string(text, end.ptr);
}

std::string general(double x, int digits) {
  return formatted(x, std::chars_format::general, digits);
}

/// printf's % .*E: a sign or a blank, the exponent's letter a capital.
std::string phc_number(double x) {
  std::string text = formatted(x, std::chars_format::scientific, kMostDigits - 1);
  if (!std::signbit(x)) text.insert(text.begin(), ' ');
  const std::size_t exponent = text.find('e');
  if (exponent != std::string::npos) text[exponent] = 'E';
  return text;
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
  return general(x, std::clamp(digits, 1, kMostDigits));
}

std::string known_digits(Complex x, double error) {
  std::string re = known_digits(x.real(), error);
  const std::string im = known_digits(std::abs(x.imag()), error);
  if (im == "0") return re;
  return re + (x.imag() < 0 ? " - " : " + ") + im + " i";
}

std::string short_text(double x, int digits) { return general(x, digits); }

std::string rough_text(double x) { return std::isfinite(x) ? general(x, 2) : "unknown"; }

std::string phc_text(Complex x) { return phc_number(x.real()) + "  " + phc_number(x.imag()); }

}  // namespace moivre
