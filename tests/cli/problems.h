// SPDX-License-Identifier: MIT
// Small problems with known answers that the tests of the program solve.
#pragma once

#include <sstream>
#include <string>

namespace moivre::test {

/// Four real roots: (1, 2), (2, 1), (-1, -2), (-2, -1).
inline constexpr const char* kCircleAndHyperbola = "2\nx^2 + y^2 - 5;\nx*y - 2;\n";

/// No root at all.
inline constexpr const char* kParallelLines = "2\nx + y - 1;\nx + y - 2;\n";

/// katsura-n in n + 1 unknowns: 2^n roots, all of them isolated and simple.
inline std::string katsura(int n) {
  std::ostringstream text;
  text << n + 1 << '\n';
  for (int m = 0; m < n; ++m) {
    for (int l = -n; l <= n; ++l) {
      const int k = m - l;
      if (k >= -n && k <= n) text << " + u" << std::abs(l) << "*u" << std::abs(k);
    }
    text << " - u" << m << ";\n";
  }
  text << "u0";
  for (int m = 1; m <= n; ++m) text << " + 2*u" << m;
  text << " - 1;\n";
  return text.str();
}

/// cyclic-n: most of the n! paths of the total degree end at infinity, in cycles.
inline std::string cyclic(int n) {
  std::string text = std::to_string(n) + "\n";
  for (int length = 1; length < n; ++length) {
    for (int first = 0; first < n; ++first) {
      text += first == 0 ? "" : " + ";
      for (int k = 0; k < length; ++k) {
        text += (k == 0 ? "x" : "*x") + std::to_string((first + k) % n);
      }
    }
    text += ";\n";
  }
  for (int k = 0; k < n; ++k) text += (k == 0 ? "x" : "*x") + std::to_string(k);
  return text + " - 1;\n";
}

}  // namespace moivre::test
