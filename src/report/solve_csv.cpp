// SPDX-License-Identifier: MIT
// A solve as CSV: one root a line, coordinates as pairs of columns NAME.re, NAME.im.
#include "moivre/report/number_text.h"
#include "moivre/report/solve_report.h"
#include "moivre/report/text_pieces.h"

namespace moivre {

namespace {

std::string coordinate_text(const Solution& root, std::size_t i) {
  if (!root.x_digits.empty()) return ',' + root.x_digits[i].re + ',' + root.x_digits[i].im;
  return ',' + exact_text(root.x[i].real()) + ',' + exact_text(root.x[i].imag());
}

}  // namespace

void write_solve_csv(const TextSink& sink, const SolveResult& result) {
  TextPieces text(sink);
  text += "path,real,singular,multiplicity,residual,accuracy,condition";
  for (const std::string& name : result.system.variables)
    text += ',' + name + ".re," + name + ".im";
  text += "\n";
  for (const Solution& root : result.solutions) {
    text += std::to_string(root.path) + (root.real ? ",1," : ",0,") +
            (root.singular ? "1," : "0,") + std::to_string(root.multiplicity);
    for (const double x : {root.residual, root.accuracy, root.condition})
      text += ',' + exact_text(x);
    for (std::size_t i = 0; i < root.x.size(); ++i) text += coordinate_text(root, i);
    text += "\n";
  }
  text.flush();
}

std::string solve_csv(const SolveResult& result) {
  return whole_text([&](const TextSink& sink) { write_solve_csv(sink, result); });
}

}  // namespace moivre
