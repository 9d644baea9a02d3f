// SPDX-License-Identifier: MIT
// A solve as PHCpack writes it: the system, then THE SOLUTIONS, each with t, m, coordinates, err,
// rco and res.
#include <algorithm>
#include <cmath>

#include "moivre/polynomial/read.h"
#include "moivre/report/number_text.h"
#include "moivre/report/solve_report.h"
#include "moivre/report/text_pieces.h"

namespace moivre {
namespace {

const std::string kRule(75, '=');

std::string column(double x) {
  // PHCpack has no word for an unknown number; 1 is the worst of each of its three figures.
  char text[16];
  std::snprintf(text, sizeof text, "%.3E", std::isfinite(x) ? x : 1.0);
  return text;
}

std::string figures(const Solution& root) {
  return "== err :  " + column(root.accuracy) + " = rco :  " + column(1 / root.condition) +
         " = res :  " + column(root.residual) + " ==\n";
}

}  // namespace

void write_solve_phc(const TextSink& sink, const SolveResult& result, const System& f) {
  TextPieces text(sink);
  text += to_text(f, PolynomialFormat::phcpack);
  text += "\nTHE SOLUTIONS :\n" + std::to_string(result.solutions.size()) + ' ' +
          std::to_string(f.variables.size()) + '\n' + kRule + '\n';
  std::size_t width = 0;
  for (const std::string& name : f.variables) width = std::max(width, name.size());
  std::size_t number = 0;
  for (const Solution& root : result.solutions) {
    text += "solution " + std::to_string(++number) + " :\n";
    text += "t : " + phc_text(1) + "\nm : " + std::to_string(root.multiplicity) +
            "\nthe solution for t :\n";
    for (std::size_t i = 0; i < f.variables.size(); ++i) {
      const std::string& name = f.variables[i];
      text +=
          ' ' + name + std::string(width - name.size(), ' ') + " : " + phc_text(root.x[i]) + '\n';
    }
    text += figures(root);
  }
  text.flush();
}

std::string solve_phc(const SolveResult& result, const System& f) {
  return whole_text([&](const TextSink& sink) { write_solve_phc(sink, result, f); });
}

}  // namespace moivre
