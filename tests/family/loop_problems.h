// SPDX-License-Identifier: MIT
// Which families do loops learn that no start system fits? Conics that touch conics, a nine-link,
// the families of problems/families.
#pragma once

#include <string>
#include <vector>

#include "moivre/family/learn.h"
#include "moivre/polynomial/read.h"

namespace moivre {

/// A system of problems/families with the parameters that it declares.
inline Family declared_family(const std::string& file) {
  const ParametricSystem read =
      read_parametric(read_source(MOIVRE_SOURCE_DIR "/problems/families/" + file), {});
  std::vector<NamedParameter> parameters;
  for (const std::string& name : read.declared) parameters.push_back({name});
  return unlearned_family(read.system, parameters);
}

/// Conics a x^2 + b xy + c y^2 + d x + e y + 1 that touch `conics` conics, at (x1, y1), ..., and
/// pass through 5 - conics points:
/// 1, 6, 36, 184, 816, 3264 for 0 to 5 conics.
inline Family conics_that_touch(int conics) {
  std::vector<NamedParameter> parameters;
  const auto parameter = [&](char letter, const std::string& number) {
    parameters.push_back({letter + number});
    return letter + number;
  };
  std::string equations;
  for (int j = 1; j <= 5; ++j) {
    const std::string number = std::to_string(j);
    const std::string x = j <= conics ? "x" + number : parameter('X', number);
    const std::string y = j <= conics ? "y" + number : parameter('Y', number);
    equations +=
        "a*" + x + "^2 + b*" + x + "*" + y + " + c*" + y + "^2 + d*" + x + " + e*" + y + " + 1;\n";
    if (j > conics) continue;
    std::vector<std::string> k;
    for (const char letter : {'p', 'q', 'r', 's', 't', 'u'}) k.push_back(parameter(letter, number));
    equations += k[0] + "*" + x + "^2 + " + k[1] + "*" + x + "*" + y + " + " + k[2] + "*" + y +
                 "^2 + " + k[3] + "*" + x + " + " + k[4] + "*" + y + " + " + k[5] + ";\n";
    equations += "(2*a*" + x + " + b*" + y + " + d)*(" + k[1] + "*" + x + " + 2*" + k[2] + "*" + y +
                 " + " + k[4] + ") - (b*" + x + " + 2*c*" + y + " + e)*(2*" + k[0] + "*" + x +
                 " + " + k[1] + "*" + y + " + " + k[3] + ");\n";
  }
  const int unknowns = 5 + 2 * conics;
  const std::string head = std::to_string(unknowns) + " " +
                           std::to_string(static_cast<std::size_t>(unknowns) + parameters.size());
  return unlearned_family(read_system({"conics", head + "\n" + equations}), parameters);
}

/// Four ternary links in a ring on four bars, in isotropic coordinates
/// (problems/polynomials/nine-link-56.phc): the Assur structure 4/4.
/// r_j: bars; a_j, b_j, c_j and, conjugate, A_j, B_j, C_j: sides of links, ground. The loops'
/// constants add up to 0.
inline Family nine_link() {
  std::vector<NamedParameter> parameters{{"r1"}, {"r2"}, {"r3"}, {"r4"}};
  std::string equations;
  for (const char* letters : {"abct", "ABCu"}) {
    const std::string a(1, letters[0]), b(1, letters[1]), c(1, letters[2]), t(1, letters[3]);
    const auto bars = [&](const char* plus, const char* minus) {
      return std::string("r").append(plus) + "*" + t + plus + " - r" + minus + "*" + t + minus;
    };
    equations +=
        bars("1", "2") + " + " + a + "1*" + t + "5 + " + b + "1*" + t + "6 + " + c + "1;\n";
    equations +=
        bars("2", "3") + " + " + a + "2*" + t + "6 + " + b + "2*" + t + "7 + " + c + "2;\n";
    equations +=
        bars("3", "4") + " + " + a + "3*" + t + "7 + " + b + "3*" + t + "8 + " + c + "3;\n";
    equations += bars("4", "1") + " + " + a + "4*" + t + "8 + " + b + "4*" + t + "5 - " + c +
                 "1 - " + c + "2 - " + c + "3;\n";
    for (const std::string& letter : {a, b, c}) {
      for (int j = 1; j <= (letter == c ? 3 : 4); ++j) {
        parameters.push_back({letter + std::to_string(j)});
      }
    }
  }
  for (int j = 1; j <= 8; ++j) {
    const std::string number = std::to_string(j);
    equations += std::string("t").append(number) + "*u" + number + " - 1;\n";
  }
  const std::string head = "16 " + std::to_string(16 + parameters.size()) + "\n";
  return unlearned_family(read_system({"nine-link", head + equations}), parameters);
}

}  // namespace moivre
