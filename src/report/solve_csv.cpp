// SPDX-License-Identifier: MIT
// A solve as CSV: one root a line, coordinates as pairs of columns NAME.re, NAME.im.
#include "moivre/report/number_text.h"
#include "moivre/report/solve_report.h"

namespace moivre {

std::string solve_csv(const SolveResult& result) {
  std::string text = "path,real,singular,multiplicity,residual,accuracy,condition";
  for (const std::string& name : result.system.variables)
    text += ',' + name + ".re," + name + ".im";
  text += '\n';
  for (const Solution& root : result.solutions) {
    text += std::to_string(root.path) + (root.real ? ",1," : ",0,") +
            (root.singular ? "1," : "0,") + std::to_string(root.multiplicity);
    for (const double x : {root.residual, root.accuracy, root.condition})
      text += ',' + exact_text(x);
    for (const Complex& x : root.x) {
      text += ',' + exact_text(x.real()) + ',' + exact_text(x.imag());
    }
    text += '\n';
  }
  return text;
}

}  // namespace moivre
