// SPDX-License-Identifier: MIT
// The parts that more than one report for people has.
#include "moivre/report/text_blocks.h"

#include <cmath>

#include "moivre/report/number_text.h"

namespace moivre {
namespace {

// Degrees in a row from which they are counted instead of listed.
constexpr std::size_t kLongRun = 4;

}  // namespace

std::string degrees_text(const std::vector<std::uint64_t>& degrees) {
  std::string text;
  for (std::size_t begin = 0; begin < degrees.size();) {
    std::size_t end = begin;
    while (end < degrees.size() && degrees[end] == degrees[begin]) ++end;
    const std::size_t run = end - begin;
    if (begin > 0) text += ' ';
    text += std::to_string(degrees[begin]);
    if (run >= kLongRun) text.append(" (").append(std::to_string(run)).append(" times)");
    begin = run >= kLongRun ? end : begin + 1;
  }
  return text;
}

std::string count_text(const std::optional<std::uint64_t>& count) {
  return count ? std::to_string(*count) : "beyond 64 bits";
}

std::string complex_text(Complex x) {
  constexpr int kDigits = 6;
  const std::string re = short_text(x.real(), kDigits);
  if (x.imag() == 0) return re;
  return re + (x.imag() < 0 ? " - " : " + ") + short_text(std::abs(x.imag()), kDigits) + " i";
}

std::string left_out_text(const std::vector<LeftOut>& left_out) {
  if (left_out.empty()) return "";
  std::string text = "\nLeft out\n";
  for (const LeftOut& item : left_out) text += "  " + item.what + ": " + item.why + '\n';
  return text;
}

}  // namespace moivre
